// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTileFS.glsl: slopes from a tile that repeats (vtkWaterSlopeTexture): mip levels average
// slopes and their squares alike, and what a pixel does not resolve is left as variance.

const int WATER_TILE_LOOKS = 4; // along the pixel's longer side: the anisotropy

// dz/dx and dz/dy.
//
// middle        of the pixel, in tiles; across and down its sides
// texel         size of one, in tiles
// strength      factor of the slopes
// variance      of the slopes within the pixel, and what the filter took, are added, as in WaterPoint
vec2 waterTileSlope(sampler2D tile, vec2 middle, vec2 across, vec2 down, float texel,
  float strength, inout vec4 variance)
{
  // GL's own anisotropic filter is not used: Mesa's software renderer needs minutes for it
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = isWide ? across : down;
  vec2 shorter = isWide ? down : across;
  vec4 seen = vec4(0.0);
  for (int i = 0; i < WATER_TILE_LOOKS; ++i)
  {
    float along = (float(i) + 0.5) / float(WATER_TILE_LOOKS) - 0.5;
    seen += textureGrad(tile, middle + along * longer, longer / float(WATER_TILE_LOOKS), shorter);
  }
  seen /= float(WATER_TILE_LOOKS);
  // Between texels the slope is linear, and the filtered squares exceed its square by the step^2 / 6
  // on average; a pixel that spans w texels has a variance of only (w step)^2 / 12.
  float texels = length(longer) / texel;
  float share = min(0.5 * texels * texels, 1.0);
  vec2 within = strength * strength * max(seen.zw - seen.xy * seen.xy, 0.0);
  variance += vec4(share * within, (1.0 - share) * within);
  return strength * seen.xy;
}
