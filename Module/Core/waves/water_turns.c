// SPDX-License-Identifier: BSD-3-Clause
// water_turns.c: the phases of many waves in whole numbers of 32 bits.
#include "water_turns.h"

#include "water_math.h"

static const int spare_bits = 26;     // of a turn, that a frequency stays below in a unit of time
static const int no_exponent = 10000; // no time but 0 has so few units

int water_turns_exponent(double largest)
{
  int exponent = 0;
  if (!isfinite(largest))
  {
    return no_exponent;
  }
  (void)frexp(largest, &exponent); // largest < 2^exponent
  return exponent + spare_bits;
}

void water_turns_frequency(double frequency, int exponent, uint32_t words[3])
{
  double rest = ldexp(frequency, -exponent);
  for (int i = 0; i < 3; ++i)
  {
    const double shifted = isfinite(rest) ? ldexp(rest, 32) : 0.0;
    words[i] = (uint32_t)shifted;
    rest = shifted - floor(shifted); // exact
  }
}

bool water_turns_time(double time, int exponent, uint32_t words[2])
{
  const double units = rint(ldexp(fabs(time), exponent));
  if (!(units < ldexp(1.0, 63)))
  {
    return false;
  }
  const uint64_t whole = (uint64_t)units;
  words[0] = (uint32_t)(whole & 0xFFFFFFFFu);
  words[1] = (uint32_t)(whole >> 32);
  return true;
}
