// SPDX-License-Identifier: BSD-3-Clause
// test_tile_time.c: a tile's spectra row by row are those of the whole tile, to the bit.
#include "test_main.h"

#include "water_tile_time.h"

#include <string.h>

enum
{
  LARGEST = 14,
  PLACES = LARGEST * LARGEST
};

static const double unset = 7.0;
static const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, 6.0, 0.7, 2e4, 3.0,
  3.3, 8.0 };
// the least size, one without a middle of the quadrant, one with a period
static const water_tile tiles[] = { { 4, 60.0, 0.0, 1, 0.0, 0.0 }, { 14, 35.0, 0.0, 2, 0.0, 0.0 },
  { 12, 80.0, 17.0, 3, 0.0, 0.0 } };
static const double times[] = { 0.0, 3.25, -1e6, 1e12 };

// All rows of a spectrum; the row that is not asked for stays unset.
static void fill(const water_tile* tile, const double* amplitudes, double time,
  water_tile_pair pair, double* spectrum)
{
  static double frequencies[PLACES / 4];
  static double phasors[PLACES / 2];
  const size_t n = tile->size;
  assert_int_equal(water_tile_frequencies(tile, &sea, frequencies), WATER_OK);
  // ranges in any order
  water_tile_phasors(tile, frequencies, time, 1, n / 2, phasors);
  water_tile_phasors(tile, frequencies, time, 0, 1, phasors);
  for (size_t i = 0; i < 2 * n * n; ++i)
  {
    spectrum[i] = unset;
  }
  for (size_t row = 0; row < n / 2; ++row)
  {
    water_tile_pair_row(tile, amplitudes, phasors, pair, row, spectrum + 2 * n * row,
      row > 0 ? spectrum + 2 * n * (n - row) : NULL);
  }
}

static void check_equal(const water_tile* tile, const double* found, const double* whole)
{
  const size_t n = tile->size;
  bool is_empty = true;
  for (size_t i = 0; i < 2 * n * n; ++i)
  {
    const bool is_left = i / (2 * n) == n / 2;
    ASSERT_CLOSE(found[i], is_left ? unset : whole[i], 0.0);
    ASSERT_CLOSE(whole[i], is_left ? 0.0 : whole[i], 0.0);
    is_empty = is_empty && whole[i] == 0.0;
  }
  assert_false(is_empty);
}

TEST(rows_are_those_of_the_whole_tile)
{
  static double amplitudes[2 * PLACES];
  static double height[2 * PLACES];
  static double slopes[2][2 * PLACES];
  static double found[2 * PLACES];
  for (size_t i = 0; i < sizeof tiles / sizeof tiles[0]; ++i)
  {
    const water_tile* tile = &tiles[i];
    assert_int_equal(water_tile_amplitudes(tile, &sea, amplitudes), WATER_OK);
    for (size_t j = 0; j < sizeof times / sizeof times[0]; ++j)
    {
      assert_int_equal(water_tile_at(tile, &sea, amplitudes, times[j], height), WATER_OK);
      water_tile_derive(tile, height, WATER_TILE_SLOPE_X, slopes[0]);
      water_tile_derive(tile, height, WATER_TILE_SLOPE_Y, slopes[1]);
      water_tile_pack(tile, slopes[0], slopes[1], slopes[0]);
      water_tile_pack(tile, height, NULL, height);
      fill(tile, amplitudes, times[j], WATER_PAIR_SLOPES, found);
      check_equal(tile, found, slopes[0]);
      fill(tile, amplitudes, times[j], WATER_PAIR_HEIGHT, found);
      check_equal(tile, found, height);
    }
  }
}

// A range writes its own rows and columns alone: other threads may write the others.
TEST(ranges_of_phasors_keep_to_themselves)
{
  const water_tile* tile = &tiles[1];
  const size_t half = tile->size / 2;
  static double frequencies[PLACES / 4];
  double phasors[PLACES / 2];
  assert_int_equal(water_tile_frequencies(tile, &sea, frequencies), WATER_OK);
  for (size_t i = 0; i < 2 * half * half; ++i)
  {
    phasors[i] = unset;
  }
  water_tile_phasors(tile, frequencies, 2.5, 2, 4, phasors);
  for (size_t i = 0; i < half * half; ++i)
  {
    const size_t low = i / half < i % half ? i / half : i % half;
    assert_int_equal(phasors[2 * i] != unset, low == 2 || low == 3);
    assert_int_equal(phasors[2 * i + 1] != unset, low == 2 || low == 3);
  }
}

