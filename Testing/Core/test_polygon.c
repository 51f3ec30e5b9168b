// SPDX-License-Identifier: BSD-3-Clause
// test_polygon.c: the normals of polygons.
#include "test_scene.h"

#include <stdlib.h>

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

// Triangles and quads, in rows and mixed, some without a normal.
enum
{
  MIXED = 200
};

static double mixed_points[3 * MIXED];
static int64_t mixed_starts[MIXED + 1];
static int64_t mixed_corners[4 * MIXED];

static void mix(dice* from)
{
  for (int i = 0; i < 3 * MIXED; ++i)
  {
    mixed_points[i] = dice_roll(from, -1.0, 1.0);
  }
  mixed_points[31] = (double)NAN;
  mixed_points[60] = 1e200;
  int64_t count = 0;
  for (int i = 0; i < MIXED; ++i)
  {
    mixed_starts[i] = count;
    const int size = i % 50 == 3 ? 3 : 4;
    for (int k = 0; k < size; ++k)
    {
      mixed_corners[count++] = (int64_t)dice_roll(from, 0.0, MIXED);
    }
  }
  mixed_starts[MIXED] = count;
}

// What the sums must be, bit by bit: each polygon's normal, one after the other.
static void sum_one_by_one(float sums[3 * MIXED])
{
  memset(sums, 0, 3 * MIXED * sizeof(float));
  for (int i = 0; i < MIXED; ++i)
  {
    double corners[12];
    const int64_t size = mixed_starts[i + 1] - mixed_starts[i];
    for (int64_t k = 0; k < size; ++k)
    {
      memcpy(
        corners + 3 * k, mixed_points + 3 * mixed_corners[mixed_starts[i] + k], 3 * sizeof(double));
    }
    double normal[3];
    water_polygon_normal(corners, (size_t)size, normal);
    for (int64_t k = 0; k < size; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        sums[3 * mixed_corners[mixed_starts[i] + k] + axis] += (float)normal[axis];
      }
    }
  }
}

TEST(rows_of_quads_have_the_same_normals)
{
  dice from = dice_seeded(21);
  for (int i = 0; i < 20; ++i)
  {
    mix(&from);
    float expected[3 * MIXED];
    float sums[3 * MIXED] = { 0.0f };
    sum_one_by_one(expected);
    water_polygon_add_normals(mixed_points, mixed_starts, mixed_corners, MIXED, sums);
    assert_memory_equal(sums, expected, sizeof sums);
    water_polygon_unit_normals(sums, MIXED);
    for (int j = 0; j < MIXED; ++j)
    {
      const double sum[3] = { (double)expected[3 * j], (double)expected[3 * j + 1],
        (double)expected[3 * j + 2] };
      const double length = sqrt(dot(sum, sum));
      for (int axis = 0; axis < 3; ++axis)
      {
        const double one = length > 0.0 ? sum[axis] / length : 0.0;
        ASSERT_CLOSE((double)sums[3 * j + axis], one, 1e-7);
      }
    }
  }
}

