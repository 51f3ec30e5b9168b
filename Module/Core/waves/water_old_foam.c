// SPDX-License-Identifier: BSD-3-Clause
// water_old_foam.c: the foam that crests of a wind sea have left behind, as a function of time.
#include "water_old_foam.h"

#include "water_math.h"
#include "water_phase.h"
#include "water_whitecap.h"

static const double lives = 3.0;            // after which a crest's foam has gone: 5 % of it
static const double steps_of_a_wave = 10.0; // a crest moves by less than its foam is wide in one
static const double apart = 0.8; // of the foam; the rest lies on older foam: waves come in groups
static const double largest_level = 8.0; // standard deviations; what is rarer never happens

enum
{
  PANELS = 512 // of the spectrum, in ln k; halves of a level; parts of a normal distribution
};

typedef struct crests // the Jacobian of a tile, to first order: a Gaussian process in time
{
  double variance; // with that over which a crest turns white
  double likeness; // correlation after a step
  double step_s;
} crests;

// The variance of the tile's Jacobian, that of its rate of change (1/s^2), and its covariance after
// a time.
static void moments_of(
  const water_sea* sea, const water_tile* tile, double after_s, double moments[3])
{
  const double nyquist = 0.5 * water_two_pi * (double)tile->size / tile->length;
  const double low = fmax(tile->k_low, water_two_pi / tile->length);
  const double high = tile->k_high > 0.0 ? fmin(tile->k_high, nyquist) : nyquist;
  memset(moments, 0, 3 * sizeof moments[0]);
  const double panel = log(high / low) / PANELS;
  for (int i = 0; i < PANELS && panel > 0.0; ++i)
  {
    const double k = low * exp((i + 0.5) * panel);
    const double omega = water_dispersion(k, sea->depth);
    const double part = water_sea_wavenumber_density(sea, k) * k * k * k * panel;
    moments[0] += part;
    moments[1] += omega * omega * part;
    moments[2] += cos(omega * after_s) * part;
  }
}

static double share_above(double level)
{
  return 0.5 * erfc(level * sqrt(0.5));
}

// The chance that of two normal numbers of a correlation only the second is above a level.
static double chance_to_rise(double level, double likeness)
{
  const double width = largest_level / PANELS; // what is farther over it hardly counts
  const double across = sqrt(fmax(1.0 - likeness * likeness, 1e-12));
  double sum = 0.0;
  for (int i = 0; i < PANELS; ++i)
  {
    const double x = level + (i + 0.5) * width;
    const double stays = share_above((level - likeness * x) / across);
    sum += exp(-0.5 * x * x) / sqrt(water_two_pi) * (1.0 - stays) * width;
  }
  return sum;
}

// The mean share that is foam. What breaks once at a place leaves foam for a lifetime.
static double cover_of(const crests* of, double level, double life_s)
{
  const double breaking = share_above(level);
  const double left = chance_to_rise(level, of->likeness) / of->step_s * life_s;
  return breaking + apart * left;
}

