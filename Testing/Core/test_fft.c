// SPDX-License-Identifier: BSD-3-Clause
// test_fft.c: passes of a Fourier transform, carried out as their header says, are the transform.
#include "test_main.h"

#include "water_fft.h"
#include "water_random.h"

#include <string.h>

enum
{
  LARGEST = 1024
};

static const double two_pi = 6.283185307179586;

// What a shader does, in doubles.
static void run(const water_fft* plan, double* line)
{
  static float table[4 * LARGEST];
  static double next[2 * LARGEST];
  for (int pass = 0; pass < plan->count; ++pass)
  {
    const size_t radix = plan->radix[pass];
    water_fft_table(plan, pass, table);
    for (size_t o = 0; o < plan->size; ++o)
    {
      const double w[2] = { (double)table[4 * o], (double)table[4 * o + 1] };
      double sum[2] = { 0.0, 0.0 };
      assert_true(table[4 * o + 3] == 0.0f);
      for (size_t r = radix; r-- > 0;)
      {
        const double* in = line + 2 * ((size_t)table[4 * o + 2] + r * plan->size / radix);
        const double turned[2] = { sum[0] * w[0] - sum[1] * w[1], sum[0] * w[1] + sum[1] * w[0] };
        sum[0] = turned[0] + in[0];
        sum[1] = turned[1] + in[1];
      }
      next[2 * o] = sum[0];
      next[2 * o + 1] = sum[1];
    }
    memcpy(line, next, 2 * plan->size * sizeof *line);
  }
}

TEST(passes_are_the_transform)
{
  static double line[2 * LARGEST];
  static double in[2 * LARGEST];
  const size_t sizes[] = { 2, 4, 6, 14, 22, 32, 64, 96, 120, 128, 182, 250, 256, 360, 512, 1024 };
  for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; ++s)
  {
    const size_t n = sizes[s];
    water_fft plan;
    assert_true(water_fft_plan(n, &plan));
    double largest = 0.0;
    for (size_t i = 0; i < n; ++i)
    {
      water_random_normal(1, i, in + 2 * i);
    }
    memcpy(line, in, 2 * n * sizeof *in);
    run(&plan, line);
    for (size_t k = 0; k < n; k += 1 + n / 50)
    {
      double sum[2] = { 0.0, 0.0 };
      for (size_t i = 0; i < n; ++i)
      {
        const double angle = two_pi * (double)(i * k % n) / (double)n;
        sum[0] += in[2 * i] * cos(angle) + in[2 * i + 1] * sin(angle);
        sum[1] += in[2 * i + 1] * cos(angle) - in[2 * i] * sin(angle);
      }
      largest = fmax(largest, hypot(line[2 * k] - sum[0], line[2 * k + 1] - sum[1]));
    }
    // the table's roundings to floats, of numbers whose sums are sqrt(2 n)
    ASSERT_CLOSE(largest / sqrt(2.0 * (double)n), 0.0, 2e-6);
  }
}

// As few passes as can be, radices as alike as can be, and none without need.
TEST(plans_are_short)
{
  const struct
  {
    size_t size;
    int count;
    size_t sum; // of the radices
  } cases[] = { { 2, 1, 2 }, { 16, 1, 16 }, { 32, 2, 12 }, { 64, 2, 16 }, { 128, 2, 24 },
    { 250, 3, 20 }, { 256, 2, 32 }, { 512, 3, 24 }, { 1024, 3, 32 }, { 4096, 3, 48 },
    { 6250, 5, 30 }, { 16384, 4, 48 } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_fft plan;
    assert_true(water_fft_plan(cases[i].size, &plan));
    assert_int_equal(plan.size, cases[i].size);
    assert_int_equal(plan.count, cases[i].count);
    size_t product = 1;
    size_t sum = 0;
    for (int pass = 0; pass < plan.count; ++pass)
    {
      assert_true(plan.radix[pass] >= 2 && plan.radix[pass] <= WATER_FFT_LARGEST_RADIX);
      product *= plan.radix[pass];
      sum += plan.radix[pass];
    }
    assert_int_equal(product, cases[i].size);
    assert_int_equal(sum, cases[i].sum);
  }
}

// Every size has a plan, but for those with a prime factor above the largest radix.
TEST(sizes_with_large_primes_are_refused)
{
  for (size_t size = 2; size <= 16384; ++size)
  {
    size_t rest = size;
    for (size_t i = 2; i <= WATER_FFT_LARGEST_RADIX; ++i)
    {
      while (rest % i == 0)
      {
        rest /= i;
      }
    }
    water_fft plan = { 7, 7, { 7 } };
    assert_int_equal(water_fft_plan(size, &plan), rest == 1);
    assert_int_equal(plan.size, rest == 1 ? size : 7);
  }
}

TESTS(passes_are_the_transform, plans_are_short, sizes_with_large_primes_are_refused)
