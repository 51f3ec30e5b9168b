// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFog: the water between an eye in it and the scene.
#ifndef vtkWaterFog_h
#define vtkWaterFog_h

#include "vtkWaterQuad.h"
#include "water_types.h"

class vtkRenderer;
class vtkWaterBackdrop;

class vtkWaterFog
{
public:
  // Draws the picture again as seen through the water, for an eye that is submerged.
  void Draw(vtkRenderer* renderer, const water_plan& plan, vtkWaterBackdrop& backdrop,
    const double deepColor[3], const double extinction[3]);

  void ReleaseGraphicsResources();

private:
  vtkWaterQuad Quad;
};

#endif
