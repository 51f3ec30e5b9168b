// SPDX-License-Identifier: BSD-3-Clause
// test_cascade.c: a sea on several tiles is the spectrum's: its variances, its period; where it
// moves.
#include "test_main.h"

#include "water_cascade.h"
#include "water_tile_time.h"

#include <string.h>

static const double pi = 3.141592653589793;
static const double g = 9.80665;

static water_sea sea_of(double wind)
{
  const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, wind, 0.4,
    (double)INFINITY, (double)INFINITY, 1.0, 10.0 };
  return sea;
}

static water_cascades cascades_of(const water_sea* sea, size_t size, size_t count)
{
  const water_tile first = { size, water_cascades_natural_length(sea, count), 0.0, 7, 0.0, 0.0 };
  water_cascades made;
  assert_int_equal(water_cascades_make(&first, sea, count, &made), WATER_OK);
  return made;
}

typedef struct moments // of all tiles' waves: of height, of height by omega^2, of slope
{
  double height;
  double swing;
  double slope;
} moments;

// What the amplitudes of a tile's places are expected to have.
static void add_tile(const water_tile* tile, const water_sea* sea, moments* sum)
{
  const double step = 2.0 * pi / tile->length;
  const int half = (int)tile->size / 2;
  const double end = tile->k_high > 0.0 ? tile->k_high : half * step;
  for (int row = 1 - half; row < half; ++row)
  {
    for (int column = 1 - half; column < half; ++column)
    {
      const double k = step * hypot(row, column);
      if (k > 0.0 && k >= tile->k_low && k < end)
      {
        const double part = water_sea_density(sea, column * step, row * step) * step * step;
        sum->height += part;
        sum->swing += g * k * part;
        sum->slope += k * k * part;
      }
    }
  }
}

// Hs, mean period and slope of the tiles together are those of the spectrum's integrals, within 3
// %.
TEST(tiles_have_the_variance_of_the_spectrum)
{
  const double winds[] = { 5.0, 10.0, 15.0 };
  for (size_t i = 0; i < 3; ++i)
  {
    const water_sea sea = sea_of(winds[i]);
    const water_cascades cascades = cascades_of(&sea, 256, 3);
    assert_int_equal(cascades.count, 3);
    moments sum = { 0.0, 0.0, 0.0 };
    for (size_t tile = 0; tile < cascades.count; ++tile)
    {
      add_tile(&cascades.tiles[tile], &sea, &sum);
    }
    const water_tile* last = &cascades.tiles[2];
    const double end = pi * (double)last->size / last->length;
    double height = 0.0;
    double slope = 0.0;
    assert_int_equal(water_sea_moments(&sea, 0.0, end, &height, &slope), WATER_OK);
    double swing = 0.0; // integral of omega^2 S by the trapezoid rule of ln k
    const int steps = 20000;
    for (int step = 0; step < steps; ++step)
    {
      const double k = end * exp(-14.0 * (step + 0.5) / steps);
      swing += 14.0 / steps * k * g * k * water_sea_wavenumber_density(&sea, k);
    }
    printf("wind %g: Hs %.4f of %.4f m, period %.3f of %.3f s, slope variance %.5f of %.5f\n",
      winds[i], 4.0 * sqrt(sum.height), 4.0 * sqrt(height), 2.0 * pi * sqrt(sum.height / sum.swing),
      2.0 * pi * sqrt(height / swing), sum.slope, slope);
    ASSERT_CLOSE(sqrt(sum.height / height), 1.0, 0.03);
    ASSERT_CLOSE(sqrt(sum.height / sum.swing), sqrt(height / swing), 0.03 * sqrt(height / swing));
    ASSERT_CLOSE(sum.slope, slope, 0.03 * slope);
  }
}

