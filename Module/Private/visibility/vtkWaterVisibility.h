// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVisibility: finds out which cells of the reflection
// texture visible water looks up (water_visibility.h): on a GPU draws a pixel for each and reads
// them back; without one reads the depths themselves.
#ifndef vtkWaterVisibility_h
#define vtkWaterVisibility_h

#include "vtkSmartPointer.h"
#include "water_plan.h"
#include "water_visibility.h"

#include <cstdint>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkRenderer;
class vtkTextureObject;
class vtkWaterSceneDepth;
class vtkWaterMask;
class vtkWindow;

class vtkWaterVisibility
{
public:
  // Returns nullptr when it cannot be found out: anything may be looked up.
  const water_visibility* Find(vtkRenderer* renderer, const water_plan& plan, vtkWaterMask& mask,
    vtkWaterSceneDepth& sceneDepth);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkRenderer* renderer);
  bool ReadCells(vtkRenderer* renderer, const water_plan& plan, vtkWaterMask& mask,
    vtkWaterSceneDepth& sceneDepth);
  void ReadDepths(
    vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth);

  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<uint8_t> Pixels; // of each cell: RGBA, or one byte
  std::vector<float> Depths;
  std::vector<int32_t> Row;
  std::vector<uint32_t> Counts;
  water_visibility Seen{};
};

#endif
