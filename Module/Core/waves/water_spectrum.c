// SPDX-License-Identifier: BSD-3-Clause
// water_spectrum.c: how much variance a wind sea has at each wave vector.
#include "water_spectrum.h"

#include "water_math.h"
#include "water_phase.h"
#include "water_waves.h"

static const double phillips_alpha = 0.0081; // Phillips 1958, 1977

// Under peak / 6 the density is below exp(-1.25 * 6^4) = 1e-703 of the peak's: no double holds it.
static const double lowest = 1.0 / 6.0;

water_status water_sea_check(const water_sea* sea)
{
  if ((sea->model != WATER_SEA_JONSWAP && sea->model != WATER_SEA_PHILLIPS) ||
    (sea->spreading != WATER_SPREAD_DONELAN_BANNER && sea->spreading != WATER_SPREAD_COS_2S))
  {
    return WATER_BAD_SEA_MODEL;
  }
  if (!(sea->wind_speed >= 0.1 && sea->wind_speed <= 100.0))
  {
    return WATER_BAD_WIND_SPEED;
  }
  if (!isfinite(sea->wind_dir_rad))
  {
    return WATER_BAD_WIND_DIRECTION;
  }
  if (!(sea->fetch >= 1.0))
  {
    return WATER_BAD_FETCH;
  }
  if (!(sea->depth > 0.0))
  {
    return WATER_BAD_DEPTH;
  }
  if (!(sea->peak_enhancement >= 1.0 && sea->peak_enhancement <= 20.0))
  {
    return WATER_BAD_PEAK_ENHANCEMENT;
  }
  if (!(sea->spreading_power >= 0.0 && sea->spreading_power <= 1000.0))
  {
    return WATER_BAD_SPREADING_POWER;
  }
  return WATER_OK;
}

bool water_sea_is_same(const water_sea* a, const water_sea* b)
{
  return a->model == b->model && a->spreading == b->spreading && a->wind_speed == b->wind_speed &&
    a->wind_dir_rad == b->wind_dir_rad && a->fetch == b->fetch && a->depth == b->depth &&
    a->peak_enhancement == b->peak_enhancement && a->spreading_power == b->spreading_power;
}

// g F / U^2, up to where 22 (U^2 / (g F))^(1/3) = 2 pi 0.13.
static double dimensionless_fetch(const water_sea* sea)
{
  const double grown = pow(22.0 / (water_two_pi * 0.13), 3.0);
  const double fetch = water_gravity * sea->fetch / (sea->wind_speed * sea->wind_speed);
  return fmin(fetch, grown);
}

double water_sea_peak(const water_sea* sea)
{
  const double unit = water_gravity / sea->wind_speed;
  if (sea->model == WATER_SEA_PHILLIPS)
  {
    return unit * pow(0.8, 0.25); // where d/domega of omega^-5 exp(-(g / (omega U))^4) is 0
  }
  return unit * 22.0 / cbrt(dimensionless_fetch(sea));
}

double water_sea_depth_factor(double omega, double depth)
{
  double k = 0.0;
  (void)water_waves_wavenumber(omega, depth, &k);
  const double t = tanh(k * depth);
  return t * t / (1.0 + water_shallowness(k * depth));
}

double water_sea_frequency_density(const water_sea* sea, double omega)
{
  const double peak = water_sea_peak(sea);
  const double ratio = peak / omega;
  if (!(ratio * lowest < 1.0))
  {
    return 0.0;
  }
  const double fourth = ratio * ratio * ratio * ratio;
  // g^2 omega^-5 exp(-5/4 (peak / omega)^4), m^2 s; for Phillips 5/4 peak^4 is (g / U)^4
  const double shape =
    water_gravity * water_gravity / pow(peak, 5.0) * fourth * ratio * exp(-1.25 * fourth);
  if (sea->model == WATER_SEA_PHILLIPS)
  {
    return phillips_alpha * shape;
  }
  const double alpha = 0.076 * pow(dimensionless_fetch(sea), -0.22);
  const double width = omega > peak ? 0.09 : 0.07;
  const double away = (omega / peak - 1.0) / width;
  return alpha * shape * pow(sea->peak_enhancement, exp(-0.5 * away * away)) *
    water_sea_depth_factor(omega, sea->depth);
}

// Depth for the dispersion of a sea's waves: Phillips knows deep water only.
static double sea_depth(const water_sea* sea)
{
  return sea->model == WATER_SEA_PHILLIPS ? (double)INFINITY : sea->depth;
}

double water_sea_wavenumber_density(const water_sea* sea, double k)
{
  const double depth = sea_depth(sea);
  return water_sea_frequency_density(sea, water_dispersion(k, depth)) *
    water_group_velocity(k, depth);
}

static double donelan_banner(double ratio, double angle)
{
  double beta = 1.24; // before the rise, Donelan et al.
  if (ratio > 1.6)
  {
    beta = pow(10.0, -0.4 + 0.8393 * exp(-0.567 * log(ratio * ratio)));
  }
  else if (ratio > 0.95)
  {
    beta = 2.28 * pow(ratio, -1.3);
  }
  else if (ratio > 0.56)
  {
    beta = 2.61 * pow(ratio, 1.3);
  }
  const double fall = cosh(beta * angle);
  return beta / (2.0 * tanh(beta * 0.5 * water_two_pi)) / (fall * fall);
}

