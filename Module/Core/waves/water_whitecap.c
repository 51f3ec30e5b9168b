// SPDX-License-Identifier: BSD-3-Clause
// water_whitecap.c: how much of a wind sea is white, and where.
#include "water_whitecap.h"

#include "water_math.h"

static const double softness = 0.03;

water_status water_whitecap_cover(double wind_speed, double* cover)
{
  if (!(wind_speed >= 0.1 && wind_speed <= 100.0))
  {
    return WATER_BAD_WIND_SPEED;
  }
  *cover = fmin(3.84e-6 * pow(wind_speed, 3.41), 1.0);
  return WATER_OK;
}

// z that a normal number exceeds with a chance in (0, 1), by halving: 60 halves of [-40, 40].
static double quantile(double chance)
{
  double low = -40.0;
  double high = 40.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    const bool is_beyond = 0.5 * erfc(middle * sqrt(0.5)) < chance;
    high = is_beyond ? middle : high;
    low = is_beyond ? low : middle;
  }
  return 0.5 * (low + high);
}

double water_whitecap_jacobian(double cover, const double variance[2])
{
  if (!(cover > 0.0) || !(cover < 1.0))
  {
    return cover > 0.0 ? (double)INFINITY : -(double)INFINITY;
  }
  const double sum = variance[0] + variance[1];
  if (!(sum > 0.0))
  {
    return 1.0;
  }
  const double z = quantile(cover);
  return 1.0 - z * sqrt(sum + softness * softness);
}

double water_whitecap_softness(void)
{
  return softness;
}
