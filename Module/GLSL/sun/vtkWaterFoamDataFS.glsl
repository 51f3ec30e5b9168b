// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamDataFS.glsl: slot foam_data: the share of the surface that foam covers as data have it (vtkWaterFoamDataVS.glsl).

in float waterFoamVSOutput;
uniform vec2 waterFoamEnds; // values of the measure: up to the first there is no foam, from the last on nothing else

// How much of the water foam covers, that of other foam included.
float waterWithFoamData(float cover)
{
  return max(cover, waterFoamOfMeasure(waterFoamVSOutput, waterFoamEnds.x, waterFoamEnds.y));
}
