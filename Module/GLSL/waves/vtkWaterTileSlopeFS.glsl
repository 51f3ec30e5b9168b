// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTileSlopeFS.glsl: slot slope: the slope of a tile over a pixel, and the variance that is
// not seen there. The slot tile has waterTileMean.

// dz/dx and dz/dy.
//
// across, down  sides of the pixel, in tiles
// middle, texel, looks  as of waterTileMean
// variance      of the slopes within the pixel, and what the filter took, are added, as in WaterPoint
vec2 waterTileSlope(sampler2DArray tile, vec3 middle, vec2 across, vec2 down, float texel,
  int looks, inout vec4 variance)
{
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = isWide ? across : down;
  vec2 shorter = isWide ? down : across;
  vec4 seen = waterTileMean(tile, middle, longer, shorter, texel, looks);
  // Between texels the slope is linear, and the filtered squares exceed its square by the step^2 / 6
  // on average; a pixel that spans w texels has a variance of only (w step)^2 / 12.
  float texels = length(longer) / texel;
  float share = min(0.5 * texels * texels, 1.0);
  vec2 within = max(seen.zw - seen.xy * seen.xy, 0.0);
  variance += vec4(share * within, (1.0 - share) * within);
  return seen.xy;
}
