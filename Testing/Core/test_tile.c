// SPDX-License-Identifier: BSD-3-Clause
// test_tile.c: the sea on a tile: statistics, symmetry, time.
#include "test_scene.h"

#include "water_tile.h"

static const double pi = 3.141592653589793;

enum
{
  SIDE = 64,
  NUMBERS = 2 * SIDE * SIDE
};

static const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, 6.0, 0.7, 2e4,
  (double)INFINITY, 3.3, 8.0 };
static const water_tile tile = { SIDE, 200.0, 0.0, 11, 0.0, 0.0 };

static void amplitudes_of(const water_tile* of, double* amplitudes)
{
  assert_int_equal(water_tile_amplitudes(of, &sea, amplitudes), WATER_OK);
}

static void height_at(const water_tile* of, const double* amplitudes, double time, double* height)
{
  assert_int_equal(water_tile_at(of, &sea, amplitudes, time, height), WATER_OK);
}

static size_t place(const water_tile* of, int column, int row)
{
  const int n = (int)of->size;
  return 2 * ((size_t)((row + n) % n) * of->size + (size_t)((column + n) % n));
}

// The surface is real: h(-k) is the conjugate of h(k); the mean is 0, the highest frequency empty.
TEST(spectrum_is_hermitian)
{
  static double amplitudes[NUMBERS];
  static double height[NUMBERS];
  amplitudes_of(&tile, amplitudes);
  height_at(&tile, amplitudes, 17.3, height);
  double sum = 0.0;
  for (int row = -SIDE / 2; row < SIDE / 2; ++row)
  {
    for (int column = -SIDE / 2; column < SIDE / 2; ++column)
    {
      const double* one = height + place(&tile, column, row);
      const double* other = height + place(&tile, -column, -row);
      ASSERT_CLOSE(one[0], other[0], 0.0);
      ASSERT_CLOSE(one[1], -other[1], 0.0);
      if (column == -SIDE / 2 || row == -SIDE / 2 || (column == 0 && row == 0))
      {
        assert_true(one[0] == 0.0 && one[1] == 0.0);
      }
      sum += fabs(one[0]);
    }
  }
  assert_true(sum > 0.1);
}

// Sum of S dk^2 over the tile's wave vectors.
static double tile_sum(int side)
{
  const double step = 2.0 * pi / tile.length;
  double sum = 0.0;
  for (int row = 1 - side / 2; row < side / 2; ++row)
  {
    for (int column = 1 - side / 2; column < side / 2; ++column)
    {
      sum += water_sea_density(&sea, column * step, row * step) * step * step;
    }
  }
  return sum;
}

// On a tile of 10 peak wavelengths and more, fine enough for its corners not to count, the sum over
// the tile is the integral over all wave vectors, within 1 %.
TEST(tile_holds_the_variance_of_the_spectrum)
{
  double height = 0.0;
  double slope = 0.0;
  const double end = 127.5 * 2.0 * pi / tile.length;
  assert_int_equal(water_sea_moments(&sea, 0.0, end, &height, &slope), WATER_OK);
  const double peak = water_sea_peak(&sea);
  assert_true(tile.length > 10.0 * 2.0 * pi * 9.80665 / (peak * peak));
  ASSERT_CLOSE(tile_sum(256), height, 0.01 * height);
}

// Averaged over seeds the surface's variance is the sum of S dk^2.
TEST(variance_is_that_of_the_spectrum)
{
  static double amplitudes[NUMBERS];
  static double height[NUMBERS];
  const double known = tile_sum(SIDE);
  double variance = 0.0;
  const int seeds = 60;
  for (int seed = 0; seed < seeds; ++seed)
  {
    water_tile own = tile;
    own.seed = (uint64_t)seed;
    amplitudes_of(&own, amplitudes);
    height_at(&own, amplitudes, 3.0 * seed, height);
    for (int i = 0; i < NUMBERS; ++i)
    {
      variance += height[i] * height[i] / seeds;
    }
  }
  ASSERT_CLOSE(variance, known, 0.05 * known);
}

