// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyViewFS.glsl: slot sky of meshes that may be the sky, in a view of their own (water_sky_view.h).

uniform sampler2D waterSkyView;
uniform sampler2D waterSkyViewDepth;
uniform mat3 waterDirToSkyView; // direction in the plane's axes -> x, y and w of its clip space
uniform vec3 waterSkyViewAt;    // where it is from, in the plane's axes, from the point under the eye
uniform vec2 waterSkyViewNear;  // 1 / w is its depth times x, plus y

const int WATER_SKY_SPHERES = 3;

float waterSkyViewTexels; // a radian in its middle
float waterSkyWay = 0.0;  // along the last ray, to what it meets

void waterReadSky()
{
  waterSkyViewTexels = 0.36 * float(textureSize(waterSkyView, 0).x); // 2.75 to a side: water_sky_view.c
}

// Where a direction from the view's own place is in it: outside of it at its border.
vec2 waterSkyViewPlace(vec3 dir)
{
  vec3 seen = waterDirToSkyView * dir;
  return clamp(0.5 + 0.5 * seen.xy / max(seen.z, 1e-6), 0.0, 1.0);
}

vec3 waterDrawn(vec4 texel, vec3 background); // of the slot dome

vec2 waterSkyPlace(vec3 dir)
{
  return vec2(0.0);
}

vec3 waterSky(vec3 dir)
{
  vec3 from = waterFrom - waterSkyViewAt;
  float ahead = dot(from, dir);
  float rest = dot(from, from);
  vec3 way = dir; // from the view's place to what the ray meets: first as if that were infinitely far
  for (int i = 0; i < WATER_SKY_SPHERES; ++i)
  {
    float depth = textureLod(waterSkyViewDepth, waterSkyViewPlace(way), 0.0).r;
    float perW = waterSkyViewNear.x * min(depth, 1.0) + waterSkyViewNear.y;
    float radius = length(way) / max(perW * (waterDirToSkyView * way).z, 1e-20);
    float met = sqrt(max(ahead * ahead - rest + radius * radius, 0.0)) - ahead;
    waterSkyWay = max(met, 0.0);
    way = from + waterSkyWay * dir;
  }
  float level = log2(max(waterSpread * waterSkyViewTexels, 1.0));
  return waterDrawn(textureLod(waterSkyView, waterSkyViewPlace(way), level), waterSkyBottom.rgb);
}

bool waterIsSkyKnown()
{
  return true;
}
