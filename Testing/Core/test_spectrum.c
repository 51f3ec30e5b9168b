// SPDX-License-Identifier: BSD-3-Clause
// test_spectrum.c: the wind sea against published heights, periods, slopes and limits.
#include "test_scene.h"

#include "water_phase.h"
#include "water_spectrum.h"
#include "water_waves.h"

static const double pi = 3.141592653589793;
static const double g = 9.80665;
static const double deep = (double)INFINITY;

static water_sea sea_of(double wind, double fetch, double gamma)
{
  const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, wind, 0.0, fetch, deep,
    gamma, 8.0 };
  assert_int_equal(water_sea_check(&sea), WATER_OK);
  return sea;
}

// Moment of the frequency spectrum by the trapezium rule in ln omega.
static double moment(const water_sea* sea, int order)
{
  const double peak = water_sea_peak(sea);
  double sum = 0.0;
  for (double step = -2.0; step < 9.0; step += 0.0005)
  {
    const double omega = peak * exp(step);
    sum += 0.0005 * omega * pow(omega, order) * water_sea_frequency_density(sea, omega);
  }
  return sum;
}

static double height_variance(const water_sea* sea)
{
  double height = 0.0;
  double slope = 0.0;
  assert_int_equal(water_sea_moments(sea, 0.0, 1e5, &height, &slope), WATER_OK);
  return height;
}

// Without enhancement the variance is alpha g^2 / (5 peak^4) (the integral in closed form); with
// 3.3, that over 1 - 0.287 ln 3.3, and the mean zero-crossing period is 0.7775 of the peak's
// (DNV-RP-C205, 3.5.5: the first within 2 %, the second within 1 %).
TEST(shape_has_the_known_area_and_period)
{
  const water_sea plain = sea_of(10.0, 1e5, 1.0);
  const water_sea peaked = sea_of(10.0, 1e5, 3.3);
  const double peak = water_sea_peak(&plain);
  const double alpha = 0.01006188; // 0.076 * 9806.65^-0.22
  const double known = alpha * g * g / (5.0 * pow(peak, 4.0));
  ASSERT_CLOSE(moment(&plain, 0), known, 1e-4 * known);
  const double area = moment(&peaked, 0);
  ASSERT_CLOSE(area, known / (1.0 - 0.287 * log(3.3)), 0.02 * area);
  // one width beside the peak, 0.07 of it below and 0.09 above, the enhancement is 3.3^exp(-1/2)
  for (int side = 0; side < 2; ++side)
  {
    const double omega = (side == 0 ? 0.93 : 1.09) * peak;
    ASSERT_CLOSE(
      water_sea_frequency_density(&peaked, omega) / water_sea_frequency_density(&plain, omega),
      2.0630, 1e-4);
  }
  const double period = 2.0 * pi * sqrt(area / moment(&peaked, 2));
  ASSERT_CLOSE(period, 0.7775 * 2.0 * pi / peak, 0.01 * period);
}

// A fully developed sea has the height of Pierson and Moskowitz, 0.21 U^2 / g with the wind at 19.5
// m, which is 0.243 U^2 / g with it at 10 m (0.62, 2.5 and 5.6 m at 5, 10 and 15 m/s), and their
// peak period, 0.729 U / g * 10 (within 5 %); a longer fetch changes nothing.
TEST(developed_sea_has_the_height_of_pierson_and_moskowitz)
{
  for (double wind = 5.0; wind < 25.0; wind += 5.0)
  {
    const water_sea sea = sea_of(wind, deep, 1.0);
    const double known = 0.243 * wind * wind / g;
    ASSERT_CLOSE(4.0 * sqrt(height_variance(&sea)), known, 0.05 * known);
    const double period = 2.0 * pi * wind / (0.855 * g); // 0.877 g / U at 19.5 m
    ASSERT_CLOSE(2.0 * pi / water_sea_peak(&sea), period, 0.1 * period);
    const water_sea longer = sea_of(wind, 1e9, 1.0);
    ASSERT_CLOSE(height_variance(&longer), height_variance(&sea), 1e-12);
  }
}