// A lone amplitude is a wave that travels along its wave vector with the speed of its dispersion:
// at (x, t) it is what it was at the origin at time 0.
TEST(waves_travel_along_their_wave_vector)
{
  static double amplitudes[NUMBERS];
  static double height[NUMBERS];
  memset(amplitudes, 0, sizeof amplitudes);
  const double k[2] = { 2.0 * pi / 200.0 * 3.0, 2.0 * pi / 200.0 * -5.0 };
  amplitudes[place(&tile, 3, -5)] = 0.5;
  const double length = hypot(k[0], k[1]);
  const double seconds = 5.0;
  const double way = seconds * sqrt(9.80665 / length); // phase velocity
  height_at(&tile, amplitudes, seconds, height);
  for (int pick = 0; pick < 2; ++pick) // the crest, then a quarter wave before it
  {
    const double there = way + pick * 0.5 * pi / length;
    double sum = 0.0;
    for (int sign = -1; sign <= 1; sign += 2)
    {
      const double* h = height + place(&tile, sign * 3, sign * -5);
      const double angle = sign * there * length;
      sum += h[0] * cos(angle) - h[1] * sin(angle);
    }
    ASSERT_CLOSE(sum, pick == 0 ? 1.0 : 0.0, 1e-13);
  }
}

// Slopes and chop of a lone wave of height cos(angle): -k sin(angle) and -sin(angle), which moves
// the water towards the crests.
TEST(fields_follow_from_the_height)
{
  static double height[NUMBERS];
  static double out[NUMBERS];
  memset(height, 0, sizeof height);
  height[place(&tile, 3, 4)] = 0.5;
  height[place(&tile, -3, -4)] = 0.5;
  const double step = 2.0 * pi / 200.0;
  const double known[4] = { 3.0 * step, 4.0 * step, 0.6, 0.8 };
  const water_tile_field fields[4] = { WATER_TILE_SLOPE_X, WATER_TILE_SLOPE_Y, WATER_TILE_CHOP_X,
    WATER_TILE_CHOP_Y };
  for (int i = 0; i < 4; ++i)
  {
    water_tile_derive(&tile, height, fields[i], out);
    // -s sin(angle) = Re(i s exp(i angle)): i s / 2 at k and -i s / 2 at -k
    ASSERT_CLOSE(out[place(&tile, 3, 4)], 0.0, 0.0);
    ASSERT_CLOSE(out[place(&tile, 3, 4) + 1], 0.5 * known[i], 1e-15);
    ASSERT_CLOSE(out[place(&tile, -3, -4) + 1], -0.5 * known[i], 1e-15);
  }
  // sin(angle) has the slope k cos(angle): -i / 2 becomes k / 2
  height[place(&tile, 3, 4)] = 0.0;
  height[place(&tile, 3, 4) + 1] = -0.5;
  height[place(&tile, -3, -4)] = 0.0;
  height[place(&tile, -3, -4) + 1] = 0.5;
  water_tile_derive(&tile, height, WATER_TILE_SLOPE_X, out);
  ASSERT_CLOSE(out[place(&tile, 3, 4)], 1.5 * step, 1e-15);
  ASSERT_CLOSE(out[place(&tile, -3, -4)], 1.5 * step, 1e-15);
  water_tile_derive(&tile, height, WATER_TILE_CHOP_Y, out);
  water_tile_derive(&tile, height, WATER_TILE_CHOP_Y, height); // in place
  assert_memory_equal(height, out, sizeof out);
}

// With a period the sea is bit for bit the same after any number of them, and near the free one at
// first.
TEST(period_repeats_exactly)
{
  static double amplitudes[NUMBERS];
  static double first[NUMBERS];
  static double later[NUMBERS];
  water_tile repeating = tile;
  repeating.period = 64.0;
  amplitudes_of(&tile, amplitudes);
  height_at(&repeating, amplitudes, 11.25, first);
  height_at(&repeating, amplitudes, 11.25 + 64.0 * 150000.0, later);
  assert_memory_equal(first, later, sizeof first);
  height_at(&tile, amplitudes, 11.25, later);
  assert_true(memcmp(first, later, sizeof first) != 0);
  height_at(&repeating, amplitudes, 0.0, first);
  height_at(&tile, amplitudes, 0.0, later);
  assert_memory_equal(first, later, sizeof first);
}

