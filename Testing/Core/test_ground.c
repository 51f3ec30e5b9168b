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

static double is_row_of_boxes(double x, double y)
{
  (void)y;
  return fmod(x + 2.2, 1.0) <= 0.4 ? 0.3 : (double)NAN;
}

TEST(things_in_a_row_are_not)
{
  assert_false(has_ground(is_row_of_boxes, 100, false, 0.0));
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

// Twice the area of a quadrilateral in the plane; positive if it is counter-clockwise.
static double area_of(const double part[12])
{
  return (part[6] - part[0]) * (part[10] - part[4]) - (part[9] - part[3]) * (part[7] - part[1]);
}

static bool is_inside(const double part[12], double x, double y)
{
  for (int i = 0; i < 4; ++i)
  {
    const double* from = part + 3 * i;
    const double* to = part + 3 * ((i + 1) % 4);
    if ((to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]) < -1e-12)
    {
      return false;
    }
  }
  return true;
}

static double wet_area(const water_ground* ground, double water_level)
{
  double area = 0.0;
  for (int i = 0; i < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++i)
  {
    double parts[24];
    const int count =
      water_ground_wet(ground, water_level, i % WATER_GROUND_CELLS, i / WATER_GROUND_CELLS, parts);
    assert_in_range(count, 0, 2);
    for (int j = 0; j < count; ++j)
    {
      assert_true(area_of(parts + 12 * j) > -1e-12);
      area += 0.5 * area_of(parts + 12 * j);
    }
  }
  return area;
}

static bool is_wet(const water_ground* ground, double water_level, double x, double y)
{
  const int column = (int)fmin((x + 2.0) / 4.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  const int row = (int)fmin((y + 1.0) / 2.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  double parts[24];
  const int count = water_ground_wet(ground, water_level, column, row, parts);
  return (count > 0 && is_inside(parts, x, y)) || (count > 1 && is_inside(parts + 12, x, y));
}

// Where nothing is known all of the scene is wet, at the level.
TEST(cells_cover_the_scene)
{
  const water_ground ground = begun();
  double parts[24];
  assert_int_equal(water_ground_wet(&ground, 0.25, 0, 0, parts), 1);
  ASSERT_CLOSE(parts[0], -2.0, 1e-12);
  ASSERT_CLOSE(parts[1], -1.0, 1e-12);
  ASSERT_CLOSE(parts[2], 0.25, 1e-12);
  ASSERT_CLOSE(wet_area(&ground, 0.25), 8.0, 1e-9);
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

static double ridge(double x, double y)
{
  return 1.0 - fabs(x + 0.7 * y);
}

static double islands(double x, double y)
{
  return 0.4 * cos(5.0 * x) * cos(5.0 * y) - 0.1;
}

// All that is under the level is wet, and of what is over it all but a border of two to three
// cells.
TEST(ground_is_dry_where_it_stands_out)
{
  double (*const heights[2])(double, double) = { ridge, islands };
  const double widest[2] = { 0.19, 0.3 }; // m of height that the border holds
  for (int k = 0; k < 2; ++k)
  {
    water_ground ground = begun();
    for (int i = 0; i <= 400; ++i)
    {
      for (int j = 0; j <= 400; ++j)
      {
        const double x = -2.0 + 0.01 * i;
        const double y = -1.0 + 0.005 * j;
        add(x, y, heights[k](x, y), &ground);
      }
    }
    int wet_count = 0;
    for (int i = 0; i < 40000; ++i)
    {
      const double x = -1.99 + 3.98 * (i % 200) / 199.0;
      const double y = -0.99 + 1.98 * (i / 200) / 199.0;
      const double height = heights[k](x, y);
      const bool is = is_wet(&ground, 0.05, x, y);
      assert_true(is || height > 0.05);
      assert_true(!is || height < 0.05 + widest[k]);
      wet_count += is ? 1 : 0;
    }
    ASSERT_CLOSE(wet_area(&ground, 0.05), 8.0 * wet_count / 40000.0, 0.08);
    ASSERT_CLOSE(wet_area(&ground, 5.0), 8.0, 1e-9);
  }
}

// What nobody knows is wet, up to what is known to be dry.
TEST(ground_is_wet_where_nothing_is_known)
{
  water_ground ground = begun();
  add(0.0, 0.0, 1.0, &ground);
  ASSERT_CLOSE(wet_area(&ground, 0.0), 8.0, 1e-9);
  for (int i = 0; i <= 200; ++i)
  {
    for (int j = 0; j <= 200; ++j)
    {
      add(0.01 * i, -1.0 + 0.01 * j, 1.0, &ground); // the half of it
    }
  }
  ASSERT_CLOSE(wet_area(&ground, 0.0), 4.0 + 2.0 * 2.0 * 4.0 / WATER_GROUND_CELLS, 0.13);
}

TESTS(coarse_meshes_are_looked_at_in_more_places, cells_cover_the_scene,
  ground_is_dry_where_it_stands_out, ground_is_wet_where_nothing_is_known,
  bad_scenes_have_no_ground, terrain_is_ground, round_and_thick_things_are_not,
  things_in_a_row_are_not, few_points_are_no_ground, a_bed_under_the_water_is_ground,
  numbers_that_are_none_count_nothing)
