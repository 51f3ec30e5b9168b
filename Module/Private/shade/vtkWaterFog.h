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
  // Which pixels of the picture it changes. Of ranks whose pictures are blended in an order, the
  // farthest draws it over the background, and each over its own props.
  enum Cover
  {
    ALL,            // and leaves the picture's depth and alpha
    ALL_WITH_DEPTH, // and gives the background a depth: IceT leaves out pixels that have none
    ALL_AND_OPAQUE, // and hides what is behind the picture
    PROPS           // as far as they are opaque
  };

  // Draws the picture again as seen through the water, for an eye that is submerged. The backdrop's
  // textures are active.
  //
  // cover      where it is drawn
  // setLight   sets the uniforms of the slot haze and, if it has them, of its light shafts
  void Draw(vtkRenderer* renderer, const water_plan& plan, vtkWaterBackdrop& backdrop,
    const double deepColor[3], const double extinction[3], bool hasShafts, Cover cover,
    const std::function<void(vtkShaderProgram*)>& setLight);

  void ReleaseGraphicsResources();

private:
  vtkWaterQuad Quad;
  vtkWaterQuad ShaftQuad; // with light shafts
};

#endif
