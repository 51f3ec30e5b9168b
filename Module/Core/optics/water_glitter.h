// SPDX-License-Identifier: BSD-3-Clause
// water_glitter.h: slopes of a wind-blown sea as a distribution, and the sun's glitter from it.
//
// Directions are in axes whose third is the plane's normal; wind speeds are at 12.5 m (41 feet),
// the height of the measurements (within 3 % of those at 10 m).
// Source: Cox and Munk 1954, "Measurement of the Roughness of the Sea Surface from Photographs of
// the Sun's Glitter" (clean sea, winds of 1 to 14 m/s).
#ifndef water_glitter_h
#define water_glitter_h

#include "water_status.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Variances of slope of a wind sea along and across the wind: 0.000 + 0.00316 U (+- 0.004) and
// 0.003 + 0.00192 U (+- 0.002).
//
// wind_speed  m/s, in [0.1, 100]
//
// Returns WATER_OK or WATER_BAD_WIND_SPEED. On an error, variance is unchanged.
water_status water_glitter_variance(double wind_speed, double variance[2]);

// The two together, in Cox and Munk's own fit of the sum: 0.003 + 0.00512 U (+- 0.004). Inputs and
// errors as above.
// Used only by tests, as a reference.
water_status water_glitter_mean_square(double wind_speed, double* mean_square);

// The same variances along the axes from which the direction of the first variance is counted: xx,
// yy and xy.
//
// dir_rad  of the first variance, from the first towards the second axis
void water_glitter_covariance(const double variance[2], double dir_rad, double covariance[3]);

// How much more of the facets that face a direction there is than is seen from there, of 1: with a
// sun at the horizon, the way of the light is full of waves. Waves between a facet and the sun, or
// the eye, take the light away with the probability 1 / (1 + the sum of these of both).
//
// dir         unit length
// covariance  of the slopes, xx, yy and xy
//
// 0 where the direction is not above the plane.
// Source: Smith 1967, "Geometrical Shadowing of a Random Rough Surface" (heights and slopes that do
// not depend on each other).
double water_glitter_hidden(const double dir[3], const double covariance[3]);

// Probability per unit of both slopes, Gaussian; the integral over all slopes is 1.
//
// variance  along two axes at right angles, both > 0
// slope     along the same axes
double water_glitter_density(const double variance[2], const double slope[2]);

// Radiance towards the eye per irradiance of the sun on a plane facing it (1/sr), for a surface
// that reflects everything: density / (4 cos(eye) cos^4(facet)), less what waves hide of each other
// (water_glitter_hidden). Times Fresnel's reflectance at facet_cosine it is the glitter. Light that
// waves hide is lost: a second reflection is left out.
//
// sun_dir, eye_dir  from the water to the sun and to the eye, unit length, above the plane
// wind_dir_rad      axis of the first variance, from the first towards the second axis
// facet_cosine      of the angle of incidence on the facets that shine
//
// 0 where the sun or the eye is not above the plane.
// Used only by tests, as a reference.
double water_glitter_radiance(const double sun_dir[3], const double eye_dir[3], double wind_dir_rad,
  const double variance[2], double* facet_cosine);

#ifdef __cplusplus
}
#endif
#endif
