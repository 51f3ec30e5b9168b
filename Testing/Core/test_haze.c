// SPDX-License-Identifier: BSD-3-Clause
// test_haze.c: light that the water scatters towards an eye in it.
#include "test_scene.h"

#include "water_haze.h"
#include "water_preset.h"
#include "water_shared.h"

static const double pi = 3.14159265358979323846;
static const double down[3] = { 0.0, 0.0, -1.0 };
static const double level[3] = { 0.0, 1.0, 0.0 };
static const double endless = 1e9;

// A clear sky in "clear tropical", the sun at a height.
static water_haze_input tropical(double elevation)
{
  static const double daylight[3] = { 1.07, 1.147, 1.306 };
  static const double sun[3] = { 1.0, 0.971, 0.907 };
  water_preset preset;
  assert_int_equal(water_preset_find("clear tropical", &preset), WATER_OK);
  water_haze_input input = { .index = 1.333, .medium = preset.medium };
  water_medium_extinction(&preset.medium, input.extinction);
  water_medium_reflectance(&preset.medium, input.deep);
  for (int i = 0; i < 3; ++i)
  {
    input.deep[i] *= daylight[i];
    input.daylight[i] = daylight[i];
    input.sun_color[i] = sun[i];
  }
  input.sun_dir[0] = cos(elevation * pi / 180.0);
  input.sun_dir[2] = sin(elevation * pi / 180.0);
  return input;
}

// Backward scattering is what it is said to be: its integral over those directions is 2 pi.
TEST(phases_are_of_all_backward_light)
{
  double particles = 0.0;
  double molecules = 0.0;
  const int count = 20000;
  for (int i = 0; i < count; ++i)
  {
    const double cosine = -(i + 0.5) / count;
    particles += water_shared_haze_particles(cosine) / count;
    molecules += water_shared_haze_molecules(cosine) / count;
  }
  ASSERT_CLOSE(particles, 1.0, 2e-3);
  ASSERT_CLOSE(molecules, 1.0, 1e-6);
  // analytic values of molecules: 0.75 (1 + cos^2)
  ASSERT_CLOSE(water_shared_haze_molecules(0.0), 0.75, 0.0);
  ASSERT_CLOSE(water_shared_haze_molecules(-1.0), 1.5, 0.0);
}

TEST(integral_is_closed_and_keeps_its_digits)
{
  ASSERT_CLOSE(water_shared_haze_integral(0.0, 7.0), 7.0, 0.0);
  ASSERT_CLOSE(water_shared_haze_integral(2.0, 1.0), (1.0 - exp(-2.0)) / 2.0, 1e-15);
  ASSERT_CLOSE(water_shared_haze_integral(0.0299999, 1.0), -expm1(-0.0299999) / 0.0299999, 1e-8);
  ASSERT_CLOSE(water_shared_haze_integral(0.0300001, 1.0), -expm1(-0.0300001) / 0.0300001, 1e-8);
  ASSERT_CLOSE(water_shared_haze_integral(-0.5, 2.0), expm1(1.0) / 0.5, 1e-14);
}

// Against sums of the same integrals in small steps, up, level and down.
TEST(over_is_the_integral)
{
  static const double ways[][5] = { // extinction, diffuse, fall, depth, way
    { 0.07, 0.08, 0.0, 5.0, 12.0 }, { 0.07, 0.08, 0.7, 5.0, 40.0 }, { 0.07, 0.08, -0.6, 5.0, 8.0 },
    { 0.07, 0.07, -1.0, 5.0, 5.0 }, { 0.36, 0.41, -0.99, 30.0, 25.0 }, { 0.03, 0.0, 1.0, 2.0, 9.0 },
    { 0.0, 0.0, 0.3, 2.0, 9.0 }
  };
  for (size_t i = 0; i < sizeof ways / sizeof ways[0]; ++i)
  {
    const double* in = ways[i];
    const int count = 100000;
    double along = 0.0;
    double same = 0.0;
    for (int j = 0; j < count; ++j)
    {
      const double s = in[4] * (j + 0.5) / count;
      along += exp(-in[1] * (in[3] + in[2] * s) - in[0] * s);
      same += exp(-in[0] * s);
    }
    ASSERT_CLOSE(water_shared_haze_over(in[0], in[1], in[2], in[3], in[4]), along / same, 1e-7);
  }
}