// A growing sea is the JONSWAP charts', Hs = 0.0163 sqrt(X) U and Tp = 0.566 X^0.3 U^0.4 with X in
// km (Carter 1982), as near as the published means of its parts are: up to 35 % over in height, 12
// % in period.
TEST(growing_sea_follows_the_charts)
{
  for (double km = 10.0; km <= 120.0; km *= 1.5)
  {
    for (double wind = 10.0; wind <= 20.0; wind += 5.0)
    {
      const water_sea sea = sea_of(wind, 1e3 * km, 3.3);
      const double ratio = 4.0 * sqrt(height_variance(&sea)) / (0.0163 * sqrt(km) * wind);
      assert_true(ratio > 1.0 && ratio < 1.35);
      const double period = 0.566 * pow(km, 0.3) * pow(wind, 0.4);
      ASSERT_CLOSE(2.0 * pi / water_sea_peak(&sea), period, 0.12 * period);
    }
  }
}

// Where two formulas of Donelan and Banner meet, a little apart, the one below still holds: along
// the wind the share is beta / (2 tanh(pi beta)).
TEST(spreading_changes_its_formula_where_it_should)
{
  const water_sea sea = sea_of(10.0, 1e5, 3.3);
  const double peak = water_sea_peak(&sea);
  const double limits[3] = { 0.56, 0.95, 1.6 };
  const double betas[3] = { 1.24, 2.61 * pow(0.95, 1.3), 2.28 * pow(1.6, -1.3) };
  for (int i = 0; i < 3; ++i)
  {
    double omega = limits[i] * peak;
    omega = omega / peak > limits[i] ? nextafter(omega, 0.0) : omega;
    assert_true(omega / peak == limits[i]);
    const double share = betas[i] / (2.0 * tanh(betas[i] * pi));
    ASSERT_CLOSE(water_sea_spread(&sea, omega, 0.0), share, 1e-6);
  }
}

// A range of wave numbers has an end beyond its begin.
TEST(empty_ranges_of_waves_are_refused)
{
  const water_sea sea = sea_of(10.0, 1e5, 3.3);
  double height = -1.0;
  double slope = -1.0;
  double slopes[2];
  assert_int_equal(water_sea_moments(&sea, 2.0, 2.0, &height, &slope), WATER_BAD_WAVENUMBER);
  assert_int_equal(water_sea_slopes(&sea, 2.0, 2.0, slopes), WATER_BAD_WAVENUMBER);
  assert_true(height == -1.0 && slope == -1.0);
  assert_int_equal(water_sea_moments(&sea, 2.0, nextafter(2.0, 3.0), &height, &slope), WATER_OK);
}

// The peak is the peak: nothing to its left or right is higher.
TEST(peak_is_the_highest)
{
  water_sea sea = sea_of(12.0, 3e4, 3.3);
  for (int model = 0; model < 2; ++model)
  {
    sea.model = model == 0 ? WATER_SEA_JONSWAP : WATER_SEA_PHILLIPS;
    const double peak = water_sea_peak(&sea);
    const double top = water_sea_frequency_density(&sea, peak);
    for (double factor = 0.1; factor < 3.0; factor += 0.01)
    {
      assert_true(water_sea_frequency_density(&sea, factor * peak) <= top * (1.0 + 1e-12));
    }
    assert_true(water_sea_frequency_density(&sea, 0.1 * peak) == 0.0);
  }
}