// Two who share a mesh: each adds to its own points, and then the second to those of the first.
TEST(shares_of_a_mesh_make_the_whole)
{
  dice from = dice_seeded(22);
  mix(&from);
  float expected[3 * MIXED];
  float sums[3 * MIXED] = { 0.0f };
  uint16_t owners[MIXED];
  sum_one_by_one(expected);
  memset(owners, 0xff, sizeof owners);
  for (int half = 1; half >= 0; --half) // the first half has what it has
  {
    const int64_t begin = mixed_starts[half * MIXED / 2];
    for (int64_t i = begin; i < mixed_starts[(half + 1) * MIXED / 2]; ++i)
    {
      owners[mixed_corners[i]] = (uint16_t)half;
    }
  }
  for (int turn = 0; turn < 3; ++turn)
  {
    const int half = turn == 0 ? 1 : turn - 1 ? 1 : 0; // the order of the first two is any
    const water_polygon_share share = { owners, (uint16_t)half, turn < 2 };
    water_polygon_add_shared_normals(
      mixed_points, mixed_starts + half * MIXED / 2, mixed_corners, MIXED / 2, &share, sums);
  }
  assert_memory_equal(sums, expected, sizeof sums);
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

// A polygon without corners, after all others, adds nothing and reads nothing.
TEST(the_last_polygon_may_be_empty)
{
  const double points[9] = { 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0 };
  const int64_t starts[3] = { 0, 3, 3 };
  int64_t* corners = malloc(3 * sizeof *corners); // sanitizers see who reads on
  assert_non_null(corners);
  for (int i = 0; i < 3; ++i)
  {
    corners[i] = i;
  }
  float sums[9] = { 0.0f };
  water_polygon_add_normals(points, starts, corners, 2, sums);
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE((double)sums[i], i % 3 == 2 ? 1.0 : 0.0, 0.0);
  }
  free(corners);
}

// Rows of triangles and of pentagons are no quads.
TEST(rows_of_others_have_their_normals)
{
  enum
  {
    COUNT = 40
  };
  dice from = dice_seeded(22);
  for (int size = 3; size <= 5; size += 2)
  {
    double points[3 * 5 * COUNT];
    int64_t starts[COUNT + 1];
    int64_t corners[5 * COUNT];
    float sums[3 * 5 * COUNT] = { 0.0f };
    for (int i = 0; i < 3 * 5 * COUNT; ++i)
    {
      points[i] = dice_roll(&from, -1.0, 1.0);
      corners[i / 3] = i / 3;
    }
    for (int i = 0; i <= COUNT; ++i)
    {
      starts[i] = (int64_t)size * i;
    }
    water_polygon_add_normals(points, starts, corners, COUNT, sums);
    for (int i = 0; i < COUNT; ++i)
    {
      double normal[3];
      assert_true(water_polygon_normal(points + 3 * size * i, (size_t)size, normal));
      for (int j = 0; j < 3 * size; ++j)
      {
        ASSERT_CLOSE((double)sums[3 * size * i + j], (double)(float)normal[j % 3], 0.0);
      }
    }
  }
}

// Empty polygons add nothing, however many follow each other, and whatever the list has besides.
TEST(rows_of_empty_polygons_add_nothing)
{
  enum
  {
    COUNT = 40
  };
  double points[3 * 4 * COUNT];
  int64_t corners[4 * COUNT];
  int64_t starts[COUNT + 1] = { 0 };
  float sums[3 * 4 * COUNT] = { 0.0f };
  for (int i = 0; i < 4 * COUNT; ++i)
  {
    corners[i] = i;
    points[3 * i] = i % 4 == 1 || i % 4 == 2 ? 1.0 : 0.0;
    points[3 * i + 1] = i % 4 >= 2 ? 1.0 : 0.0;
    points[3 * i + 2] = 0.0;
  }
  for (int i = 1; i <= COUNT; ++i) // the first is a line
  {
    starts[i] = 2;
  }
  water_polygon_add_normals(points, starts, corners, COUNT, sums);
  for (int i = 0; i < 3 * 4 * COUNT; ++i)
  {
    ASSERT_CLOSE((double)sums[i], 0.0, 0.0);
  }
}

TESTS(rows_of_empty_polygons_add_nothing, rows_of_others_have_their_normals,
  the_last_polygon_may_be_empty, sums_of_normals_become_units,
  a_pentagon_s_normal_is_that_of_its_parts, points_get_the_normals_of_their_polygons,
  a_triangle_s_normal_follows_the_right_hand, a_concave_polygon_has_the_normal_of_its_whole,
  a_bent_quad_has_the_mean_normal, what_has_no_area_has_no_normal,
  rows_of_quads_have_the_same_normals, shares_of_a_mesh_make_the_whole)
