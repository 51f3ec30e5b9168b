// SPDX-License-Identifier: BSD-3-Clause
// test_old_foam.c: foam that crests have left covers what was measured, decays with its life time,
// and depends on the time alone, without jumps.
#include "test_main.h"

#include "water_cascade.h"
#include "water_old_foam.h"
#include "water_tile_time.h"
#include "water_whitecap.h"

#include <stdlib.h>
#include <string.h>

enum
{
  N = 128,
  PLACES = N * N
};

static water_sea sea_of(double wind)
{
  const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, wind, 0.4,
    (double)INFINITY, (double)INFINITY, 1.0, 10.0 };
  return sea;
}

static water_tile first_tile(const water_sea* sea, double period)
{
  const water_tile tile = { N, water_cascades_natural_length(sea, 2), period, 7, 0.0, 0.0 };
  water_cascades cascades;
  assert_int_equal(water_cascades_make(&tile, sea, 2, &cascades), WATER_OK);
  return cascades.tiles[0];
}

static water_old_foam foam_of(double wind, double cover, double life_s, double period)
{
  const water_sea sea = sea_of(wind);
  const water_tile tile = first_tile(&sea, period);
  water_old_foam foam;
  assert_int_equal(water_old_foam_make(&sea, &tile, cover, life_s, &foam), WATER_OK);
  return foam;
}

// A forward FFT of N numbers that lie a stride apart, by halves.
static void fft(const double* in, size_t stride, size_t count, double* out)
{
  if (count == 1)
  {
    out[0] = in[0];
    out[1] = in[1];
    return;
  }
  const size_t half = count / 2;
  fft(in, 2 * stride, half, out);
  fft(in + 2 * stride, 2 * stride, half, out + 2 * half);
  for (size_t i = 0; i < half; ++i)
  {
    const double angle = -2.0 * 3.141592653589793 * (double)i / (double)count;
    const double c = cos(angle);
    const double s = sin(angle);
    double* a = out + 2 * i;
    double* b = out + 2 * (half + i);
    const double turned[2] = { c * b[0] - s * b[1], s * b[0] + c * b[1] };
    b[0] = a[0] - turned[0];
    b[1] = a[1] - turned[1];
    a[0] += turned[0];
    a[1] += turned[1];
  }
}

typedef struct waves // of a tile
{
  double amplitudes[2 * PLACES];
  double frequencies[PLACES / 4];
  double phasors[PLACES / 2];
  double spectrum[2 * PLACES];
  double rows[2 * PLACES];
  double line[2 * N];
  double stretch[2][PLACES];
} waves;

static void stretch_at(const water_tile* tile, double time, waves* w)
{
  water_tile_phasors(tile, w->frequencies, time, 0, N / 2, w->phasors);
  memset(w->spectrum, 0, sizeof w->spectrum);
  for (size_t row = 0; row < N / 2; ++row)
  {
    double unused[2 * N];
    double* mirror = row > 0 ? w->spectrum + 2 * N * (N - row) : unused;
    water_tile_pair_row(
      tile, w->amplitudes, w->phasors, WATER_PAIR_STRETCH, row, w->spectrum + 2 * N * row, mirror);
  }
  for (size_t row = 0; row < N; ++row)
  {
    fft(w->spectrum + 2 * N * row, 1, N, w->rows + 2 * N * row);
  }
  for (size_t column = 0; column < N; ++column)
  {
    fft(w->rows + 2 * column, N, N, w->line);
    for (size_t row = 0; row < N; ++row)
    {
      w->stretch[0][row * N + column] = w->line[2 * row];
      w->stretch[1][row * N + column] = w->line[2 * row + 1];
    }
  }
}

