// SPDX-License-Identifier: BSD-3-Clause
// water_tile_time.c: a tile's spectra at one time after another.
#include "water_tile_time.h"

#include "water_math.h"
#include "water_phase.h"

water_status water_tile_frequencies(
  const water_tile* tile, const water_sea* sea, double* frequencies)
{
  const water_status status = water_tile_check(tile, sea);
  const size_t half = tile->size / 2;
  for (size_t row = 0; row < half && status == WATER_OK; ++row)
  {
    for (size_t column = row; column < half; ++column)
    {
      const double frequency = water_tile_frequency(tile, sea, column, row);
      frequencies[row * half + column] = frequency;
      frequencies[column * half + row] = frequency;
    }
  }
  return status;
}

void water_tile_phasors(const water_tile* tile, const double* frequencies, double time,
  size_t first, size_t end, double* phasors)
{
  const size_t half = tile->size / 2;
  const double clock = water_tile_clock(tile, time);
  for (size_t row = first; row < end; ++row)
  {
    for (size_t column = row; column < half; ++column)
    {
      const double angle = water_two_pi * water_turns(frequencies[row * half + column], clock);
      double* own = phasors + 2 * (row * half + column);
      double* other = phasors + 2 * (column * half + row);
      own[0] = other[0] = cos(angle);
      own[1] = other[1] = sin(angle);
    }
  }
}

typedef struct wave // a wave vector and its opposite
{
  double k[2];       // rad/m
  const double* own; // their amplitudes
  const double* other;
} wave;

// Of -k, for an index of k: no division, which all else together does not take as long as.
static size_t mirrored(size_t n, size_t index)
{
  return index > 0 ? n - index : 0;
}

static wave wave_of(const water_tile* tile, const double* amplitudes, size_t column, size_t row)
{
  const size_t n = tile->size;
  const size_t partner = mirrored(n, row) * n + mirrored(n, column);
  const int number[2] = { column < n / 2 ? (int)column : (int)column - (int)n,
    row < n / 2 ? (int)row : (int)row - (int)n };
  const wave made = { { water_two_pi * number[0] / tile->length,
                        water_two_pi * number[1] / tile->length },
    amplitudes + 2 * (row * n + column), amplitudes + 2 * partner };
  return made;
}

// What a wave's height (water_tile_at) becomes in a packed spectrum, at its place and at its
// opposite's.
typedef void packing(const wave* w, const double height[2], double at[2], double opposite[2]);

// conj(i kx h) + i conj(i ky h) = (ky - i kx) conj(h)
static void pack_slopes(const wave* w, const double height[2], double at[2], double opposite[2])
{
  at[0] = w->k[1] * height[0] - w->k[0] * height[1];
  at[1] = -w->k[1] * height[1] - w->k[0] * height[0];
  opposite[0] = -w->k[1] * height[0] - w->k[0] * height[1];
  opposite[1] = w->k[0] * height[0] - w->k[1] * height[1];
}

static void pack_height(const wave* w, const double height[2], double at[2], double opposite[2])
{
  (void)w;
  at[0] = opposite[0] = height[0];
  at[1] = -height[1];
  opposite[1] = height[1];
}

// 1 / |k|; the mean has no amplitude, whatever this is.
static double wavelength_of(const wave* w)
{
  const double square = w->k[0] * w->k[0] + w->k[1] * w->k[1];
  return square > 0.0 ? 1.0 / sqrt(square) : 0.0;
}

static void pack_chop(const wave* w, const double height[2], double at[2], double opposite[2])
{
  const double per_k = wavelength_of(w);
  const wave unit = { { per_k * w->k[0], per_k * w->k[1] }, w->own, w->other };
  pack_slopes(&unit, height, at, opposite);
}

// (first + i second) conj(h), for fields that are real multiples of the height's spectrum
static void pack_even(
  double first, double second, const double height[2], double at[2], double opposite[2])
{
  at[0] = first * height[0] + second * height[1];
  at[1] = second * height[0] - first * height[1];
  opposite[0] = first * height[0] - second * height[1];
  opposite[1] = second * height[0] + first * height[1];
}

