// SPDX-License-Identifier: BSD-3-Clause
// water_cascade.h: a wind sea on several tiles of different lengths, each with a band of wave
// numbers, so that a picture has long and short waves, and the tiles do not repeat together.
//
// The bands follow each other without a gap: no wave is on two tiles, and variances add up. Each
// tile has its own random numbers. x and y are in the plane's own axes, all in metres. The tiles
// after the first are small compared with a picture. Their coordinates are warped, so that their
// waves do not return at regular distances. Source: Bruneton, Neyret and Holzschuch 2010,
// "Real-time Realistic Ocean Lighting using Seamless Transitions from Geometry to BRDF" (tiles of
// several lengths).
#ifndef water_cascade_h
#define water_cascade_h

#include "water_tile.h"
#include "water_waves.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_CASCADES_MAX = 3,
  WATER_CASCADE_WARPS = 4
};

// A wave that warps the coordinates of tiles: a row of parabolas, similar to a sine. It shifts them
// at right angles to its own direction, so areas do not change.
typedef struct water_cascade_warp
{
  double cycles[2]; // wave vector, cycles/m
  double way[2];    // how far it moves a place at most, m
} water_cascade_warp;

typedef struct water_cascades
{
  size_t count;
  water_tile tiles[WATER_CASCADES_MAX];          // from the longest waves to the shortest
  water_cascade_warp warps[WATER_CASCADE_WARPS]; // of the tiles after the first; 0 without one
} water_cascades;

// A suitable length of the first tile: water_tile_natural_length for a single tile; 24 wavelengths
// of the peak for several, because the other tiles hold the short waves. The sea then repeats only
// after more than 20 waves. At least 0.001 m.
double water_cascades_natural_length(const water_sea* sea, size_t count);

// Makes the tiles. The first is the given one, apart from its band; each further tile is shorter by
// the same factor. This factor is the smaller of two: the one with which a tile is 5 times as long
// as the longest waves of its band, and the one with which the last tile ends at 370 rad/m (1.7
// cm). If fewer tiles reach this limit, only these are made.
//
// first  its band is not read
// count  1 to WATER_CASCADES_MAX
//
// Returns WATER_OK, WATER_BAD_CASCADES, or as water_tile_check. On an error, made is unchanged.
water_status water_cascades_make(
  const water_tile* first, const water_sea* sea, size_t count, water_cascades* made);

// Shift of the coordinates of the tiles after the first, at a place, and its derivatives.
//
// moved  m
// turn   d moved[i] / d x is turn[i][0], d / d y turn[i][1]
void water_cascades_warped(
  const water_cascades* cascades, const double place[2], double moved[2], double turn[2][2]);

// A warp relative to a point: cycles per unit along x and y; cycles at the point, in [0, 1); and
// the factor from the wave vector, turned by 90 degrees, to the shift in units.
//
// metres_per_unit  of the scene
// origin           the point, in units
void water_cascades_warp_under(const water_cascades* cascades, size_t warp, double metres_per_unit,
  const double origin[2], double values[4]);

// Coordinates on a tile (given by its index), m, of a place of the sea, and the derivatives of the
// shift, with which water_cascades_turned converts the tile's slopes to the sea's.
void water_cascades_place(const water_cascades* cascades, size_t tile, const double place[2],
  double on_tile[2], double turn[2][2]);

// The sea's slope where the tile has the given slope.
void water_cascades_turned(double turn[2][2], double slope[2]);

// Slope variances, along and across the wind, of the waves from a tile on, up to 370 rad/m:
// beyond[i] of tile i and everything shorter, beyond[count] of the waves that are too short for all
// tiles.
//
// beyond  (count + 1) pairs, written
void water_cascades_slopes(
  const water_cascades* cascades, const water_sea* sea, double beyond[][2]);

// Such variances along the plane's axes: xx, yy and xy.
void water_cascades_turn(const water_sea* sea, const double along_wind[2], double along_axes[3]);

// Covariance xy of the slopes of a tile's own waves, of the sum of their variances along the axes.
// Short waves go in all directions, long ones with the wind: tiles differ.
//
// from, beyond  of the waves from the tile on, and from the next one on
double water_cascades_lean(const double from[3], const double beyond[3]);

// The longest waves that a tile holds of its band, m: as long as the tile for the first.
double water_cascades_longest(const water_cascades* cascades, size_t tile);

// The band of wave numbers in which a tile has slopes, rad/m: from the spectrum's peak, or where
// the tile begins, to where it ends. Without a peak from the first of these that the tile has.
void water_cascades_band(
  const water_cascades* cascades, const water_sea* sea, size_t tile, double band[2]);

// Variance of the height of all waves up to 370 rad/m, m^2; the variances of the two components of
// the chop add up to the same value.
double water_cascades_height(const water_sea* sea);

// How far such a sea moves a point: 6 standard deviations up or down, and this distance times the
// choppiness in the plane. One in 6e7 crests of a Gaussian sea is higher (exp(-18)); no code relies
// on there being none. Source: Longuet-Higgins 1952, "On the Statistical Distribution of the
// Heights of Sea Waves".
void water_cascades_reach(
  double height_variance, double choppiness, double* height, double* across);

// The fields of a tile at a time: size * size numbers each, the column fastest.
typedef struct water_cascade_fields
{
  const double* height;
  const double* slope[2];
  const double* chop[2];
  const double* bend[3]; // xx, yy, xy of the chop's derivatives
} water_cascade_fields;

// A sea for water_waves_find: what its context points to.
typedef struct water_cascade_surface
{
  const water_cascades* cascades;
  const water_cascade_fields* fields; // of each tile
  double choppiness;                  // share of the horizontal displacement, in [0, 1]
  double units_per_m;                 // of the scene that places and heights are in
} water_cascade_surface;

// The sea at a place at rest, added to a sum: a water_waves_add.
bool water_cascades_add(const void* surface, double x, double y, water_wave_sum* sum);

#ifdef __cplusplus
}
#endif
#endif
