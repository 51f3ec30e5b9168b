// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNormalMapsFS.glsl: slot waves: one or two normal maps that move over the water.

uniform sampler2DArray waterNormalMap0; // vtkWaterSlopeTexture
uniform sampler2DArray waterNormalMap1;
uniform vec4 waterNormalMapPlace0; // where under the eye, in maps: x, y; maps per m; strength
uniform vec4 waterNormalMapPlace1; // strength 0: there is no second one
uniform vec2 waterNormalMapTexels; // size of a texel, in maps

// One of them.
vec2 waterMapSlope(sampler2DArray map, vec4 moved, float texel, vec2 place, vec2 across, vec2 down,
  inout vec4 variance)
{
  vec4 within = vec4(0.0);
  vec2 slope = waterTileSlope(map, vec3(moved.xy + moved.z * place, 0.0), moved.z * across,
    moved.z * down, texel, WATER_TILE_LOOKS, within);
  variance += moved.w * moved.w * within;
  return moved.w * slope;
}

// As waterSlope of vtkWaterWavesFS.glsl.
vec2 waterMapSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance)
{
  return waterMapSlope(waterNormalMap0, waterNormalMapPlace0, waterNormalMapTexels.x, place, across, down, variance) +
    waterMapSlope(waterNormalMap1, waterNormalMapPlace1, waterNormalMapTexels.y, place, across, down, variance);
}
