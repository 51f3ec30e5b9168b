// SPDX-License-Identifier: BSD-3-Clause
// water_old_foam.h: the foam that crests of a wind sea have left behind, as a function of time.
//
// A crest is white while it breaks. Its foam stays at its place on the water, and decays. The foam
// at a place and a time is therefore the maximum, over earlier times, of the foam that broke there
// then, times exp(-age / lifetime). Earlier times are multiples of a step, so all pictures use the
// same ones, and nothing is carried over from picture to picture. Only the sea's first tile leaves
// foam, because the foam of large breakers lasts longest; its places are at rest.
//
// Flow: water_old_foam_make once for a sea -> water_old_foam_at for each time -> the tile's stretch
// at each of the earlier times -> water_old_foam_shares -> water_old_foam_join -> a texture.
// Sources: Callaghan, Deane, Stokes and Ward 2012, "Observed Variation in the Decay Time of Oceanic
// Whitecap Foam" (exponential decay, 0.5 to 8 s); Rice 1945, "Mathematical Analysis of Random
// Noise" (how often a Gaussian process crosses a level).
#ifndef water_old_foam_h
#define water_old_foam_h

#include "water_tile.h"

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_FOAM_LIFE_MAX 10.0 // s, of the lifetime

enum
{
  WATER_OLD_FOAM_TIMES_MAX = 48, // earlier times, at most
  WATER_OLD_FOAM_SIZE_MAX = 256  // points along the tile, at most
};

typedef struct water_old_foam
{
  size_t count;    // earlier times that leave foam; 0: there is none
  double life_s;   // after which a share 1 / e of the foam is left
  double step_s;   // between earlier times
  double jacobian; // the Jacobian to first order under which a crest of the tile leaves foam
  double fresh;    // share of the sea that is breaking, without what it left
  water_tile tile; // that leaves it: the sea's first one, with fewer points if it has many
} water_old_foam;

// The foam of a sea. Together with the breaking crests it covers the given share of the sea on
// average.
//
// first   tile of the sea
// cover   in [0, 1]; without waves on the tile, and for 0 and 1, there is no old foam
// life_s  in [0, WATER_FOAM_LIFE_MAX]; 0: no old foam
//
// Returns WATER_OK, WATER_BAD_LIFE_TIME, or as water_tile_check. On an error, made is unchanged.
water_status water_old_foam_make(
  const water_sea* sea, const water_tile* first, double cover, double life_s, water_old_foam* made);

// Are two of them the same?
bool water_old_foam_is_same(const water_old_foam* a, const water_old_foam* b);

// The number of the newest of the earlier times, and the weights of the three numbers of a place
// (water_old_foam_join) at a time. The weights are continuous in time: new foam is faded in, and
// the oldest faded out, over a step.
//
// time  s, finite
void water_old_foam_at(const water_old_foam* foam, double time, double* newest, double weights[3]);

// An earlier time, s.
double water_old_foam_time(const water_old_foam* foam, double number);

// The foam that breaking crests leave at an earlier time.
//
// stretch_x, stretch_y  of the tile then (WATER_PAIR_STRETCH), tile.size^2 numbers
// shares                as many, in 1/255, written
void water_old_foam_shares(const water_old_foam* foam, const double* stretch_x,
  const double* stretch_y, unsigned char* shares);

// The foam at the newest of the earlier times, as three numbers: what is left of all times except
// the newest and the oldest; what the newest adds; what the oldest adds.
//
// shares  of count earlier times, from the newest to the oldest
// texels  4 tile.size^2 numbers, written; the last of each four is 0
void water_old_foam_join(
  const water_old_foam* foam, const unsigned char* const* shares, float* texels);

#ifdef __cplusplus
}
#endif
#endif