// The same seed is the same sea; another seed is another; a finer tile of the same length has the
// same long waves.
TEST(seed_makes_the_sea)
{
  static double one[NUMBERS];
  static double other[NUMBERS];
  amplitudes_of(&tile, one);
  amplitudes_of(&tile, other);
  assert_memory_equal(one, other, sizeof one);
  water_tile coarse = tile;
  coarse.size = 16;
  amplitudes_of(&coarse, other);
  for (int row = -7; row < 8; ++row)
  {
    for (int column = -7; column < 8; ++column)
    {
      const double* coarsely = other + place(&coarse, column, row);
      if (hypot(column, row) < 8.0) // the coarse tile's Nyquist wave number
      {
        assert_memory_equal(one + place(&tile, column, row), coarsely, 2 * sizeof(double));
      }
      else
      {
        assert_true(coarsely[0] == 0.0 && coarsely[1] == 0.0);
      }
    }
  }
  water_tile seeded = tile;
  seeded.seed = 12;
  amplitudes_of(&seeded, other);
  assert_true(memcmp(one, other, sizeof one) != 0);
}

// One forward FFT of a packed pair gives both fields: the sums over wave vectors that define them.
TEST(packed_pair_is_two_fields)
{
  enum
  {
    SMALL = 8
  };
  const water_tile small = { SMALL, 3.0, 0.0, 4, 0.0, 0.0 };
  double first[2 * SMALL * SMALL];
  double second[2 * SMALL * SMALL];
  double packed[2 * SMALL * SMALL];
  amplitudes_of(&small, packed);
  height_at(&small, packed, 0.7, first);
  water_tile_derive(&small, first, WATER_TILE_SLOPE_X, second);
  water_tile_pack(&small, first, second, packed);
  const int places[3][2] = { { 0, 0 }, { 3, 1 }, { 6, 7 } };
  for (int at = 0; at < 3; ++at)
  {
    double known[2] = { 0.0, 0.0 };
    double found[2] = { 0.0, 0.0 };
    for (int row = 0; row < SMALL; ++row)
    {
      for (int column = 0; column < SMALL; ++column)
      {
        const double angle = 2.0 * pi * (column * places[at][0] + row * places[at][1]) / SMALL;
        const size_t i = place(&small, column, row);
        known[0] += first[i] * cos(angle) - first[i + 1] * sin(angle);
        known[1] += second[i] * cos(angle) - second[i + 1] * sin(angle);
        found[0] += packed[i] * cos(angle) + packed[i + 1] * sin(angle);
        found[1] += packed[i + 1] * cos(angle) - packed[i] * sin(angle);
      }
    }
    ASSERT_CLOSE(found[0], known[0], 1e-14);
    ASSERT_CLOSE(found[1], known[1], 1e-14);
  }
  water_tile_pack(&small, first, NULL, packed);
  water_tile_pack(&small, first, NULL, first); // in place
  assert_memory_equal(first, packed, sizeof packed);
}

// Bilinear between the points, the same in every repetition of the tile, and exact far away.
TEST(samples_are_bilinear_and_repeat)
{
  const water_tile small = { 4, 8.0, 0.0, 0, 0.0, 0.0 };
  double values[16];
  for (int i = 0; i < 16; ++i)
  {
    values[i] = i * i;
  }
  const struct
  {
    double x, y, value;
  } cases[] = {
    { 2.0, 4.0, 81.0 },  // column 1, row 2
    { 3.0, 4.0, 90.5 },  // halfway to column 2
    { 2.0, 5.0, 125.0 }, // to row 3
    { 3.0, 5.0, 136.5 }, // between 81, 100, 169 and 196
    { 7.0, 7.0, 94.5 },  // between the four corners: 225, 144, 9 and 0
    { -1.0, -1.0, 94.5 },
    { 2.0 + 8e15, 4.0, 81.0 },
    { 2.0, 4.0 - 8e15, 81.0 },
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    double value = 0.0;
    assert_int_equal(water_tile_sample(&small, values, cases[i].x, cases[i].y, &value), WATER_OK);
    ASSERT_CLOSE(value, cases[i].value, 1e-12);
  }
  double share[2] = { 7.0, 7.0 };
  assert_int_equal(water_tile_place(&small, -1e-300, 10.0, share), WATER_OK);
  assert_true(share[0] == 0.0 && share[1] == 0.25); // never 1
  share[0] = 7.0;
  assert_int_equal(water_tile_place(&small, (double)NAN, 0.0, share), WATER_BAD_POINT);
  assert_int_equal(
    water_tile_sample(&small, values, 0.0, (double)INFINITY, share), WATER_BAD_POINT);
  assert_true(share[0] == 7.0);
}