TEST(over_has_its_limits)
{
  // c / (c + Kd fall) without an end; exp(-Kd depth) on a level or a short way
  ASSERT_CLOSE(water_shared_haze_over(0.1, 0.3, 0.5, 0.0, endless), 0.1 / 0.25, 1e-12);
  ASSERT_CLOSE(water_shared_haze_over(0.1, 0.3, 0.0, 2.0, endless), exp(-0.6), 1e-12);
  ASSERT_CLOSE(water_shared_haze_over(0.1, 0.3, 1.0, 2.0, 1e-9), exp(-0.6), 1e-8);
  ASSERT_CLOSE(water_shared_haze_over(0.1, 0.3, 1.0, 2.0, 0.0), exp(-0.6), 1e-8);
  // a way up ends at the surface, however long it is said to be
  ASSERT_CLOSE(water_shared_haze_over(0.1, 0.3, -0.5, 2.0, endless),
    water_shared_haze_over(0.1, 0.3, -0.5, 2.0, 4.0), 1e-12);
  // nothing is lost in the deep
  ASSERT_CLOSE(water_shared_haze_over(1.0, 1.1, -1.0, 1e5, endless), 0.0, 1e-12);
}

// Straight down from just under the surface the eye sees what one over the water sees, under any
// sun.
TEST(straight_down_is_the_deep_color)
{
  for (double elevation = -10.0; elevation <= 90.0; elevation += 20.0)
  {
    const water_haze_input input = tropical(elevation);
    water_haze haze;
    double color[3];
    water_haze_find(&input, &haze);
    water_haze_color(&haze, input.extinction, down, 0.0, endless, color);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(color[i], input.deep[i], 1e-12);
    }
  }
}

// Kd of Gordon 1989: the sun at the zenith alone has 1.0395 (a + b), an even sky 1.197 times as
// much.
TEST(daylight_falls_off_as_gordon_says)
{
  water_haze_input input = tropical(90.0);
  water_haze haze;
  for (int i = 0; i < 3; ++i)
  {
    input.daylight[i] = input.sun_color[i];
  }
  water_haze_find(&input, &haze);
  ASSERT_CLOSE(haze.diffuse[1], 1.0395 * input.extinction[1], 1e-12);
  input.sun_dir[2] = -1.0;
  water_haze_find(&input, &haze);
  ASSERT_CLOSE(haze.diffuse[1], 1.0395 * 1.197 * input.extinction[1], 1e-12);
  ASSERT_CLOSE(haze.particles[1] + haze.molecules[1], 0.0, 0.0);
}

// Without light all is black, and nothing is divided by it; water that takes nothing adds nothing.
TEST(no_light_is_black)
{
  water_haze_input input = tropical(60.0);
  water_haze haze;
  double color[3];
  for (int i = 0; i < 3; ++i)
  {
    input.daylight[i] = input.deep[i] = input.sun_color[i] = 0.0;
  }
  water_haze_find(&input, &haze);
  water_haze_color(&haze, input.extinction, level, 5.0, endless, color);
  ASSERT_CLOSE(color[1], 0.0, 0.0);
  for (int i = 0; i < 3; ++i)
  {
    input.extinction[i] = input.medium.absorption[i] = input.medium.scattering[i] = 0.0;
  }
  water_haze_find(&input, &haze);
  water_haze_color(&haze, input.extinction, level, 5.0, endless, color);
  ASSERT_CLOSE(color[1], 0.0, 0.0);
}

