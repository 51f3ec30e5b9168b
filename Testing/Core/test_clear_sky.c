// SPDX-License-Identifier: BSD-3-Clause
// test_clear_sky.c: the clear sky by the formulas of the paper, which stand here once more as it
// prints them, and what follows from them without formulas.
#include "test_main.h"

#include "water_clear_sky.h"

#include <math.h>

static const double deg = 0.017453292519943295;

static double luminance_of(const double color[3])
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

static void color_at(const water_clear_sky* sky, double azimuth, double elevation, double color[3])
{
  const double dir[3] = { cos(elevation * deg) * sin(azimuth * deg),
    cos(elevation * deg) * cos(azimuth * deg), sin(elevation * deg) };
  water_clear_sky_color(sky, dir, color);
}

// Independent of water_clear_sky.c: evaluated in Python with the paper's tables, and the matrix
// of IEC 61966-2-1 in four digits. The azimuth is from the sun. The first and the last two of the
// paper are purple, and lie on the daylight locus here.
TEST(colors_are_those_of_the_paper)
{
  static const struct
  {
    double turbidity;
    double sun;
    double azimuth;
    double elevation;
    double color[3];
  } cases[] = { { 3, 40, 0, 45, { 20.0622419, 24.2488293, 32.8211378 } },
    { 3, 40, 180, 30, { 3.18333132, 5.90482154, 10.6227812 } },
    { 2, 10, 90, 20, { 5.62472514, 7.47341118, 10.0026873 } },
    { 6, 60, 45, 70, { 21.5161877, 27.6969872, 41.1452066 } },
    { 10, 5, 120, 5, { 2.67158004, 1.66966212, 0.698802538 } },
    { 3, 40, 0, 89.999, { 3.85019391, 6.7117563, 12.5568289 } },
    { 3, 50, 180, 3, { 7.70113404, 8.00146453, 8.48747829 } } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_clear_sky sky;
    double color[3];
    assert_true(water_clear_sky_make(30.0, cases[i].sun, cases[i].turbidity, &sky));
    color_at(&sky, 30.0 + cases[i].azimuth, cases[i].elevation, color);
    for (int j = 0; j < 3; ++j)
    {
      ASSERT_CLOSE(color[j], cases[i].color[j], 1e-6 * (1.0 + cases[i].color[j]));
    }
  }
}

// No sky is purple: a chromaticity lies on the locus of daylight or on its green side.
TEST(skies_are_not_purple)
{
  for (int sun = 20; sun <= 90; sun += 10)
  {
    for (double turbidity = 2.0; turbidity <= 10.0; turbidity += 1.0)
    {
      water_clear_sky sky;
      assert_true(water_clear_sky_make(0.0, sun, turbidity, &sky));
      for (int i = 0; i < 12 * 18; ++i)
      {
        double color[3];
        color_at(&sky, 30.0 * (i % 12), 5.0 * (i / 12), color);
        const double cie_x = 0.4124 * color[0] + 0.3576 * color[1] + 0.1805 * color[2];
        const double cie_y = luminance_of(color);
        const double sum =
          cie_x + cie_y + 0.0193 * color[0] + 0.1192 * color[1] + 0.9505 * color[2];
        const double x = fmin(fmax(cie_x / sum, 0.25), 0.38);
        assert_true(cie_y / sum > (-3.0 * x + 2.87) * x - 0.275 - 1e-3);
      }
    }
  }
}

// Luminance at the zenith is the paper's own formula.
TEST(zenith_has_its_luminance)
{
  for (int sun = 0; sun <= 90; sun += 15)
  {
    for (double turbidity = 2.0; turbidity <= 10.0; turbidity += 2.0)
    {
      water_clear_sky sky;
      double color[3];
      assert_true(water_clear_sky_make(0.0, sun, turbidity, &sky));
      color_at(&sky, 0.0, 90.0, color);
      const double chi = (4.0 / 9.0 - turbidity / 120.0) * 2.0 * sun * deg;
      const double expected =
        (4.0453 * turbidity - 4.9710) * tan(chi) - 0.2155 * turbidity + 2.4192;
      ASSERT_CLOSE(luminance_of(color), expected, 2e-3 * expected + 1e-12);
    }
  }
}

// The sky is blue over us, brightest beside the sun, whiter in haze, and never negative.
TEST(skies_look_like_skies)
{
  water_clear_sky sky;
  water_clear_sky hazy;
  double zenith[3];
  double beside[3];
  double away[3];
  assert_true(water_clear_sky_make(90.0, 40.0, 2.5, &sky));
  assert_true(water_clear_sky_make(90.0, 40.0, 9.0, &hazy));
  color_at(&sky, 0.0, 90.0, zenith);
  color_at(&sky, 90.0, 41.0, beside);
  color_at(&sky, 270.0, 41.0, away);
  assert_true(zenith[2] > 1.5 * zenith[0]);
  assert_true(luminance_of(beside) > 2.0 * luminance_of(away));
  const double blue = zenith[2] / zenith[0];
  color_at(&hazy, 0.0, 90.0, zenith);
  assert_true(zenith[2] / zenith[0] < blue);
  for (int azimuth = 0; azimuth < 360; azimuth += 30)
  {
    for (int elevation = -90; elevation <= 90; elevation += 5)
    {
      color_at(&sky, azimuth, elevation, away);
      for (int i = 0; i < 3; ++i)
      {
        assert_true(away[i] >= 0.0 && isfinite(away[i]));
      }
    }
  }
}