double water_sea_spread(const water_sea* sea, double omega, double angle_rad)
{
  const double angle = remainder(angle_rad, water_two_pi);
  if (sea->model == WATER_SEA_PHILLIPS)
  {
    const double c = cos(angle);
    return c * c / (0.5 * water_two_pi);
  }
  if (sea->spreading == WATER_SPREAD_DONELAN_BANNER)
  {
    return donelan_banner(omega / water_sea_peak(sea), angle);
  }
  const double s = sea->spreading_power;
  // Gamma(s + 1) / (2 sqrt(pi) Gamma(s + 1/2)) makes the integral 1
  const double scale = exp(lgamma(s + 1.0) - lgamma(s + 0.5)) / sqrt(2.0 * water_two_pi);
  return scale * pow(fabs(cos(0.5 * angle)), 2.0 * s);
}

double water_sea_density(const water_sea* sea, double kx, double ky)
{
  const double k = hypot(kx, ky);
  if (!(k > 0.0))
  {
    return 0.0;
  }
  const double omega = water_dispersion(k, sea_depth(sea));
  const double angle = atan2(ky, kx) - remainder(sea->wind_dir_rad, water_two_pi);
  return water_sea_wavenumber_density(sea, k) / k * water_sea_spread(sea, omega, angle);
}

// Gauss's rule over ln k between two wave numbers.
enum
{
  PANELS = 512,
  NODES = 4
};
static const double node[NODES] = { -0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
  0.8611363115940526 };
static const double weight[NODES] = { 0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
  0.3478548451374538 };

typedef struct band
{
  double first; // ln k
  double half;  // half a panel
} band;

static water_status band_of(const water_sea* sea, double k_low, double k_high, band* made)
{
  if (!(k_low >= 0.0) || !(k_high > k_low) || !isfinite(k_high))
  {
    return WATER_BAD_WAVENUMBER;
  }
  double k_empty = 0.0; // no variance below
  (void)water_waves_wavenumber(water_sea_peak(sea) * lowest, sea_depth(sea), &k_empty);
  made->first = log(fmin(fmax(k_low, k_empty), k_high));
  made->half = 0.5 * (log(k_high) - made->first) / (double)PANELS;
  return WATER_OK;
}

static double middle_of(const band* of, int panel)
{
  return of->first + of->half * (2.0 * panel + 1.0);
}

// Adds the variances of height and slope of a panel.
static void add_panel(
  const water_sea* sea, const band* of, int panel, double* height, double* slope)
{
  for (int i = 0; i < NODES; ++i)
  {
    // dk = k d(ln k)
    const double k = exp(middle_of(of, panel) + of->half * node[i]);
    const double part = of->half * weight[i] * k * water_sea_wavenumber_density(sea, k);
    *height += part;
    *slope += k * k * part;
  }
}

water_status water_sea_moments(
  const water_sea* sea, double k_low, double k_high, double* height, double* slope)
{
  band all;
  const water_status status = band_of(sea, k_low, k_high, &all);
  if (status != WATER_OK)
  {
    return status;
  }
  *height = 0.0;
  *slope = 0.0;
  for (int panel = 0; panel < PANELS; ++panel)
  {
    add_panel(sea, &all, panel, height, slope);
  }
  return WATER_OK;
}

// Mean of cos(2 angle) over the directions of a frequency, the angle from the wind.
static double alignment(const water_sea* sea, double omega)
{
  enum
  {
    POINTS = 128
  };
  double sum = 0.0;
  double aligned = 0.0;
  for (int i = 0; i < POINTS; ++i)
  {
    const double angle = water_two_pi * i / (double)POINTS;
    const double share = water_sea_spread(sea, omega, angle);
    sum += share;
    aligned += share * cos(2.0 * angle);
  }
  return aligned / sum;
}

water_status water_sea_slopes(const water_sea* sea, double k_low, double k_high, double variance[2])
{
  band all;
  const water_status status = band_of(sea, k_low, k_high, &all);
  if (status != WATER_OK)
  {
    return status;
  }
  const double turn = cos(2.0 * remainder(sea->wind_dir_rad, water_two_pi));
  variance[0] = 0.0;
  variance[1] = 0.0;
  for (int panel = 0; panel < PANELS; ++panel)
  {
    double height = 0.0;
    double slope = 0.0;
    add_panel(sea, &all, panel, &height, &slope);
    if (slope > 0.0)
    {
      // cos^2 = (1 + cos 2) / 2; spreading is even in the angle, so that its sines cancel
      const double omega = water_dispersion(exp(middle_of(&all, panel)), sea_depth(sea));
      const double share = 0.5 + 0.5 * turn * alignment(sea, omega);
      variance[0] += share * slope;
      variance[1] += (1.0 - share) * slope;
    }
  }
  return WATER_OK;
}