// Each wave is on one tile; the first holds the peak, the last ends at waves of some centimetres or
// at 370 rad/m.
TEST(bands_follow_each_other)
{
  const double winds[] = { 0.5, 3.0, 10.0, 40.0 };
  for (size_t i = 0; i < 4; ++i)
  {
    const water_sea sea = sea_of(winds[i]);
    const water_cascades cascades = cascades_of(&sea, 256, 3);
    assert_true(cascades.tiles[0].k_low == 0.0);
    assert_true(cascades.tiles[cascades.count - 1].k_high == 0.0);
    for (size_t tile = 0; tile + 1 < cascades.count; ++tile)
    {
      const water_tile* of = &cascades.tiles[tile];
      assert_true(of->k_high == of[1].k_low && of->seed != of[1].seed);
      // the band's longest waves fit five times, its shortest have more than two points
      assert_true(of[1].length > 4.999 * 2.0 * pi / of[1].k_low);
      assert_true(of->k_high < pi * 256.0 / of->length);
      ASSERT_CLOSE(of->length / of[1].length, cascades.tiles[0].length / cascades.tiles[1].length,
        1e-9 * of->length / of[1].length);
    }
    for (size_t tile = 0; tile < cascades.count; ++tile)
    {
      double band[2];
      water_cascades_band(&cascades, &sea, tile, band);
      const double first =
        tile > 0 ? cascades.tiles[tile].k_low : 2.0 * pi / water_tile_peak_wavelength(&sea);
      ASSERT_CLOSE(band[0], first, 1e-9 * first);
      assert_true(band[1] > band[0]);
      assert_true(band[1] == cascades.tiles[tile].k_high || tile + 1 == cascades.count);
    }
    const water_tile* last = &cascades.tiles[cascades.count - 1];
    const double end = pi * 256.0 / last->length;
    assert_true(end < 370.0 * 1.000001 || cascades.count == 1);
    assert_true(winds[i] > 10.0 || 2.0 * pi / end < 0.06);
  }
  const water_sea slow = sea_of(0.2);
  assert_true(cascades_of(&slow, 256, 3).count < 3);
  const water_sea sea = sea_of(10.0);
  ASSERT_CLOSE(cascades_of(&sea, 256, 1).tiles[0].length, water_tile_natural_length(&sea), 0.0);
}

// Amplitudes are of the band alone, and those of another tile's band are others.
TEST(amplitudes_keep_to_the_band)
{
  enum
  {
    N = 32
  };
  static double amplitudes[2 * N * N];
  const water_sea sea = sea_of(6.0);
  water_tile tile = { N, 60.0, 0.0, 3, 0.5, 1.2 };
  assert_int_equal(water_tile_amplitudes(&tile, &sea, amplitudes), WATER_OK);
  int held = 0;
  for (int row = 0; row < N; ++row)
  {
    for (int column = 0; column < N; ++column)
    {
      const double k =
        2.0 * pi / 60.0 * hypot(row < N / 2 ? row : row - N, column < N / 2 ? column : column - N);
      const bool is_held = amplitudes[2 * (row * N + column)] != 0.0;
      assert_int_equal(is_held, k >= 0.5 && k < 1.2);
      held += is_held;
    }
  }
  assert_true(held > 300);
  tile.k_high = 0.4;
  assert_int_equal(water_tile_check(&tile, &sea), WATER_BAD_WAVENUMBER);
  tile.k_low = -1.0;
  assert_int_equal(water_tile_check(&tile, &sea), WATER_BAD_WAVENUMBER);
}

TEST(bad_cascades_are_refused)
{
  const water_sea sea = sea_of(6.0);
  const water_tile first = { 64, 60.0, 0.0, 3, 0.0, 0.0 };
  water_tile odd = first;
  odd.size = 5;
  water_cascades made;
  memset(&made, 0, sizeof made);
  assert_int_equal(water_cascades_make(&first, &sea, 0, &made), WATER_BAD_CASCADES);
  assert_int_equal(
    water_cascades_make(&first, &sea, WATER_CASCADES_MAX + 1, &made), WATER_BAD_CASCADES);
  assert_int_equal(water_cascades_make(&odd, &sea, 1, &made), WATER_BAD_TILE_SIZE);
  assert_int_equal(made.count, 0);
}

