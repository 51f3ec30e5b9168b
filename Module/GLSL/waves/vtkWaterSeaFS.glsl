// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaFS.glsl: slot waves: the slopes of a wind sea from its tiles; water_cascade.c for the shader.
//
// Of the tiles a pixel looks at those whose waves it resolves. The last of them has waves of about its size, which
// take all looks; of the others a texel is about a pixel, or many. As many looks for all pixels, at tiles that depend on
// the pixel, and no branch or loop: software renderers take longer for these than for a look.

uniform vec4 waterSeaBands[4]; // slope variance of the waves from a tile on: xx, yy; longest wave of that tile; xy
uniform vec3 waterSeaLeans;    // xy of a tile's own waves, of the sum of their xx and yy

const float WATER_SEA_FADES = 0.5; // a tile's waves are resolved while the longest are as long as a pixel, and fade from

vec3 waterSeaGains = vec3(1.0); // of the tiles' waves, where a current carries them
vec2 waterSeaPlace = vec2(0.0); // at rest: the last one that was asked for

struct WaterSeaTile
{
  vec4 place;  // of waterSeaTiles
  float layer;
  float part;  // of it that is seen
  vec3 hidden; // slope variance of what is not: xx, yy, xy
  float warp;  // 1: its places are warped
  float gain;  // of waterSeaGains
};

// Adds a tile's part.
//
// looks  as in waterTileMean
// warp   how far places are moved, and what that does to slopes
void waterAddTile(WaterSeaTile tile, int looks, vec2 place, vec2 across, vec2 down, vec2 warp, mat2 turn,
  inout vec2 slope, inout vec4 variance, inout vec3 bent)
{
  variance.xy += tile.hidden.xy;
  waterBoth += tile.hidden.z;
  if (!waterTileIsRead(tile.part))
  {
    return;
  }
  vec3 middle = vec3(tile.place.xy + tile.place.z * (place + tile.warp * warp) + tile.place.w, tile.layer);
  vec2 wide = tile.place.z * across;
  vec2 high = tile.place.z * down;
  vec4 within = vec4(0.0);
  vec2 own = waterTileSlope(waterSea, middle, wide, high, 2.0 * tile.place.w, looks, within);
  slope += tile.gain * tile.part * (own + tile.warp * (turn * own));
  float seen = tile.part * tile.part;
  variance += seen * within;
  float lean = tile.layer > 1.5 ? waterSeaLeans.z : tile.layer > 0.5 ? waterSeaLeans.y : waterSeaLeans.x;
  waterBoth += seen * lean * dot(within, vec4(1.0));
  bent += tile.gain * tile.part * waterSeaBend(waterSea, middle, wide, high, 2.0 * tile.place.w, looks);
}

// The tile that many places before the last one that a pixel resolves; part 0: there is none.
WaterSeaTile waterSeaTile(int last, int before)
{
  int i = last - before;
  // numbers known early: software renderers are slow with a place that is known late
  vec4 place = i == 2 ? waterSeaTiles[2] : i == 1 ? waterSeaTiles[1] : waterSeaTiles[0];
  return WaterSeaTile(place, float(max(i, 0)), i < 0 ? 0.0 : 1.0, vec3(0.0), i > 0 ? 1.0 : 0.0,
    waterSeaGains[max(i, 0)]);
}

// As waterSlope of vtkWaterWavesFS.glsl.
//
// bent  of the points' motion in the plane: d place / d rest is added, xx, xy, yy
vec2 waterSeaSlope(vec2 place, vec2 across, vec2 down, inout vec4 variance, inout vec3 bent)
{
  waterSeaPlace = place;
  float pixel = max(length(across), length(down));
  int last = 0;
  vec4 band = waterSeaBands[0];
  vec3 beyond = waterSeaBands[1].xyw;
  for (int i = 1; i < 3; ++i)
  {
    bool isResolved = i < waterSeaCount && pixel < waterSeaBands[i].z;
    last = isResolved ? i : last;
    band = isResolved ? waterSeaBands[i] : band;
    beyond = isResolved ? waterSeaBands[i + 1].xyw : beyond;
  }
  WaterSeaTile tile = waterSeaTile(last, 0);
  tile.part = 1.0 - smoothstep(WATER_SEA_FADES * band.z, band.z, pixel);
  tile.hidden = beyond + (1.0 - tile.part * tile.part) * (band.xyw - beyond);
  vec2 slope = vec2(0.0);
  mat2 turn;
  vec2 warp = waterSeaWarped(place, turn);
  waterAddTile(tile, WATER_TILE_LOOKS, place, across, down, warp, turn, slope, variance, bent);
  waterAddTile(waterSeaTile(last, 1), 1, place, across, down, warp, turn, slope, variance, bent);
  waterAddTile(waterSeaTile(last, 2), 1, place, across, down, warp, turn, slope, variance, bent);
  return slope;
}
