// SPDX-License-Identifier: BSD-3-Clause
// water_glitter.c: slopes of a wind-blown sea as a distribution, and the sun's glitter from it.
#include "water_glitter.h"

#include "water_math.h"
#include "water_shared.h"

static bool is_wind(double wind_speed)
{
  return wind_speed >= 0.1 && wind_speed <= 100.0;
}

water_status water_glitter_variance(double wind_speed, double variance[2])
{
  if (!is_wind(wind_speed))
  {
    return WATER_BAD_WIND_SPEED;
  }
  variance[0] = 0.00316 * wind_speed;
  variance[1] = 0.003 + 0.00192 * wind_speed;
  return WATER_OK;
}

water_status water_glitter_mean_square(double wind_speed, double* mean_square)
{
  if (!is_wind(wind_speed))
  {
    return WATER_BAD_WIND_SPEED;
  }
  *mean_square = 0.003 + 0.00512 * wind_speed;
  return WATER_OK;
}

void water_glitter_covariance(const double variance[2], double dir_rad, double covariance[3])
{
  const double c = cos(dir_rad);
  const double s = sin(dir_rad);
  covariance[0] = c * c * variance[0] + s * s * variance[1];
  covariance[1] = s * s * variance[0] + c * c * variance[1];
  covariance[2] = c * s * (variance[0] - variance[1]);
}

double water_glitter_hidden(const double dir[3], const double covariance[3])
{
  const double along = covariance[0] * dir[0] * dir[0] + 2.0 * covariance[2] * dir[0] * dir[1] +
    covariance[1] * dir[1] * dir[1];
  if (!(dir[2] > 0.0) || !(along > 0.0))
  {
    return 0.0;
  }
  // the approximation of the normal distribution may be a little less than the cosine
  return fmax(water_shared_facing_area(dir[2], sqrt(along)) / dir[2] - 1.0, 0.0);
}

double water_glitter_density(const double variance[2], const double slope[2])
{
  // in units of the spreads, whose squares may vanish
  const double spread[2] = { sqrt(variance[0]), sqrt(variance[1]) };
  const double x = slope[0] / spread[0];
  const double y = slope[1] / spread[1];
  if (isinf(x) || isinf(y))
  {
    return 0.0; // times a covariance of 0 it would be no number
  }
  return water_shared_slope_density(1.0, 1.0, 0.0, 1.0, x, y) / (spread[0] * spread[1]);
}

double water_glitter_radiance(const double sun_dir[3], const double eye_dir[3], double wind_dir_rad,
  const double variance[2], double* facet_cosine)
{
  double facet[3]; // the normal that mirrors the sun into the eye
  for (int i = 0; i < 3; ++i)
  {
    facet[i] = sun_dir[i] + eye_dir[i];
  }
  const double length = water_vec3_length(facet);
  *facet_cosine = 0.5 * length; // of half the angle between two unit vectors
  if (!(sun_dir[2] > 0.0) || !(eye_dir[2] > 0.0))
  {
    return 0.0;
  }
  const double slope[2] = { -facet[0] / facet[2], -facet[1] / facet[2] };
  const double c = cos(wind_dir_rad);
  const double s = sin(wind_dir_rad);
  const double turned[2] = { c * slope[0] + s * slope[1], c * slope[1] - s * slope[0] };
  const double tilt = facet[2] / length;
  double covariance[3];
  water_glitter_covariance(variance, wind_dir_rad, covariance);
  const double hidden =
    water_glitter_hidden(sun_dir, covariance) + water_glitter_hidden(eye_dir, covariance);
  return water_glitter_density(variance, turned) /
    water_shared_glitter_spread(eye_dir[2] * (1.0 + hidden), tilt * tilt * tilt * tilt);
}
