// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMatterVS.glsl: how much matter the water carries at the vertices of a user's mesh (water_matter.h).

in float waterMatterMC; // concentration, >= 0
out float waterMatterVSOutput;

void waterMeasureMatter()
{
  waterMatterVSOutput = waterMatterMC;
}