// Photons of an own Monte Carlo program in the same water (all scattering, the phase function of
// Fournier and Forand, a flat surface, 0.73 of green and 0.60 of blue light from the sun): radiance
// of a level way at 5 m, over that of a look straight down from just under the surface. Their
// standard errors are 2 to 5 %, and 15 % for blue at 90 degrees.
TEST(level_ways_are_as_photons_say)
{
  static const struct
  {
    int channel;
    double azimuth; // between the look and the sun, degrees
    double photons;
    double error; // relative; larger in blue: nine tenths of what is lost of it is scattered
  } cases[] = { { 1, 0.0, 0.0645 / 0.0193, 0.1 }, { 1, 90.0, 0.0417 / 0.0193, 0.1 },
    { 1, 150.0, 0.0344 / 0.0193, 0.1 }, { 2, 0.0, 0.1518 / 0.0602, 0.3 },
    { 2, 90.0, 0.1402 / 0.0602, 0.3 }, { 2, 150.0, 0.1053 / 0.0602, 0.3 } };
  const water_haze_input input = tropical(60.0);
  water_haze haze;
  water_haze_find(&input, &haze);
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    const int channel = cases[i].channel;
    const double turn = cases[i].azimuth * pi / 180.0;
    const double dir[3] = { cos(turn), sin(turn), 0.0 };
    double color[3];
    water_haze_color(&haze, input.extinction, dir, 5.0, endless, color);
    const double ratio = color[channel] / input.deep[channel];
    printf("channel %d, %3.0f degrees from the sun: %.3f, photons %.3f\n", channel,
      cases[i].azimuth, ratio, cases[i].photons);
    ASSERT_CLOSE(ratio, cases[i].photons, cases[i].error * cases[i].photons);
  }
}

// The polynomial for the light of the sky agrees with its mean over the cone.
TEST(skys_light_is_smooth)
{
  water_haze_input input = tropical(-1.0);
  water_haze haze;
  water_haze_find(&input, &haze);
  double before = INFINITY;
  for (double fall = -1.0; fall <= 1.0; fall += 0.05)
  {
    const double dir[3] = { sqrt(fmax(1.0 - fall * fall, 0.0)), 0.0, -fall };
    double color[3];
    water_haze_color(&haze, input.extinction, dir, 0.0, 1e-9, color);
    assert_true(color[1] > 0.0);
    assert_true(color[1] <= 1.02 * before); // brightest where the light comes from
    before = color[1];
  }
}

// An eye that comes into the water sees what it saw over it; a step deeper changes little.
TEST(haze_begins_at_the_surface_and_grows_with_the_depth)
{
  ASSERT_CLOSE(water_haze_share(0.1, 0.0), 0.0, 0.0);
  ASSERT_CLOSE(water_haze_share(0.1, -1.0), 0.0, 0.0);
  ASSERT_CLOSE(water_haze_share(0.1, 0.5), 0.5, 1e-15);
  ASSERT_CLOSE(water_haze_share(0.2, 0.25), 0.5, 1e-15); // of the optical depth
  ASSERT_CLOSE(water_haze_share(0.1, 1.0), 1.0, 1e-15);
  ASSERT_CLOSE(water_haze_share(0.1, 5.0), 1.0, 0.0);
  double last = 0.0;
  for (int step = 1; step <= 100; ++step)
  {
    const double share = water_haze_share(0.1, 0.01 * step);
    assert_true(share > last && share - last < 0.016);
    last = share;
  }
}

// Under a sky without a sun, molecules scatter by 0.75 (1 + cos^2). Refracted light has cosines
// from c to 1 of the angle from the zenith, whose squares have the mean (1 + c + c^2) / 3; of the
// angle from a level look, half of the rest.
TEST(molecules_scatter_the_skys_light_to_all_sides)
{
  water_haze_input input = tropical(-10.0);
  for (int i = 0; i < 3; ++i)
  {
    input.medium.scattering[i] = 1e-9; // fewer than there are molecules: no particles
  }
  water_haze haze;
  water_haze_find(&input, &haze);
  const double edge = sqrt(1.0 - 1.0 / (1.333 * 1.333));
  const double squared = (1.0 + edge + edge * edge) / 3.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* sky = haze.sky[i];
    const double straight = sky[0] + sky[1] + sky[2] + sky[3];
    ASSERT_CLOSE(sky[0] / straight, (1.0 + 0.5 * (1.0 - squared)) / (1.0 + squared), 1e-12);
  }
}

