// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShadowsFS.glsl: slot shadows: of things on the water's glitter and foam.

// How much of the sun's light arrives.
float waterSunArrives(WaterPoint point)
{
  return 1.0 - waterShaded(point, waterSunDir);
}
