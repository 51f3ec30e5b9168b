// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFog: the water between an eye in it and the scene.
#ifndef vtkWaterFog_h
#define vtkWaterFog_h

#include "vtkWaterQuad.h"
#include "water_types.h"

#include <functional>

class vtkRenderer;
class vtkShaderProgram;
class vtkWaterBackdrop;

class vtkWaterFog
{
public:
  // Draws the picture again as seen through the water, for an eye that is submerged. The backdrop's
  // textures are active.
  //
  // setLight   sets the uniforms of the slot haze and, if it has them, of its light shafts
  void Draw(vtkRenderer* renderer, const water_plan& plan, vtkWaterBackdrop& backdrop,
    const double deepColor[3], const double extinction[3], bool hasShafts,
    const std::function<void(vtkShaderProgram*)>& setLight);

  void ReleaseGraphicsResources();

private:
  vtkWaterQuad Quad;
  vtkWaterQuad ShaftQuad; // with light shafts
};

#endif