// The natural length is 10 wavelengths: of the deep water's peak, less over a shallow bed.
TEST(natural_length_is_ten_peak_waves)
{
  const double peak = water_sea_peak(&sea);
  ASSERT_CLOSE(water_tile_natural_length(&sea), 20.0 * pi * 9.80665 / (peak * peak), 1e-9);
  water_sea other = sea;
  other.depth = 0.5;
  const double k = 20.0 * pi / water_tile_natural_length(&other);
  ASSERT_CLOSE(9.80665 * k * tanh(0.5 * k), peak * peak, 1e-12);
  other.model = WATER_SEA_PHILLIPS; // knows deep water only
  ASSERT_CLOSE(
    water_tile_natural_length(&other), 2.0 * pi * 36.0 / 9.80665 * 10.0 / sqrt(0.8), 1e-9);
  other.model = WATER_SEA_JONSWAP;
  other.depth = 1e-300;
  assert_true(water_tile_natural_length(&other) == 1e-3);
}

// What the tile holds and what it leaves out are together the slope of all waves that count.
TEST(held_and_left_out_slopes_are_all)
{
  double held[2];
  double left_out[2];
  double height = 0.0;
  double slope = 0.0;
  water_tile_slopes(&tile, &sea, held, left_out);
  assert_int_equal(water_sea_moments(&sea, 0.0, 370.0, &height, &slope), WATER_OK);
  ASSERT_CLOSE(held[0] + held[1] + left_out[0] + left_out[1], slope, 1e-5 * slope);
  ASSERT_CLOSE(water_tile_slope_rms(held, 0.1), sqrt(held[0] + held[1] + 0.01), 1e-15);
  water_tile fine = tile;
  fine.length = 0.1;
  water_tile_slopes(&fine, &sea, held, left_out);
  assert_true(left_out[0] == 0.0 && left_out[1] == 0.0);
}

TEST(texels_hold_slopes_and_squares)
{
  const water_tile small = { 4, 8.0, 0.0, 0, 0.0, 0.0 };
  double slopes[2][16];
  float texels[64];
  for (int i = 0; i < 16; ++i)
  {
    slopes[0][i] = 0.25 * i;
    slopes[1][i] = -0.5 * i;
  }
  water_tile_texels(&small, slopes[0], slopes[1], texels);
  const float known[4] = { 0.75f, -1.5f, 0.5625f, 2.25f };
  assert_memory_equal(texels + 12, known, sizeof known);
}

