// SPDX-License-Identifier: BSD-3-Clause
// fuzz_sea.c: any wind sea, on any tile.
#include "fuzz_input.h"

#include "water_fft.h"
#include "water_glitter.h"
#include "water_shared.h"
#include "water_tile_time.h"
#include "water_turns.h"

enum
{
  SIDE = 16
};

static void fuzz_spectrum(fuzz_input* from, const water_sea* sea)
{
  const double omega = fuzz_near(from, 1.0);
  if (omega > 0.0 && isfinite(omega))
  {
    PROMISED(!(water_sea_frequency_density(sea, omega) < 0.0));
    PROMISED(!(water_sea_spread(sea, omega, fuzz_double(from)) < 0.0));
    PROMISED(!(water_sea_depth_factor(omega, sea->depth) < 0.0));
  }
  PROMISED(!(water_sea_density(sea, fuzz_double(from), fuzz_double(from)) < 0.0));
  double height = 0.0;
  double slope = 0.0;
  double variance[2];
  const double low = fuzz_near(from, 0.1);
  const double high = fuzz_near(from, 10.0);
  const uint8_t chance = fuzz_byte(from); // these take long
  if (chance % 16 == 0 && water_sea_moments(sea, low, high, &height, &slope) == WATER_OK)
  {
    PROMISED(!(height < 0.0) && !(slope < 0.0));
  }
  if (chance == 1)
  {
    (void)water_sea_slopes(sea, low, high, variance);
  }
}

// The same row by row, of threads and shaders.
static void fuzz_rows(fuzz_input* from, const water_tile* tile, const water_sea* sea,
  const double* amplitudes, double time)
{
  static double frequencies[SIDE * SIDE / 4];
  static double phasors[SIDE * SIDE / 2];
  static double rows[2][2 * SIDE];
  static float numbers[4 * SIDE * SIDE];
  const size_t half = tile->size / 2;
  PROMISED(water_tile_frequencies(tile, sea, frequencies) == WATER_OK);
  if (isfinite(time))
  {
    water_tile_phasors(tile, frequencies, time, 0, half, phasors);
    const size_t row = fuzz_below(from, half);
    for (int pair = 0; pair < WATER_PAIR_COUNT; ++pair)
    {
      water_tile_pair_row(tile, amplitudes, phasors, (water_tile_pair)pair, row, rows[0], rows[1]);
    }
  }
  water_tile_pair_waves(tile, amplitudes, WATER_PAIR_SLOPES, numbers);
  const int exponent = water_turns_exponent(frequencies[half * half - 1]);
  uint32_t units[2];
  uint32_t words[3];
  water_turns_frequency(frequencies[half], exponent, words);
  if (water_turns_time(water_tile_clock(tile, time), exponent, units))
  {
    const uint32_t phase = water_shared_phase(words[0], words[1], words[2], units[0], units[1]);
    PROMISED(fabs(water_shared_cosine(phase)) < 1.0001);
  }
  water_fft plan;
  PROMISED(water_fft_plan(tile->size, &plan)); // all of so few points
  water_fft_table(&plan, (int)fuzz_below(from, (size_t)plan.count), numbers);
}

int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size)
{
  fuzz_input from = { bytes, size };
  static double amplitudes[2 * SIDE * SIDE];
  static double height[2 * SIDE * SIDE];
  static double field[2 * SIDE * SIDE];
  static float texels[4 * SIDE * SIDE];
  water_tile tile;
  water_sea sea;
  tile.size = fuzz_below(&from, SIDE + 2);
  tile.length = fuzz_near(&from, 100.0);
  tile.period = fuzz_near(&from, 0.0);
  fuzz_raw(&from, &tile.seed, sizeof tile.seed);
  sea.model = (water_sea_model)(fuzz_byte(&from) % 3);
  sea.spreading = (water_sea_spreading)(fuzz_byte(&from) % 3);
  sea.wind_speed = fuzz_near(&from, 8.0);
  sea.wind_dir_rad = fuzz_near(&from, 0.0);
  sea.fetch = fuzz_near(&from, 1e4);
  sea.depth = fuzz_near(&from, 10.0);
  sea.peak_enhancement = fuzz_near(&from, 3.3);
  sea.spreading_power = fuzz_near(&from, 10.0);
  if (water_sea_check(&sea) == WATER_OK)
  {
    fuzz_spectrum(&from, &sea);
    PROMISED(water_tile_natural_length(&sea) >= 1e-3);
  }
  const double time = fuzz_near(&from, 1.0);
  const double x = fuzz_near(&from, 1.0);
  const double y = fuzz_near(&from, 1.0);
  if (tile.size <= SIDE && water_tile_amplitudes(&tile, &sea, amplitudes) == WATER_OK)
  {
    fuzz_rows(&from, &tile, &sea, amplitudes, time);
    if (water_tile_at(&tile, &sea, amplitudes, time, height) == WATER_OK)
    {
      water_tile_derive(&tile, height, (water_tile_field)(fuzz_byte(&from) % 4), field);
      water_tile_pack(&tile, height, fuzz_bool(&from) ? field : NULL, field);
      water_tile_texels(&tile, field, height, texels);
    }
    double share[2];
    double value;
    if (water_tile_place(&tile, x, y, share) == WATER_OK)
    {
      PROMISED(share[0] >= 0.0 && share[0] < 1.0 && share[1] >= 0.0 && share[1] < 1.0);
      PROMISED(water_tile_sample(&tile, field, x, y, &value) == WATER_OK);
    }
  }
  double variance[2];
  double facet;
  if (water_glitter_variance(fuzz_double(&from), variance) == WATER_OK)
  {
    double dirs[2][3];
    fuzz_doubles(&from, &dirs[0][0], 6);
    (void)water_glitter_radiance(dirs[0], dirs[1], fuzz_double(&from), variance, &facet);
  }
  return 0;
}
