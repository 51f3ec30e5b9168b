// SPDX-License-Identifier: BSD-3-Clause
// water_spectrum.h: how much variance a wind sea has at each wave vector.
//
// Units are metres, seconds and radians; wave vectors in the plane's own axes; g = 9.80665 m/s^2.
// A density is of variance (m^2), not of energy; Hs = 4 sqrt(variance).
#ifndef water_spectrum_h
#define water_spectrum_h

#include "water_status.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

typedef enum water_sea_model
{
  WATER_SEA_JONSWAP, // with the TMA factor for finite depth
  WATER_SEA_PHILLIPS // for comparison: deep, fully developed, as much against the wind as with it
} water_sea_model;

typedef enum water_sea_spreading // not used by WATER_SEA_PHILLIPS, which has its own
{
  WATER_SPREAD_DONELAN_BANNER, // narrow at the peak, wider for shorter waves
  WATER_SPREAD_COS_2S          // the same for all waves: cos^2s of half the angle
} water_sea_spreading;

typedef struct water_sea
{
  water_sea_model model;
  water_sea_spreading spreading;
  double wind_speed;       // m/s at 10 m, in [0.1, 100]
  double wind_dir_rad;     // in which it blows, from the first towards the second axis
  double fetch;            // m of open water upwind, >= 1; infinity: fully developed
  double depth;            // m, > 0; infinity is deep water
  double peak_enhancement; // gamma in [1, 20]; 3.3 growing sea (the mean of JONSWAP), 1 developed
  double spreading_power;  // s of cos^2s in [0, 1000]; 0: all directions alike
} water_sea;

// Returns WATER_OK, or the first of WATER_BAD_SEA_MODEL, WATER_BAD_WIND_SPEED,
// WATER_BAD_WIND_DIRECTION, WATER_BAD_FETCH, WATER_BAD_DEPTH, WATER_BAD_PEAK_ENHANCEMENT,
// WATER_BAD_SPREADING_POWER that applies. The functions below require a checked sea.
water_status water_sea_check(const water_sea* sea);

// Are two seas the same?
bool water_sea_is_same(const water_sea* a, const water_sea* b);

// Angular frequency of the spectrum's peak in rad/s. JONSWAP: 22 (g^2 / (U F))^(1/3), down to the
// fully developed sea's 2 pi 0.13 g / U, where the growth ends (g F / U^2 = 1.95e4; with longer
// fetches nothing changes any more). Phillips: (4/5)^(1/4) g / U.
// Sources: Hasselmann et al. 1973, "Measurements of Wind-Wave Growth and Swell Decay during the
// Joint North Sea Wave Project"; Pierson and Moskowitz 1964 (the end of growth).
double water_sea_peak(const water_sea* sea);

// The depth factor of the frequency spectrum, in (0, 1]: tanh^2(kh) / (1 + 2kh / sinh(2kh)).
//
// omega  rad/s, > 0
// Sources: Kitaigorodskii et al. 1975, "On Phillips' Theory of Equilibrium Range in the Spectra of
// Wind-Generated Gravity Waves"; Bouws et al. 1985, "Similarity of the Wind Wave Spectrum in Finite
// Depth Water 1" (TMA).
double water_sea_depth_factor(double omega, double depth);

// Variance per rad/s (m^2 s), over all directions; omega > 0.
//
// JONSWAP: alpha g^2 omega^-5 exp(-5/4 (peak/omega)^4) gamma^r, alpha = 0.076 (g F / U^2)^-0.22,
// times the depth factor. With gamma 3.3 its Hs is 6 to 36 % above the fit of the measured heights
// in the same report, 1.6e-7 g F / U^2 of variance: the published means of the parts do not make
// the mean of the whole.
// Phillips: alpha g^2 omega^-5 exp(-(g / (omega U))^4), alpha = 0.0081; the same as Tessendorf's
// below.
double water_sea_frequency_density(const water_sea* sea, double omega);

// Variance per rad/m (m^3), over all directions; k > 0. Phillips: alpha/2 k^-3 exp(-1 / (k
// U^2/g)^2).
// Source: Tessendorf 2001, "Simulating Ocean Water", whose constant is set to Phillips' 0.0081
// here.
double water_sea_wavenumber_density(const water_sea* sea, double k);

// The share of a direction, per radian; its integral over the circle is 1.
//
// omega      rad/s, > 0
// angle_rad  from the wind
// Sources: Longuet-Higgins, Cartwright and Smith 1963 (cos^2s); Donelan, Hamilton and Hui 1985,
// "Directional Spectra of Wind-Generated Waves", with Banner 1990, "Equilibrium Spectra of Wind
// Waves" beyond 1.6 times the peak.
double water_sea_spread(const water_sea* sea, double omega, double angle_rad);

// Variance per wave vector, S(kx, ky) in m^4; 0 at the origin.
double water_sea_density(const water_sea* sea, double kx, double ky);

// Variances of height (m^2) and slope of the waves with wave numbers in a band, over all
// directions: for Hs = 4 sqrt(height), and for what a pixel or a tile leaves out. The slope's grows
// with the logarithm of k_high; real water ends near 2 pi / 1.7 cm = 370 rad/m.
//
// k_low, k_high  rad/m, 0 <= k_low < k_high
//
// Returns WATER_OK or WATER_BAD_WAVENUMBER. On an error, the outputs are unchanged. Error below
// 1e-5 of the value, by Gauss's rule of 4 points on 512 panels of ln k.
// Used only by tests, as a reference.
water_status water_sea_moments(
  const water_sea* sea, double k_low, double k_high, double* height, double* slope);

// The slope's variance along the plane's two axes; the two together are that of water_sea_moments.
// The directions by the trapezoid rule of 128 points, once a panel.
//
// Returns WATER_OK or WATER_BAD_WAVENUMBER. On an error, variance is unchanged.
water_status water_sea_slopes(
  const water_sea* sea, double k_low, double k_high, double variance[2]);

#ifdef __cplusplus
}
#endif
#endif
