// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyMapFS.glsl: slot sky that is a picture in longitude and latitude, as vtkSkybox has it. Its level of detail is
// given: the longitude jumps where the picture's sides meet, and derivatives would see a seam there.

uniform sampler2D waterSkyMap;
uniform mat3 waterDirToMap;    // direction in the plane's axes -> right, up, back of the picture
uniform vec2 waterMapLatitude; // v is latitude / pi times x, plus y
uniform vec3 waterMapShown;    // exponent of its colours, level of detail, brightest colour

vec3 waterOverFloor(vec3 dir, vec3 color); // of the slot floor

mat3 waterHalfToMap;
vec4 waterMapTexels; // width, height, both ends of the picture's v

void waterReadSky()
{
  waterHalfToMap = 0.5 * waterDirToMap;
  waterMapTexels.xy = vec2(textureSize(waterSkyMap, 0));
  waterMapTexels.zw = waterMapLatitude.y + vec2(-0.5, 0.5) * waterMapLatitude.x;
}

vec2 waterSkyPlace(vec3 dir)
{
  vec3 around = waterHalfToMap * dir;
  return vec2(0.5 + 0.15915494 * atan(around.z, around.x),
    waterMapLatitude.y + waterMapLatitude.x * 0.31830989 * atan(around.y, length(around.xz)));
}

vec3 waterSky(vec3 dir)
{
  vec2 place = waterSkyPlace(dir);
  // texels that represent the spread; at a coarser level, half of the last texel at a pole belongs
  // to the other pole
  float level = log2(max(0.31830989 * waterSpread * waterMapLatitude.x * waterMapTexels.y, 1.0));
  float border = level > 0.0 ? (exp2(ceil(level)) - 0.5) / waterMapTexels.y : 0.0; // drivers round levels up
  place.y = clamp(place.y, waterMapTexels.z + border, waterMapTexels.w - border);
  vec3 color = textureLod(waterSkyMap, place, max(waterMapShown.y, level)).rgb;
  color = waterMapShown.x == 1.0 ? color : pow(max(color, vec3(0.0)), vec3(waterMapShown.x));
  return waterOverFloor(dir, min(color, vec3(waterMapShown.z)));
}

bool waterIsSkyKnown()
{
  return waterSkyBottom.a > 0.5;
}