// The depth factor: 1 in deep water, (omega_h)^2 / 2 in shallow, and between within 4 % of
// 1 - (2 - omega_h)^2 / 2 (Thompson and Vincent 1983); omega_h = omega sqrt(h / g).
TEST(depth_factor_has_its_limits)
{
  for (double h = 0.01; h < 0.99; h += 0.01)
  {
    ASSERT_CLOSE(water_sea_depth_factor(h * sqrt(g), 1.0), 0.5 * h * h, 0.04);
    ASSERT_CLOSE(
      water_sea_depth_factor((1.0 + h) * sqrt(g), 1.0), 1.0 - 0.5 * (1.0 - h) * (1.0 - h), 0.04);
  }
  ASSERT_CLOSE(water_sea_depth_factor(1e-3 * sqrt(g), 1.0), 0.5e-6, 1e-11);
  ASSERT_CLOSE(water_sea_depth_factor(1e-9 * sqrt(g), 1.0), 0.5e-18, 1e-32);
  ASSERT_CLOSE(water_sea_depth_factor(10.0 * sqrt(g), 1.0), 1.0, 1e-15);
  ASSERT_CLOSE(water_sea_depth_factor(0.3, deep), 1.0, 1e-15);
}

// By definition: k^-3 dk/domega, over the same in deep water.
TEST(depth_factor_is_kitaigorodskiis)
{
  for (double omega = 0.2; omega < 6.0; omega *= 1.3)
  {
    double k = 0.0;
    double deep_k = 0.0;
    assert_int_equal(water_waves_wavenumber(omega, 3.0, &k), WATER_OK);
    assert_int_equal(water_waves_wavenumber(omega, deep, &deep_k), WATER_OK);
    const double shallow = pow(k, -3.0) / water_group_velocity(k, 3.0);
    const double all = pow(deep_k, -3.0) / water_group_velocity(deep_k, deep);
    ASSERT_CLOSE(water_sea_depth_factor(omega, 3.0), shallow / all, 1e-12);
  }
}

// Tessendorf's form of Phillips' spectrum, and its variance alpha L^2 / 4, L = U^2 / g: a height of
// 0.18 U^2 / g. It blows from both sides.
TEST(phillips_has_tessendorfs_form)
{
  water_sea sea = sea_of(10.0, 1e5, 3.3);
  sea.model = WATER_SEA_PHILLIPS;
  sea.depth = 2.0; // not used
  const double size = 100.0 / g;
  for (double k = 0.03; k < 100.0; k *= 1.4)
  {
    const double known = 0.00405 * pow(k, -3.0) * exp(-1.0 / (k * size * k * size));
    ASSERT_CLOSE(water_sea_wavenumber_density(&sea, k), known, 1e-11 * known);
    const double along = known / k / pi; // cos^2 of 0
    ASSERT_CLOSE(water_sea_density(&sea, k, 0.0), along, 1e-11 * along);
    ASSERT_CLOSE(water_sea_density(&sea, -k, 0.0), along, 1e-11 * along);
    ASSERT_CLOSE(water_sea_density(&sea, 0.0, k), 0.0, 1e-20 * along);
  }
  ASSERT_CLOSE(4.0 * sqrt(height_variance(&sea)), 0.18 * size, 1e-4);
}

