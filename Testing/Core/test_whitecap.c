// SPDX-License-Identifier: BSD-3-Clause
// test_whitecap.c: of a sea on its tiles, what lies under the threshold is the share that was
// measured.
#include "test_main.h"

#include "water_cascade.h"
#include "water_whitecap.h"

enum
{
  N = 64,
  NUMBERS = 2 * N * N
};

// The published fit at three winds, by hand.
TEST(cover_is_monahans)
{
  double cover = -1.0;
  assert_int_equal(water_whitecap_cover(5.0, &cover), WATER_OK);
  ASSERT_CLOSE(cover, 9.286e-4, 1e-6);
  assert_int_equal(water_whitecap_cover(10.0, &cover), WATER_OK);
  ASSERT_CLOSE(cover, 9.870e-3, 1e-5);
  assert_int_equal(water_whitecap_cover(100.0, &cover), WATER_OK);
  assert_true(cover == 1.0);
  assert_int_equal(water_whitecap_cover(0.0, &cover), WATER_BAD_WIND_SPEED);
  assert_true(cover == 1.0);
}

// A transform by its definition, along one axis after the other: real parts.
static void transform(const double* spectrum, double* real)
{
  static double middle[NUMBERS];
  const double turn = 2.0 * 3.141592653589793 / N;
  for (int row = 0; row < N; ++row)
  {
    for (int x = 0; x < N; ++x)
    {
      double sum[2] = { 0.0, 0.0 };
      for (int i = 0; i < N; ++i)
      {
        const double* h = spectrum + 2 * (row * N + i);
        const double c = cos(turn * ((i * x) % N));
        const double s = sin(turn * ((i * x) % N));
        sum[0] += h[0] * c - h[1] * s;
        sum[1] += h[0] * s + h[1] * c;
      }
      middle[2 * (row * N + x)] = sum[0];
      middle[2 * (row * N + x) + 1] = sum[1];
    }
  }
  for (int x = 0; x < N; ++x)
  {
    for (int y = 0; y < N; ++y)
    {
      double sum = 0.0;
      for (int i = 0; i < N; ++i)
      {
        const double* h = middle + 2 * (i * N + x);
        sum += h[0] * cos(turn * ((i * y) % N)) - h[1] * sin(turn * ((i * y) % N));
      }
      real[y * N + x] = sum;
    }
  }
}

// The three derivatives of a tile's chop.
static void bends_of(const water_tile* tile, const water_sea* sea, double bends[3][N * N])
{
  static const water_tile_field of[3][2] = { { WATER_TILE_CHOP_X, WATER_TILE_SLOPE_X },
    { WATER_TILE_CHOP_X, WATER_TILE_SLOPE_Y }, { WATER_TILE_CHOP_Y, WATER_TILE_SLOPE_Y } };
  static double amplitudes[NUMBERS];
  static double height[NUMBERS];
  static double field[NUMBERS];
  assert_int_equal(water_tile_amplitudes(tile, sea, amplitudes), WATER_OK);
  assert_int_equal(water_tile_at(tile, sea, amplitudes, 3.0, height), WATER_OK);
  for (int i = 0; i < 3; ++i)
  {
    water_tile_derive(tile, height, of[i][0], field);
    water_tile_derive(tile, field, of[i][1], field);
    transform(field, bends[i]);
  }
}

// Counted over places that are chosen on each tile by themselves, as tiles' lengths have no common
// measure: within a factor of 1.5 at 5, 10 and 15 m/s.
TEST(cover_is_what_is_counted)
{
  static double bends[WATER_CASCADES_MAX][3][N * N];
  const double winds[] = { 5.0, 10.0, 15.0 };
  for (size_t i = 0; i < 3; ++i)
  {
    const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, winds[i], 0.4,
      (double)INFINITY, (double)INFINITY, 1.0, 10.0 };
    const water_tile first = { N, water_cascades_natural_length(&sea, 3), 0.0, 7, 0.0, 0.0 };
    water_cascades cascades;
    assert_int_equal(water_cascades_make(&first, &sea, 3, &cascades), WATER_OK);
    double beyond[WATER_CASCADES_MAX + 1][2];
    water_cascades_slopes(&cascades, &sea, beyond);
    const size_t count = cascades.count;
    const double held[2] = { beyond[0][0] - beyond[count][0], beyond[0][1] - beyond[count][1] };
    double cover = 0.0;
    assert_int_equal(water_whitecap_cover(winds[i], &cover), WATER_OK);
    const double least = water_whitecap_jacobian(cover, held);
    for (size_t tile = 0; tile < count; ++tile)
    {
      bends_of(&cascades.tiles[tile], &sea, bends[tile]);
    }
    int white = 0;
    const int places = 1000000;
    unsigned random = 12345u;
    for (int place = 0; place < places; ++place)
    {
      double sum[3] = { 0.0, 0.0, 0.0 };
      for (size_t tile = 0; tile < count; ++tile)
      {
        random = random * 1664525u + 1013904223u;
        const size_t at = (random >> 8) % (N * N);
        for (int j = 0; j < 3; ++j)
        {
          sum[j] += bends[tile][j][at];
        }
      }
      white += 1.0 + sum[0] + sum[2] < least;
    }
    const double counted = white / (double)places;
    printf("wind %g: %.3f %% of the sea is white, %.3f %% were measured; Jacobian under %.3f\n",
      winds[i], 100.0 * counted, 100.0 * cover, least);
    assert_true(counted > cover / 1.5 && counted < cover * 1.5);
  }
}

TEST(ends_of_the_cover)
{
  const double variance[2] = { 0.03, 0.01 };
  const double calm[2] = { 0.0, 0.0 };
  assert_true(water_whitecap_jacobian(0.0, variance) == -(double)INFINITY);
  assert_true(water_whitecap_jacobian(1.0, variance) == (double)INFINITY);
  assert_true(water_whitecap_jacobian(0.01, calm) == 1.0);
  // waves along one line have no product: a normal distribution, 1 % below 2.3263 deviations
  const double line[2] = { 0.04, 0.0 };
  const double softness = water_whitecap_softness();
  ASSERT_CLOSE(
    water_whitecap_jacobian(0.01, line), 1.0 - 2.3263479 * sqrt(0.04 + softness * softness), 1e-6);
}

// Winds that were never measured, or are none, have no share.
TEST(winds_out_of_range_are_refused)
{
  const double winds[4] = { 0.09, 100.1, NAN, -5.0 };
  double cover = 7.0;
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(water_whitecap_cover(winds[i], &cover), WATER_BAD_WIND_SPEED);
  }
  ASSERT_CLOSE(cover, 7.0, 0.0);
}

TESTS(
  winds_out_of_range_are_refused, cover_is_monahans, cover_is_what_is_counted, ends_of_the_cover)
