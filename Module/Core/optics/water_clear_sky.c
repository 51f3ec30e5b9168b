// SPDX-License-Identifier: BSD-3-Clause
// water_clear_sky.c: the model of Preetham, Shirley and Smits 1999.
#include "water_clear_sky.h"

#include "water_math.h"
#include "water_phase.h"

const double water_clear_sky_turbidity_min = 2.0;
const double water_clear_sky_turbidity_max = 10.0;

static const double half_pi = 1.5707963267948966;
static const double degree = 0.017453292519943295;

// Perez's function is not defined at the horizon, and grows towards it in no time.
static const double lowest_cosine = 0.01;

static const double locus_x[2] = { 0.25, 0.38 }; // of 25,000 and 4,000 K, where it is known

static const double ground_albedo = 0.1;
static const double haze_sine = 0.17364817766693; // of 10 degrees
static const double mean_shown = 0.3;

static const double sun_illuminance = 128.0; // klx, over the air

enum
{
  MEAN_RINGS = 32, // of the sky's mean
  MEAN_SECTORS = 64
};

static double power_sum(const double coefficients[4], double x)
{
  return ((coefficients[0] * x + coefficients[1]) * x + coefficients[2]) * x + coefficients[3];
}

// x or y at the zenith: section A.2.
static double zenith_chromaticity(const double rows[3][4], double turbidity, double sun_angle)
{
  return (power_sum(rows[0], sun_angle) * turbidity + power_sum(rows[1], sun_angle)) * turbidity +
    power_sum(rows[2], sun_angle);
}

static double perez(const double c[5], double cosine, double sun_cosine)
{
  const double to_sun = acos(fmin(fmax(sun_cosine, -1.0), 1.0));
  return (1.0 + c[0] * exp(c[1] / cosine)) *
    (1.0 + c[2] * exp(c[3] * to_sun) + c[4] * sun_cosine * sun_cosine);
}

static void set_distribution(water_clear_sky* sky)
{
  // Section A.2: slope and value at turbidity 0 of A to E, for Y, x and y.
  static const double rows[3][5][2] = { { { 0.1787, -1.4630 }, { -0.3554, 0.4275 },
                                          { -0.0227, 5.3251 }, { 0.1206, -2.5771 },
                                          { -0.0670, 0.3703 } },
    { { -0.0193, -0.2592 }, { -0.0665, 0.0008 }, { -0.0004, 0.2125 }, { -0.0641, -0.8989 },
      { -0.0033, 0.0452 } },
    { { -0.0167, -0.2608 }, { -0.0950, 0.0092 }, { -0.0079, 0.2102 }, { -0.0441, -1.6537 },
      { -0.0109, 0.0529 } } };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 5; ++j)
    {
      sky->perez[i][j] = rows[i][j][0] * sky->turbidity + rows[i][j][1];
    }
  }
}

static void set_zenith(water_clear_sky* sky)
{
  static const double x_rows[3][4] = { { 0.00166, -0.00375, 0.00209, 0.0 },
    { -0.02903, 0.06377, -0.03202, 0.00394 }, { 0.11693, -0.21196, 0.06052, 0.25886 } };
  static const double y_rows[3][4] = { { 0.00275, -0.00610, 0.00317, 0.0 },
    { -0.04214, 0.08970, -0.04153, 0.00516 }, { 0.15346, -0.26756, 0.06670, 0.26688 } };
  const double angle = sky->zenith_angle_rad;
  const double turbidity = sky->turbidity;
  const double chi = (4.0 / 9.0 - turbidity / 120.0) * 2.0 * (half_pi - angle);
  const double at_zenith[3] = { (4.0453 * turbidity - 4.9710) * tan(chi) - 0.2155 * turbidity +
      2.4192,
    zenith_chromaticity(x_rows, turbidity, angle), zenith_chromaticity(y_rows, turbidity, angle) };
  for (int i = 0; i < 3; ++i)
  {
    sky->zenith[i] = at_zenith[i] / perez(sky->perez[i], 1.0, cos(angle));
  }
}

// Skylight lies on the daylight locus or on its green side (Judd, MacAdam and Wyszecki 1964). The
// model's polynomials leave it towards purple near the horizon, and away from the sun.
static double on_daylight_side(double x, double y)
{
  const double within = fmin(fmax(x, locus_x[0]), locus_x[1]);
  return fmax(y, (-3.0 * within + 2.87) * within - 0.275);
}

