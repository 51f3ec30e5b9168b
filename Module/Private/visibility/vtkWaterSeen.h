// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeen: finds out which cells of the map visible water looks up (water_seen.h): on a GPU
// draws a pixel for each and reads them back; without one reads the depths themselves.
#ifndef vtkWaterSeen_h
#define vtkWaterSeen_h

#include "vtkSmartPointer.h"
#include "water_plan.h"
#include "water_seen.h"

#include <cstdint>
#include <vector>

class vtkOpenGLFramebufferObject;
class vtkRenderer;
class vtkTextureObject;
class vtkWaterSceneDepth;
class vtkWaterScreen;
class vtkWindow;

class vtkWaterSeen
{
public:
  // Returns nullptr when it cannot be found out: anything may be looked up.
  const water_seen* Find(vtkRenderer* renderer, const water_plan& plan, vtkWaterScreen& screen,
    vtkWaterSceneDepth& sceneDepth);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool Ensure(vtkRenderer* renderer);
  bool ReadCells(vtkRenderer* renderer, const water_plan& plan, vtkWaterScreen& screen,
    vtkWaterSceneDepth& sceneDepth);
  void ReadDepths(
    vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth);

  vtkSmartPointer<vtkTextureObject> Color;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<uint8_t> Pixels; // of each cell: RGBA, or one byte
  std::vector<float> Depths;
  std::vector<int32_t> Row;
  std::vector<uint32_t> Counts;
  water_seen Seen{};
};

#endif
