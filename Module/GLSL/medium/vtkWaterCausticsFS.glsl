// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCausticsFS.glsl: slot caustics: how waves gather the sun's light on what lies under them.
//
// A slope g turns a steep ray by (1 - 1/n) g, so that a point x of the surface sends its light to
// x + depth (1 - 1/n) g(x): where that reflection texture shrinks an area, the bed is as much brighter. Of several
// points that light the same place the one found first counts.

uniform float waterCaustics;      // strength, 0 to 1
uniform float waterCausticsWidth; // the least over which light is gathered, 1 mm

const float WATER_CAUSTIC_BLUR = 0.15; // the sun is a disc: no place is infinitely bright

vec2 waterCausticSlope(vec2 place, float width)
{
  vec4 variance = vec4(0.0);
  float jacobian;
  return waterAllSlopes(
    place, vec2(width, 0.0), vec2(0.0, width), vec3(0.0), variance, jacobian);
}

// Light on a place under water, over that of calm water.
float waterCaustic(vec2 place, float depth)
{
  vec3 down = refract(-waterSunDir, vec3(0.0, 0.0, 1.0), 1.0 / waterEta);
  vec2 source = place + depth * down.xy / min(down.z, -1e-3);
  float turn = depth * (1.0 - 1.0 / waterEta);
  float width = max(0.02 * depth, waterCausticsWidth);
  vec2 from = source;
  for (int i = 0; i < 2; ++i)
  {
    from = source - turn * waterCausticSlope(from, width);
  }
  vec2 slope = waterCausticSlope(from, width);
  vec2 bendX = turn / width * (waterCausticSlope(from + vec2(width, 0.0), width) - slope);
  vec2 bendY = turn / width * (waterCausticSlope(from + vec2(0.0, width), width) - slope);
  float area = (1.0 + bendX.x) * (1.0 + bendY.y) - bendX.y * bendY.x;
  float light = inversesqrt(area * area + WATER_CAUSTIC_BLUR * WATER_CAUSTIC_BLUR);
  return waterSunDir.z > 0.0 ? 1.0 + waterCaustics * (light - 1.0) : 1.0;
}
