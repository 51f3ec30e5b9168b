// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShadowsFS.glsl: stage shadows: of things on the water's glitter and foam.
// Needs vtkWaterPointFS.glsl and vtkWaterLookupFS.glsl before it, or another of the latter's stage.

// How much of the sun's light arrives.
float waterSunArrives(WaterPoint point)
{
  return 1.0 - waterShaded(point, waterSunDir);
}