// Above the horizon.
static void sky_color(const water_clear_sky* sky, const double dir[3], double color[3])
{
  // XYZ to the linear primaries of sRGB
  static const double to_rgb[3][3] = { { 3.2406, -1.5372, -0.4986 }, { -0.9689, 1.8758, 0.0415 },
    { 0.0557, -0.2040, 1.0570 } };
  const double cosine = fmax(dir[2], lowest_cosine);
  const double sun_cosine = water_vec3_dot(dir, sky->sun_dir);
  double value[3];
  for (int i = 0; i < 3; ++i)
  {
    value[i] = sky->zenith[i] * perez(sky->perez[i], cosine, sun_cosine);
  }
  value[2] = on_daylight_side(value[1], value[2]);
  const double x = value[1] / value[2];
  const double z = (1.0 - value[1] - value[2]) / value[2];
  for (int i = 0; i < 3; ++i)
  {
    color[i] = fmax(value[0] * (to_rgb[i][0] * x + to_rgb[i][1] + to_rgb[i][2] * z), 0.0);
  }
}

// Rings of equal steps in the squared sine from the zenith have equal shares.
static void set_mean(water_clear_sky* sky)
{
  for (int i = 0; i < MEAN_RINGS; ++i)
  {
    const double squared = (i + 0.5) / MEAN_RINGS;
    for (int j = 0; j < MEAN_SECTORS; ++j)
    {
      const double angle = water_two_pi * (j + 0.5) / MEAN_SECTORS;
      const double dir[3] = { sqrt(squared) * cos(angle), sqrt(squared) * sin(angle),
        sqrt(1.0 - squared) };
      double color[3];
      sky_color(sky, dir, color);
      for (int k = 0; k < 3; ++k)
      {
        sky->mean[k] += color[k] / (MEAN_RINGS * MEAN_SECTORS);
      }
    }
  }
}

bool water_clear_sky_make(
  double azimuth_deg, double elevation_deg, double turbidity, water_clear_sky* sky)
{
  if (!isfinite(azimuth_deg) || !(elevation_deg >= 0.0 && elevation_deg <= 90.0) ||
    !(turbidity >= water_clear_sky_turbidity_min && turbidity <= water_clear_sky_turbidity_max))
  {
    return false;
  }
  memset(sky, 0, sizeof *sky);
  const double azimuth = fmod(azimuth_deg, 360.0) * degree;
  sky->zenith_angle_rad = half_pi - elevation_deg * degree;
  sky->turbidity = turbidity;
  sky->sun_dir[0] = sin(sky->zenith_angle_rad) * sin(azimuth);
  sky->sun_dir[1] = sin(sky->zenith_angle_rad) * cos(azimuth);
  sky->sun_dir[2] = cos(sky->zenith_angle_rad);
  set_distribution(sky);
  set_zenith(sky);
  set_mean(sky);
  return true;
}

void water_clear_sky_color(const water_clear_sky* sky, const double dir[3], double color[3])
{
  sky_color(sky, dir, color);
  const double sunk = fmin(fmax(-dir[2] / haze_sine, 0.0), 1.0);
  const double share = sunk * sunk * (3.0 - 2.0 * sunk);
  const double grey =
    ground_albedo * (0.2126 * sky->mean[0] + 0.7152 * sky->mean[1] + 0.0722 * sky->mean[2]);
  for (int i = 0; i < 3; ++i)
  {
    color[i] += share * (grey - color[i]);
  }
}

void water_clear_sky_sun(const water_clear_sky* sky, double color[3])
{
  static const double wavelength_um[3] = { 0.650, 0.570, 0.475 };
  const double angle_deg = sky->zenith_angle_rad / degree;
  // how many times the air over the zenith; section A.1
  const double mass = 1.0 / (sky->sun_dir[2] + 0.15 * pow(93.885 - angle_deg, -1.253));
  const double beta = 0.04608 * sky->turbidity - 0.04586; // aerosols
  for (int i = 0; i < 3; ++i)
  {
    const double molecules = exp(-0.008735 * pow(wavelength_um[i], -4.08) * mass);
    const double aerosols = exp(-beta * pow(wavelength_um[i], -1.3) * mass);
    color[i] = 2.0 * sun_illuminance / water_two_pi * molecules * aerosols;
  }
}

double water_clear_sky_exposure(const water_clear_sky* sky)
{
  return mean_shown / (0.2126 * sky->mean[0] + 0.7152 * sky->mean[1] + 0.0722 * sky->mean[2]);
}

void water_clear_sky_place(double u, double v, double dir[3])
{
  const double longitude = water_two_pi * (u - 0.5);
  const double latitude = 2.0 * half_pi * (v - 0.5);
  dir[0] = cos(latitude) * cos(longitude);
  dir[1] = -cos(latitude) * sin(longitude);
  dir[2] = sin(latitude);
}
