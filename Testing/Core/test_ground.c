// SPDX-License-Identifier: BSD-3-Clause
// test_ground.c: terrains and basins have ground under all of their water, what stands in it has
// not.
#include "test_main.h"

#include "water_ground.h"

#include <math.h>

static const double scene[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 };
static const water_plane level = { { 0.0, 0.0, 2.0 }, 0.0 };

static water_ground begun(void)
{
  water_ground ground;
  assert_int_equal(water_ground_begin(&level, scene, &ground), WATER_OK);
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
  return water_ground_is_under(&ground, 0.0);
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
  assert_false(water_ground_is_under(&ground, 0.0));
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
    assert_true(water_ground_is_under(&ground, 0.0) == (i == 0));
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
  assert_false(water_ground_is_under(&ground, 0.0));
}

// The corners of all cells cover the scene, at the level.
TEST(cells_cover_the_scene)
{
  const water_ground ground = begun();
  double first[12];
  double last[12];
  water_ground_corners(&ground, 0.25, 0, 0, first);
  water_ground_corners(&ground, 0.25, WATER_GROUND_CELLS - 1, WATER_GROUND_CELLS - 1, last);
  ASSERT_CLOSE(first[0], -2.0, 1e-12);
  ASSERT_CLOSE(first[1], -1.0, 1e-12);
  ASSERT_CLOSE(first[2], 0.25, 1e-12);
  ASSERT_CLOSE(last[6], 2.0, 1e-12);
  ASSERT_CLOSE(last[7], 1.0, 1e-12);
}

TEST(coarse_meshes_are_looked_at_in_more_places)
{
  assert_int_equal(water_ground_across(1.0), WATER_GROUND_CELLS);
  assert_int_equal(water_ground_across(0.0), WATER_GROUND_CELLS);
  assert_int_equal(water_ground_across(1e9), 2);
  for (double side = 1.0; side < 200.0; side += 1.0)
  {
    assert_true(side * water_ground_across(side * side) >= WATER_GROUND_CELLS);
  }
}

// A plane without a normal and a scene without bounds have no ground.
TEST(bad_scenes_have_no_ground)
{
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  const double empty[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  water_ground ground;
  assert_int_not_equal(water_ground_begin(&none, scene, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground, 0.0));
  assert_int_not_equal(water_ground_begin(&level, empty, &ground), WATER_OK);
  assert_false(water_ground_is_under(&ground, 0.0));
}

// A ridge that stands out of the water along y: dry where it and all around it is, whatever the
// level, and nowhere when all is flooded; unknown where there are no points.
TEST(ground_is_dry_where_it_stands_out)
{
  water_ground ground = begun();
  for (int i = 0; i <= 400; ++i)
  {
    for (int j = 0; j <= 200; ++j)
    {
      const double x = -2.0 + 0.01 * i;
      add(x, -1.0 + 0.01 * j, 1.0 - fabs(x), &ground);
    }
  }
  for (int step = -1; step <= 1; ++step)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      double first[12];
      double last[12];
      water_ground_corners(&ground, 0.0, x > 0 ? x - 1 : 0, 20, first);
      water_ground_corners(
        &ground, 0.0, x + 1 < WATER_GROUND_CELLS ? x + 1 : WATER_GROUND_CELLS - 1, 20, last);
      const double low = first[0];
      const double high = last[3];
      const double lowest = 1.0 - fmax(fabs(low), fabs(high)); // around the cell
      const bool is_dry = water_ground_is_dry(&ground, 0.7 * step, x, 20);
      assert_true(!is_dry || lowest > 0.7 * step - 0.011);
      assert_true(is_dry || lowest <= 0.7 * step + 0.011);
    }
  }
  ground = begun();
  add(0.0, 0.0, 1.0, &ground);
  assert_false(water_ground_is_dry(&ground, 0.0, WATER_GROUND_CELLS / 2, WATER_GROUND_CELLS / 2));
}

TESTS(coarse_meshes_are_looked_at_in_more_places, cells_cover_the_scene,
  ground_is_dry_where_it_stands_out, bad_scenes_have_no_ground, terrain_is_ground,
  round_and_thick_things_are_not, few_points_are_no_ground, a_bed_under_the_water_is_ground,
  numbers_that_are_none_count_nothing)
