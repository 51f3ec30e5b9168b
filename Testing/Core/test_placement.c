// SPDX-License-Identifier: BSD-3-Clause
// test_placement.c: surfaces of the user's in the water's plane, off it, and upright.
#include "test_scene.h"

#include "water_placement.h"

// A square of 6 by 8 (diagonal 10) in the plane of x and a turned y, with waves; its middle is at
// (0, 0, height).
static water_placement_verdict square(double height, double turn_deg, double amplitude, int step)
{
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double turn = turn_deg * 3.14159265358979323846 / 180.0;
  water_placement placement;
  water_placement_begin(&level, &placement);
  for (int i = 0; i < 40; ++i)
  {
    double corners[4][3];
    for (int k = 0; k < 4; ++k)
    {
      const double along = -3.0 + 6.0 * (i + (k & 1)) / 40.0;
      const double across = k & 2 ? 4.0 : -4.0;
      const double wave = amplitude * sin(along * 3.14159265358979323846);
      corners[k][0] = along;
      corners[k][1] = across * cos(turn) - wave * sin(turn);
      corners[k][2] = height + across * sin(turn) + wave * cos(turn);
    }
    water_placement_add(corners[0], corners[step], corners[3 - step], &placement);
    water_placement_add(corners[3], corners[2], corners[1], &placement);
  }
  return water_placement_judge(&placement);
}

// 1 % of the diagonal is accepted, over the plane and under it.
TEST(a_surface_off_its_plane_is_known_by_its_mean_height)
{
  const double heights[] = { 0.0, 0.099, -0.099, 0.101, -0.101, 1.0 };
  for (size_t i = 0; i < sizeof heights / sizeof heights[0]; ++i)
  {
    const water_placement_verdict verdict = square(heights[i], 0.0, 0.0, 1);
    ASSERT_CLOSE(verdict.height, heights[i], 1e-12);
    ASSERT_CLOSE(verdict.height_max, 0.1, 1e-12);
    ASSERT_CLOSE(verdict.angle_rad, 0.0, 1e-7);
    assert_int_equal(verdict.is_off, fabs(heights[i]) > 0.1);
    assert_false(verdict.is_upright);
  }
}

// Whichever way round its triangles are.
TEST(a_surface_is_upright_from_30_degrees_on)
{
  const double turns[] = { 0.0, 29.9, 30.1, 90.0, 149.9, 150.1 };
  for (size_t i = 0; i < sizeof turns / sizeof turns[0]; ++i)
  {
    for (int step = 1; step <= 2; ++step)
    {
      const water_placement_verdict verdict = square(0.0, turns[i], 0.0, step);
      assert_int_equal(verdict.is_upright, turns[i] > 30.0 && turns[i] < 150.0);
      ASSERT_CLOSE(verdict.angle_max_rad, 0.52359877559829887, 1e-15);
      assert_false(verdict.is_off);
    }
  }
}

// Three waves of 2 with an amplitude of 0.15, whose slopes reach 25 degrees.
TEST(waves_are_right)
{
  const water_placement_verdict verdict = square(0.0, 0.0, 0.15, 1);
  assert_true(verdict.angle_rad > 0.1);
  assert_false(verdict.is_off || verdict.is_upright);
}

TEST(without_area_nothing_is_wrong)
{
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double corners[4][3] = { { 0.0, 0.0, 5.0 }, { 1.0, 0.0, 5.0 }, { 2.0, 0.0, 5.0 },
    { (double)NAN, 1.0, 5.0 } };
  water_placement placement;
  water_placement_begin(&level, &placement);
  water_placement_add(corners[0], corners[1], corners[2], &placement);
  water_placement_add(corners[0], corners[1], corners[3], &placement);
  const water_placement_verdict verdict = water_placement_judge(&placement);
  assert_false(verdict.is_off || verdict.is_upright);
  ASSERT_CLOSE(verdict.height, 0.0, 0.0);
  ASSERT_CLOSE(verdict.height_max, 0.0, 0.0);
  ASSERT_CLOSE(verdict.angle_rad, 0.0, 0.0);
}

// 1 % of the diagonal itself is accepted.
TEST(a_hundredth_of_the_diagonal_is_right)
{
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  water_placement placement;
  water_placement_begin(&level, &placement);
  const double corners[3][3] = { { 0.0, 0.0, 1.0 }, { 60.0, 0.0, 1.0 }, { 0.0, 80.0, 1.0 } };
  water_placement_add(corners[0], corners[1], corners[2], &placement);
  const water_placement_verdict verdict = water_placement_judge(&placement);
  ASSERT_CLOSE(verdict.height, 1.0, 0.0);
  ASSERT_CLOSE(verdict.height_max, 1.0, 0.0);
  assert_false(verdict.is_off);
}

TESTS(a_hundredth_of_the_diagonal_is_right, a_surface_off_its_plane_is_known_by_its_mean_height,
  a_surface_is_upright_from_30_degrees_on, waves_are_right, without_area_nothing_is_wrong)
