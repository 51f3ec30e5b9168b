// SPDX-License-Identifier: BSD-3-Clause
// test_turns.c: phases in whole numbers, as shaders compute them, are the exact ones.
#include "test_main.h"

#include "water_phase.h"
#include "water_random.h"
#include "water_shared.h"
#include "water_turns.h"

static const double part = 2.3283064365386963e-10; // of a turn: 2^-32

static double between(uint64_t* counter, double low, double high)
{
  const double share = (double)(water_random_bits(5, (*counter)++) >> 11) * 0x1p-53;
  return low + share * (high - low);
}

// Turns, of times from 0, as a shader has them.
static double shader_turns(double frequency, double largest, double time)
{
  const int exponent = water_turns_exponent(largest);
  uint32_t f[3];
  uint32_t t[2];
  water_turns_frequency(frequency, exponent, f);
  assert_true(water_turns_time(time, exponent, t));
  return part * water_shared_phase(f[0], f[1], f[2], t[0], t[1]);
}

// Of any frequency up to the largest, and any time that is taken: within 2^-26 turns, as the header
// proves. water_turns is exact to 2^-54, which test_dispersion.c and test_waves.c know.
TEST(phases_are_exact)
{
  uint64_t counter = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const double largest = exp2(between(&counter, -20.0, 20.0));
    const double frequency = largest * exp2(-fabs(between(&counter, -1.0, 30.0)));
    const double limit = 0x1p36 / largest; // a factor of 2 below the least that is refused
    const double time = limit * exp2(between(&counter, -50.0, 0.0));
    const double kept = fmin(frequency, largest);
    const double found = shader_turns(kept, largest, time);
    ASSERT_CLOSE(water_turn(found - water_turns(kept, time)), 0.0, 0x1p-26);
  }
}

// Times at which they can be told by hand.
TEST(phases_of_simple_times)
{
  ASSERT_CLOSE(shader_turns(0.375, 1.0, 2.0), 0.75, 0x1p-31);
  ASSERT_CLOSE(shader_turns(0.375, 1.0, 4294967298.0), 0.75, 0x1p-31); // both words of the time
  // 1e9 + 2 = 3 * 333333334
  ASSERT_CLOSE(water_turn(shader_turns(1.0 / 3.0, 0.5, 1e9 + 2.0)), 0.0, 0x1p-24);
  ASSERT_CLOSE(shader_turns(0.0, 1.0, 123.0), 0.0, 0.0);
  ASSERT_CLOSE(shader_turns(1.0, 1.0, 0.25), 0.25, 0x1p-31);
}

// A time of 2^63 units is too long, one that is a bit shorter is not; a sign does not matter, and
// words that are refused are left alone.
TEST(long_times_are_refused)
{
  const int exponent = water_turns_exponent(1.5); // below 2
  assert_int_equal(exponent, 27);
  uint32_t words[2] = { 7, 7 };
  assert_false(water_turns_time(0x1p36, exponent, words));
  assert_false(water_turns_time(-0x1p36, exponent, words));
  assert_false(water_turns_time((double)INFINITY, exponent, words));
  assert_false(water_turns_time((double)NAN, exponent, words));
  assert_true(words[0] == 7 && words[1] == 7);
  assert_true(water_turns_time(-nextafter(0x1p36, 0.0), exponent, words));
  assert_true(words[0] == 0xFFFFFC00u && words[1] == 0x7FFFFFFFu);
  assert_true(water_turns_time(1.0, exponent, words));
  assert_true(words[0] == 0x08000000u && words[1] == 0);
  // a sea's period so long that its frequencies are no number
  const int none = water_turns_exponent((double)INFINITY);
  assert_false(water_turns_time(1e-9, none, words));
  uint32_t three[3] = { 7, 7, 7 };
  water_turns_frequency((double)INFINITY, none, three);
  assert_true(three[0] == 0 && three[1] == 0 && three[2] == 0);
}

// The largest frequency leaves 26 bits of a turn to a unit of time; all of 96 bits are used.
TEST(frequencies_are_fractions)
{
  uint32_t words[3];
  assert_int_equal(water_turns_exponent(1.0), 27);
  assert_int_equal(water_turns_exponent(0.0), 26);
  water_turns_frequency(1.0, 27, words);
  assert_true(words[0] == 0x20u && words[1] == 0 && words[2] == 0);
  water_turns_frequency(1.0 + 0x1p-36 + 0x1p-52, 27, words);
  assert_true(words[0] == 0x20u && words[1] == 2u && words[2] == 0x00020000u);
}

TEST(upper_halves_are_those_of_the_product)
{
  uint64_t counter = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const uint64_t bits = i % 16 ? water_random_bits(9, counter++) : 0xFFFFFFFFFFFFFFFFu >> i % 3;
    const uint32_t a = (uint32_t)bits;
    const uint32_t b = (uint32_t)(bits >> 32);
    assert_true(water_shared_upper_half(a, b) == (uint32_t)((uint64_t)a * b >> 32));
  }
}

// The series of the shader, in doubles: their own error, without a float's roundings.
TEST(cosine_and_sine_are_right)
{
  uint64_t counter = 0;
  for (int i = 0; i < 40000; ++i)
  {
    const uint32_t edge = (uint32_t)(i % 64) << 26; // sixty-fourths, where quarters and eighths end
    const uint32_t phase =
      i % 2 ? (uint32_t)water_random_bits(3, counter++) : edge + (uint32_t)(i % 3) - 1u;
    const double angle = water_two_pi * part * phase;
    ASSERT_CLOSE(water_shared_cosine(phase), cos(angle), 3e-8);
    ASSERT_CLOSE(water_shared_sine(phase), sin(angle), 3e-8);
  }
}

TESTS(phases_are_exact, phases_of_simple_times, long_times_are_refused, frequencies_are_fractions,
  upper_halves_are_those_of_the_product, cosine_and_sine_are_right)
