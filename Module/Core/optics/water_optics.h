// SPDX-License-Identifier: BSD-3-Clause
// water_optics.h: how much the surface reflects.
//
// eta is the index of refraction beyond the surface over the one on the eye's side: 1.333 seen from
// above, 1 / 1.333 seen from below. cosine is that of the angle between ray and normal, in [0, 1];
// values outside are clamped. Both reflectances are vtkWaterOptics.glsl, the shader's.
#ifndef water_optics_h
#define water_optics_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Returns WATER_OK, WATER_BAD_INDEX or WATER_BAD_REFLECTANCE. Both numbers are checked whichever is
// in use, so that switching the mode brings no new error.
water_status water_optics_check(const water_look* look);

// Adds a water to the common look of the waters that share a reflection texture. From every
// direction, this look reflects at least as much as each of them.
void water_optics_join(const water_look* look, water_look* all);

// The index ratio for an eye on that side.
double water_optics_eta(const water_look* look, water_side side);

// Reflectance of unpolarised light at a smooth surface, exact; 1 under total internal reflection.
// In [0, 1], and falls with the cosine for indices up to 2 + sqrt(3). Error: 16 u, u = 2^-53, and
// what 4 u in the squared cosine of the refracted ray do, which is most at the critical angle:
// sqrt(u) there. Derived at, and checked by, Testing/Core/Stability. Source: Fresnel 1823, in the
// form of Cook and Torrance 1982, "A Reflectance Model for Computer Graphics".
double water_optics_fresnel(double cosine, double eta);

// The same by Schlick's approximation, off by less than 0.06 for water. From the denser side the
// angle is that of the refracted ray, which keeps total internal reflection where it is.
// Source: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
// Used only by tests, as a reference.
double water_optics_schlick(double cosine, double eta);

// The most that any pixel of a part of the picture reflects, from above the water.
//
// ndc_to_ray  of the plan
// box         the part, NDC of the eye: low x, low y, high x, high y
// slope_max   of the waves, >= 0, may be infinite
double water_optics_reflectance_max(const water_look* look, double eta, const double ndc_to_ray[9],
  const double box[4], double slope_max);

// The angle from the normal beyond which everything is reflected, in radians; pi/2 (never) when the
// eye is on the thinner side, eta >= 1.
// Used only by tests, as a reference.
double water_optics_critical_rad(double eta);

#ifdef __cplusplus
}
#endif
#endif
