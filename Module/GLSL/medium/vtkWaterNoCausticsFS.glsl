// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoCausticsFS.glsl: slot caustics of water without them.

float waterCaustic(vec2 place, float depth)
{
  return 1.0;
}
