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

TESTS(a_triangle_s_normal_follows_the_right_hand, a_concave_polygon_has_the_normal_of_its_whole,
  a_bent_quad_has_the_mean_normal, what_has_no_area_has_no_normal)
