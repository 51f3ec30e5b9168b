// SPDX-License-Identifier: BSD-3-Clause
// test_ground.c: terrains and basins have ground under all of their water, what stands in it has
// not.
#include "test_main.h"

#include "water_ground.h"

#include <math.h>

static const double scene[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 };
static const double origin[3] = { 0.0, 0.0, 0.0 };
static const water_plane level = { { 0.0, 0.0, 2.0 }, 0.0 };

static water_ground begun(void)
{
  water_ground ground;
  assert_int_equal(water_ground_begin(&level, origin, scene, &ground), WATER_OK);
  return ground;
}

static void add(double x, double y, double height, water_ground* ground)
{
  const double point[3] = { x, y, height };
  water_ground_add_point(point, ground);
}

typedef double (*height_of)(double x, double y);

static double hills(double x, double y)
{
  return 0.3 * sin(3.0 * x) * cos(2.0 * y) - 0.05;
}

// A surface over the scene's bounds, or the part of them that is in an ellipse.
static bool has_ground(height_of height, int points, bool is_round, double thick)
{
  water_ground ground = begun();
  for (int i = 0; i <= points; ++i)
  {
    for (int j = 0; j <= points; ++j)
    {
      const double x = -2.0 + 4.0 * i / points;
      const double y = -1.0 + 2.0 * j / points;
      if (!is_round || 0.25 * x * x + y * y <= 1.0)
      {
        add(x, y, height(x, y), &ground);
        add(x, y, height(x, y) + thick, &ground);
      }
    }
  }
  return water_ground_is_under(&ground);
}

TEST(terrain_is_ground)
{
  assert_true(has_ground(hills, 100, false, 0.0));
  assert_true(has_ground(hills, 12, false, 0.0));
}

TEST(round_and_thick_things_are_not)
{
  assert_false(has_ground(hills, 100, true, 0.0));  // an island
  assert_false(has_ground(hills, 100, false, 2.0)); // a block
}

TEST(few_points_are_no_ground)
{
  assert_false(has_ground(hills, 1, false, 0.0)); // four corners
  water_ground ground = begun();
  assert_false(water_ground_is_under(&ground));
}

TEST(a_bed_under_the_water_is_ground)
{
  const double beds[5][6] = {
    { -1.9, 1.9, -0.9, 0.9, -2.0, -1.0 }, // wide and under it
    { -1.9, 1.9, -0.9, 0.9, -2.0, 0.1 },  // stands out
    { -1.0, 1.0, -0.9, 0.9, -2.0, -1.0 }, // as wide as half of it
    { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 },  // empty
    { -1.9, 1.9, -0.9, 0.9, -2.0, (double)NAN },
  };
  for (int i = 0; i < 5; ++i)
  {
    water_ground ground = begun();
    water_ground_add_bounds(beds[i], &ground);
    assert_true(water_ground_is_under(&ground) == (i == 0));
  }
}

TEST(numbers_that_are_none_count_nothing)
{
  water_ground ground = begun();
  for (int i = 0; i < 1000; ++i)
  {
    const double t = (i % 250) / 250.0;
    const double x = i < 250 ? -2.0 + 4.0 * t : i < 500 ? 2.0 : i < 750 ? 2.0 - 4.0 * t : -2.0;
    const double y = i < 250 ? -1.0 : i < 500 ? -1.0 + 2.0 * t : i < 750 ? 1.0 : 1.0 - 2.0 * t;
    add(x, y, (double)NAN, &ground);
    add(x, (double)NAN, 0.0, &ground);
  }
  assert_false(water_ground_is_under(&ground));
}

// A plane without a normal and a scene without bounds have no ground.
TEST(bad_scenes_have_no_ground)
{
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  const double empty[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  water_ground ground;
  assert_int_not_equal(water_ground_begin(&none, origin, scene, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground));
  assert_int_not_equal(water_ground_begin(&level, origin, empty, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground));
}

TESTS(bad_scenes_have_no_ground, terrain_is_ground, round_and_thick_things_are_not,
  few_points_are_no_ground, a_bed_under_the_water_is_ground, numbers_that_are_none_count_nothing)
