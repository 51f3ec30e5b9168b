// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFoamFS.glsl: slot foam of water that has none.

float waterFoamShare(WaterPoint point)
{
  return 0.0;
}

vec3 waterFoamLit(WaterPoint point, vec3 sun)
{
  return vec3(0.0);
}
