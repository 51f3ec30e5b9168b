// SPDX-License-Identifier: BSD-3-Clause
// test_shared.c: formulas that core and shaders have in one text, where no other file of tests asks
// for all of their inputs.
#include "test_main.h"

#include "water_random.h"
#include "water_shared.h"

#include <float.h>

// A gradient is painted on the screen: 0 at its bottom, 1 at its top, and its last colours beyond.
TEST(gradient_ends_at_the_screens_edge)
{
  const double w = 3.0;
  ASSERT_CLOSE(water_shared_gradient_height(-w, w), 0.0, 0.0);
  ASSERT_CLOSE(water_shared_gradient_height(-0.5 * w, w), 0.25, 1e-15);
  ASSERT_CLOSE(water_shared_gradient_height(0.0, w), 0.5, 0.0);
  ASSERT_CLOSE(water_shared_gradient_height(w, w), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_gradient_height(-2.0 * w, w), 0.0, 0.0);
  ASSERT_CLOSE(water_shared_gradient_height(2.0 * w, w), 1.0, 0.0);
}

// A direction beside or behind the camera is above all of the screen or under it.
TEST(gradient_behind_the_camera_is_its_top_or_bottom)
{
  const double ws[] = { 0.0, -DBL_MIN, -1.0 };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(water_shared_gradient_height(1.0, ws[i]), 1.0, 0.0);
    ASSERT_CLOSE(water_shared_gradient_height(0.0, ws[i]), 1.0, 0.0);
    ASSERT_CLOSE(water_shared_gradient_height(-1.0, ws[i]), 0.0, 0.0);
  }
}

// Slopes that go together are likely where both have one sign: at (1, 1) with variances 2, 3 and
// covariance 1 the exponent is -(3 - 2 + 2) / 10.
TEST(slope_density_knows_the_covariance)
{
  const double pi = 3.14159265358979323846;
  ASSERT_CLOSE(water_shared_slope_density(2.0, 3.0, 1.0, 5.0, 1.0, 1.0),
    exp(-0.3) / (2.0 * pi * sqrt(5.0)), 1e-16);
  ASSERT_CLOSE(water_shared_slope_density(2.0, 3.0, 1.0, 5.0, 1.0, -1.0),
    exp(-0.7) / (2.0 * pi * sqrt(5.0)), 1e-16);
}

// Light rolls off: it is as it was up to 0.72, has no step or kink, grows for ever and stays below
// white.
TEST(highlights_roll_off)
{
  double last = 0.0;
  double last_slope = 1.0;
  for (int i = 0; i <= 20000; ++i)
  {
    const double light = 0.001 * i;
    const double shown = water_shared_roll_off(light);
    assert_true(i == 0 || shown > last);
    const double slope = (shown - last) / 0.001;
    assert_true(i == 0 || (slope <= last_slope + 1e-9 && slope > last_slope - 0.01));
    assert_true(light > 0.72 || fabs(shown - light) < 1e-15);
    last_slope = i == 0 ? 1.0 : slope;
    last = shown;
  }
  ASSERT_CLOSE(water_shared_roll_off(1.0), 0.87, 0.01);
  ASSERT_CLOSE(water_shared_roll_off(10.0), 0.96, 0.01);
  assert_true(water_shared_roll_off(1e9) < 0.99);
  assert_true(water_shared_roll_off(100.0) - water_shared_roll_off(10.0) > 5.0 / 255.0);
}

