// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaVS.glsl: how far a wind sea moves a vertex: water_cascades_add for the shader, without what the grid
// cannot hold.

uniform vec2 waterSeaMove; // units per m of the sea in the plane, the choppiness in it, and along the normal

// Texels of the level that is read, to a cell: short waves fade where a wave has fewer than some four cells, as in
// waterKept.
const float WATER_SEA_CELL = 1.0;

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
    moved += textureLod(waterSea, at, log2(max(texels, 1.0))).xyz; // the last level, their mean, is 0
  }
  return moved * waterSeaMove.xxy;
}
