// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamDataVS.glsl: what data say of foam at the vertices of a user's mesh (water_foam_measure.h).

in float waterFoamMC; // a value of the measure, >= 0
out float waterFoamVSOutput;

void waterMeasureFoam()
{
  waterFoamVSOutput = waterFoamMC;
}
