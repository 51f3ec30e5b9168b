// SPDX-License-Identifier: BSD-3-Clause
// water_tile.c: a wind sea on a square that repeats: random amplitudes, and the spectrum at a time.
#include "water_tile.h"

#include "water_math.h"
#include "water_phase.h"
#include "water_random.h"
#include "water_waves.h"

#include <stdlib.h>

static const double natural_waves = 10.0;

water_status water_tile_check(const water_tile* tile, const water_sea* sea)
{
  if (tile->size < 4 || tile->size > 16384 || tile->size % 2 != 0)
  {
    return WATER_BAD_TILE_SIZE;
  }
  if (!(tile->length >= 1e-3 && tile->length <= 1e9))
  {
    return WATER_BAD_TILE_LENGTH;
  }
  if (!isfinite(tile->period) || tile->period < 0.0)
  {
    return WATER_BAD_PERIOD;
  }
  if (!(tile->k_low >= 0.0) || !isfinite(tile->k_low) || !isfinite(tile->k_high) ||
    !(tile->k_high == 0.0 || tile->k_high > tile->k_low))
  {
    return WATER_BAD_WAVENUMBER;
  }
  return water_sea_check(sea);
}

bool water_tile_is_same(const water_tile* a, const water_tile* b)
{
  return a->size == b->size && a->length == b->length && a->period == b->period &&
    a->seed == b->seed && a->k_low == b->k_low && a->k_high == b->k_high;
}

typedef struct mode // a wave vector of the tile
{
  int number[2];  // whole waves along the side
  double k[2];    // rad/m
  size_t at;      // where its complex number is
  size_t partner; // where that of -k is
  bool is_used;   // not the mean, and has a partner
} mode;

static mode mode_of(const water_tile* tile, size_t column, size_t row)
{
  const size_t n = tile->size;
  const size_t index[2] = { column, row };
  mode made;
  for (int i = 0; i < 2; ++i)
  {
    made.number[i] = index[i] < n / 2 ? (int)index[i] : (int)index[i] - (int)n;
    made.k[i] = water_two_pi * made.number[i] / tile->length;
  }
  made.at = 2 * (row * n + column);
  made.partner = 2 * ((n - row) % n * n + (n - column) % n);
  made.is_used = column != n / 2 && row != n / 2 && (column != 0 || row != 0);
  return made;
}

// Where a tile's band ends. The corners of the square have waves beyond its Nyquist wave number,
// but not in all directions: they count as waves that it leaves out.
static double end_of(const water_tile* tile)
{
  const double nyquist = 0.5 * water_two_pi * (double)tile->size / tile->length;
  return tile->k_high > 0.0 ? fmin(tile->k_high, nyquist) : nyquist;
}

static bool is_in_band(const water_tile* tile, const mode* m)
{
  const double k = hypot(m->k[0], m->k[1]);
  return m->is_used && k >= tile->k_low && k < end_of(tile);
}

// One number for each (i, j), whatever the tile's size (16384 at most).
static uint64_t counter_of(const mode* m)
{
  return (uint64_t)(m->number[0] + 8192) * 16384u + (uint64_t)(m->number[1] + 8192);
}

water_status water_tile_amplitudes(const water_tile* tile, const water_sea* sea, double* amplitudes)
{
  const water_status status = water_tile_check(tile, sea);
  if (status != WATER_OK)
  {
    return status;
  }
  const double step = water_two_pi / tile->length;
  // seeds that differ by the generator's step would give the same sequence, shifted: mixed first
  const uint64_t seed = water_random_bits(tile->seed, 0);
  for (size_t row = 0; row < tile->size; ++row)
  {
    for (size_t column = 0; column < tile->size; ++column)
    {
      const mode m = mode_of(tile, column, row);
      double pair[2];
      water_random_normal(seed, counter_of(&m), pair);
      // |h|^2 has the variance of both h0: a half each, and a half each for its two parts
      const double scale =
        is_in_band(tile, &m) ? 0.5 * step * sqrt(water_sea_density(sea, m.k[0], m.k[1])) : 0.0;
      amplitudes[m.at] = scale * pair[0];
      amplitudes[m.at + 1] = scale * pair[1];
    }
  }
  return WATER_OK;
}

double water_tile_frequency(const water_tile* tile, const water_sea* sea, size_t i, size_t j)
{
  const double k =
    hypot(water_two_pi * (double)i / tile->length, water_two_pi * (double)j / tile->length);
  const double frequency = water_dispersion(k, sea->depth) / water_two_pi;
  return tile->period > 0.0 ? fmax(1.0, rint(frequency * tile->period)) : frequency;
}

double water_tile_clock(const water_tile* tile, double time)
{
  return tile->period > 0.0 ? fmod(time, tile->period) / tile->period : time; // fmod is exact
}