// Numbers out of range are refused by every function, and nothing is written.
TEST(bad_tiles_are_refused)
{
  const double nan = (double)NAN;
  const struct
  {
    water_tile tile;
    water_status status;
  } cases[] = {
    { { 2, 200.0, 0.0, 0 }, WATER_BAD_TILE_SIZE },
    { { 63, 200.0, 0.0, 0 }, WATER_BAD_TILE_SIZE },
    { { 16386, 200.0, 0.0, 0 }, WATER_BAD_TILE_SIZE },
    { { 64, 0.0, 0.0, 0 }, WATER_BAD_TILE_LENGTH },
    { { 64, nan, 0.0, 0 }, WATER_BAD_TILE_LENGTH },
    { { 64, (double)INFINITY, 0.0, 0 }, WATER_BAD_TILE_LENGTH },
    { { 64, 200.0, -1.0, 0 }, WATER_BAD_PERIOD },
    { { 64, 200.0, nan, 0 }, WATER_BAD_PERIOD },
  };
  double numbers[2] = { 7.0, 7.0 };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    assert_int_equal(water_tile_amplitudes(&cases[i].tile, &sea, numbers), cases[i].status);
    assert_int_equal(water_tile_at(&cases[i].tile, &sea, numbers, 0.0, numbers), cases[i].status);
  }
  water_sea calm = sea;
  calm.wind_speed = 0.0;
  assert_int_equal(water_tile_amplitudes(&tile, &calm, numbers), WATER_BAD_WIND_SPEED);
  assert_int_equal(water_tile_at(&tile, &sea, numbers, nan, numbers), WATER_BAD_TIME);
  assert_true(numbers[0] == 7.0 && numbers[1] == 7.0);
}

// Every wave of the tile has an amplitude, but for the mean and those from its Nyquist wave number
// on, and turns in time as h0(k) exp(-i w t) + conj(h0(-k)) exp(i w t), with w in whole turns of
// the period.
TEST(spectrum_turns_as_its_formula)
{
  enum
  {
    N = 8
  };
  const water_sea windy = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, 8.0, 0.4, 1e4,
    (double)INFINITY, 3.3, 10.0 };
  const double two_pi = 6.283185307179586;
  for (int round = 0; round < 2; ++round)
  {
    const water_tile small = { N, 60.0, round == 0 ? 0.0 : 20.0, 5, 0.0, 0.0 };
    const double time = 3.25;
    double h0[2 * N * N];
    double h[2 * N * N];
    assert_int_equal(water_tile_amplitudes(&small, &windy, h0), WATER_OK);
    assert_int_equal(water_tile_at(&small, &windy, h0, time, h), WATER_OK);
    for (int i = 0; i < N * N; ++i)
    {
      const int column = i % N;
      const int row = i / N;
      const int across = column < N / 2 ? column : column - N;
      const int along = row < N / 2 ? row : row - N;
      const int is_used = i != 0 && hypot(across, along) < N / 2;
      assert_int_equal(h0[2 * i] != 0.0 && h0[2 * i + 1] != 0.0, is_used);
      const double kx = two_pi * across / 60.0;
      const double ky = two_pi * along / 60.0;
      const double frequency = sqrt(9.80665 * hypot(kx, ky)) / two_pi;
      const double turns =
        round == 0 ? frequency * time : fmax(1.0, rint(frequency * 20.0)) * time / 20.0;
      const double c = cos(two_pi * turns);
      const double s = sin(two_pi * turns);
      const double* own = h0 + 2 * i;
      const double* other = h0 + 2 * ((N - row) % N * N + (N - column) % N);
      const double real = own[0] * c + own[1] * s + other[0] * c + other[1] * s;
      const double imaginary = own[1] * c - own[0] * s + other[0] * s - other[1] * c;
      ASSERT_CLOSE(h[2 * i], is_used ? real : 0.0, 1e-14);
      ASSERT_CLOSE(h[2 * i + 1], is_used ? imaginary : 0.0, 1e-14);
    }
  }
}

// Tiles are the same if each of their numbers is.
TEST(tiles_are_the_same_in_all_numbers)
{
  const water_tile given = { 16, 100.0, 60.0, 5, 0.1, 2.0 };
  water_tile other[6];
  for (int i = 0; i < 6; ++i)
  {
    other[i] = given;
    assert_true(water_tile_is_same(&given, other + i));
  }
  other[0].size = 32;
  other[1].length = 101.0;
  other[2].period = 61.0;
  other[3].seed = 6;
  other[4].k_low = 0.2;
  other[5].k_high = 3.0;
  for (int i = 0; i < 6; ++i)
  {
    assert_false(water_tile_is_same(&given, other + i));
  }
}

