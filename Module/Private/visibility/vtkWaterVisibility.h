// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVisibility: finds out which cells of the reflection texture visible water looks up, from
// the depths of the picture so far (water_visibility.h). They are read back: for software rendering
// alone, where that waits for nobody.
#ifndef vtkWaterVisibility_h
#define vtkWaterVisibility_h

#include "water_plan.h"
#include "water_visibility.h"

#include <cstdint>
#include <vector>

class vtkRenderer;
class vtkWaterSceneDepth;

class vtkWaterVisibility
{
public:
  const water_visibility* Find(
    vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth);

private:
  void ReadDepths(
    vtkRenderer* renderer, const water_plan& plan, const vtkWaterSceneDepth& sceneDepth);

  std::vector<uint8_t> Cells;
  std::vector<float> Depths;
  std::vector<int32_t> Row;
  std::vector<uint32_t> Counts;
  water_visibility Seen{};
};

#endif
