// SPDX-License-Identifier: BSD-3-Clause
// water_cascade.h: a wind sea on several tiles of different lengths, each with a band of its wave
// numbers, so that a picture has long waves and short ones, and no tile's repetition is that of
// all.
//
// The bands follow each other without a gap: no wave is on two tiles, and variances add up. Each
// tile has its own random numbers. x and y are in the plane's own axes, all in metres.
// The tiles after the first are short against a picture: their places are warped, so that the same
// waves do not come back in the same places from tile to tile.
// Source: Bruneton, Neyret and Holzschuch 2010, "Real-time Realistic Ocean Lighting using Seamless
// Transitions from Geometry to BRDF" (tiles of several lengths).
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

// A wave by which the places of tiles are warped: a row of parabolas, which nears a sine. It moves
// them across its own direction, so that areas stay as they are.
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

// A length of the first tile that shows a sea well: water_tile_natural_length for one tile; 24
// wavelengths of the peak for more of them, as the short waves are on the others, so that what
// repeats is farther apart than 20 waves. At least 0.001 m.
double water_cascades_natural_length(const water_sea* sea, size_t count);

// The tiles. The first is the given one, up to its band; each other one is shorter by the same
// factor, which is the smaller of that which leaves the longest waves of a band 5 times along its
// tile, and that with which the last tile ends at 370 rad/m (1.7 cm). Where fewer tiles get there,
// there are fewer.
//
// first  its band is not read
// count  1 to WATER_CASCADES_MAX
//
// Returns WATER_OK, WATER_BAD_CASCADES, or as water_tile_check; then made is unchanged.
water_status water_cascades_make(
  const water_tile* first, const water_sea* sea, size_t count, water_cascades* made);

// How far the places of the tiles after the first are moved at a place, and the derivatives of
// that.
//
// moved  m
// turn   d moved[i] / d x is turn[i][0], d / d y turn[i][1]
void water_cascades_warped(
  const water_cascades* cascades, const double place[2], double moved[2], double turn[2][2]);

// A warp about a point: cycles per unit along x and y, cycles at the point, in [0, 1), and the
// factor of the wave vector, turned by 90 degrees, to its way in units.
//
// metres_per_unit  of the scene
// origin           the point, in units
void water_cascades_warp_under(const water_cascades* cascades, size_t warp, double metres_per_unit,
  const double origin[2], double values[4]);

// Where on a tile (by its index) a place of the sea is, m, and the derivatives of its way there:
// slopes of the sea are those of the tile and their changes by turn (water_cascades_turned).
void water_cascades_place(const water_cascades* cascades, size_t tile, const double place[2],
  double on_tile[2], double turn[2][2]);

// The slope that the sea has where a tile has the given one.
void water_cascades_turned(double turn[2][2], double slope[2]);

// Slope variances along the wind and across it of the waves from a tile on, those that are too
// short for all included, up to 370 rad/m: beyond[i] of tile i and all after it, beyond[count] of
// what none has.
//
// beyond  (count + 1) pairs, written
void water_cascades_slopes(
  const water_cascades* cascades, const water_sea* sea, double beyond[][2]);

// Such variances along the plane's axes.
void water_cascades_turn(const water_sea* sea, const double along_wind[2], double along_axes[2]);

// The longest waves that a tile holds of its band, m: as long as the tile for the first.
double water_cascades_longest(const water_cascades* cascades, size_t tile);

// The band of wave numbers in which a tile has slopes, rad/m: from the spectrum's peak, or where
// the tile begins, to where it ends. Without a peak from the first of these that the tile has.
void water_cascades_band(
  const water_cascades* cascades, const water_sea* sea, size_t tile, double band[2]);

// Variance of the height of all waves up to 370 rad/m, m^2; that of the chop's two parts together
// is the same.
double water_cascades_height(const water_sea* sea);

// How far such a sea moves a point: 6 standard deviations up or down, and as many times the
// choppiness in the plane. Of a Gaussian sea's crests one in 6e7 is higher (exp(-18)): nothing
// relies on there being none.
// Source: Longuet-Higgins 1952, "On the Statistical Distribution of the Heights of Sea Waves".
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
