// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHighlights.glsl: how light that is brighter than white is shown; for shaders and, by
// water_shared.c, for C.

// What is shown of a light that is added to a colour, both in units of the room that the colour leaves up to white.
// Light below 0.72 is shown as it is. What is brighter rolls off towards 0.99, by a curve whose slope is continuous: 1 is
// shown as 0.87, 3 as 0.95. So little is taken that a picture keeps 95 % of the light that it can show. The last part
// is slow, and still tells 10, shown as 0.96, from 100, shown as 0.98.
//
// light  >= 0
float waterRollOff(float light)
{
  float over = max(light - 0.72, 0.0);
  float left = 1.0 / (1.0 + over / 0.6765225563909774); // 3 0.225 / (1 - 0.045 / 20): the slope is 1 at first
  return min(light, 0.72) + 0.225 * (1.0 - left * left * left) + 0.045 * over / (over + 20.0);
}
