// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFlowFS.glsl: slot flow of water without a current.

uniform float waterFootprint; // share of the pixel's sides that slopes are means over; 0: those of the pixel's middle

vec2 waterAllSlopes(vec2 place, vec2 across, vec2 down, vec3 ray, inout vec4 variance, out float jacobian);

vec2 waterFlowingSlopes(WaterPoint point, vec3 ray, inout vec4 variance, out float jacobian)
{
  return waterAllSlopes(
    point.place, waterFootprint * point.across, waterFootprint * point.down, ray, variance, jacobian);
}
