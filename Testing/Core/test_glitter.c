// SPDX-License-Identifier: BSD-3-Clause
// test_glitter.c: Cox and Munk's slopes, and that glitter neither makes nor loses light.
#include "test_scene.h"

#include "water_glitter.h"

static const double pi = 3.141592653589793;

// Cox and Munk's own figures: at 10 m/s the sea's mean square slope is 0.054 (rms 13 degrees), more
// along the wind than across; the parts add up to the sum within the error they state.
TEST(slopes_are_cox_and_munks)
{
  double sum = 0.0;
  double parts[2];
  assert_int_equal(water_glitter_mean_square(10.0, &sum), WATER_OK);
  ASSERT_CLOSE(sum, 0.0542, 1e-12);
  ASSERT_CLOSE(atan(sqrt(sum)) * 180.0 / pi, 13.1, 0.05);
  for (double wind = 1.0; wind < 15.0; wind += 1.0)
  {
    assert_int_equal(water_glitter_mean_square(wind, &sum), WATER_OK);
    assert_int_equal(water_glitter_variance(wind, parts), WATER_OK);
    ASSERT_CLOSE(parts[0] + parts[1], sum, 0.004);
  }
  assert_true(parts[0] > parts[1]);
}

// The density is one of probability: it integrates to 1, and its moments are the variances.
TEST(density_has_its_moments)
{
  const double variance[2] = { 0.03, 0.02 };
  double sum[3] = { 0.0, 0.0, 0.0 };
  const double step = 0.01;
  for (double x = -2.0; x < 2.0; x += step)
  {
    for (double y = -2.0; y < 2.0; y += step)
    {
      const double slope[2] = { x, y };
      const double part = water_glitter_density(variance, slope) * step * step;
      sum[0] += part;
      sum[1] += part * x * x;
      sum[2] += part * y * y;
    }
  }
  ASSERT_CLOSE(sum[0], 1.0, 1e-9);
  ASSERT_CLOSE(sum[1], 0.03, 1e-9);
  ASSERT_CLOSE(sum[2], 0.02, 1e-9);
}

// Neither the smallest spread nor the steepest slope makes it something that is no number.
TEST(density_is_a_number_everywhere)
{
  const double calm[2] = { 1e-300, 1e-300 };
  const double level[2] = { 0.0, 0.0 };
  const double wall[2] = { (double)INFINITY, 1e300 };
  ASSERT_CLOSE(water_glitter_density(calm, level) * 1e-300, 0.5 / pi, 1e-15);
  assert_true(water_glitter_density(calm, wall) == 0.0);
}

// A surface that reflects everything sends on what it takes in: over all directions the radiance
// adds up to the sun's irradiance on the level surface, its cosine; for slopes so small that no
// facet turns the light down.
TEST(glitter_keeps_the_light)
{
  const double variance[2] = { 0.004, 0.002 };
  const double sun[3] = { sin(0.6), 0.0, cos(0.6) };
  double sum = 0.0;
  const double step = 0.005;
  for (double polar = 0.5 * step; polar < 0.5 * pi; polar += step)
  {
    for (double turn = 0.0; turn < 2.0 * pi; turn += step)
    {
      const double eye[3] = { sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar) };
      double cosine = 0.0;
      const double radiance = water_glitter_radiance(sun, eye, 0.8, variance, &cosine);
      sum += radiance * eye[2] * sin(polar) * step * step;
    }
  }
  ASSERT_CLOSE(sum, cos(0.6), 2e-3);
}

// What facets hide is Smith's closed form, in which the normal distribution is exact; in any
// azimuth, from the zenith to a sun at the horizon.
TEST(facets_hide_each_other_as_smith_says)
{
  const double covariance[3] = { 0.03, 0.02, 0.008 };
  for (int turn = 0; turn < 8; ++turn)
  {
    const double c = cos(0.25 * pi * turn);
    const double s = sin(0.25 * pi * turn);
    const double deviation =
      sqrt(c * c * covariance[0] + 2.0 * c * s * covariance[2] + s * s * covariance[1]);
    for (double height = 0.5; height < 90.0; height += 0.5)
    {
      const double angle = height * pi / 180.0;
      const double dir[3] = { c * cos(angle), s * cos(angle), sin(angle) };
      const double nu = tan(angle) / (sqrt(2.0) * deviation);
      const double hidden = 0.5 * (exp(-nu * nu) / (nu * sqrt(pi)) - erfc(nu));
      ASSERT_CLOSE(water_glitter_hidden(dir, covariance), hidden, 5e-4 * (1.0 + hidden));
    }
  }
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double under[3] = { 0.6, 0.0, -0.8 };
  const double calm[3] = { 0.0, 0.0, 0.0 };
  const double low[3] = { 1.0, 0.0, 1e-300 };
  ASSERT_CLOSE(water_glitter_hidden(up, covariance), 0.0, 0.0);
  ASSERT_CLOSE(water_glitter_hidden(under, covariance), 0.0, 0.0);
  ASSERT_CLOSE(water_glitter_hidden(low, calm), 0.0, 0.0);
  assert_true(water_glitter_hidden(low, covariance) > 1e200);
}

