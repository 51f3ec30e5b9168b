// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterErrors: what is wrong with a scene, in words: the core's text and the value it had.
#ifndef vtkWaterErrors_h
#define vtkWaterErrors_h

#include "water_status.h"

#include <string>

struct water_plan;
struct vtkWaterGather;
class vtkWaterActor;

struct vtkWaterError
{
  std::string Kind; // the same for the same error with another value; empty: no error
  std::string Text; // with the value
};

// gather, plan  where the value is read from; nullptr: from the water alone
vtkWaterError vtkWaterDescribe(water_status status, vtkWaterActor* water,
  const vtkWaterGather* gather = nullptr, const water_plan* plan = nullptr);

#endif