water_status water_old_foam_make(
  const water_sea* sea, const water_tile* first, double cover, double life_s, water_old_foam* made)
{
  const water_status status = water_tile_check(first, sea);
  if (status != WATER_OK)
  {
    return status;
  }
  if (!(life_s >= 0.0 && life_s <= WATER_FOAM_LIFE_MAX))
  {
    return WATER_BAD_LIFE_TIME;
  }
  memset(made, 0, sizeof *made);
  made->fresh = cover;
  made->tile = *first;
  made->tile.size = first->size < WATER_OLD_FOAM_SIZE_MAX ? first->size : WATER_OLD_FOAM_SIZE_MAX;
  double moments[3];
  moments_of(sea, &made->tile, 0.0, moments);
  if (!(life_s > 0.0) || !(cover > 0.0) || !(cover < 1.0) || !(moments[0] > 0.0))
  {
    return WATER_OK;
  }
  const double turn_s = water_two_pi * sqrt(moments[0] / moments[1]);
  const double longest = lives * life_s / WATER_OLD_FOAM_TIMES_MAX;
  made->step_s = fmax(fmin(turn_s / steps_of_a_wave, 0.5 * life_s), longest);
  if (first->period > 0.0) // so that earlier times come back as well
  {
    made->step_s = first->period / ceil(first->period / made->step_s);
  }
  const double count = ceil(lives * life_s / made->step_s);
  made->count = (size_t)fmin(fmax(count, 2.0), WATER_OLD_FOAM_TIMES_MAX);
  made->life_s = life_s;
  moments_of(sea, &made->tile, made->step_s, moments);
  const double softness = water_whitecap_softness();
  const double variance = moments[0] + softness * softness;
  const crests of = { variance, (moments[2] + softness * softness) / variance, made->step_s };
  double low = -largest_level;
  double high = largest_level;
  for (int i = 0; i < 50; ++i)
  {
    const double middle = 0.5 * (low + high);
    const bool is_too_white = cover_of(&of, middle, life_s) > cover;
    low = is_too_white ? middle : low;
    high = is_too_white ? high : middle;
  }
  made->jacobian = 1.0 - low * sqrt(variance);
  made->fresh = share_above(low);
  return WATER_OK;
}

bool water_old_foam_is_same(const water_old_foam* a, const water_old_foam* b)
{
  return a->count == b->count && a->life_s == b->life_s && a->step_s == b->step_s &&
    a->jacobian == b->jacobian && a->fresh == b->fresh && water_tile_is_same(&a->tile, &b->tile);
}

void water_old_foam_at(const water_old_foam* foam, double time, double* newest, double weights[3])
{
  *newest = 0.0;
  memset(weights, 0, 3 * sizeof weights[0]);
  if (foam->count == 0)
  {
    return;
  }
  const double now = foam->tile.period > 0.0 ? fmod(time, foam->tile.period) : time;
  *newest = floor(now / foam->step_s);
  const double age = fmin(fmax(now - *newest * foam->step_s, 0.0), foam->step_s);
  const double left = exp(-age / foam->life_s);
  weights[0] = left;
  weights[1] = left * age / foam->step_s;
  weights[2] = left - weights[1];
}

double water_old_foam_time(const water_old_foam* foam, double number)
{
  return number * foam->step_s;
}

void water_old_foam_shares(const water_old_foam* foam, const double* stretch_x,
  const double* stretch_y, unsigned char* shares)
{
  const double per_softness = 1.0 / water_whitecap_softness();
  const size_t count = foam->tile.size * foam->tile.size;
  for (size_t i = 0; i < count; ++i)
  {
    const double level = (1.0 + stretch_x[i] + stretch_y[i] - foam->jacobian) * per_softness;
    shares[i] = level > 4.0 ? 0 : (unsigned char)(255.0 * share_above(level) + 0.5);
  }
}

void water_old_foam_join(
  const water_old_foam* foam, const unsigned char* const* shares, float* texels)
{
  float left[WATER_OLD_FOAM_TIMES_MAX];
  for (size_t i = 0; i < foam->count; ++i)
  {
    left[i] = (float)(exp(-(double)i * foam->step_s / foam->life_s) / 255.0);
  }
  const size_t oldest = foam->count - 1;
  const size_t count = foam->tile.size * foam->tile.size;
  for (size_t place = 0; place < count; ++place)
  {
    float most = 0.0f;
    for (size_t i = 1; i < oldest; ++i)
    {
      const float share = left[i] * (float)shares[i][place];
      most = share > most ? share : most;
    }
    float* texel = texels + 4 * place;
    texel[0] = most;
    texel[1] = fmaxf(left[0] * (float)shares[0][place] - most, 0.0f);
    texel[2] = fmaxf(left[oldest] * (float)shares[oldest][place] - most, 0.0f);
    texel[3] = 0.0f;
  }
}