// Slope variances from a tile on add up to those of all waves; turned, their sum stays.
TEST(slopes_add_up)
{
  const water_sea sea = sea_of(8.0);
  const water_cascades cascades = cascades_of(&sea, 128, 3);
  double beyond[WATER_CASCADES_MAX + 1][2];
  water_cascades_slopes(&cascades, &sea, beyond);
  double height = 0.0;
  double slope = 0.0;
  assert_int_equal(water_sea_moments(&sea, 0.0, 370.0, &height, &slope), WATER_OK);
  ASSERT_CLOSE(beyond[0][0] + beyond[0][1], slope, 1e-4 * slope);
  assert_true(beyond[0][0] > beyond[0][1]); // more along the wind
  for (size_t i = 0; i < cascades.count; ++i)
  {
    double axes[3];
    double own[2] = { 0.0, 0.0 };
    double left_out[2];
    water_tile_slopes(&cascades.tiles[i], &sea, own, left_out);
    const double held[2] = { beyond[i][0] - beyond[i + 1][0], beyond[i][1] - beyond[i + 1][1] };
    water_cascades_turn(&sea, held, axes);
    ASSERT_CLOSE(axes[0], own[0], 1e-5 * slope);
    ASSERT_CLOSE(axes[1], own[1], 1e-5 * slope);
    // along the wind and across it the slopes do not depend on each other: turned back there is
    // nothing between them
    const double c = cos(2.0 * sea.wind_dir_rad);
    const double s = sin(2.0 * sea.wind_dir_rad);
    ASSERT_CLOSE(c * axes[2] - 0.5 * s * (axes[0] - axes[1]), 0.0, 1e-15);
    double from[3];
    double next[3];
    water_cascades_turn(&sea, beyond[i], from);
    water_cascades_turn(&sea, beyond[i + 1], next);
    ASSERT_CLOSE(water_cascades_lean(from, next) * (axes[0] + axes[1]), axes[2], 1e-15);
    ASSERT_CLOSE(water_cascades_lean(from, from), 0.0, 0.0);
  }
  ASSERT_CLOSE(water_cascades_height(&sea), height, 0.0);
  double up = 0.0;
  double across = 0.0;
  water_cascades_reach(4.0, 0.5, &up, &across);
  assert_true(up == 12.0 && across == 6.0);
}

// One wave along x on a tile, sampled at its points: a Gerstner wave of steepness 1.
TEST(a_sea_of_one_wave_is_gerstners)
{
  enum
  {
    N = 64
  };
  static double fields[7][N * N];
  const double length = 16.0;
  const double k = 2.0 * pi / length;
  const double amplitude = 0.8;
  for (int row = 0; row < N; ++row)
  {
    for (int column = 0; column < N; ++column)
    {
      const double angle = k * length * column / N;
      double* at[7];
      for (int i = 0; i < 7; ++i)
      {
        at[i] = &fields[i][row * N + column];
      }
      *at[0] = amplitude * sin(angle);
      *at[1] = k * amplitude * cos(angle);
      *at[3] = amplitude * cos(angle);
      *at[5] = -k * amplitude * sin(angle);
    }
  }
  const water_cascades cascades = { 1, { { N, length, 0.0, 1, 0.0, 0.0 } },
    { { { 0.0, 0.0 }, { 0.0, 0.0 } } } };
  const water_cascade_fields of = { fields[0], { fields[1], fields[2] }, { fields[3], fields[4] },
    { fields[5], fields[2], fields[2] } };
  const water_wave wave = { amplitude, length, 0.0, 0.0, 1.0 };
  water_wave_term term;
  size_t bad = 0;
  assert_int_equal(water_waves_at(&wave, 1, (double)INFINITY, 0.0, &term, &bad), WATER_OK);
  for (double units = 1.0; units < 30.0; units *= 10.0)
  {
    const water_cascade_surface surface = { &cascades, &of, 1.0, units };
    const water_wave_others others = { water_cascades_add, &surface, units * amplitude };
    for (double x = -20.0; x < 20.0; x += 0.37)
    {
      double rest[2];
      water_wave_point found;
      water_wave_point right;
      assert_int_equal(
        water_waves_find_all(NULL, 0, &others, units * x, units * 3.0, rest, &found), WATER_OK);
      double right_rest[2];
      assert_int_equal(water_waves_find(&term, 1, x, 3.0, right_rest, &right), WATER_OK);
      // bilinear between points: (k step)^2 / 8 of the amplitude
      ASSERT_CLOSE(found.displacement[2] / units, right.displacement[2], 2e-3 * amplitude);
      ASSERT_CLOSE(rest[0] / units, right_rest[0], 4e-3 * amplitude);
      ASSERT_CLOSE(found.normal[0], right.normal[0], 6e-3);
      // and the place is met
      ASSERT_CLOSE(rest[0] + found.displacement[0], units * x, 1.1e-6 * units * amplitude);
    }
  }
  const water_cascade_surface calm = { &cascades, &of, 0.0, 1.0 };
  const water_wave_others up = { water_cascades_add, &calm, 0.0 };
  double rest[2];
  water_wave_point found;
  assert_int_equal(water_waves_find_all(NULL, 0, &up, 4.0, 1.0, rest, &found), WATER_OK);
  assert_true(rest[0] == 4.0);
  ASSERT_CLOSE(found.displacement[2], amplitude, 1e-12);
  assert_int_equal(
    water_waves_find_all(NULL, 0, &up, (double)NAN, 1.0, rest, &found), WATER_BAD_POINT);
}

