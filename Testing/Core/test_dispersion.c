// SPDX-License-Identifier: BSD-3-Clause
// test_dispersion.c: frequency against wave number, and phases that are exact at any time.
#include "test_scene.h"

#include "water_phase.h"
#include "water_waves.h"

static const double two_pi = 6.283185307179586;
static const double g = 9.80665;
static const double deep = (double)INFINITY;

static double omega_of(double k, double depth)
{
  double omega = -1.0;
  assert_int_equal(water_waves_omega(k, depth, &omega), WATER_OK);
  return omega;
}

static double wavenumber_of(double omega, double depth)
{
  double k = -1.0;
  assert_int_equal(water_waves_wavenumber(omega, depth, &k), WATER_OK);
  return k;
}

static void terms_of(
  const water_wave* waves, size_t count, double depth, double time, water_wave_term* terms)
{
  size_t bad_index = 0;
  assert_int_equal(water_waves_at(waves, count, depth, time, terms, &bad_index), WATER_OK);
}

// Waves of 100 m in deep water and over 10 m, from 40 digits; a long wave over a shallow bed goes
// sqrt(g h), whatever its length; a deep swell of 8 s is 1.56 T^2 = 99.9 m long. The Shore
// Protection Manual's table C-1 (1984): depth over deep wavelength 0.1 is depth over wavelength
// 0.1410.
TEST(dispersion_has_the_known_values)
{
  ASSERT_CLOSE(omega_of(two_pi / 100.0, 10.0), 0.585782335357289202, 4e-16);
  ASSERT_CLOSE(omega_of(two_pi / 100.0, deep), 0.784964962228586937, 4e-16);
  ASSERT_CLOSE(omega_of(two_pi / 200.0, 5.0), 0.219088438305898734, 2e-16);
  ASSERT_CLOSE(omega_of(1e-6, 5.0) / 1e-6, sqrt(g * 5.0), 1e-9);
  ASSERT_CLOSE(omega_of(0.0, deep), 0.0, 0.0);
  ASSERT_CLOSE(two_pi / wavenumber_of(two_pi / 8.0, deep), 99.9, 0.05);
  const double period = 10.0;
  const double deep_length = g * period * period / two_pi;
  const double k = wavenumber_of(two_pi / period, 0.1 * deep_length);
  ASSERT_CLOSE(0.1 * deep_length * k / two_pi, 0.1410, 5e-5);
  ASSERT_CLOSE(tanh(0.1 * deep_length * k), 0.7093, 5e-5);
}

// The wave number is where bisection finds it, within 1e-14 of itself, from tidal to ripple scale.
TEST(wavenumber_is_the_one_bisection_finds)
{
  for (double power = -24.0; power <= 8.0; power += 0.0625)
  {
    const double depth = 3.0;
    const long double goal = powl(10.0L, power); // (omega^2 h / g)
    const double omega = (double)sqrtl(goal * 9.80665L / 3.0L);
    const long double square = (long double)omega * omega * 3.0L / 9.80665L;
    long double low = 0.0L;
    long double high = square + sqrtl(square) + 1e-30L; // y tanh y > min(y, y^2) / 2
    high *= 2.0L;
    for (int i = 0; i < 200; ++i)
    {
      const long double middle = 0.5L * (low + high);
      *(middle * tanhl(middle) < square ? &low : &high) = middle;
    }
    const double known = (double)(low / 3.0L);
    ASSERT_CLOSE(wavenumber_of(omega, depth), known, 1e-14 * known);
  }
  ASSERT_CLOSE(wavenumber_of(0.0, 3.0), 0.0, 0.0);
  // depth times omega^2 overflows, the answer does not
  ASSERT_CLOSE(wavenumber_of(1e100, 1e200), 1e200 / g, 1e186);
  ASSERT_CLOSE(wavenumber_of(1e6, 1e308), 1e12 / g, 1e-2);
}

// The group velocity is the slope of omega(k): half the phase's in deep water, all of it in
// shallow.
TEST(group_velocity_is_the_slope_of_dispersion)
{
  for (double k = 1e-3; k < 50.0; k *= 1.7)
  {
    const double step = 1e-5 * k;
    const double slope = (omega_of(k + step, 4.0) - omega_of(k - step, 4.0)) / (2.0 * step);
    ASSERT_CLOSE(water_group_velocity(k, 4.0), slope, 1e-8 * slope);
  }
  ASSERT_CLOSE(water_group_velocity(1.0, deep), 0.5 * sqrt(g), 1e-15);
  ASSERT_CLOSE(water_group_velocity(1e-10, 4.0), sqrt(4.0 * g), 1e-14);
}

