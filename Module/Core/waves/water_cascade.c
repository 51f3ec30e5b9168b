// SPDX-License-Identifier: BSD-3-Clause
// water_cascade.c: a wind sea on several tiles, each with a band of its wave numbers.
#include "water_cascade.h"

#include "water_math.h"
#include "water_phase.h"
#include "water_random.h"

// A band ends where a wave has 8 / 3 points: bilinear between points it keeps most of its slope.
static const double band_end = 0.75; // of the Nyquist wave number
static const double longest = 5.0;   // the longest waves of a band, along its tile
static const double natural_waves = 24.0;
static const double reach_sigmas = 6.0;

double water_cascades_natural_length(const water_sea* sea, size_t count)
{
  return count <= 1 ? water_tile_natural_length(sea)
                    : fmax(natural_waves * water_tile_peak_wavelength(sea), 1e-3);
}

// Nyquist wave number of a tile's points.
static double nyquist_of(double size, double length)
{
  return 0.5 * water_two_pi * size / length;
}

water_status water_cascades_make(
  const water_tile* first, const water_sea* sea, size_t count, water_cascades* made)
{
  water_tile whole = *first;
  whole.k_low = 0.0;
  whole.k_high = 0.0;
  if (count < 1 || count > WATER_CASCADES_MAX)
  {
    return WATER_BAD_CASCADES;
  }
  const water_status status = water_tile_check(&whole, sea);
  if (status != WATER_OK)
  {
    return status;
  }
  const double size = (double)first->size;
  const double most = band_end * size / (2.0 * longest); // from a tile to the next
  const double needed = WATER_TILE_SHORTEST / nyquist_of(size, first->length);
  const double steps = most > 1.0 && needed > 1.0 ? ceil(log(needed) / log(most)) : 0.0;
  const size_t others = (size_t)fmin((double)(count - 1), steps);
  const double factor = others > 0 ? fmin(most, pow(needed, 1.0 / (double)others)) : 1.0;
  made->count = others + 1;
  for (size_t i = 0; i <= others; ++i)
  {
    water_tile* tile = &made->tiles[i];
    *tile = whole;
    tile->length = i > 0 ? made->tiles[i - 1].length / factor : whole.length;
    tile->seed = i > 0 ? water_random_bits(whole.seed, i) : whole.seed;
    tile->k_low = i > 0 ? made->tiles[i - 1].k_high : 0.0;
    tile->k_high = i < others ? band_end * nyquist_of(size, tile->length) : 0.0;
  }
  return WATER_OK;
}

void water_cascades_slopes(const water_cascades* cascades, const water_sea* sea, double beyond[][2])
{
  water_sea along = *sea;
  along.wind_dir_rad = 0.0;
  const size_t last = cascades->count - 1;
  for (size_t i = cascades->count; i-- > 0;)
  {
    double held[2];
    double left_out[2] = { 0.0, 0.0 };
    const water_tile* tile = &cascades->tiles[i];
    const double end = i < last ? tile->k_high : nyquist_of((double)tile->size, tile->length);
    (void)water_sea_slopes(&along, tile->k_low, end, held);
    if (i == last && end < WATER_TILE_SHORTEST)
    {
      (void)water_sea_slopes(&along, end, WATER_TILE_SHORTEST, left_out);
    }
    for (int j = 0; j < 2; ++j)
    {
      beyond[i + 1][j] = i == last ? left_out[j] : beyond[i + 1][j];
      beyond[i][j] = beyond[i + 1][j] + held[j];
    }
  }
}

void water_cascades_turn(const water_sea* sea, const double along_wind[2], double along_axes[2])
{
  const double c = cos(remainder(sea->wind_dir_rad, water_two_pi));
  const double share = c * c;
  along_axes[0] = share * along_wind[0] + (1.0 - share) * along_wind[1];
  along_axes[1] = (1.0 - share) * along_wind[0] + share * along_wind[1];
}

double water_cascades_longest(const water_cascades* cascades, size_t tile)
{
  const water_tile* of = &cascades->tiles[tile];
  return of->k_low > 0.0 ? water_two_pi / of->k_low : of->length;
}

double water_cascades_height(const water_sea* sea)
{
  double height = 0.0;
  double slope = 0.0;
  (void)water_sea_moments(sea, 0.0, WATER_TILE_SHORTEST, &height, &slope);
  return height;
}

void water_cascades_reach(double height_variance, double choppiness, double* height, double* across)
{
  *height = reach_sigmas * sqrt(height_variance);
  *across = choppiness * *height;
}

typedef struct weights // of the four points about a place
{
  size_t at[4];
  double share[4];
} weights;

static bool weights_at(const water_tile* tile, double x, double y, weights* made)
{
  double share[2];
  if (water_tile_place(tile, x, y, share) != WATER_OK)
  {
    return false;
  }
  const size_t n = tile->size;
  const double column = share[0] * (double)n;
  const double row = share[1] * (double)n;
  const size_t low[2] = { (size_t)column % n, (size_t)row % n };
  const size_t high[2] = { (low[0] + 1) % n, (low[1] + 1) % n };
  const double part[2] = { column - floor(column), row - floor(row) };
  for (size_t i = 0; i < 4; ++i)
  {
    made->at[i] = (i < 2 ? low[1] : high[1]) * n + (i % 2 == 0 ? low[0] : high[0]);
    made->share[i] = (i < 2 ? 1.0 - part[1] : part[1]) * (i % 2 == 0 ? 1.0 - part[0] : part[0]);
  }
  return true;
}

static double value_at(const weights* of, const double* field)
{
  double sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    sum += of->share[i] * field[of->at[i]];
  }
  return sum;
}

bool water_cascades_add(const void* surface, double x, double y, water_wave_sum* sum)
{
  const water_cascade_surface* sea = surface;
  for (size_t i = 0; i < sea->cascades->count; ++i)
  {
    const water_cascade_fields* fields = &sea->fields[i];
    weights at;
    if (!weights_at(&sea->cascades->tiles[i], x / sea->units_per_m, y / sea->units_per_m, &at))
    {
      return false;
    }
    for (int j = 0; j < 2; ++j)
    {
      sum->moved[j] += sea->choppiness * sea->units_per_m * value_at(&at, fields->chop[j]);
      sum->gradient[j] += value_at(&at, fields->slope[j]);
    }
    sum->moved[2] += sea->units_per_m * value_at(&at, fields->height);
    sum->stretch[0] += sea->choppiness * value_at(&at, fields->bend[0]);
    sum->stretch[1] += sea->choppiness * value_at(&at, fields->bend[2]);
    sum->stretch[2] += sea->choppiness * value_at(&at, fields->bend[1]);
  }
  return true;
}