// The places of the first tile stay; those of the others move without a seam, by their derivatives,
// over areas that stay, and far enough that the longest wave of the second tile is elsewhere.
TEST(places_of_short_tiles_are_warped)
{
  const water_sea sea = sea_of(10.0);
  const water_cascades cascades = cascades_of(&sea, 256, 3);
  const double longest = cascades.tiles[1].length / 5.0;
  const double step = 1e-4;
  double square = 0.0;
  double area = 0.0;
  double turned = 0.0;
  int count = 0;
  for (double x = -3e4; x < 3e4; x += 433.7)
  {
    for (double y = -3e4; y < 3e4; y += 517.3)
    {
      double turn[2][2];
      double at[2][3][2]; // tiles 1 and 2; there, a step along x, a step along y
      for (size_t i = 0; i < 2; ++i)
      {
        for (int j = 2; j >= 0; --j)
        {
          const double place[2] = { x + (j == 1 ? step : 0.0), y + (j == 2 ? step : 0.0) };
          water_cascades_place(&cascades, i + 1, place, at[i][j], turn);
        }
        for (int k = 0; k < 2; ++k)
        {
          ASSERT_CLOSE((at[i][1][k] - at[i][0][k]) / step, (k == 0) + turn[k][0], 1e-5);
          ASSERT_CLOSE((at[i][2][k] - at[i][0][k]) / step, (k == 1) + turn[k][1], 1e-5);
        }
      }
      assert_true(at[0][0][0] == at[1][0][0] && at[0][0][1] == at[1][0][1]);
      square += (at[0][0][0] - x) * (at[0][0][0] - x);
      area += (1.0 + turn[0][0]) * (1.0 + turn[1][1]) - turn[0][1] * turn[1][0];
      double slope[2] = { 0.6, 0.8 };
      water_cascades_turned(turn, slope);
      turned += slope[0] * slope[0] + slope[1] * slope[1];
      ++count;
      const double place[2] = { x, y };
      water_cascades_place(&cascades, 0, place, at[0][0], turn);
      assert_true(at[0][0][0] == x && at[0][0][1] == y && turn[0][0] == 0.0 && turn[1][0] == 0.0);
    }
  }
  printf("places move by %.3f of the longest wave (rms), areas %.5f, slope variance %.5f\n",
    sqrt(square / count) / longest, area / count, turned / count);
  assert_true(sqrt(square / count) > 0.25 * longest);
  ASSERT_CLOSE(area / count, 1.0, 2e-3);
  ASSERT_CLOSE(turned / count, 1.0, 0.01);
  const water_cascades one = cascades_of(&sea, 256, 1);
  assert_true(one.warps[0].way[0] == 0.0 && one.warps[0].way[1] == 0.0);
}

