// SPDX-License-Identifier: BSD-3-Clause
// water_caustics.h: light that waves focus under water: how it is refracted, how far it spreads,
// and the sum of the light from many points of the surface.
//
// Directions are in axes whose third is the plane's normal; depths are under the plane, > 0.
#ifndef water_caustics_h
#define water_caustics_h

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Horizontal displacement of refracted light per unit of depth: exact, by Snell's law.
//
// sun_dir  towards the sun, unit length, the third > 0
// slope    of the surface, dz/dx and dz/dy
//
// Returns false where no light enters: the surface faces away. Then way is unchanged.
bool water_caustics_way(
  const double sun_dir[3], const double slope[2], double index, double way[2]);

// Covariance xx, xy, yy of the light that the sun's disc casts on a level bed through one point,
// per depth squared: of a disc of 0.2665 degrees of radius (mean, as seen from the Earth),
// uniformly bright, refracted. Source: Snell's law, differentiated; a disc of radius r has the
// variance r^2 / 4.
void water_caustics_sun_spread(const double sun_dir[3], double index, double spread[3]);

// Derivative of the horizontal displacement by the surface's slope, per depth, for calm water: xx,
// xy, yy (it is symmetric to first order). It is (1 - 1/n) for a sun at the zenith.
void water_caustics_turn(const double sun_dir[3], double index, double turn[3]);

// Accumulates light in a texture on the CPU, which is faster than drawing points with software GL.
// The result is the same as with vtkWaterLightVS.glsl and vtkWaterLightFS.glsl. A texel at a
// distance d from a photon's place gets weight (1 - d . shape d)^3, 0 where that is negative.
//
// places  count times 4: place x, y in texels, weight, and what is not used
// shapes  count times 4: shape xx, xy, yy, positive definite, and what is not used
// light   texture_px[0] * texture_px[1], row by row; it is added to
void water_caustics_add(
  const float* places, const float* shapes, size_t count, const int texture_px[2], float* light);

#ifdef __cplusplus
}
#endif
#endif
