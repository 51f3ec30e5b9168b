// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaTiles.glsl: the tiles of a wind sea (water_cascade.h); for both shaders.

uniform sampler2DArray waterSea; // vtkWaterSea: slopes of the tiles; their bends (xx, yy, xy); what they move points by
uniform int waterSeaCount;       // tiles, from the longest waves to the shortest
uniform vec4 waterSeaTiles[3];   // where under the eye, in tiles: x, y; tiles per m; half a texel
uniform vec4 waterSeaWarps[4];   // wave vector, cycles/unit; cycles under the eye; from that vector across it to its way

// How far the places of the tiles after the first are moved: water_cascades_warped for the shader.
//
// turn  from slopes on a tile to their change by that
vec2 waterSeaWarped(vec2 place, out mat2 turn)
{
  vec2 moved = vec2(0.0);
  turn = mat2(0.0);
  for (int i = 0; i < 4; ++i)
  {
    vec2 cycles = waterSeaWarps[i].xy;
    vec2 way = waterSeaWarps[i].w * vec2(-cycles.y, cycles.x);
    float part = fract(dot(cycles, place) + waterSeaWarps[i].z) - 0.5;
    moved += 8.0 * part * (1.0 - 2.0 * abs(part)) * way;
    turn += (8.0 - 32.0 * abs(part)) * outerProduct(cycles, way);
  }
  return moved;
}
