// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterScreen: the two full-screen draws: the sky behind the mirrored view, and the debug
// corner.
#ifndef vtkWaterScreen_h
#define vtkWaterScreen_h

#include "water_types.h"

#include <memory>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;

class vtkWaterScreen
{
public:
  vtkWaterScreen();
  ~vtkWaterScreen();

  // Clears the bound framebuffer, its viewport and scissor set, to the renderer's background as the
  // mirrored view sees it: a plain colour, or the gradient in the direction of each ray. Textured
  // backgrounds give their plain colour.
  void DrawSky(vtkRenderer* renderer, const water_plan& plan);

  // Shows a texture in the lower left quarter of the renderer's viewport.
  void DrawCorner(vtkRenderer* renderer, vtkTextureObject* reflection);

  void ReleaseGraphicsResources();

private:
  std::unique_ptr<vtkOpenGLQuadHelper> Sky;
  std::unique_ptr<vtkOpenGLQuadHelper> Corner;
};

#endif