// About any point, and in any unit, the numbers for a shader give the same places.
TEST(warps_about_a_point_are_the_same)
{
  const water_sea sea = sea_of(10.0);
  const water_cascades cascades = cascades_of(&sea, 256, 2);
  const double origin[2] = { 4321.0, -98765.0 };
  for (double metres = 1e-3; metres < 1e4; metres *= 1e3)
  {
    for (double x = -400.0; x < 400.0; x += 39.0)
    {
      double moved[2];
      double turn[2][2];
      const double place[2] = { metres * (origin[0] + x), metres * (origin[1] + 2.0 * x) };
      water_cascades_warped(&cascades, place, moved, turn);
      double sum[2] = { 0.0, 0.0 };
      for (size_t i = 0; i < WATER_CASCADE_WARPS; ++i)
      {
        double of[4];
        water_cascades_warp_under(&cascades, i, metres, origin, of);
        const double cycles = of[0] * x + of[1] * 2.0 * x + of[2];
        const double part = cycles - floor(cycles) - 0.5;
        const double swing = 8.0 * part * (1.0 - 2.0 * fabs(part));
        sum[0] -= swing * of[3] * of[1];
        sum[1] += swing * of[3] * of[0];
      }
      ASSERT_CLOSE(sum[0] * metres, moved[0], 1e-7);
      ASSERT_CLOSE(sum[1] * metres, moved[1], 1e-7);
    }
  }
}

// Slopes on a warped tile are those of the sea by the chain rule.
TEST(slopes_turn_by_the_chain_rule)
{
  double turn[2][2] = { { 0.1, 0.02 }, { -0.3, 0.05 } };
  double slope[2] = { 2.0, 5.0 };
  water_cascades_turned(turn, slope);
  ASSERT_CLOSE(slope[0], 2.0 + 0.1 * 2.0 - 0.3 * 5.0, 1e-14);
  ASSERT_CLOSE(slope[1], 5.0 + 0.02 * 2.0 + 0.05 * 5.0, 1e-14);
}

// The first tile has the given seed and is as long as its longest wave; without further tiles
// nothing is warped, and cycles at a point are a fraction.
TEST(first_tile_is_the_given_one)
{
  const water_sea sea = sea_of(10.0);
  const water_cascades three = cascades_of(&sea, 64, 3);
  const water_cascades one = cascades_of(&sea, 64, 1);
  assert_true(three.tiles[0].seed == 7 && one.tiles[0].seed == 7);
  assert_true(three.tiles[1].seed != 7 && three.tiles[2].seed != three.tiles[1].seed);
  ASSERT_CLOSE(water_cascades_longest(&three, 0), three.tiles[0].length, 0.0);
  ASSERT_CLOSE(water_cascades_longest(&three, 1), 2.0 * pi / three.tiles[1].k_low, 1e-12);
  const double origin[2] = { 4321.0, -98765.0 };
  for (size_t i = 0; i < WATER_CASCADE_WARPS; ++i)
  {
    double values[4];
    water_cascades_warp_under(&three, i, 1.0, origin, values);
    assert_true(values[2] >= 0.0 && values[2] < 1.0);
    water_cascades_warp_under(&one, i, 1.0, origin, values);
    ASSERT_CLOSE(values[3], 0.0, 0.0);
  }
}

// Number i of the fields of a tile, of 16 points a side.
static double field_at(const double* values, const water_tile* tile, const double place[2])
{
  const double at[2] = { place[0] / tile->length * 16.0, place[1] / tile->length * 16.0 };
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double low[2] = { floor(at[0]), floor(at[1]) };
    const int column = (int)fmod(fmod(low[0] + i % 2, 16.0) + 16.0, 16.0);
    const int row = (int)fmod(fmod(low[1] + i / 2, 16.0) + 16.0, 16.0);
    const double share[2] = { at[0] - low[0], at[1] - low[1] };
    sum += (i % 2 ? share[0] : 1.0 - share[0]) * (i / 2 ? share[1] : 1.0 - share[1]) *
      values[16 * row + column];
  }
  return sum;
}

