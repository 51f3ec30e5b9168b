// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHighlights.glsl: how light that is brighter than white is shown; for shaders and, by
// water_shared.c, for C.

// What is shown of a light that is added to a colour, both in units of the room that the colour leaves up to white.
// Light below 0.6 is shown as it is. What is brighter rolls off towards 0.99, by a curve whose slope is continuous and
// that still tells 10 from 100: 3 is shown as 0.88, 10 as 0.93, 100 as 0.97.
//
// light  >= 0
float waterRollOff(float light)
{
  return min(light, 0.6) + 0.39 * (1.0 - 1.0 / sqrt(1.0 + max(light - 0.6, 0.0) / 0.195));
}