// A shore's foam covers the waterline, ends where it is said to, and its bands travel towards the
// shore.
TEST(shore_foam_has_bands)
{
  for (int i = 0; i < 12; ++i)
  {
    const double turn = i / 12.0;
    ASSERT_CLOSE(water_shared_shore_foam(0.0, turn), 1.0, 1e-15);
    ASSERT_CLOSE(water_shared_shore_foam(1.0, turn), 0.0, 1e-15);
    ASSERT_CLOSE(water_shared_shore_foam(7.0, turn), 0.0, 1e-15);
    ASSERT_CLOSE(
      water_shared_shore_foam(0.7, turn), water_shared_shore_foam(0.7, turn + 1.0), 1e-12);
  }
  // away from the waterline a band covers 0.8 of what is left of the depth, and nothing between two
  ASSERT_CLOSE(water_shared_shore_foam(0.8, 0.4), 0.8 * 0.2, 1e-12);
  ASSERT_CLOSE(water_shared_shore_foam(0.8, 0.15), 0.0, 1e-12);
  // a band is at the depth where it covers the most
  double crest[2];
  for (int i = 0; i < 2; ++i)
  {
    double most = 0.0;
    for (double depth = 0.58; depth < 1.0; depth += 0.001)
    {
      const double cover = water_shared_shore_foam(depth, 0.02 + 0.02 * i) / (1.0 - depth);
      crest[i] = cover > most ? depth : crest[i];
      most = fmax(most, cover);
    }
  }
  ASSERT_CLOSE(crest[1] - crest[0], -2.0 * 0.02 / 1.5, 0.0021);
}

// A point of the lace: one to a cell, within 0.38 of the cell's middle.
static double off_in_cell(uint64_t number)
{
  return 0.5 + 0.38 * sin(6.283185307179586 * water_random_uniform(7, number));
}

// The lace is below the threshold of a share on that share of the water.
TEST(foam_covers_its_share)
{
  enum
  {
    SIDE = 24,
    PLACES = 20000
  };
  static double points[2][SIDE][SIDE][2];
  static double lace[PLACES];
  for (int i = 0; i < 2 * SIDE * SIDE; ++i)
  {
    double* point = points[i / (SIDE * SIDE)][i / SIDE % SIDE][i % SIDE];
    point[0] = off_in_cell((uint64_t)(2 * i));
    point[1] = off_in_cell((uint64_t)(2 * i + 1));
  }
  for (int i = 0; i < PLACES; ++i)
  {
    lace[i] = 0.0;
    for (int size = 0; size < 2; ++size)
    {
      const uint64_t number = (uint64_t)(4 * i + 2 * size);
      const double x = 1.0 + (SIDE - 2.0) * water_random_uniform(8, number);
      const double y = 1.0 + (SIDE - 2.0) * water_random_uniform(8, number + 1);
      double near[2] = { 9.0, 9.0 };
      for (int j = 0; j < 9; ++j)
      {
        const int column = (int)x + j % 3 - 1;
        const int row = (int)y + j / 3 - 1;
        const double* point = points[size][row][column];
        const double distance = hypot(column + point[0] - x, row + point[1] - y);
        near[1] = fmin(near[1], fmax(distance, near[0]));
        near[0] = fmin(near[0], distance);
      }
      lace[i] += (size == 0 ? 0.65 : 0.35) * (near[1] - near[0]);
    }
  }
  for (int step = 0; step <= 20; ++step)
  {
    const double share = 0.05 * step;
    int covered = 0;
    for (int i = 0; i < PLACES; ++i)
    {
      covered += lace[i] < water_shared_foam_threshold(share) ? 1 : 0;
    }
    ASSERT_CLOSE((double)covered / PLACES, share, 0.03);
  }
}

// Each gradient has its first colour and its second where VTK's have them: from bottom to top, from
// left to right, and from the middle to the sides or to the corners.
TEST(gradients_have_their_ends)
{
  enum
  {
    VERTICAL = 1, // water_screen
    HORIZONTAL,
    SIDE,
    CORNER
  };
  ASSERT_CLOSE(water_shared_gradient_share(VERTICAL, 0.3, 0.75), 0.75, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(HORIZONTAL, 0.25, 0.7), 0.25, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(SIDE, 0.5, 0.75), 0.5, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(SIDE, 0.0, 0.5), 1.0, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(SIDE, 0.0, 0.0), 1.0, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(CORNER, 0.5, 0.5), 0.0, 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(CORNER, 0.5, 1.0), sqrt(0.5), 1e-6);
  ASSERT_CLOSE(water_shared_gradient_share(CORNER, 1.0, 0.0), 1.0, 1e-6);
}

TESTS(gradients_have_their_ends, highlights_roll_off, shore_foam_has_bands, foam_covers_its_share,
  gradient_ends_at_the_screens_edge, gradient_behind_the_camera_is_its_top_or_bottom,
  slope_density_knows_the_covariance)
