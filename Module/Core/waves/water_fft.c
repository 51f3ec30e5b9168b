// SPDX-License-Identifier: BSD-3-Clause
// water_fft.c: a Fourier transform in passes that compute each number from a few others.
#include "water_fft.h"

#include "water_math.h"
#include "water_phase.h"

static size_t power(size_t base, int exponent)
{
  return exponent > 0 ? base * power(base, exponent - 1) : 1;
}

// Is rest the product of so many radices? The largest of them is not below its root; the smallest
// that will do is tried first. At most WATER_FFT_MOST_PASSES calls deep.
static bool split(size_t rest, int passes, size_t* radix)
{
  for (size_t i = 2; i <= WATER_FFT_LARGEST_RADIX; ++i)
  {
    if (rest % i == 0 && power(i, passes) >= rest &&
      (passes == 1 ? rest == i : split(rest / i, passes - 1, radix + 1)))
    {
      *radix = i;
      return true;
    }
  }
  return false;
}

bool water_fft_plan(size_t size, water_fft* plan)
{
  water_fft made = { size, 1, { 0 } };
  while (made.count <= WATER_FFT_MOST_PASSES && !split(size, made.count, made.radix))
  {
    ++made.count;
  }
  if (made.count > WATER_FFT_MOST_PASSES)
  {
    return false;
  }
  *plan = made;
  return true;
}

void water_fft_table(const water_fft* plan, int pass, float* table)
{
  size_t before = 1; // lines so long are transformed already
  for (int i = 0; i < pass; ++i)
  {
    before *= plan->radix[i];
  }
  const size_t after = before * plan->radix[pass];
  for (size_t o = 0; o < plan->size; ++o)
  {
    const size_t rest = o % after;
    const double angle = water_two_pi * (double)rest / (double)after;
    table[4 * o] = (float)cos(angle);
    table[4 * o + 1] = (float)-sin(angle);
    table[4 * o + 2] = (float)(o / after * before + rest % before);
    table[4 * o + 3] = 0.0f;
  }
}