// The mean over the sky's refracted light of what particles scatter into a direction, counted in
// 400 zenith angles by 400 azimuths.
static double particles_of_sky(double fall)
{
  enum
  {
    COUNT = 400
  };
  const double edge = sqrt(1.0 - 1.0 / (1.333 * 1.333));
  double sum = 0.0;
  for (int i = 0; i < COUNT * COUNT; ++i)
  {
    const double cosine = edge + (1.0 - edge) * (i / COUNT + 0.5) / COUNT;
    const double turn = 2.0 * pi * (i % COUNT) / COUNT;
    const double light[3] = { sqrt(1.0 - cosine * cosine) * cos(turn),
      sqrt(1.0 - cosine * cosine) * sin(turn), cosine };
    const double look[3] = { sqrt(1.0 - fall * fall), 0.0, -fall };
    sum +=
      water_shared_haze_particles(look[0] * light[0] + look[1] * light[1] + look[2] * light[2]);
  }
  return sum / (COUNT * COUNT);
}

// The same of particles, at the four directions that the cubic goes through.
TEST(particles_scatter_the_skys_light_by_their_phase)
{
  water_haze_input input = tropical(-10.0);
  for (int i = 0; i < 3; ++i)
  {
    input.medium.scattering[i] = 1e9; // more than there are molecules
  }
  water_haze haze;
  water_haze_find(&input, &haze);
  const double falls[4] = { WATER_HAZE_FALL_MIN, 0.0, 0.5, 1.0 };
  const double straight = particles_of_sky(1.0);
  for (int i = 0; i < 4; ++i)
  {
    const double x = falls[i];
    const double* sky = haze.sky[1];
    const double of_straight = sky[0] + sky[1] + sky[2] + sky[3];
    const double value = sky[0] + x * (sky[1] + x * (sky[2] + x * sky[3]));
    ASSERT_CLOSE(value / of_straight, particles_of_sky(x) / straight, 3e-3);
  }
}

// Without daylight, water dims as under the sky alone; water that scatters nothing itself has its
// colour from particles.
TEST(haze_without_light_or_scattering_has_its_kinds)
{
  water_haze_input dark = tropical(60.0);
  water_haze_input cloudy = tropical(60.0);
  water_haze_input clear = tropical(60.0);
  for (int i = 0; i < 3; ++i)
  {
    dark.daylight[i] = 0.0;
    cloudy.sun_color[i] = 0.0;
    clear.medium.scattering[i] = 0.0;
  }
  water_haze found[3];
  water_haze_find(&dark, &found[0]);
  water_haze_find(&cloudy, &found[1]);
  water_haze_find(&clear, &found[2]);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(found[0].diffuse[i], found[1].diffuse[i], 0.0);
    assert_true(found[2].particles[i] > 0.0);
    ASSERT_CLOSE(found[2].molecules[i], 0.0, 0.0);
  }
}

TESTS(haze_without_light_or_scattering_has_its_kinds,
  particles_scatter_the_skys_light_by_their_phase, molecules_scatter_the_skys_light_to_all_sides,
  haze_begins_at_the_surface_and_grows_with_the_depth, phases_are_of_all_backward_light,
  integral_is_closed_and_keeps_its_digits, over_is_the_integral, over_has_its_limits,
  straight_down_is_the_deep_color, daylight_falls_off_as_gordon_says, no_light_is_black,
  level_ways_are_as_photons_say, skys_light_is_smooth)
