// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyInternals.h: what a vtkWaterProperty holds besides plain numbers; for its own
// source files.
#ifndef vtkWaterPropertyInternals_h
#define vtkWaterPropertyInternals_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWaterNormalMaps.h"
#include "vtkWaterProperty.h"
#include "water_waves.h"

#include <vector>

struct vtkWaterProperty::Internals
{
  std::vector<water_wave> Waves;
  double Extinction[3]; // 1/m
  double Natural[3];    // of a scene with such water, m: water_preset.natural_m
  vtkSmartPointer<vtkTexture> Environment;
  vtkWaterNormalMaps NormalMaps;
  double SeaSlopes[2] = { 0.0, 0.0 };  // variances of the sea that its tile holds, as of SeaTime
  double SeaLeftOut[2] = { 0.0, 0.0 }; // and of what is too short for it
  vtkMTimeType SeaTime = 0;
};

#endif
