// SPDX-License-Identifier: BSD-3-Clause
// water_phase.h: phases reduced without loss, and the dispersion of water waves; private to the
// core.
//
// A phase is kept in turns (1 turn = 2 pi): the whole turns of a double come off exactly, those of
// 2 pi never do.
#ifndef water_phase_h
#define water_phase_h

#include <math.h>

#ifdef __cplusplus
extern "C"
{
#endif

static const double water_two_pi = 6.283185307179586;
static const double water_gravity = 9.80665; // m/s^2, standard gravity (CGPM 1901)

// The nearest whole turn comes off; exact. In [-1/2, 1/2].
static inline double water_turn(double turns)
{
  return turns - rint(turns);
}

// Rounding error of the product a * b by Dekker 1971, with Veltkamp's halves of 26 bits; exact for
// factors under 1e299 unless the error itself underflows.
static inline double water_product_loss_by_halves(double a, double b)
{
  const double split = 134217729.0; // 2^27 + 1
  const double a_high = split * a - (split * a - a);
  const double b_high = split * b - (split * b - b);
  const double a_low = a - a_high;
  const double b_low = b - b_high;
  return ((a_high * b_high - a * b) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

// The same in one instruction where there is one.
static inline double water_product_loss(double a, double b)
{
#ifdef __MINGW32__ // its fma rounds twice
  return water_product_loss_by_halves(a, b);
#else
  return fma(a, b, -(a * b));
#endif
}

// a * b turns without the whole ones, within 2^-54 turn for any product that is finite: the product
// and what its rounding took both lose their whole turns exactly, and only their sum
// is rounded. Needs a compiler that does not contract (CMakeLists.txt: -ffp-contract=off).
static inline double water_turns(double a, double b)
{
  return water_turn(water_turn(a * b) + water_product_loss(a, b));
}

// 2 k h / sinh(2 k h): 1 in shallow, 0 in deep water, with no overflow between.
static inline double water_shallowness(double kh)
{
  if (kh < 1e-8) // the next term of the series, 2/3 (kh)^2, is under a rounding
  {
    return 1.0;
  }
  return kh > 20.0 ? 0.0 : 2.0 * kh / sinh(2.0 * kh); // 40 / sinh(40) is under a rounding of 1
}

// Angular frequency in rad/s of wave number k in rad/m; depth in m, infinity is deep.
static inline double water_dispersion(double k, double depth)
{
  return k > 0.0 ? sqrt(water_gravity * k) * sqrt(tanh(k * depth)) : 0.0;
}

// Group velocity d omega / d k in m/s, k > 0.
static inline double water_group_velocity(double k, double depth)
{
  return 0.5 * water_dispersion(k, depth) / k * (1.0 + water_shallowness(k * depth));
}

#ifdef __cplusplus
}
#endif
#endif
