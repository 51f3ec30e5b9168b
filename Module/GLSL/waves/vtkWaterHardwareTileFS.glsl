// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareTileFS.glsl: slot tile for hardware: as vtkWaterTileFS.glsl, with fewer looks where a pixel is
// small against a texel, and no gradients where these ask for the finest level: hardware filters four numbers of 32
// bits several times as slowly as it reads a depth.

const float WATER_TILE_ONE = 0.05; // up to so many texels along the longer side one look is the mean of four,
const float WATER_TILE_TWO = 0.3;   // and up to so many two: between texels the slope is linear

// The mean of four looks along the pixel's longer side.
vec4 waterTileFour(sampler2D tile, vec2 middle, vec2 longer, vec2 shorter, bool isFine)
{
  vec2 inner = 0.125 * longer;
  vec2 outer = 0.375 * longer;
  if (isFine)
  {
    return 0.25 * (textureLod(tile, middle - outer, 0.0) + textureLod(tile, middle - inner, 0.0) +
      textureLod(tile, middle + inner, 0.0) + textureLod(tile, middle + outer, 0.0));
  }
  vec2 part = 0.25 * longer;
  return 0.25 * (textureGrad(tile, middle - outer, part, shorter) + textureGrad(tile, middle - inner, part, shorter) +
    textureGrad(tile, middle + inner, part, shorter) + textureGrad(tile, middle + outer, part, shorter));
}

// As in vtkWaterTileFS.glsl.
vec2 waterTileSlope(sampler2D tile, vec2 middle, vec2 across, vec2 down, float texel,
  float strength, inout vec4 variance)
{
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = isWide ? across : down;
  vec2 shorter = isWide ? down : across;
  float texels = length(longer) / texel;
  vec4 seen;
  if (texels < WATER_TILE_ONE)
  {
    seen = textureLod(tile, middle, 0.0);
  }
  else if (texels < WATER_TILE_TWO)
  {
    seen = 0.5 * (textureLod(tile, middle - 0.2795085 * longer, 0.0) + textureLod(tile, middle + 0.2795085 * longer, 0.0));
  }
  else
  {
    seen = waterTileFour(tile, middle, longer, shorter, max(0.25 * texels, length(shorter) / texel) < 1.0);
  }
  // as there
  float share = min(0.5 * texels * texels, 1.0);
  vec2 within = strength * strength * max(seen.zw - seen.xy * seen.xy, 0.0);
  variance += vec4(share * within, (1.0 - share) * within);
  return strength * seen.xy;
}
