// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBackground: what the mirrored view begins with, and the debug corner that shows it.
#ifndef vtkWaterBackground_h
#define vtkWaterBackground_h

#include "vtkWaterQuad.h"
#include "water_types.h"

class vtkRenderer;
class vtkTextureObject;
struct vtkWaterSkyTextures;

class vtkWaterBackground
{
public:
  // Clears the bound framebuffer to the renderer's background as the mirrored view sees it: a plain
  // colour, or, within its viewport and scissor, the gradient or picture in the direction of each
  // ray.
  void DrawSky(vtkRenderer* renderer, const water_plan& plan, const vtkWaterSkyTextures& textures);

  // Shows a texture in the lower left quarter of the renderer's viewport.
  void DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection);

  void ReleaseGraphicsResources();

private:
  vtkWaterQuad Sky;
  vtkWaterQuad Corner;
};

#endif
