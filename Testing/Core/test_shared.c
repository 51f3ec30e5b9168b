// SPDX-License-Identifier: BSD-3-Clause
// test_shared.c: formulas that core and shaders have in one text, where no other file of tests asks
// for all of their inputs.
#include "test_main.h"

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

TESTS(gradient_ends_at_the_screens_edge, gradient_behind_the_camera_is_its_top_or_bottom,
  slope_density_knows_the_covariance)
