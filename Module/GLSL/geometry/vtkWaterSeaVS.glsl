// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaVS.glsl: how far a wind sea moves a vertex: water_cascades_add for the shader, without what the grid
// cannot hold.

uniform vec2 waterSeaMove; // units per m of the sea in the plane, the choppiness in it, and along the normal

// Texels of the level that is read, to a cell: short waves fade where a wave has fewer than some four cells, as in
// waterKept.
const float WATER_SEA_CELL = 1.0;

// The tile of level 0 between texels. GPUs filter with fractions of 8 bits: a height would be off by up to 4e-4 of the
// waves' height.
//
// at  in tiles, and the layer
vec3 waterSeaBetween(vec3 at)
{
  ivec2 size = textureSize(waterSea, 0).xy;
  vec2 texel = fract(at.xy) * vec2(size) - 0.5;
  vec2 first = floor(texel);
  vec2 part = texel - first;
  int layer = int(at.z);
  ivec2 low = (ivec2(first) + size) % size;
  ivec2 high = (low + 1) % size;
  vec3 below = mix(texelFetch(waterSea, ivec3(low, layer), 0).xyz, texelFetch(waterSea, ivec3(high.x, low.y, layer), 0).xyz, part.x);
  vec3 above = mix(texelFetch(waterSea, ivec3(low.x, high.y, layer), 0).xyz, texelFetch(waterSea, ivec3(high, layer), 0).xyz, part.x);
  return mix(below, above, part.y);
}

// In the plane's axes, the third up.
//
// cell  as in waterKept
vec3 waterSeaMoved(vec2 place, vec2 cell)
{
  vec3 moved = vec3(0.0);
  mat2 turn;
  vec2 warp = waterSeaWarped(place, turn);
  for (int i = 0; i < waterSeaCount; ++i)
  {
    vec4 tile = waterSeaTiles[i];
    float texels = WATER_SEA_CELL * max(cell.x, cell.y) * tile.z / (2.0 * tile.w);
    vec3 at = vec3(tile.xy + tile.z * (i > 0 ? place + warp : place) + tile.w, float(2 * waterSeaCount + i));
    if (texels > 1.0)
    {
      moved += textureLod(waterSea, at, log2(texels)).xyz; // the last level, their mean, is 0
    }
    else
    {
      moved += waterSeaBetween(at);
    }
  }
  return moved * waterSeaMove.xxy;
}