// The mean share that is foam at some times.
static double counted(
  const water_old_foam* foam, const water_sea* sea, const double* times, size_t count)
{
  waves* w = malloc(sizeof *w);
  unsigned char* all = malloc(foam->count * PLACES);
  const unsigned char* shares[WATER_OLD_FOAM_TIMES_MAX];
  float* texels = malloc(4 * PLACES * sizeof *texels);
  assert_int_equal(water_tile_amplitudes(&foam->tile, sea, w->amplitudes), WATER_OK);
  assert_int_equal(water_tile_frequencies(&foam->tile, sea, w->frequencies), WATER_OK);
  double sum = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    double newest;
    double weights[3];
    water_old_foam_at(foam, times[i], &newest, weights);
    for (size_t j = 0; j < foam->count; ++j)
    {
      stretch_at(&foam->tile, water_old_foam_time(foam, newest - (double)j), w);
      water_old_foam_shares(foam, w->stretch[0], w->stretch[1], all + j * PLACES);
      shares[j] = all + j * PLACES;
    }
    water_old_foam_join(foam, shares, texels);
    for (size_t place = 0; place < PLACES; ++place)
    {
      for (size_t j = 0; j < 3; ++j)
      {
        sum += weights[j] * (double)texels[4 * place + j];
      }
    }
  }
  free(texels);
  free(all);
  free(w);
  return sum / ((double)PLACES * (double)count);
}

// With what is breaking, half of which lies beside it, within a factor of 1.5.
TEST(cover_is_what_is_counted)
{
  const double winds[] = { 5.0, 10.0, 15.0 };
  const double lives[] = { 0.5, 3.5, 8.0 };
  const double times[] = { 3.1, 40.33, 91.7 };
  for (size_t i = 0; i < 3; ++i)
  {
    for (size_t j = 0; j < 3; ++j)
    {
      const water_sea sea = sea_of(winds[i]);
      double cover = 0.0;
      assert_int_equal(water_whitecap_cover(winds[i], &cover), WATER_OK);
      const water_old_foam foam = foam_of(winds[i], cover, lives[j], 0.0);
      const double old = counted(&foam, &sea, times, 3);
      const double all = old + 0.5 * foam.fresh;
      printf("wind %g, life time %g s: %.3f %% is old foam, %.3f %% breaks, %.3f %% were measured: "
             "%.2f; %d times, %.2f s apart, J %.3f\n",
        winds[i], lives[j], 100.0 * old, 100.0 * foam.fresh, 100.0 * cover, all / cover,
        (int)foam.count, foam.step_s, foam.jacobian);
      assert_true(all > cover / 1.5 && all < cover * 1.5);
      assert_true(foam.fresh < cover);
    }
  }
}

typedef struct history // what breaks at a place at each of the earlier times
{
  unsigned char at[WATER_OLD_FOAM_TIMES_MAX];
} history;

// The foam at a place of a tile of one; what breaks there is given for whole numbers of steps.
static double foam_at(water_old_foam foam, double time, const unsigned char* breaks, size_t length)
{
  foam.tile.size = 1;
  double newest;
  double weights[3];
  water_old_foam_at(&foam, time, &newest, weights);
  history shares;
  const unsigned char* places[WATER_OLD_FOAM_TIMES_MAX];
  for (size_t i = 0; i < foam.count; ++i)
  {
    const double number = newest - (double)i;
    const bool is_given = number >= 0.0 && number < (double)length;
    shares.at[i] = is_given ? breaks[(size_t)number] : 0;
    places[i] = shares.at + i;
  }
  float texel[4];
  water_old_foam_join(&foam, places, texel);
  assert_true(texel[3] == 0.0f);
  return weights[0] * (double)texel[0] + weights[1] * (double)texel[1] +
    weights[2] * (double)texel[2];
}

// What breaks once, at time 0, is all foam a step later, and a share exp(-age / life time) of it
// until it is three life times old.
TEST(foam_decays_with_its_life_time)
{
  const water_old_foam foam = foam_of(10.0, 0.01, 3.5, 0.0);
  const unsigned char once[] = { 255 };
  assert_true(foam_at(foam, -1e-9, once, 1) == 0.0);
  assert_true(foam_at(foam, 1e-9, once, 1) < 1e-6);
  const double last = ((double)foam.count - 1.0) * foam.step_s;
  assert_true(last > 2.5 * 3.5 && foam.step_s < 1.0);
  for (double age = foam.step_s; age < last; age += 0.1)
  {
    ASSERT_CLOSE(foam_at(foam, age, once, 1), exp(-age / 3.5), 1e-5);
  }
  assert_true(foam_at(foam, last + foam.step_s, once, 1) == 0.0);
}

