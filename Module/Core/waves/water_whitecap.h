// SPDX-License-Identifier: BSD-3-Clause
// water_whitecap.h: how much of a wind sea is white, and where: on the crests where its points are
// closest together.
//
// A sea's points move horizontally, towards the crests (chop). The area over that at rest, the
// Jacobian J of that motion, is 1 in the mean; where it is least the waves break. Its sum of
// derivatives is Gaussian, with the variance of the slope.
// Source: Tessendorf 2001, "Simulating Ocean Water" (the Jacobian of choppy waves and spray).
#ifndef water_whitecap_h
#define water_whitecap_h

#include "water_status.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Share of the sea's surface that is white: 3.84e-6 U^3.41, at most 1.
//
// wind_speed  m/s at 10 m, in [0.1, 100]; measured from 2 to 18
//
// Returns WATER_OK or WATER_BAD_WIND_SPEED. On an error, cover is unchanged.
// Source: Monahan and O'Muircheartaigh 1980, "Optimal Power-Law Description of Oceanic Whitecap
// Coverage Dependence on Wind Speed".
water_status water_whitecap_cover(double wind_speed, double* cover);

// The threshold of the Jacobian, to first order (1 plus the sum of the two derivatives), below
// which the sea is white. It is chosen so that a share `cover` of the sea's area at rest is white:
// 1 - z s, where a standard normal number exceeds z with the probability `cover`, and s^2 is the
// sum of the variances and of the square of water_whitecap_softness. To first order the Jacobian is
// Gaussian, and the variances of what a pixel resolves and of the rest add up.
//
// cover     in [0, 1]: nothing is white at 0, all at 1
// variance  of the slopes along two axes at right angles, one of them the wind's; both >= 0
//
// 1 for a calm sea; minus infinity and infinity for covers of 0 and 1.
double water_whitecap_jacobian(double cover, const double variance[2]);

// Standard deviation of the Jacobian over which a crest turns white: no edge is sharper.
double water_whitecap_softness(void);

#ifdef __cplusplus
}
#endif
#endif
