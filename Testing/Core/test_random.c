// SPDX-License-Identifier: BSD-3-Clause
// test_random.c: the random numbers of a sea: their bits, and their statistics.
#include "test_scene.h"

#include "water_random.h"

static const double pi = 3.141592653589793;

// The first five numbers of splitmix64 for seed 1234567 and the first for seed 0, as its authors'
// program prints them.
TEST(bits_are_splitmix64s)
{
  const uint64_t known[5] = { 6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
    4593380528125082431u, 16408922859458223821u };
  for (uint64_t i = 0; i < 5; ++i)
  {
    assert_true(water_random_bits(1234567, i) == known[i]);
  }
  assert_true(water_random_bits(0, 0) == 0xe220a8397b1dcdafu);
}

// Box and Muller's formula, from 40 digits; then on many pairs against the C library's functions.
TEST(normal_numbers_are_box_and_mullers)
{
  const struct
  {
    uint64_t seed;
    uint64_t counter;
    double pair[2];
  } known[] = {
    { 1, 0, { -0.0282497460958549411, -1.06561764841432598 } },
    { 1, 1, { -0.227919522867634717, 0.08309416847150083 } },
    { 42, 7, { 0.260450539110271898, 0.864651733247278753 } },
    { 9223372036854775808u, 123456789, { -2.33470460939649032, 1.10528591003665835 } },
  };
  double pair[2];
  for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i)
  {
    water_random_normal(known[i].seed, known[i].counter, pair);
    ASSERT_CLOSE(pair[0], known[i].pair[0], 1e-15);
    ASSERT_CLOSE(pair[1], known[i].pair[1], 1e-15);
  }
  for (uint64_t i = 0; i < 50000; ++i)
  {
    const double u = ldexp((double)(water_random_bits(5, 2 * i) >> 11) + 1.0, -53);
    const double v = ldexp((double)(water_random_bits(5, 2 * i + 1) >> 11), -53);
    water_random_normal(5, i, pair);
    ASSERT_CLOSE(pair[0], sqrt(-2.0 * log(u)) * cos(2.0 * pi * v), 4e-15);
    ASSERT_CLOSE(pair[1], sqrt(-2.0 * log(u)) * sin(2.0 * pi * v), 4e-15);
  }
}

// The bits themselves, which must be the same with every compiler and library: the checksum comes
// from Python.
TEST(normal_numbers_have_the_same_bits_everywhere)
{
  uint64_t sum = 0;
  for (uint64_t i = 0; i < 1000; ++i)
  {
    double pair[2];
    uint64_t bits[2];
    water_random_normal(2026, i, pair);
    memcpy(bits, pair, sizeof bits);
    sum = sum * 31u + bits[0];
    sum = sum * 31u + bits[1];
  }
  assert_true(sum == 0x6bd978744613aed7u);
}

// Mean 0, variance 1, kurtosis 3, the two of a pair independent, the right share beyond 2.
TEST(normal_numbers_are_normal)
{
  const int count = 200000;
  double sum[4] = { 0.0, 0.0, 0.0, 0.0 };
  int beyond = 0;
  for (int i = 0; i < count; ++i)
  {
    double pair[2];
    water_random_normal(77, (uint64_t)i, pair);
    sum[0] += pair[0] / count;
    sum[1] += pair[0] * pair[0] / count;
    sum[2] += pow(pair[1], 4.0) / count;
    sum[3] += pair[0] * pair[1] / count;
    beyond += fabs(pair[1]) > 2.0 ? 1 : 0;
  }
  // five standard errors of each
  ASSERT_CLOSE(sum[0], 0.0, 5.0 / sqrt(count));
  ASSERT_CLOSE(sum[1], 1.0, 5.0 * sqrt(2.0 / count));
  ASSERT_CLOSE(sum[2], 3.0, 5.0 * sqrt(96.0 / count));
  ASSERT_CLOSE(sum[3], 0.0, 5.0 / sqrt(count));
  ASSERT_CLOSE((double)beyond / count, 0.0455, 5.0 * sqrt(0.0455 / count));
}

TESTS(bits_are_splitmix64s, normal_numbers_are_box_and_mullers,
  normal_numbers_have_the_same_bits_everywhere, normal_numbers_are_normal)