// Whole numbers over powers of two multiply exactly in 64 bits, which wrap at the whole turn: the
// reduced product is theirs within 2^-54, however many turns there are.
TEST(turns_are_exact_for_any_number_of_them)
{
  dice from = dice_seeded(2);
  for (int round = 0; round < 20000; ++round)
  {
    const uint64_t a = (uint64_t)dice_roll(&from, 0.0, 9007199254740992.0);
    const uint64_t b = (uint64_t)dice_roll(&from, 0.0, 9007199254740992.0);
    // a / 2^30 turns per second, up to 8e6, for b / 2^34 seconds, up to 5e5: 4e12 turns
    const double known = ldexp((double)(int64_t)(a * b), -64);
    const double reduced = water_turns(ldexp((double)a, -30), ldexp((double)b, -34));
    const double apart = fabs(reduced - known);
    assert_true(fmin(apart, 1.0 - apart) <= ldexp(1.0, -53)); // known is rounded as well
  }
  ASSERT_CLOSE(water_turns(1.0 / 3.0, 3e200), 0.0, 0.5); // stays in range
}

// What a product loses by rounding, by halves of its factors, is what fma says, bit by bit. Where
// fma rounds twice it has no say.
TEST(products_lose_the_same_by_halves)
{
#ifndef __MINGW32__
  dice from = dice_seeded(3);
  for (int round = 0; round < 20000; ++round)
  {
    const double scale = round % 2 ? 1e120 : 1.0;
    const double a = scale * dice_roll(&from, -1.0, 1.0);
    const double b = dice_roll(&from, -1.0, 1.0) / (round % 3 ? 1.0 : scale);
    ASSERT_CLOSE(water_product_loss_by_halves(a, b), fma(a, b, -(a * b)), 0.0);
  }
#endif
  // (1 + 2^-30)(1 - 2^-30) is 1 - 2^-60, which rounds to 1
  const double small = ldexp(1.0, -30);
  ASSERT_CLOSE(water_product_loss_by_halves(1.0 + small, 1.0 - small), -ldexp(1.0, -60), 0.0);
}

// At 1e7 s a wave is where long arithmetic puts it, as near as the time itself can be told: three
// steps between doubles there. Time 0, the phase as given.
TEST(phase_after_a_third_of_a_year_is_as_exact_as_time)
{
  const double step = ldexp(1.0, -29); // between doubles at 1e7
  for (double length = 0.05; length < 500.0; length *= 1.9)
  {
    const water_wave wave = { 1.0, length, 0.0, 0.7, 0.0 };
    water_wave_term term;
    terms_of(&wave, 1, deep, 0.0, &term);
    ASSERT_CLOSE(term.turns * two_pi, 0.7, 2e-16);
    terms_of(&wave, 1, deep, 1e7, &term);
    const long double pi_2 = 6.283185307179586476925286766559L;
    const long double frequency = sqrtl(9.80665L / (pi_2 * (long double)length));
    const long double turns = 0.7L / pi_2 - frequency * 1e7L;
    const double known = (double)(turns - rintl(turns));
    const double apart = fabs(term.turns - known);
    assert_true(fmin(apart, 1.0 - apart) < 3.0 * step * (double)frequency + 1e-10);
  }
}

// What is no number, or out of range, has its own status; the output stays as it was.
TEST(bad_numbers_are_refused)
{
  const double nan = (double)NAN;
  double out = 7.0;
  assert_int_equal(water_waves_omega(-1.0, 1.0, &out), WATER_BAD_WAVENUMBER);
  assert_int_equal(water_waves_omega(nan, 1.0, &out), WATER_BAD_WAVENUMBER);
  assert_int_equal(water_waves_omega(1.0, 0.0, &out), WATER_BAD_DEPTH);
  assert_int_equal(water_waves_omega(1.0, nan, &out), WATER_BAD_DEPTH);
  assert_int_equal(water_waves_wavenumber(-1.0, 1.0, &out), WATER_BAD_FREQUENCY);
  assert_int_equal(water_waves_wavenumber(deep, 1.0, &out), WATER_BAD_FREQUENCY);
  assert_int_equal(water_waves_wavenumber(1e200, deep, &out), WATER_BAD_FREQUENCY);
  assert_int_equal(water_waves_wavenumber(1.0, -1.0, &out), WATER_BAD_DEPTH);
  assert_true(out == 7.0);
}

TESTS(dispersion_has_the_known_values, wavenumber_is_the_one_bisection_finds,
  group_velocity_is_the_slope_of_dispersion, turns_are_exact_for_any_number_of_them,
  products_lose_the_same_by_halves, phase_after_a_third_of_a_year_is_as_exact_as_time,
  bad_numbers_are_refused)