// Whatever the spreading, the directions together make the whole; with cos^2s the mean cosine is
// s / (s + 1) (Longuet-Higgins et al.); Donelan and Banner's is narrowest at 0.95 of the peak,
// where the half width at half height is acosh(sqrt 2) / beta = 0.8814 / 2.44 = 21 degrees.
TEST(spreading_is_a_share)
{
  water_sea sea = sea_of(10.0, 1e5, 3.3);
  const double peak = water_sea_peak(&sea);
  for (int kind = 0; kind < 3; ++kind)
  {
    sea.model = kind == 2 ? WATER_SEA_PHILLIPS : WATER_SEA_JONSWAP;
    sea.spreading = kind == 0 ? WATER_SPREAD_DONELAN_BANNER : WATER_SPREAD_COS_2S;
    for (double ratio = 0.3; ratio < 6.0; ratio *= 1.2)
    {
      double sum = 0.0;
      double cosine = 0.0;
      for (int i = 0; i < 3600; ++i)
      {
        const double angle = 4.0 + 2.0 * pi * i / 3600.0; // any turn
        const double part = water_sea_spread(&sea, ratio * peak, angle) * 2.0 * pi / 3600.0;
        sum += part;
        cosine += part * cos(angle);
      }
      ASSERT_CLOSE(sum, 1.0, 1e-5); // sech^2 has a kink opposite to the wind
      if (kind == 1)
      {
        ASSERT_CLOSE(cosine, 8.0 / 9.0, 1e-9);
      }
    }
  }
  sea.model = WATER_SEA_JONSWAP;
  sea.spreading = WATER_SPREAD_DONELAN_BANNER;
  const double top = water_sea_spread(&sea, 0.9501 * peak, 0.0);
  ASSERT_CLOSE(water_sea_spread(&sea, 0.9501 * peak, 0.8814 / 2.437), 0.5 * top, 0.01 * top);
  // the clusters of beta meet, as far as their authors' digits go
  const double ends[3] = { 0.56, 0.95, 1.6 };
  for (int i = 0; i < 3; ++i)
  {
    const double before = water_sea_spread(&sea, (ends[i] - 1e-9) * peak, 0.0);
    ASSERT_CLOSE(water_sea_spread(&sea, (ends[i] + 1e-9) * peak, 0.0), before, 0.02 * before);
  }
  sea.spreading = WATER_SPREAD_COS_2S;
  sea.spreading_power = 0.0;
  ASSERT_CLOSE(water_sea_spread(&sea, peak, 2.5), 0.5 / pi, 1e-15);
}

// The variance over wave vectors is that over frequencies, in deep and in shallow water; the wind's
// direction turns it.
TEST(variance_is_the_same_in_every_variable)
{
  water_sea sea = sea_of(10.0, 5e4, 3.3);
  for (int i = 0; i < 2; ++i)
  {
    sea.depth = i == 0 ? deep : 8.0;
    const double known = moment(&sea, 0);
    ASSERT_CLOSE(height_variance(&sea), known, 1e-5 * known);
    double sum = 0.0; // over rings of wave vectors
    for (double step = -5.0; step < 4.0; step += 0.01)
    {
      const double k = exp(step);
      for (int turn = 0; turn < 200; ++turn)
      {
        const double angle = 2.0 * pi * turn / 200.0;
        sum += water_sea_density(&sea, k * cos(angle), k * sin(angle)) * k * k * 0.01 * pi / 100.0;
      }
    }
    ASSERT_CLOSE(sum, known, 3e-3 * known);
  }
  const double along = water_sea_density(&sea, 0.5, 0.0);
  sea.wind_dir_rad = 0.5 * pi + 20.0 * pi;
  ASSERT_CLOSE(water_sea_density(&sea, 0.0, 0.5), along, 1e-12 * along);
  ASSERT_CLOSE(water_sea_density(&sea, 0.0, 0.0), 0.0, 0.0);
}

// The mean square slope of waves down to 1.7 cm is of Cox and Munk's size, 0.003 + 0.00512 U:
// within a factor of 2 (their slopes hold capillary waves, which are not in the spectrum).
TEST(slopes_are_of_cox_and_munks_size)
{
  for (double wind = 4.0; wind < 15.0; wind += 2.0)
  {
    const water_sea sea = sea_of(wind, deep, 1.0);
    double height = 0.0;
    double slope = 0.0;
    assert_int_equal(water_sea_moments(&sea, 0.0, 370.0, &height, &slope), WATER_OK);
    const double ratio = slope / (0.003 + 0.00512 * wind);
    assert_true(ratio > 0.5 && ratio < 2.0);
  }
}

