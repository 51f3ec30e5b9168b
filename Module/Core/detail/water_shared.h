// SPDX-License-Identifier: BSD-3-Clause
// water_shared.h: the formulas that core and shaders have in one text, Module/Core/shared/*.glsl.
// What each computes stands there; none checks its inputs.
#ifndef water_shared_h
#define water_shared_h

#ifdef __cplusplus
extern "C"
{
#endif

double water_shared_fresnel(double cosine, double eta);
double water_shared_schlick(double cosine, double eta);
double water_shared_transmittance(double extinction, double way);
double water_shared_slope_density(double xx, double yy, double xy, double area, double x, double y);
double water_shared_glitter_spread(double eye_cosine, double facet4);
// Reference of tests: nothing in the module calls it; two shaders have its text.
double water_shared_gradient_height(double y, double w);

#ifdef __cplusplus
}
#endif
#endif
