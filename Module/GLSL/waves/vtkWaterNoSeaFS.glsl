// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSeaFS.glsl: slot waves of water without a wind sea.

vec3 waterSeaGains = vec3(1.0); // of a sea

vec2 waterSeaSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance, inout vec3 bent)
{
  return vec2(0.0);
}
