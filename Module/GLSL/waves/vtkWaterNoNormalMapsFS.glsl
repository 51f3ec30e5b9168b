// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoNormalMapsFS.glsl: slot waves of water without normal maps.

vec2 waterMapSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance)
{
  return vec2(0.0);
}