// Under the horizon the sky goes over into grey ground without a step.
TEST(horizon_has_no_step)
{
  water_clear_sky sky;
  double over[3];
  double under[3];
  assert_true(water_clear_sky_make(0.0, 20.0, 3.0, &sky));
  for (int azimuth = 0; azimuth < 360; azimuth += 45)
  {
    color_at(&sky, azimuth, 0.01, over);
    color_at(&sky, azimuth, -0.01, under);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(over[i], under[i], 1e-3 * over[i]);
    }
    color_at(&sky, azimuth, -20.0, under);
    ASSERT_CLOSE(under[0], under[2], 1e-12);
    ASSERT_CLOSE(under[0], 0.1 * luminance_of(sky.mean), 1e-12);
  }
}

// A low sun is dimmer and redder, and haze dims it.
TEST(low_suns_are_red)
{
  water_clear_sky sky;
  double high[3];
  double low[3];
  double dim[3];
  assert_true(water_clear_sky_make(0.0, 80.0, 3.0, &sky));
  water_clear_sky_sun(&sky, high);
  assert_true(water_clear_sky_make(0.0, 5.0, 3.0, &sky));
  water_clear_sky_sun(&sky, low);
  assert_true(water_clear_sky_make(0.0, 5.0, 8.0, &sky));
  water_clear_sky_sun(&sky, dim);
  assert_true(low[0] < high[0] && low[0] / low[2] > 2.0 * high[0] / high[2]);
  assert_true(dim[0] < low[0]);
}

// Shown with its exposure the sky's mean is 0.3 of white.
TEST(exposure_shows_the_mean)
{
  water_clear_sky sky;
  assert_true(water_clear_sky_make(0.0, 35.0, 3.0, &sky));
  ASSERT_CLOSE(luminance_of(sky.mean) * water_clear_sky_exposure(&sky), 0.3, 1e-12);
}

// Places of the picture: its middle is the east, a quarter to the left the north, its top the
// zenith.
TEST(places_of_the_picture)
{
  const double places[4][5] = { { 0.5, 0.5, 1.0, 0.0, 0.0 }, { 0.25, 0.5, 0.0, 1.0, 0.0 },
    { 0.0, 0.5, -1.0, 0.0, 0.0 }, { 0.3, 1.0, 0.0, 0.0, 1.0 } };
  for (int i = 0; i < 4; ++i)
  {
    double dir[3];
    water_clear_sky_place(places[i][0], places[i][1], dir);
    for (int j = 0; j < 3; ++j)
    {
      ASSERT_CLOSE(dir[j], places[i][2 + j], 1e-15);
    }
  }
}

// A sun that has set, and air that is no air, make no sky.
TEST(other_suns_and_airs_are_refused)
{
  water_clear_sky sky = { { 7.0 } };
  assert_false(water_clear_sky_make(0.0, -0.1, 3.0, &sky));
  assert_false(water_clear_sky_make(0.0, 90.1, 3.0, &sky));
  assert_false(water_clear_sky_make(0.0, 30.0, 1.9, &sky));
  assert_false(water_clear_sky_make(0.0, 30.0, 10.1, &sky));
  assert_false(water_clear_sky_make((double)NAN, 30.0, 3.0, &sky));
  assert_false(water_clear_sky_make(0.0, 30.0, (double)NAN, &sky));
  ASSERT_CLOSE(sky.sun_dir[0], 7.0, 0.0);
  assert_true(water_clear_sky_make(0.0, 0.0, 2.0, &sky));
  assert_true(water_clear_sky_make(0.0, 90.0, 10.0, &sky));
}

// The mean is what level ground gets: over the hemisphere, the mean weighted with the cosine. Here
// it is summed in steps of a degree.
TEST(the_mean_is_that_of_the_hemisphere)
{
  const double radian = 3.14159265358979323846 / 180.0;
  const double elevations[] = { 10.0, 40.0, 80.0 };
  for (size_t number = 0; number < sizeof elevations / sizeof *elevations; ++number)
  {
    water_clear_sky sky;
    assert_true(water_clear_sky_make(70.0, elevations[number], 3.0, &sky));
    double sum[3] = { 0.0, 0.0, 0.0 };
    double weights = 0.0;
    for (int i = 0; i < 90; ++i)
    {
      const double high = (i + 0.5) * radian;
      const double weight = cos(high) * sin(high);
      for (int j = 0; j < 360; ++j)
      {
        const double turn = j * radian;
        const double dir[3] = { cos(high) * cos(turn), cos(high) * sin(turn), sin(high) };
        double color[3];
        water_clear_sky_color(&sky, dir, color);
        for (int k = 0; k < 3; ++k)
        {
          sum[k] += weight * color[k];
        }
        weights += weight;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_CLOSE(sky.mean[k] / (sum[k] / weights), 1.0, 5e-3);
    }
  }
}

// The sun's colour by the paper's formulas, evaluated in Python.
TEST(suns_are_those_of_the_paper)
{
  const struct
  {
    double elevation;
    double turbidity;
    double red; // over green
    double blue;
  } cases[] = { { 10.0, 3.0, 1.4454102194577478, 0.44060677593119624 },
    { 60.0, 2.0, 1.0605952572248674, 0.8694377478852708 } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_clear_sky sky;
    double color[3];
    assert_true(water_clear_sky_make(20.0, cases[i].elevation, cases[i].turbidity, &sky));
    water_clear_sky_sun(&sky, color);
    ASSERT_CLOSE(color[0] / color[1], cases[i].red, 1e-9);
    ASSERT_CLOSE(color[2] / color[1], cases[i].blue, 1e-9);
  }
}

TESTS(suns_are_those_of_the_paper, the_mean_is_that_of_the_hemisphere,
  colors_are_those_of_the_paper, skies_are_not_purple, zenith_has_its_luminance,
  skies_look_like_skies, horizon_has_no_step, low_suns_are_red, exposure_shows_the_mean,
  places_of_the_picture, other_suns_and_airs_are_refused)