// Bands add up; a band under all waves is empty.
TEST(bands_add_up)
{
  const water_sea sea = sea_of(8.0, 2e4, 3.3);
  double part[2][2];
  double whole[2];
  assert_int_equal(water_sea_moments(&sea, 0.0, 2.0, &part[0][0], &part[0][1]), WATER_OK);
  assert_int_equal(water_sea_moments(&sea, 2.0, 50.0, &part[1][0], &part[1][1]), WATER_OK);
  assert_int_equal(water_sea_moments(&sea, 0.0, 50.0, &whole[0], &whole[1]), WATER_OK);
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_CLOSE(part[0][i] + part[1][i], whole[i], 1e-5 * whole[i]);
  }
  assert_int_equal(water_sea_moments(&sea, 0.0, 1e-9, &whole[0], &whole[1]), WATER_OK);
  ASSERT_CLOSE(whole[0], 0.0, 0.0);
  whole[0] = 7.0;
  assert_int_equal(water_sea_moments(&sea, 2.0, 1.0, &whole[0], &whole[1]), WATER_BAD_WAVENUMBER);
  assert_int_equal(water_sea_moments(&sea, -1.0, 1.0, &whole[0], &whole[1]), WATER_BAD_WAVENUMBER);
  assert_int_equal(water_sea_moments(&sea, 0.0, deep, &whole[0], &whole[1]), WATER_BAD_WAVENUMBER);
  assert_int_equal(
    water_sea_moments(&sea, (double)NAN, 1.0, &whole[0], &whole[1]), WATER_BAD_WAVENUMBER);
  assert_true(whole[0] == 7.0);
}

// Each number of a sea has its range, and its status.
TEST(bad_seas_are_refused)
{
  const double nan = (double)NAN;
  const water_sea good = sea_of(10.0, 1e5, 3.3);
  water_sea sea = good;
  sea.model = (water_sea_model)2;
  assert_int_equal(water_sea_check(&sea), WATER_BAD_SEA_MODEL);
  sea = good;
  sea.spreading = (water_sea_spreading)7;
  assert_int_equal(water_sea_check(&sea), WATER_BAD_SEA_MODEL);
  const struct
  {
    size_t field;
    double values[3];
    water_status status;
  } cases[] = {
    { offsetof(water_sea, wind_speed), { 0.0, nan, 101.0 }, WATER_BAD_WIND_SPEED },
    { offsetof(water_sea, wind_dir_rad), { deep, nan, -deep }, WATER_BAD_WIND_DIRECTION },
    { offsetof(water_sea, fetch), { 0.5, nan, -deep }, WATER_BAD_FETCH },
    { offsetof(water_sea, depth), { 0.0, nan, -1.0 }, WATER_BAD_DEPTH },
    { offsetof(water_sea, peak_enhancement), { 0.9, nan, 21.0 }, WATER_BAD_PEAK_ENHANCEMENT },
    { offsetof(water_sea, spreading_power), { -0.1, nan, 1001.0 }, WATER_BAD_SPREADING_POWER },
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      sea = good;
      memcpy((char*)&sea + cases[i].field, &cases[i].values[j], sizeof(double));
      assert_int_equal(water_sea_check(&sea), cases[i].status);
    }
  }
}

