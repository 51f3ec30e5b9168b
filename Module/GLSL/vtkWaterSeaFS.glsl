// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaFS.glsl: stage waves: the slopes of a wind sea from its tile; water_tile.c for the shader.
//
// Mip levels average slopes and their squares alike: what a pixel does not resolve is left as
// variance.

uniform sampler2D waterSea;    // slope x, slope y and their squares; repeats, with mip levels
uniform vec4 waterSeaTile;     // where under the eye, in tiles: x, y; tiles per m; half a texel
uniform vec2 waterSeaLeftOut;  // slope variance of the waves that are too short for the tile

const int WATER_SEA_LOOKS = 4; // along the pixel's longer side: the anisotropy

// As waterSlope of vtkWaterWavesFS.glsl. GL's own anisotropic filter is not used: Mesa's software
// renderer needs minutes for it.
vec2 waterSeaSlope(vec2 place, vec2 across, vec2 down, inout vec2 variance)
{
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = waterSeaTile.z * (isWide ? across : down);
  vec2 shorter = waterSeaTile.z * (isWide ? down : across);
  vec2 middle = waterSeaTile.xy + waterSeaTile.z * place + waterSeaTile.w;
  vec4 seen = vec4(0.0);
  for (int i = 0; i < WATER_SEA_LOOKS; ++i)
  {
    float along = (float(i) + 0.5) / float(WATER_SEA_LOOKS) - 0.5;
    seen += textureGrad(waterSea, middle + along * longer, longer / float(WATER_SEA_LOOKS), shorter);
  }
  seen /= float(WATER_SEA_LOOKS);
  // Between texels the slope is linear, and the filtered squares exceed its square by the step^2 / 6
  // on average; a pixel that spans w texels has a variance of only (w step)^2 / 12.
  float texels = 0.5 * length(longer) / waterSeaTile.w;
  float share = min(0.5 * texels * texels, 1.0);
  variance += share * max(seen.zw - seen.xy * seen.xy, 0.0) + waterSeaLeftOut;
  return seen.xy;
}
