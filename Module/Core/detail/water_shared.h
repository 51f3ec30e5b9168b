// SPDX-License-Identifier: BSD-3-Clause
// water_shared.h: the formulas that core and shaders have in one text, Module/Core/shared/*.glsl.
// What each computes stands there; none checks its inputs.
#ifndef water_shared_h
#define water_shared_h

#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

double water_shared_fresnel(double cosine, double eta);
double water_shared_schlick(double cosine, double eta);
double water_shared_transmittance(double extinction, double way);
double water_shared_sent_back(double scattering, double extinction);
double water_shared_encoded(double linear);
double water_shared_haze_particles(double cosine);
double water_shared_haze_molecules(double cosine);
double water_shared_haze_integral(double rate, double way);
double water_shared_haze_over(
  double extinction, double diffuse, double fall, double depth, double way);
double water_shared_slope_density(double xx, double yy, double xy, double area, double x, double y);
double water_shared_facing_area(double cosine, double spread);
double water_shared_glitter_spread(double seen, double facet4);
// References of tests: nothing in the module calls them; shaders have their text.
double water_shared_scattered_at(double extinction, double way, double part);
double water_shared_scattered(double extinction, double from, double to);
double water_shared_roll_off(double light);
double water_shared_shore_foam(double depth, double turn);
double water_shared_foam_threshold(double share);
double water_shared_foam_of_measure(double value, double first, double last);
double water_shared_with_matter(double clear, double per_unit, double concentration);
double water_shared_flow_gain(double weight, double apart, double likeness);
double water_shared_flow_band_gain(double weight, double apart, double first, double last);
double water_shared_gradient_height(double y, double w);
double water_shared_gradient_share(int screen, double s, double t);
// References of tests, too: the core has doubles.
uint32_t water_shared_upper_half(uint32_t a, uint32_t b);
uint32_t water_shared_phase(uint32_t f0, uint32_t f1, uint32_t f2, uint32_t t0, uint32_t t1);
double water_shared_cosine(uint32_t phase);
double water_shared_sine(uint32_t phase);

#ifdef __cplusplus
}
#endif
#endif