// The slopes along the two axes: together those of the moments; of Phillips's cos^2 three parts
// along the wind and one across; of all directions alike a half each; of a narrow sea nearly all
// along it.
TEST(slopes_know_the_wind)
{
  water_sea windy = { WATER_SEA_JONSWAP, WATER_SPREAD_DONELAN_BANNER, 8.0, 0.6, 2e4,
    (double)INFINITY, 3.3, 8.0 };
  const double c = cos(1.2);
  double height = 0.0;
  double slope = 0.0;
  double variance[2] = { 7.0, 7.0 };
  assert_int_equal(water_sea_moments(&windy, 0.5, 40.0, &height, &slope), WATER_OK);
  assert_int_equal(water_sea_slopes(&windy, 0.5, 40.0, variance), WATER_OK);
  ASSERT_CLOSE(variance[0] + variance[1], slope, 1e-12);
  assert_true(variance[0] > variance[1]); // the wind is nearer to the first axis
  windy.spreading = WATER_SPREAD_COS_2S;
  windy.spreading_power = 0.0;
  assert_int_equal(water_sea_slopes(&windy, 0.5, 40.0, variance), WATER_OK);
  ASSERT_CLOSE(variance[0], 0.5 * slope, 1e-12);
  windy.spreading_power = 1000.0; // mean of cos 2a for cos^2s: s (s - 1) / ((s + 1) (s + 2))
  assert_int_equal(water_sea_slopes(&windy, 0.5, 40.0, variance), WATER_OK);
  const double narrow = 1000.0 * 999.0 / (1001.0 * 1002.0);
  ASSERT_CLOSE(variance[0], 0.5 * slope * (1.0 + c * narrow), 1e-6 * slope);
  windy.model = WATER_SEA_PHILLIPS;
  assert_int_equal(water_sea_moments(&windy, 0.5, 40.0, &height, &slope), WATER_OK);
  assert_int_equal(water_sea_slopes(&windy, 0.5, 40.0, variance), WATER_OK);
  ASSERT_CLOSE(variance[0], 0.5 * slope * (1.0 + 0.5 * c), 1e-12);
  variance[0] = 7.0;
  assert_int_equal(water_sea_slopes(&windy, 2.0, 1.0, variance), WATER_BAD_WAVENUMBER);
  assert_true(variance[0] == 7.0);
}

// Seas are the same if each of their numbers is.
TEST(seas_are_the_same_in_all_numbers)
{
  const water_sea sea = { WATER_SEA_JONSWAP, WATER_SPREAD_COS_2S, 8.0, 0.5, 4000.0, 20.0, 3.3,
    10.0 };
  water_sea other[8];
  for (int i = 0; i < 8; ++i)
  {
    other[i] = sea;
    assert_true(water_sea_is_same(&sea, other + i));
  }
  other[0].model = WATER_SEA_PHILLIPS;
  other[1].spreading = WATER_SPREAD_DONELAN_BANNER;
  other[2].wind_speed = 9.0;
  other[3].wind_dir_rad = 0.6;
  other[4].fetch = 4001.0;
  other[5].depth = 21.0;
  other[6].peak_enhancement = 3.4;
  other[7].spreading_power = 11.0;
  for (int i = 0; i < 8; ++i)
  {
    assert_false(water_sea_is_same(&sea, other + i));
  }
}

// The ends of the ranges are in them.
TEST(seas_at_both_ends_are_accepted)
{
  const struct
  {
    size_t field;
    double values[2];
  } cases[] = { { offsetof(water_sea, wind_speed), { 0.1, 100.0 } },
    { offsetof(water_sea, fetch), { 1.0, (double)INFINITY } },
    { offsetof(water_sea, depth), { DBL_MIN, (double)INFINITY } },
    { offsetof(water_sea, peak_enhancement), { 1.0, 20.0 } },
    { offsetof(water_sea, spreading_power), { 0.0, 1000.0 } } };
  for (size_t i = 0; i < 2 * (sizeof cases / sizeof cases[0]); ++i)
  {
    water_sea sea = sea_of(10.0, 1e5, 3.3);
    memcpy((char*)&sea + cases[i / 2].field, &cases[i / 2].values[i % 2], sizeof(double));
    assert_int_equal(water_sea_check(&sea), WATER_OK);
  }
}

TESTS(seas_at_both_ends_are_accepted, seas_are_the_same_in_all_numbers,
  shape_has_the_known_area_and_period, developed_sea_has_the_height_of_pierson_and_moskowitz,
  growing_sea_follows_the_charts, spreading_changes_its_formula_where_it_should,
  empty_ranges_of_waves_are_refused, peak_is_the_highest, depth_factor_has_its_limits,
  depth_factor_is_kitaigorodskiis, phillips_has_tessendorfs_form, spreading_is_a_share,
  variance_is_the_same_in_every_variable, slopes_are_of_cox_and_munks_size, bands_add_up,
  bad_seas_are_refused, slopes_know_the_wind)
