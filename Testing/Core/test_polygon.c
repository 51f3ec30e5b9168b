// SPDX-License-Identifier: BSD-3-Clause
// test_polygon.c: the normals of polygons.
#include "test_main.h"

#include "water_polygon.h"

#include <math.h>

static void assert_normal(const double* corners, size_t count, double x, double y, double z)
{
  double normal[3];
  assert_true(water_polygon_normal(corners, count, normal));
  ASSERT_CLOSE(normal[0], x, 1e-15);
  ASSERT_CLOSE(normal[1], y, 1e-15);
  ASSERT_CLOSE(normal[2], z, 1e-15);
}

TEST(a_triangle_s_normal_follows_the_right_hand)
{
  const double corners[9] = { 5, 5, 5, 7, 5, 5, 5, 8, 5 };
  assert_normal(corners, 3, 0, 0, 1);
  const double turned[9] = { 5, 5, 5, 5, 8, 5, 7, 5, 5 };
  assert_normal(turned, 3, 0, 0, -1);
  const double upright[9] = { 0, 0, 0, 0, 2, 0, 0, 0, 3 };
  assert_normal(upright, 3, 1, 0, 0);
}

// The fan about the first corner leaves an arrow's outline: its parts have opposite signs.
TEST(a_concave_polygon_has_the_normal_of_its_whole)
{
  const double arrow[12] = { 4, 0, 0, 1, 1, 0, 0, 4, 0, 0, 0, 0 };
  double first[3];
  assert_true(water_polygon_normal(arrow, 3, first));
  assert_true(first[2] < 0.0);
  assert_normal(arrow, 4, 0, 0, 1);
}

// A quad that is not flat: its diagonals' cross product.
TEST(a_bent_quad_has_the_mean_normal)
{
  const double corners[12] = { 0, 0, 0, 1, 0, 0.5, 1, 1, 0, 0, 1, 0.5 };
  assert_normal(corners, 4, 0, 0, 1);
}

TEST(what_has_no_area_has_no_normal)
{
  const double line[9] = { 0, 0, 0, 1, 1, 1, 2, 2, 2 };
  const double broken[9] = { 0, 0, 0, 1, NAN, 1, 2, 0, 2 };
  const double huge[9] = { 0, 0, 0, 1e200, 0, 0, 0, 1e200, 0 };
  const double* all[3] = { line, broken, huge };
  double normal[3];
  for (int i = 0; i < 3; ++i)
  {
    normal[2] = 7.0;
    assert_false(water_polygon_normal(all[i], 3, normal));
    ASSERT_CLOSE(normal[2], 0.0, 0.0);
  }
  assert_false(water_polygon_normal(line, 2, normal));
  assert_false(water_polygon_normal(line, 0, normal));
}

TEST(sums_of_normals_become_units)
{
  float normals[9] = { 3.0f, 0.0f, 4.0f, 0.0f, 0.0f, 0.0f, 0.0f, -2e-20f, 0.0f };
  const double expected[9] = { 0.6, 0.0, 0.8, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0 };
  water_polygon_unit_normals(normals, 3);
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE((double)normals[i], expected[i], 1e-7);
  }
}

// Of five corners: the areas of three triangles about the first corner, added.
TEST(a_pentagon_s_normal_is_that_of_its_parts)
{
  // in two planes that meet along the diagonal x = 2, with the area vectors (0, 0, 4) and (-2, 0,
  // 2)
  const double corners[15] = { 0, 0, 0, 2, 0, 0, 3, 1, 1, 2, 2, 0, 0, 2, 0 };
  assert_normal(corners, 5, -1.0 / sqrt(26.0), 0, 5.0 / sqrt(26.0));
}

// Each point gets the normals of the polygons that it is a corner of, and no other point does.
TEST(points_get_the_normals_of_their_polygons)
{
  const double points[18] = { 9, 9, 9, 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 0, 0, 5 };
  const int64_t starts[4] = { 1, 5, 8, 10 };
  // a square in z = 0, a triangle in x = 0 that looks to +x, and a line; the first corner is of
  // none
  const int64_t corners[10] = { 0, 1, 2, 3, 4, 1, 4, 5, 0, 3 };
  const double expected[18] = { 1, 1, 1, 2, 1, 2, 1, 1, 2, 1, 1, 2, 2, 1, 2, 2, 1, 1 };
  float sums[18];
  for (int i = 0; i < 18; ++i)
  {
    sums[i] = 1.0f; // what was there is added to
  }
  water_polygon_add_normals(points, starts, corners, 3, sums);
  for (int i = 0; i < 18; ++i)
  {
    ASSERT_CLOSE((double)sums[i], expected[i], 0.0);
  }
}

TESTS(sums_of_normals_become_units, a_pentagon_s_normal_is_that_of_its_parts,
  points_get_the_normals_of_their_polygons, a_triangle_s_normal_follows_the_right_hand,
  a_concave_polygon_has_the_normal_of_its_whole, a_bent_quad_has_the_mean_normal,
  what_has_no_area_has_no_normal)
