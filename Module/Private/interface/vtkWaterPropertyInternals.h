// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPropertyInternals.h: what a vtkWaterProperty holds besides plain numbers; for its own
// source files.
#ifndef vtkWaterPropertyInternals_h
#define vtkWaterPropertyInternals_h

#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkWaterNormalMaps.h"
#include "vtkWaterProperty.h"
#include "water_cascade.h"
#include "water_old_foam.h"
#include "water_waves.h"

#include <vector>

// Integrals over a sea's spectrum: not in every frame.
struct vtkWaterPropertySeaSlopes
{
  water_sea Sea = water_sea(); // of which they are
  water_cascades Cascades = water_cascades();
  double Beyond[WATER_CASCADES_MAX + 1][2] = {}; // water_cascades_slopes
  double Height = 0.0;                           // variance, m^2
  double LifeTime = 0.0;                         // of whitecaps, s
  water_old_foam OldFoam = water_old_foam();     // that they leave
};

struct vtkWaterProperty::Internals
{
  std::vector<water_wave> Waves;
  double Extinction[3]; // 1/m
  double Natural[3];    // of a scene with such water, m: water_preset.natural_m
  vtkSmartPointer<vtkTexture> Environment;
  vtkWaterNormalMaps NormalMaps;
  vtkWaterPropertySeaSlopes SeaSlopes;
};

#endif