// Chop and its derivatives, row by row, are those of the whole tile, to rounding.
TEST(chop_is_that_of_the_whole_tile)
{
  static const water_tile_field chop[2] = { WATER_TILE_CHOP_X, WATER_TILE_CHOP_Y };
  static const water_tile_field slope[2] = { WATER_TILE_SLOPE_X, WATER_TILE_SLOPE_Y };
  static double amplitudes[2 * PLACES];
  static double height[2 * PLACES];
  static double fields[5][2 * PLACES]; // chop x, y; its derivatives xx, yy, xy
  static double whole[2 * PLACES];
  static double found[2 * PLACES];
  const water_tile* tile = &tiles[1];
  assert_int_equal(water_tile_amplitudes(tile, &sea, amplitudes), WATER_OK);
  assert_int_equal(water_tile_at(tile, &sea, amplitudes, 7.5, height), WATER_OK);
  for (int i = 0; i < 2; ++i)
  {
    water_tile_derive(tile, height, chop[i], fields[i]);
    water_tile_derive(tile, fields[i], slope[i], fields[2 + i]);
  }
  water_tile_derive(tile, fields[0], slope[1], fields[4]);
  const double* const pairs[WATER_PAIR_COUNT][2] = { { NULL, NULL }, { NULL, NULL },
    { fields[0], fields[1] }, { fields[2], fields[3] }, { fields[4], NULL },
    { height, fields[4] } };
  for (int pair = WATER_PAIR_CHOP; pair < WATER_PAIR_COUNT; ++pair)
  {
    water_tile_pack(tile, pairs[pair][0], pairs[pair][1], whole);
    fill(tile, amplitudes, 7.5, (water_tile_pair)pair, found);
    double largest = 0.0;
    for (size_t i = 0; i < 2 * tile->size * tile->size; ++i)
    {
      const bool is_left = i / (2 * tile->size) == tile->size / 2;
      ASSERT_CLOSE(found[i], is_left ? unset : whole[i], 1e-14);
      largest = fmax(largest, fabs(whole[i]));
    }
    assert_true(largest > 1e-3);
  }
}

// What a shader multiplies by cosine and sine of each wave's phase is the same spectrum.
TEST(waves_times_phasors_are_the_slopes)
{
  static double amplitudes[2 * PLACES];
  static double frequencies[PLACES / 4];
  static double phasors[PLACES / 2];
  static double whole[2 * PLACES];
  static float waves[4 * PLACES];
  const water_tile* tile = &tiles[1];
  const size_t n = tile->size;
  assert_int_equal(water_tile_amplitudes(tile, &sea, amplitudes), WATER_OK);
  assert_int_equal(water_tile_frequencies(tile, &sea, frequencies), WATER_OK);
  water_tile_phasors(tile, frequencies, 12.5, 0, n / 2, phasors);
  for (int pair = 0; pair < WATER_PAIR_COUNT; ++pair)
  {
    fill(tile, amplitudes, 12.5, (water_tile_pair)pair, whole);
    water_tile_pair_waves(tile, amplitudes, (water_tile_pair)pair, waves);
    for (size_t i = 0; i < n * n; ++i)
    {
      const size_t row = i / n;
      const size_t column = i % n;
      const float* w = waves + 4 * i;
      if (row == n / 2 || column == n / 2 || i == 0)
      {
        assert_true(w[0] == 0.0f && w[1] == 0.0f && w[2] == 0.0f && w[3] == 0.0f);
        continue;
      }
      const size_t place =
        (row < n / 2 ? row : n - row) * (n / 2) + (column < n / 2 ? column : n - column);
      const double c = phasors[2 * place];
      const double s = phasors[2 * place + 1];
      for (size_t part = 0; part < 2; ++part)
      {
        const double scale = fabs((double)w[part]) + fabs((double)w[2 + part]);
        ASSERT_CLOSE(
          (double)w[part] * c + (double)w[2 + part] * s, whole[2 * i + part], 1.2e-7 * scale);
      }
    }
  }
}

// A bad tile or sea is refused, and nothing is written.
TEST(bad_tiles_have_no_frequencies)
{
  const water_tile odd = { 5, 60.0, 0.0, 1, 0.0, 0.0 };
  water_sea calm = sea;
  calm.wind_speed = 0.0;
  double frequencies[49];
  memset(frequencies, 0, sizeof frequencies);
  frequencies[0] = unset;
  assert_int_equal(water_tile_frequencies(&odd, &sea, frequencies), WATER_BAD_TILE_SIZE);
  assert_int_equal(water_tile_frequencies(&tiles[0], &calm, frequencies), WATER_BAD_WIND_SPEED);
  assert_true(frequencies[0] == unset);
}

// Turns a second by the dispersion of the depth; with a period whole ones, from 1.
TEST(frequencies_are_the_dispersions)
{
  const double two_pi = 6.283185307179586;
  const double k = two_pi * sqrt(5.0) / 35.0;
  ASSERT_CLOSE(
    water_tile_frequency(&tiles[1], &sea, 1, 2), sqrt(9.80665 * k * tanh(3.0 * k)) / two_pi, 1e-15);
  assert_true(water_tile_frequency(&tiles[1], &sea, 0, 0) == 0.0);
  const double other = two_pi * sqrt(5.0) / 80.0;
  assert_true(water_tile_frequency(&tiles[2], &sea, 1, 2) ==
    rint(17.0 * sqrt(9.80665 * other * tanh(3.0 * other)) / two_pi));
  assert_true(water_tile_frequency(&tiles[2], &sea, 0, 0) == 1.0);
  assert_true(water_tile_clock(&tiles[1], -12.5) == -12.5);
  ASSERT_CLOSE(water_tile_clock(&tiles[2], -1701.7), -0.1, 1e-14);
}

TESTS(rows_are_those_of_the_whole_tile, chop_is_that_of_the_whole_tile,
  ranges_of_phasors_keep_to_themselves, waves_times_phasors_are_the_slopes,
  bad_tiles_have_no_frequencies, frequencies_are_the_dispersions)
