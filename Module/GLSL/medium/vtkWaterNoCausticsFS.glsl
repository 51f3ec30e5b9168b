// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoCausticsFS.glsl: slot caustics of water without them.

float waterCaustic(vec2 ndc, float w, float depth, vec2 pixel)
{
  return 1.0;
}

bool waterHasCaustics()
{
  return false;
}
