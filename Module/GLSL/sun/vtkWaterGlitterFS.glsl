// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGlitterFS.glsl: slot glitter: the sun in the slopes that a pixel does not resolve;
// water_glitter.c for the shader.

// The smallest variance of slopes: the sun is a disc of half a degree, and a pixel is not a point.
const float WATER_SUN_VARIANCE = 2e-5;

uniform int waterRollsOff; // 1: light brighter than white rolls off, because no pass maps tones afterwards

// What glitter adds to the surface's color.
//
// sun  light of the sun that arrives
// rgb  the surface's color without it
vec3 waterGlint(WaterPoint point, vec3 sun, vec3 rgb)
{
  vec3 facet = normalize(waterSunDir - point.ray);
  vec2 off = point.normal.xy / point.normal.z - facet.xy / facet.z;
  // what filters took counts, too: the sea has as many slopes from near as from afar
  float xx = point.variance.x + point.variance.z + WATER_SUN_VARIANCE;
  float yy = point.variance.y + point.variance.w + WATER_SUN_VARIANCE;
  float xy = waterSlopeVariance.z;
  float area = max(xx * yy - xy * xy, 1e-12);
  float density = waterSlopeDensity(xx, yy, xy, area, off.x, off.y);
  float facet4 = facet.z * facet.z * facet.z * facet.z;
  // a light of 1 is an irradiance of pi
  vec3 glint = 3.1415927 * sun * waterFresnel(dot(facet, waterSunDir), waterEta) * density
    / waterGlitterSpread(max(-point.ray.z, 1e-3), max(facet4, 1e-6));
  if (waterRollsOff != 0)
  {
    vec3 room = max(1.0 - rgb, 0.001);
    vec3 light = glint / room;
    glint = room * vec3(waterRollOff(light.r), waterRollOff(light.g), waterRollOff(light.b));
  }
  return waterSide > 0.0 ? glint : vec3(0.0); // from below there is none
}