// The band of a tile's waves is refused unless it rises: a lower end that is not finite or
// negative, an upper one that is not finite or not above it.
TEST(bad_bands_are_refused)
{
  const double bands[6][2] = { { NAN, 1.0 }, { INFINITY, 0.0 }, { -1.0, 1.0 }, { 0.5, INFINITY },
    { 0.5, 0.5 }, { 0.5, NAN } };
  double numbers[2] = { 7.0, 7.0 };
  for (int i = 0; i < 6; ++i)
  {
    const water_tile bad = { 64, 200.0, 0.0, 0, bands[i][0], bands[i][1] };
    assert_int_equal(water_tile_amplitudes(&bad, &sea, numbers), WATER_BAD_WAVENUMBER);
  }
  assert_true(numbers[0] == 7.0);
}

// A band that goes on beyond the Nyquist wave number ends there: it is the whole tile's, to the
// bit.
TEST(a_band_ends_at_the_nyquist_wave_number)
{
  static double amplitudes[2][NUMBERS];
  double held[2][2];
  double left_out[2][2];
  const double nyquist = pi * SIDE / tile.length;
  for (int i = 0; i < 2; ++i)
  {
    water_tile own = tile;
    own.k_high = i ? 1.3 * nyquist : 0.0; // the corners of the square reach up to 1.41
    amplitudes_of(&own, amplitudes[i]);
    water_tile_slopes(&own, &sea, held[i], left_out[i]);
  }
  assert_memory_equal(amplitudes[0], amplitudes[1], sizeof amplitudes[0]);
  assert_memory_equal(held[0], held[1], sizeof held[0]);
  assert_memory_equal(left_out[0], left_out[1], sizeof left_out[0]);
}

// Of two bands that meet at the wave number of waves, these are in the upper one alone.
TEST(bands_that_meet_at_a_wave_share_none)
{
  static double whole[NUMBERS];
  static double parts[2][NUMBERS];
  water_tile low = tile;
  water_tile high = tile;
  low.k_high = high.k_low = 2.0 * pi * 5.0 / tile.length;
  amplitudes_of(&tile, whole);
  amplitudes_of(&low, parts[0]);
  amplitudes_of(&high, parts[1]);
  const size_t at = place(&tile, 5, 0);
  assert_true(whole[at] != 0.0 && parts[0][at] == 0.0);
  for (size_t i = 0; i < NUMBERS; ++i)
  {
    ASSERT_CLOSE(parts[0][i] + parts[1][i], whole[i], 0.0);
    assert_true(parts[0][i] == 0.0 || parts[1][i] == 0.0);
  }
}

// The mean, and waves of two points, have no slope and no chop, which are 0 and not 0 / 0.
TEST(the_mean_has_no_direction)
{
  static double amplitudes[NUMBERS];
  static double height[NUMBERS];
  static double field[NUMBERS];
  amplitudes_of(&tile, amplitudes);
  height_at(&tile, amplitudes, 2.0, height);
  for (int kind = WATER_TILE_SLOPE_X; kind <= WATER_TILE_CHOP_Y; ++kind)
  {
    water_tile_derive(&tile, height, (water_tile_field)kind, field);
    for (int i = 0; i < 4; ++i)
    {
      const double* found = field + place(&tile, i % 2 ? SIDE / 2 : 0, i / 2 ? SIDE / 2 : 0);
      ASSERT_CLOSE(found[0], 0.0, 0.0);
      ASSERT_CLOSE(found[1], 0.0, 0.0);
    }
  }
}

TESTS(bands_that_meet_at_a_wave_share_none, the_mean_has_no_direction, bad_bands_are_refused,
  a_band_ends_at_the_nyquist_wave_number, tiles_are_the_same_in_all_numbers, spectrum_is_hermitian,
  tile_holds_the_variance_of_the_spectrum, variance_is_that_of_the_spectrum,
  waves_travel_along_their_wave_vector, fields_follow_from_the_height, period_repeats_exactly,
  seed_makes_the_sea, packed_pair_is_two_fields, samples_are_bilinear_and_repeat,
  natural_length_is_ten_peak_waves, held_and_left_out_slopes_are_all,
  texels_hold_slopes_and_squares, bad_tiles_are_refused, spectrum_turns_as_its_formula)
