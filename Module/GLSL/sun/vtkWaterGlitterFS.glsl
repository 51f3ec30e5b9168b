// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGlitterFS.glsl: slot glitter: the sun in the slopes that a pixel does not resolve;
// water_glitter.c for the shader.

// The smallest variance of slopes: the sun is a disc of half a degree, and a pixel is not a point.
const float WATER_SUN_VARIANCE = 2e-5;

uniform vec3 waterAllVariance;  // xx, yy, xy of all slopes
uniform float waterSunHidden;   // water_glitter_hidden of the sun
uniform int waterWavesAreDrawn; // 1: waves displace the surface
uniform int waterRollsOff;      // 1: light brighter than white rolls off, because no pass maps tones afterwards

// Area of the pixel's facets that the eye and the sun see, over their area on the plane. A surface that lies in its plane
// hides nothing of itself: all of its waves count. Of a displaced one those do that the pixel does not resolve.
//
// within  variances of these
float waterGlitterSeen(WaterPoint point, vec3 within)
{
  bool isDrawn = waterWavesAreDrawn != 0;
  vec2 slope = isDrawn ? -point.normal.xy / point.normal.z : point.tilt;
  vec3 hidden = isDrawn ? within : max(waterAllVariance, vec3(within.xy, -1e30));
  vec2 way = point.ray.xy;
  float along = hidden.x * way.x * way.x + 2.0 * hidden.z * way.x * way.y + hidden.y * way.y * way.y;
  float cosine = dot(slope, way) - point.ray.z;
  float seen = waterFacingArea(cosine, sqrt(max(along, 1e-12)));
  return max(seen + max(cosine, 0.0) * waterSunHidden, 1e-3);
}

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
  float xy = point.both;
  float area = max(xx * yy - xy * xy, 1e-12);
  float density = waterSlopeDensity(xx, yy, xy, area, off.x, off.y);
  float facet4 = facet.z * facet.z * facet.z * facet.z;
  // a light of 1 is an irradiance of pi
  vec3 glint = 3.1415927 * sun * waterFresnel(dot(facet, waterSunDir), waterEta) * density
    / waterGlitterSpread(waterGlitterSeen(point, vec3(xx, yy, xy)), max(facet4, 1e-6));
  if (waterRollsOff != 0)
  {
    vec3 room = max(1.0 - rgb, 0.001);
    vec3 light = glint / room;
    glint = room * vec3(waterRollOff(light.r), waterRollOff(light.g), waterRollOff(light.b));
  }
  return waterSide > 0.0 ? glint : vec3(0.0); // from below there is none
}