// What is added at a place are all tiles' fields, bilinear there: heights and ways in the scene's
// unit, slopes turned, and the chop's derivatives each in its own entry.
TEST(fields_are_added_between_points)
{
  const water_sea sea = sea_of(10.0);
  const water_cascades cascades = cascades_of(&sea, 16, 2);
  static double values[2][8][256];
  water_cascade_fields fields[2];
  for (int i = 0; i < 2; ++i)
  {
    for (int k = 0; k < 8 * 256; ++k)
    {
      values[i][k / 256][k % 256] = sin(1.3 * k + i);
    }
    const water_cascade_fields of = { values[i][0], { values[i][1], values[i][2] },
      { values[i][3], values[i][4] }, { values[i][5], values[i][6], values[i][7] } };
    fields[i] = of;
  }
  const water_cascade_surface surface = { &cascades, fields, 0.6, 100.0 };
  for (int round = 0; round < 200; ++round)
  {
    const double place[2] = { 3.7 * round - 300.0, 211.0 - 5.3 * round }; // m
    water_wave_sum sum;
    memset(&sum, 0, sizeof sum);
    assert_true(water_cascades_add(&surface, 100.0 * place[0], 100.0 * place[1], &sum));
    double right[8] = { 0.0 }; // height, slope, chop, bend
    for (size_t i = 0; i < 2; ++i)
    {
      double on_tile[2];
      double turn[2][2];
      double of[8];
      water_cascades_place(&cascades, i, place, on_tile, turn);
      for (int k = 0; k < 8; ++k)
      {
        of[k] = field_at(values[i][k], &cascades.tiles[i], on_tile);
        right[k] += k == 1 || k == 2 ? 0.0 : of[k];
      }
      for (int k = 0; k < 2; ++k)
      {
        right[1 + k] += of[1 + k] + turn[0][k] * of[1] + turn[1][k] * of[2];
      }
    }
    ASSERT_CLOSE(sum.gradient[0], right[1], 1e-9);
    ASSERT_CLOSE(sum.gradient[1], right[2], 1e-9);
    ASSERT_CLOSE(sum.moved[0], 60.0 * right[3], 1e-7);
    ASSERT_CLOSE(sum.moved[1], 60.0 * right[4], 1e-7);
    ASSERT_CLOSE(sum.moved[2], 100.0 * right[0], 1e-7);
    ASSERT_CLOSE(sum.stretch[0], 0.6 * right[5], 1e-9);
    ASSERT_CLOSE(sum.stretch[1], 0.6 * right[7], 1e-9);
    ASSERT_CLOSE(sum.stretch[2], 0.6 * right[6], 1e-9);
  }
}

// A tile that holds the shortest waves alone, or whose points are too few for a second one, has no
// others.
TEST(tiles_that_need_no_others_are_alone)
{
  const water_sea sea = sea_of(10.0);
  const water_tile fine = { 64, 0.001, 0.0, 7, 0.0, 0.0 };
  const water_tile coarse = { 4, 100.0, 0.0, 7, 0.0, 0.0 };
  water_cascades made;
  assert_int_equal(water_cascades_make(&fine, &sea, 3, &made), WATER_OK);
  assert_int_equal(made.count, 1);
  assert_int_equal(water_cascades_make(&coarse, &sea, 3, &made), WATER_OK);
  assert_int_equal(made.count, 1);
}

TESTS(tiles_that_need_no_others_are_alone, slopes_turn_by_the_chain_rule,
  first_tile_is_the_given_one, fields_are_added_between_points,
  tiles_have_the_variance_of_the_spectrum, bands_follow_each_other, amplitudes_keep_to_the_band,
  bad_cascades_are_refused, slopes_add_up, places_of_short_tiles_are_warped,
  warps_about_a_point_are_the_same, a_sea_of_one_wave_is_gerstners)
