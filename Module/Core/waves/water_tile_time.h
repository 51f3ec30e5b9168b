// SPDX-License-Identifier: BSD-3-Clause
// water_tile_time.h: a tile's spectra at successive times. Values that do not depend on the time
// are computed once, and half of the wave vectors determine the other half, because the fields are
// real.
//
// A quadrant has (size / 2)^2 places, for waves that the tile holds i and j times along its sides,
// i fastest: (i, j), (-i, j), (i, -j) and (-i, -j) turn alike.
// Flow: water_tile_frequencies once -> water_tile_phasors for each time -> water_tile_pair_row,
// which gives heights and slopes to the bit as water_tile_at, water_tile_derive and
// water_tile_pack do. Rows are independent of each other: several threads can share them.
#ifndef water_tile_time_h
#define water_tile_time_h

#include "water_tile.h"

#ifdef __cplusplus
extern "C"
{
#endif

// The frequencies of a quadrant (water_tile_frequency).
//
// frequencies  (size / 2)^2 numbers, written
//
// Returns as water_tile_check. On an error, frequencies are unchanged.
water_status water_tile_frequencies(
  const water_tile* tile, const water_sea* sea, double* frequencies);

// Cosine and sine of a quadrant's phases. The frequency of (i, j) is that of (j, i), too: row j
// computes those with i >= j, and writes them at both places. The tile is a checked one, the time
// finite.
//
// first, end  rows, up to size / 2; the quadrant is whole when all have been asked for
// phasors     2 (size / 2)^2 numbers
void water_tile_phasors(const water_tile* tile, const double* frequencies, double time,
  size_t first, size_t end, double* phasors);

// Two real fields that one FFT makes: the first, and i times the second (water_tile_pack).
typedef enum water_tile_pair
{
  WATER_PAIR_SLOPES,       // along x and y
  WATER_PAIR_HEIGHT,       // and 0
  WATER_PAIR_CHOP,         // along x and y
  WATER_PAIR_STRETCH,      // of the chop: d chop_x / dx and d chop_y / dy
  WATER_PAIR_SHEAR,        // of the chop: d chop_x / dy, and 0
  WATER_PAIR_HEIGHT_SHEAR, // height, and that
  WATER_PAIR_COUNT
} water_tile_pair;

// Two rows of the spectrum whose forward FFT is a pair. Row size / 2 is never requested: it is 0.
//
// phasors  whole
// row      below size / 2
// own      row `row`, 2 * size numbers, written
// mirror   row size - row, 2 * size numbers, written except for row 0, which has none
void water_tile_pair_row(const water_tile* tile, const double* amplitudes, const double* phasors,
  water_tile_pair pair, size_t row, double* own, double* mirror);

// The spectrum of water_tile_pair_row, all rows, for any time: cos E + sin F, of the wave's phase.
//
// waves  4 * size * size numbers, written: E (real, imaginary), F
void water_tile_pair_waves(
  const water_tile* tile, const double* amplitudes, water_tile_pair pair, float* waves);

#ifdef __cplusplus
}
#endif
#endif