static void pack_stretch(const wave* w, const double height[2], double at[2], double opposite[2])
{
  const double per_k = -wavelength_of(w);
  pack_even(per_k * w->k[0] * w->k[0], per_k * w->k[1] * w->k[1], height, at, opposite);
}

static void pack_shear(const wave* w, const double height[2], double at[2], double opposite[2])
{
  pack_even(-wavelength_of(w) * w->k[0] * w->k[1], 0.0, height, at, opposite);
}

static void pack_height_shear(
  const wave* w, const double height[2], double at[2], double opposite[2])
{
  pack_even(1.0, -wavelength_of(w) * w->k[0] * w->k[1], height, at, opposite);
}

static inline void fill_row(const water_tile* tile, const double* amplitudes, const double* phasors,
  size_t row, packing* pack, double* own, double* mirror)
{
  const size_t n = tile->size;
  const size_t half = n / 2;
  double* opposite = row > 0 ? mirror : own; // to which the same is written twice
  own[n] = own[n + 1] = opposite[n] = opposite[n + 1] = 0.0;
  for (size_t column = 0; column < n; ++column)
  {
    if (column != half)
    {
      const wave w = wave_of(tile, amplitudes, column, row);
      const double* phasor = phasors + 2 * (row * half + (column < half ? column : n - column));
      const double height[2] = { (w.own[0] + w.other[0]) * phasor[0] +
          (w.own[1] + w.other[1]) * phasor[1],
        (w.own[1] - w.other[1]) * phasor[0] + (w.other[0] - w.own[0]) * phasor[1] };
      pack(&w, height, own + 2 * column, opposite + 2 * mirrored(n, column));
    }
  }
}

void water_tile_pair_row(const water_tile* tile, const double* amplitudes, const double* phasors,
  water_tile_pair pair, size_t row, double* own, double* mirror)
{
  switch (pair) // a call each, so that the compiler makes a loop of each
  {
    case WATER_PAIR_SLOPES:
      fill_row(tile, amplitudes, phasors, row, pack_slopes, own, mirror);
      break;
    case WATER_PAIR_CHOP:
      fill_row(tile, amplitudes, phasors, row, pack_chop, own, mirror);
      break;
    case WATER_PAIR_STRETCH:
      fill_row(tile, amplitudes, phasors, row, pack_stretch, own, mirror);
      break;
    case WATER_PAIR_SHEAR:
      fill_row(tile, amplitudes, phasors, row, pack_shear, own, mirror);
      break;
    case WATER_PAIR_HEIGHT_SHEAR:
      fill_row(tile, amplitudes, phasors, row, pack_height_shear, own, mirror);
      break;
    case WATER_PAIR_HEIGHT:
    default:
      fill_row(tile, amplitudes, phasors, row, pack_height, own, mirror);
      break;
  }
}

void water_tile_pair_waves(
  const water_tile* tile, const double* amplitudes, water_tile_pair pair, float* waves)
{
  static packing* const packings[WATER_PAIR_COUNT] = { pack_slopes, pack_height, pack_chop,
    pack_stretch, pack_shear, pack_height_shear };
  const size_t n = tile->size;
  for (size_t row = 0; row < n; ++row)
  {
    for (size_t column = 0; column < n; ++column)
    {
      // the mean and the highest frequencies have amplitudes of 0
      const wave w = wave_of(tile, amplitudes, column, row);
      const double even[2] = { w.own[0] + w.other[0], w.own[1] - w.other[1] };
      const double odd[2] = { w.own[1] + w.other[1], w.other[0] - w.own[0] };
      double spectra[4];
      double opposite[2];
      packings[pair](&w, even, spectra, opposite);
      packings[pair](&w, odd, spectra + 2, opposite);
      for (size_t i = 0; i < 4; ++i)
      {
        waves[4 * (row * n + column) + i] = (float)spectra[i];
      }
    }
  }
}
