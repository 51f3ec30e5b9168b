// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterErrors: what is wrong with a scene, in words: the core's text and the value it had.
#ifndef vtkWaterErrors_h
#define vtkWaterErrors_h

#include "vtkWaterSource.h"
#include "water_status.h"

struct water_plan;
struct vtkWaterGather;
struct vtkWaterSnapshot;

// gather, plan  where the value is read from; nullptr: from the water alone
vtkWaterError vtkWaterDescribe(water_status status, const vtkWaterSnapshot& water,
  const vtkWaterGather* gather = nullptr, const water_plan* plan = nullptr);

// A visible skybox whose texture has no data.
vtkWaterError vtkWaterDescribeEmptySkybox();

#endif