water_status water_tile_at(const water_tile* tile, const water_sea* sea, const double* amplitudes,
  double time, double* height)
{
  const water_status status = water_tile_check(tile, sea);
  if (status != WATER_OK)
  {
    return status;
  }
  if (!isfinite(time))
  {
    return WATER_BAD_TIME;
  }
  const double clock = water_tile_clock(tile, time);
  for (size_t row = 0; row < tile->size; ++row)
  {
    for (size_t column = 0; column < tile->size; ++column)
    {
      const mode m = mode_of(tile, column, row);
      const double* own = amplitudes + m.at;
      const double* other = amplitudes + m.partner;
      const double frequency =
        water_tile_frequency(tile, sea, (size_t)abs(m.number[0]), (size_t)abs(m.number[1]));
      const double angle = water_two_pi * water_turns(frequency, clock);
      const double c = cos(angle);
      const double s = sin(angle);
      height[m.at] = m.is_used ? (own[0] + other[0]) * c + (own[1] + other[1]) * s : 0.0;
      height[m.at + 1] = m.is_used ? (own[1] - other[1]) * c + (other[0] - own[0]) * s : 0.0;
    }
  }
  return WATER_OK;
}

void water_tile_derive(
  const water_tile* tile, const double* height, water_tile_field field, double* out)
{
  const int axis = field == WATER_TILE_SLOPE_Y || field == WATER_TILE_CHOP_Y ? 1 : 0;
  const bool is_chop = field == WATER_TILE_CHOP_X || field == WATER_TILE_CHOP_Y;
  for (size_t row = 0; row < tile->size; ++row)
  {
    for (size_t column = 0; column < tile->size; ++column)
    {
      const mode m = mode_of(tile, column, row);
      const double length = m.is_used ? hypot(m.k[0], m.k[1]) : 1.0;
      const double factor = is_chop ? m.k[axis] / length : m.k[axis];
      const double real = height[m.at];
      out[m.at] = -factor * height[m.at + 1];
      out[m.at + 1] = factor * real;
    }
  }
}

void water_tile_pack(const water_tile* tile, const double* first, const double* second, double* out)
{
  for (size_t at = 0; at < 2 * tile->size * tile->size; at += 2)
  {
    const double real = first[at] + (second != NULL ? second[at + 1] : 0.0);
    const double imaginary = (second != NULL ? second[at] : 0.0) - first[at + 1];
    out[at] = real;
    out[at + 1] = imaginary;
  }
}

double water_tile_peak_wavelength(const water_sea* sea)
{
  const double depth = sea->model == WATER_SEA_PHILLIPS ? (double)INFINITY : sea->depth;
  double k = 0.0;
  const water_status status = water_waves_wavenumber(water_sea_peak(sea), depth, &k);
  return status == WATER_OK ? water_two_pi / k : 0.0;
}

double water_tile_natural_length(const water_sea* sea)
{
  return fmax(natural_waves * water_tile_peak_wavelength(sea), 1e-3);
}

void water_tile_slopes(
  const water_tile* tile, const water_sea* sea, double held[2], double left_out[2])
{
  const double end = end_of(tile);
  held[0] = held[1] = left_out[0] = left_out[1] = 0.0;
  (void)water_sea_slopes(sea, tile->k_low, end, held);
  if (end < WATER_TILE_SHORTEST)
  {
    (void)water_sea_slopes(sea, end, WATER_TILE_SHORTEST, left_out);
  }
}

double water_tile_slope_rms(const double variance[2], double other_rms)
{
  return sqrt(variance[0] + variance[1] + other_rms * other_rms);
}

water_status water_tile_place(const water_tile* tile, double x, double y, double share[2])
{
  if (!isfinite(x) || !isfinite(y))
  {
    return WATER_BAD_POINT;
  }
  const double place[2] = { x, y };
  for (int i = 0; i < 2; ++i)
  {
    const double rest = fmod(place[i], tile->length) / tile->length; // fmod is exact
    const double wrapped = rest < 0.0 ? rest + 1.0 : rest;
    share[i] = wrapped < 1.0 ? wrapped : 0.0;
  }
  return WATER_OK;
}

water_status water_tile_sample(
  const water_tile* tile, const double* values, double x, double y, double* value)
{
  double share[2];
  const water_status status = water_tile_place(tile, x, y, share);
  if (status != WATER_OK)
  {
    return status;
  }
  const size_t n = tile->size;
  size_t low[2];
  size_t high[2];
  double part[2];
  for (int i = 0; i < 2; ++i)
  {
    const double at = share[i] * (double)n;
    low[i] = (size_t)at % n;
    high[i] = (low[i] + 1) % n;
    part[i] = at - floor(at);
  }
  const double front =
    (1.0 - part[0]) * values[low[1] * n + low[0]] + part[0] * values[low[1] * n + high[0]];
  const double back =
    (1.0 - part[0]) * values[high[1] * n + low[0]] + part[0] * values[high[1] * n + high[0]];
  *value = (1.0 - part[1]) * front + part[1] * back;
  return WATER_OK;
}

void water_tile_texels(
  const water_tile* tile, const double* slope_x, const double* slope_y, float* texels)
{
  for (size_t i = 0; i < tile->size * tile->size; ++i)
  {
    texels[4 * i] = (float)slope_x[i];
    texels[4 * i + 1] = (float)slope_y[i];
    texels[4 * i + 2] = texels[4 * i] * texels[4 * i];
    texels[4 * i + 3] = texels[4 * i + 1] * texels[4 * i + 1];
  }
}