// However low the sun is, the sea sends on no more light than it takes in; nor much less, though
// what it hides is lost.
TEST(waves_make_no_light)
{
  const double variance[2] = { 0.03, 0.03 };
  for (double height = 4.0; height < 90.0; height += 10.0)
  {
    const double angle = height * pi / 180.0;
    const double sun[3] = { cos(angle), 0.0, sin(angle) };
    double sum = 0.0;
    const double step = 0.01;
    for (double polar = 0.5 * step; polar < 0.5 * pi; polar += step)
    {
      for (double turn = 0.0; turn < 2.0 * pi; turn += step)
      {
        const double eye[3] = { sin(polar) * cos(turn), sin(polar) * sin(turn), cos(polar) };
        double cosine = 0.0;
        const double radiance = water_glitter_radiance(sun, eye, 0.0, variance, &cosine);
        sum += radiance * eye[2] * sin(polar) * step * step;
      }
    }
    assert_true(sum < 1.001 * sun[2]);
    assert_true(sum > 0.5 * sun[2]);
  }
}

// Straight opposite the sun shine the level facets, at the sun's own angle; nothing shines when the
// sun or the eye is under the horizon. The wind's axis is where the glitter is longer.
TEST(glitter_is_where_the_mirror_is)
{
  const double variance[2] = { 0.03, 0.01 };
  const double sun[3] = { sin(0.6), 0.0, cos(0.6) };
  const double eye[3] = { -sin(0.6), 0.0, cos(0.6) };
  const double low[3] = { -sin(1.6), 0.0, cos(1.6) };
  double cosine = 0.0;
  const double top = water_glitter_radiance(sun, eye, 0.0, variance, &cosine);
  ASSERT_CLOSE(cosine, cos(0.6), 1e-15);
  ASSERT_CLOSE(top, 1.0 / (2.0 * pi * sqrt(0.0003)) / (4.0 * cos(0.6)), 1e-12);
  ASSERT_CLOSE(water_glitter_radiance(sun, low, 0.0, variance, &cosine), 0.0, 0.0);
  ASSERT_CLOSE(water_glitter_radiance(low, eye, 0.0, variance, &cosine), 0.0, 0.0);
  const double zenith[3] = { 0.0, 0.0, 1.0 };
  const double along[3] = { sin(0.3), 0.0, cos(0.3) };
  const double with_wind = water_glitter_radiance(zenith, along, 0.0, variance, &cosine);
  const double across = water_glitter_radiance(zenith, along, 0.5 * pi, variance, &cosine);
  assert_true(with_wind > across);
  const double slanted[3] = { sqrt(0.5) * sin(0.3), sqrt(0.5) * sin(0.3), cos(0.3) };
  const double turned = water_glitter_radiance(zenith, slanted, 0.25 * pi, variance, &cosine);
  ASSERT_CLOSE(turned, with_wind, 1e-12);
  const double other = water_glitter_radiance(zenith, slanted, -0.25 * pi, variance, &cosine);
  ASSERT_CLOSE(other, across, 1e-12);
}

TEST(bad_winds_are_refused)
{
  const double bad[4] = { 0.0, -1.0, (double)NAN, (double)INFINITY };
  double out[2] = { 7.0, 7.0 };
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(water_glitter_variance(bad[i], out), WATER_BAD_WIND_SPEED);
    assert_int_equal(water_glitter_mean_square(bad[i], out), WATER_BAD_WIND_SPEED);
  }
  assert_true(out[0] == 7.0);
}

// Turned variances keep their sum; along the first direction the variance is the first.
TEST(covariance_turns_the_variances)
{
  const double variance[2] = { 0.03, 0.02 };
  for (int degrees = -180; degrees <= 180; degrees += 15)
  {
    const double angle = degrees * 3.141592653589793 / 180.0;
    const double c = cos(angle);
    const double s = sin(angle);
    double turned[3];
    water_glitter_covariance(variance, angle, turned);
    ASSERT_CLOSE(turned[0] + turned[1], 0.05, 1e-16);
    ASSERT_CLOSE(c * c * turned[0] + 2.0 * c * s * turned[2] + s * s * turned[1], 0.03, 1e-16);
    ASSERT_CLOSE(s * s * turned[0] - 2.0 * c * s * turned[2] + c * c * turned[1], 0.02, 1e-16);
  }
}

// Slopes without an end have no density, along either axis.
TEST(endless_slopes_have_no_density)
{
  const double variance[2] = { 0.02, 0.01 };
  const double slopes[3][2] = { { INFINITY, 0.0 }, { 0.0, -INFINITY }, { INFINITY, INFINITY } };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(water_glitter_density(variance, slopes[i]), 0.0, 0.0);
  }
}

TESTS(facets_hide_each_other_as_smith_says, waves_make_no_light, endless_slopes_have_no_density,
  slopes_are_cox_and_munks, density_has_its_moments, density_is_a_number_everywhere,
  glitter_keeps_the_light, glitter_is_where_the_mirror_is, bad_winds_are_refused,
  covariance_turns_the_variances)
