// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaFS.glsl: slot waves: the slopes of a wind sea from its tile; water_tile.c for the shader.

uniform sampler2D waterSea;   // vtkWaterSlopeTexture
uniform vec4 waterSeaTile;    // where under the eye, in tiles: x, y; tiles per m; half a texel
uniform vec2 waterSeaLeftOut; // slope variance of the waves that are too short for the tile

// As waterSlope of vtkWaterWavesFS.glsl.
vec2 waterSeaSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance)
{
  variance.xy += waterSeaLeftOut;
  return waterTileSlope(waterSea, waterSeaTile.xy + waterSeaTile.z * place + waterSeaTile.w,
    waterSeaTile.z * across, waterSeaTile.z * down, 2.0 * waterSeaTile.w, 1.0, variance);
}
