// SPDX-License-Identifier: BSD-3-Clause
// water_cascade.c: a wind sea on several tiles, each with a band of its wave numbers.
#include "water_cascade.h"

#include "water_math.h"
#include "water_phase.h"
#include "water_random.h"

#include <string.h>

// A band ends where a wave has 8 / 3 points: bilinear between points it keeps most of its slope.
static const double band_end = 0.75; // of the Nyquist wave number
static const double longest = 5.0;   // the longest waves of a band, along its tile
static const double natural_waves = 24.0;
static const double reach_sigmas = 6.0;

// Lengths of the warps in lengths of the second tile, and their directions, deg: of random sets of
// four the one that leaves the least autocorrelation of the second tile's waves, that tile's length
// aside or a multiple of it. The derivatives of the four together are 0.08 (rms): the variance of
// slopes changes by 0.3 %.
static const double warp_lengths[WATER_CASCADE_WARPS] = { 8.78, 5.63, 6.59, 8.78 };
static const double warp_directions_deg[WATER_CASCADE_WARPS] = { 156.4, 202.7, 264.4, 289.6 };
static const double warp_share = 0.0085; // of a warp's length, that it moves places by at most

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
  memset(made->warps, 0, sizeof made->warps);
  for (size_t i = 0; i < WATER_CASCADE_WARPS && others > 0; ++i)
  {
    const double length = warp_lengths[i] * made->tiles[1].length;
    const double angle = warp_directions_deg[i] * water_two_pi / 360.0;
    water_cascade_warp* warp = &made->warps[i];
    warp->cycles[0] = cos(angle) / length;
    warp->cycles[1] = sin(angle) / length;
    warp->way[0] = -warp_share * length * sin(angle);
    warp->way[1] = warp_share * length * cos(angle);
  }
  return WATER_OK;
}

void water_cascades_warped(
  const water_cascades* cascades, const double place[2], double moved[2], double turn[2][2])
{
  moved[0] = moved[1] = turn[0][0] = turn[0][1] = turn[1][0] = turn[1][1] = 0.0;
  for (size_t i = 0; i < WATER_CASCADE_WARPS; ++i)
  {
    const water_cascade_warp* warp = &cascades->warps[i];
    const double cycles = warp->cycles[0] * place[0] + warp->cycles[1] * place[1];
    const double part = cycles - floor(cycles) - 0.5;
    const double swing = 8.0 * part * (1.0 - 2.0 * fabs(part)); // from -1 to 1
    const double change = 8.0 - 32.0 * fabs(part);
    for (size_t j = 0; j < 2; ++j)
    {
      moved[j] += swing * warp->way[j];
      turn[j][0] += change * warp->way[j] * warp->cycles[0];
      turn[j][1] += change * warp->way[j] * warp->cycles[1];
    }
  }
}

void water_cascades_warp_under(const water_cascades* cascades, size_t warp, double metres_per_unit,
  const double origin[2], double values[4])
{
  const water_cascade_warp* of = &cascades->warps[warp];
  values[0] = metres_per_unit * of->cycles[0];
  values[1] = metres_per_unit * of->cycles[1];
  const double cycles = values[0] * origin[0] + values[1] * origin[1];
  values[2] = cycles - floor(cycles);
  const double square = values[0] * values[0] + values[1] * values[1];
  const double way = (values[0] * of->way[1] - values[1] * of->way[0]) / metres_per_unit;
  values[3] = square > 0.0 ? way / square : 0.0;
}

void water_cascades_place(const water_cascades* cascades, size_t tile, const double place[2],
  double on_tile[2], double turn[2][2])
{
  double moved[2] = { 0.0, 0.0 };
  turn[0][0] = turn[0][1] = turn[1][0] = turn[1][1] = 0.0;
  if (tile > 0)
  {
    water_cascades_warped(cascades, place, moved, turn);
  }
  on_tile[0] = place[0] + moved[0];
  on_tile[1] = place[1] + moved[1];
}

void water_cascades_turned(double turn[2][2], double slope[2])
{
  const double own[2] = { slope[0], slope[1] };
  slope[0] += turn[0][0] * own[0] + turn[1][0] * own[1];
  slope[1] += turn[0][1] * own[0] + turn[1][1] * own[1];
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

void water_cascades_turn(const water_sea* sea, const double along_wind[2], double along_axes[3])
{
  const double c = cos(remainder(sea->wind_dir_rad, water_two_pi));
  const double s = sin(remainder(sea->wind_dir_rad, water_two_pi));
  const double share = c * c;
  along_axes[0] = share * along_wind[0] + (1.0 - share) * along_wind[1];
  along_axes[1] = (1.0 - share) * along_wind[0] + share * along_wind[1];
  along_axes[2] = c * s * (along_wind[0] - along_wind[1]);
}

double water_cascades_lean(const double from[3], const double beyond[3])
{
  const double sum = from[0] - beyond[0] + from[1] - beyond[1];
  return sum > 0.0 ? (from[2] - beyond[2]) / sum : 0.0;
}

double water_cascades_longest(const water_cascades* cascades, size_t tile)
{
  const water_tile* of = &cascades->tiles[tile];
  return of->k_low > 0.0 ? water_two_pi / of->k_low : of->length;
}

void water_cascades_band(
  const water_cascades* cascades, const water_sea* sea, size_t tile, double band[2])
{
  const water_tile* of = &cascades->tiles[tile];
  const double peak = water_tile_peak_wavelength(sea);
  const double held = water_cascades_longest(cascades, tile);
  band[1] = of->k_high > 0.0 ? of->k_high : nyquist_of((double)of->size, of->length);
  band[0] = water_two_pi / (peak > 0.0 ? fmin(held, peak) : held);
  band[0] = fmin(band[0], 0.5 * band[1]); // of a tile shorter than the peak's points
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
    const double place[2] = { x / sea->units_per_m, y / sea->units_per_m };
    double on_tile[2];
    double turn[2][2];
    water_cascades_place(sea->cascades, i, place, on_tile, turn);
    weights at;
    if (!weights_at(&sea->cascades->tiles[i], on_tile[0], on_tile[1], &at))
    {
      return false;
    }
    double slope[2] = { value_at(&at, fields->slope[0]), value_at(&at, fields->slope[1]) };
    water_cascades_turned(turn, slope);
    for (int j = 0; j < 2; ++j)
    {
      sum->moved[j] += sea->choppiness * sea->units_per_m * value_at(&at, fields->chop[j]);
      sum->gradient[j] += slope[j];
    }
    // as on the tile: the warp would change these by a twelfth, and slopes by that of their own
    sum->moved[2] += sea->units_per_m * value_at(&at, fields->height);
    sum->stretch[0] += sea->choppiness * value_at(&at, fields->bend[0]);
    sum->stretch[1] += sea->choppiness * value_at(&at, fields->bend[2]);
    sum->stretch[2] += sea->choppiness * value_at(&at, fields->bend[1]);
  }
  return true;
}