// Foam that breaks on foam is as strong as the stronger of the two; nothing jumps in time.
TEST(foam_does_not_jump)
{
  const water_old_foam foam = foam_of(10.0, 0.01, 3.5, 0.0);
  const unsigned char breaks[] = { 255, 0, 0, 30, 200, 255, 10, 0, 0, 0, 120 };
  const size_t length = sizeof breaks;
  const double step = 0.01 * foam.step_s;
  double last = 0.0;
  double most = 0.0;
  for (int i = 0; i < 6000; ++i)
  {
    const double here = foam_at(foam, i * step, breaks, length);
    assert_true(here >= 0.0 && here <= 1.0);
    most = fmax(most, fabs(here - last));
    last = here;
  }
  printf("at most %.4f of the foam comes in a hundredth of a step\n", most);
  assert_true(most < 0.012); // all comes in a hundred
  const double two[] = { exp(-4.0 * foam.step_s / 3.5), 30.0 / 255.0 * exp(-foam.step_s / 3.5) };
  ASSERT_CLOSE(foam_at(foam, 4.0 * foam.step_s, breaks, 4), fmax(two[0], two[1]), 1e-5);
}

// Only where the Jacobian is under the threshold is something left, and all of it far under it.
TEST(crests_leave_foam)
{
  water_old_foam foam = foam_of(10.0, 0.01, 3.5, 0.0);
  foam.tile.size = 2;
  const double softness = water_whitecap_softness();
  const double x[] = { 0.0, foam.jacobian - 1.0, foam.jacobian - 1.0 - 9.0 * softness,
    foam.jacobian - 1.0 + 2.0 * softness };
  const double y[] = { 0.0, 0.0, 0.0, -softness };
  unsigned char shares[4];
  water_old_foam_shares(&foam, x, y, shares);
  assert_int_equal(shares[0], 0);
  assert_int_equal(shares[1], 128);
  assert_int_equal(shares[2], 255);
  assert_int_equal(shares[3], 40); // 15.87 %
}

// A sea that repeats has foam that does, from whole numbers of earlier times in its period.
TEST(foam_repeats_with_the_sea)
{
  const water_old_foam foam = foam_of(10.0, 0.01, 3.5, 12.0);
  ASSERT_CLOSE(12.0 / foam.step_s, rint(12.0 / foam.step_s), 1e-9);
  double now;
  double later;
  double weights[2][3];
  water_old_foam_at(&foam, 5.0, &now, weights[0]);
  water_old_foam_at(&foam, 29.0, &later, weights[1]);
  assert_true(now == later && memcmp(weights[0], weights[1], sizeof weights[0]) == 0);
  ASSERT_CLOSE(water_old_foam_time(&foam, now), foam.step_s * floor(5.0 / foam.step_s), 1e-12);
}

// No life, no cover, all covered, or no waves: none, and what breaks is all that is white.
TEST(there_may_be_no_old_foam)
{
  assert_int_equal(foam_of(10.0, 0.01, 0.0, 0.0).count, 0);
  assert_true(foam_of(10.0, 0.01, 0.0, 0.0).fresh == 0.01);
  assert_int_equal(foam_of(10.0, 0.0, 3.5, 0.0).count, 0);
  assert_int_equal(foam_of(10.0, 1.0, 3.5, 0.0).count, 0);
  assert_true(foam_of(10.0, 1.0, 3.5, 0.0).fresh == 1.0);
  const water_sea sea = sea_of(10.0);
  water_tile calm = first_tile(&sea, 0.0);
  calm.k_low = 1e6; // beyond its points
  calm.k_high = 0.0;
  water_old_foam foam;
  assert_int_equal(water_old_foam_make(&sea, &calm, 0.01, 3.5, &foam), WATER_OK);
  assert_int_equal(foam.count, 0);
  double newest;
  double weights[3] = { 1.0, 1.0, 1.0 };
  water_old_foam_at(&foam, 5.0, &newest, weights);
  assert_true(weights[0] == 0.0 && weights[1] == 0.0 && weights[2] == 0.0);
}

