// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNormalMapsFS.glsl: slot waves: one or two normal maps that move over the water.

uniform sampler2D waterNormalMap0; // vtkWaterSlopeTexture
uniform sampler2D waterNormalMap1;
uniform vec4 waterNormalMapPlace0; // where under the eye, in maps: x, y; maps per m; strength
uniform vec4 waterNormalMapPlace1; // strength 0: there is no second one
uniform vec2 waterNormalMapTexels; // size of a texel, in maps

// As waterSlope of vtkWaterWavesFS.glsl.
vec2 waterMapSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance)
{
  vec4 first = waterNormalMapPlace0;
  vec4 second = waterNormalMapPlace1;
  return waterTileSlope(waterNormalMap0, first.xy + first.z * place, first.z * across,
           first.z * down, waterNormalMapTexels.x, first.w, variance) +
    waterTileSlope(waterNormalMap1, second.xy + second.z * place, second.z * across,
      second.z * down, waterNormalMapTexels.y, second.w, variance);
}
