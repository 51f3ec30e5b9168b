// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyCubeFS.glsl: slot sky that is a cube map.

uniform samplerCube waterSkyCube;
uniform mat3 waterDirToMap;
uniform vec3 waterMapShown; // exponent of its colours, level of detail, brightest colour

vec3 waterOverFloor(vec3 dir, vec3 color); // of the slot floor

mat3 waterHalfToMap;
float waterCubeTexels; // a radian in the middle of a face

void waterReadSky()
{
  waterHalfToMap = 0.5 * waterDirToMap;
  waterCubeTexels = 0.5 * float(textureSize(waterSkyCube, 0).x);
}

vec2 waterSkyPlace(vec3 dir)
{
  return vec2(0.0);
}

vec3 waterSky(vec3 dir)
{
  float level = max(waterMapShown.y, log2(max(waterSpread * waterCubeTexels, 1.0)));
  vec3 color = textureLod(waterSkyCube, waterHalfToMap * dir, level).rgb;
  color = waterMapShown.x == 1.0 ? color : pow(max(color, vec3(0.0)), vec3(waterMapShown.x));
  return waterOverFloor(dir, min(color, vec3(waterMapShown.z)));
}

bool waterIsSkyKnown()
{
  return waterSkyBottom.a > 0.5;
}
