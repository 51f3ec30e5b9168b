// SPDX-License-Identifier: BSD-3-Clause
// water_random.c: random numbers by their number: no state, and the same bits on every machine.
#include "water_random.h"

#include "water_phase.h"

uint64_t water_random_bits(uint64_t seed, uint64_t counter)
{
  uint64_t z = seed + (counter + 1u) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio, odd
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double water_random_uniform(uint64_t seed, uint64_t counter)
{
  return (double)(water_random_bits(seed, counter) >> 11) / 9007199254740992.0; // 2^53
}

// -ln(u), u in (0, 1].
static double minus_log(double u)
{
  int exponent = 0;
  double m = frexp(u, &exponent); // exact
  if (m < 0.7071067811865476)
  {
    m *= 2.0;
    exponent -= 1;
  }
  const double s = (m - 1.0) / (m + 1.0); // |s| < 0.172: the series' next term is under 1e-19
  const double square = s * s;
  double sum = 0.0;
  for (int n = 23; n >= 1; n -= 2)
  {
    sum = sum * square + 1.0 / n;
  }
  const double ln_2 = 0.6931471805599453;
  return -exponent * ln_2 - 2.0 * s * sum;
}

// Cosine and sine of a part of a turn in [0, 1).
static void circle(double turn, double point[2])
{
  const int quarter = (int)(4.0 * turn + 0.5);
  const double x = water_two_pi * (turn - 0.25 * quarter); // at most pi/4
  const double square = x * x;
  double c = 1.0;
  double s = 1.0;
  for (int n = 18; n >= 2; n -= 2) // Taylor; the next term is under 1e-17
  {
    c = 1.0 - c * square / (n * (n - 1));
    s = 1.0 - s * square / (n * (n + 1));
  }
  s *= x;
  const double turned[4] = { c, -s, -c, s };
  point[0] = turned[quarter & 3];
  point[1] = turned[(quarter + 3) & 3];
}

void water_random_normal(uint64_t seed, uint64_t counter, double pair[2])
{
  const double unit = 1.0 / 9007199254740992.0; // 2^-53
  const double u = (double)((water_random_bits(seed, 2u * counter) >> 11) + 1u) * unit;
  const double v = water_random_uniform(seed, 2u * counter + 1u);
  const double radius = sqrt(2.0 * minus_log(u));
  circle(v, pair);
  pair[0] *= radius;
  pair[1] *= radius;
}