TEST(bad_values_are_refused)
{
  const water_sea sea = sea_of(10.0);
  const water_tile tile = first_tile(&sea, 0.0);
  water_old_foam foam = { .count = 99 };
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, -0.1, &foam), WATER_BAD_LIFE_TIME);
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, 10.1, &foam), WATER_BAD_LIFE_TIME);
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, (double)NAN, &foam), WATER_BAD_LIFE_TIME);
  const water_tile odd = { 5, 100.0, 0.0, 1, 0.0, 0.0 };
  assert_int_equal(water_old_foam_make(&sea, &odd, 0.01, 3.5, &foam), WATER_BAD_TILE_SIZE);
  assert_int_equal(foam.count, 99);
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, WATER_FOAM_LIFE_MAX, &foam), WATER_OK);
  const water_tile large = { 1024, tile.length, 0.0, 7, 0.0, 0.0 };
  assert_int_equal(water_old_foam_make(&sea, &large, 0.01, 3.5, &foam), WATER_OK);
  assert_int_equal(foam.tile.size, WATER_OLD_FOAM_SIZE_MAX);
}

// Foams are the same if each of their numbers is.
TEST(foams_are_the_same_in_all_numbers)
{
  const water_old_foam foam = foam_of(10.0, 0.01, 3.5, 0.0);
  water_old_foam other[6];
  for (int i = 0; i < 6; ++i)
  {
    other[i] = foam;
    assert_true(water_old_foam_is_same(&foam, other + i));
  }
  other[0].count += 1;
  other[1].life_s += 0.5;
  other[2].step_s += 0.5;
  other[3].jacobian += 0.5;
  other[4].fresh += 0.5;
  other[5].tile.seed += 1;
  for (int i = 0; i < 6; ++i)
  {
    assert_false(water_old_foam_is_same(&foam, other + i));
  }
}

// A tile without an upper end has waves up to its points' own end.
TEST(waves_end_where_points_do)
{
  const water_sea sea = sea_of(10.0);
  water_tile tile = first_tile(&sea, 0.0);
  water_old_foam open;
  water_old_foam ended;
  tile.k_high = 0.0;
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, 3.5, &open), WATER_OK);
  assert_true(open.count > 0);
  tile.k_high = 0.5 * 6.283185307179586 * (double)open.tile.size / tile.length;
  assert_int_equal(water_old_foam_make(&sea, &tile, 0.01, 3.5, &ended), WATER_OK);
  assert_int_equal(open.count, ended.count);
  ASSERT_CLOSE(open.fresh, ended.fresh, 1e-12);
}

// The earlier times reach back by three life times, in no more steps than that needs, and at most
// 48 of them.
TEST(foam_is_kept_for_three_lives)
{
  const double lives_s[4] = { 0.1, 0.5, 3.5, 10.0 };
  for (int i = 0; i < 4; ++i)
  {
    const water_old_foam foam = foam_of(10.0, 0.01, lives_s[i], 0.0);
    const double kept_s = foam.step_s * (double)foam.count;
    assert_in_range(foam.count, 2, 48);
    assert_true(kept_s > 2.999 * lives_s[i] && kept_s < 3.0 * lives_s[i] + 1.001 * foam.step_s);
    assert_true(foam.step_s <= 0.5001 * lives_s[i]);
  }
}

TESTS(foam_is_kept_for_three_lives, waves_end_where_points_do, foams_are_the_same_in_all_numbers,
  cover_is_what_is_counted, foam_decays_with_its_life_time, foam_does_not_jump, crests_leave_foam,
  foam_repeats_with_the_sea, there_may_be_no_old_foam, bad_values_are_refused)
