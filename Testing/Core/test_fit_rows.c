// SPDX-License-Identifier: BSD-3-Clause
// test_fit_rows.c: long rows of quads in a list of polygons, which are summed many at once, have
// the area, the integrals and the bounds of their triangles.
#include "test_scene.h"

#include "water_fit.h"
#include "water_fit_rows.h"

enum
{
  MOST = 70, // polygons of a list
  ROUNDS = 400
};

typedef struct list
{
  double points[5 * MOST][3]; // each polygon has its own
  int64_t corners[5 * MOST];
  int64_t starts[MOST + 1];
  size_t count;
} list;

// Adds a polygon of 3 to 5 corners about a place, bent, and turned either way.
static void add(list* to, dice* from, int size)
{
  const double place[3] = { dice_roll(from, -9.0, 9.0), dice_roll(from, -9.0, 9.0),
    dice_roll(from, 4.0, 6.0) };
  const double way = dice_roll(from, -1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  int64_t next = to->starts[to->count];
  for (int k = 0; k < size; ++k)
  {
    const double angle = way * (k + dice_roll(from, 0.0, 0.6)) * 6.283185307179586 / size;
    const int64_t number = 5 * MOST - 1 - next; // the list is in another order than the points
    to->points[number][0] = place[0] + cos(angle);
    to->points[number][1] = place[1] + 2.0 * sin(angle);
    to->points[number][2] = place[2] + dice_roll(from, -1.0, 1.0);
    to->corners[next++] = number;
  }
  to->starts[++to->count] = next;
}

// What a fit must hold, by the corners of triangles: the integral of a product of two linear
// functions over a triangle is a twelfth of its area times the sum of the corners' products and the
// product of their sums.
static void expect(const list* of, size_t count, const double axes[3][3], const double origin[3],
  double area_first_second[10])
{
  static const int pairs[6][2] = { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } };
  memset(area_first_second, 0, 10 * sizeof(double));
  for (size_t polygon = 0; polygon < count; ++polygon)
  {
    double own[10] = { 0.0 };
    for (int64_t k = of->starts[polygon] + 2; k < of->starts[polygon + 1]; ++k)
    {
      double at[3][3];
      const int64_t corners[3] = { of->starts[polygon], k - 1, k };
      for (int i = 0; i < 3; ++i)
      {
        const double* point = of->points[of->corners[corners[i]]];
        const double off[3] = { point[0] - origin[0], point[1] - origin[1], point[2] - origin[2] };
        for (int axis = 0; axis < 3; ++axis)
        {
          at[axis][i] = dot(axes[axis], off);
        }
      }
      const double area = 0.5 *
        ((at[0][1] - at[0][0]) * (at[1][2] - at[1][0]) -
          (at[1][1] - at[1][0]) * (at[0][2] - at[0][0]));
      own[0] += area;
      for (int i = 0; i < 3; ++i)
      {
        own[1 + i] += area / 3.0 * (at[i][0] + at[i][1] + at[i][2]);
      }
      for (int i = 0; i < 6; ++i)
      {
        const double* a = at[pairs[i][0]];
        const double* b = at[pairs[i][1]];
        own[4 + i] += area / 12.0 * (dot(a, b) + (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]));
      }
    }
    const double sign = own[0] < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 10; ++i)
    {
      area_first_second[i] += sign * own[i];
    }
  }
}

static void assert_fit(const list* of, size_t count, const double axes[3][3], const water_fit* fit)
{
  double expected[10];
  double bounds[6] = { INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY };
  expect(of, count, axes, of->points[of->corners[0]], expected);
  ASSERT_CLOSE(fit->area, expected[0], 1e-12 * expected[0]);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(fit->first[i], expected[1 + i], 1e-10);
  }
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(fit->second[i], expected[4 + i], 1e-9);
  }
  for (int64_t k = 0; k < of->starts[count]; ++k)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = of->points[of->corners[k]][axis];
      bounds[2 * axis] = fmin(bounds[2 * axis], at);
      bounds[2 * axis + 1] = fmax(bounds[2 * axis + 1], at);
    }
  }
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(fit->bounds[i], bounds[i], 0.0);
  }
}

static const double upright[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

// Rows of all lengths, with other polygons before, in and after them.
TEST(rows_of_quads_have_the_integrals_of_their_triangles)
{
  static list made;
  dice from = dice_seeded(91);
  for (int round = 0; round < ROUNDS; ++round)
  {
    const size_t count = 1 + (size_t)dice_roll(&from, 0.0, MOST);
    const size_t other = (size_t)dice_roll(&from, 0.0, 2.0 * MOST); // often none
    made.count = 0;
    while (made.count < count)
    {
      add(&made, &from, made.count == other ? 3 + 2 * (round % 2) : 4);
    }
    water_fit fit;
    water_fit_begin(upright[2], &fit);
    assert_int_equal(
      water_fit_add_polygons(made.points[0], made.starts, made.corners, count, &fit), count);
    assert_fit(&made, count, upright, &fit);
  }
}

// A polygon with a coordinate that is no usable number ends the list, wherever in a row it is.
TEST(rows_end_before_a_quad_that_is_not_usable)
{
  static const double wrong[4] = { NAN, INFINITY, -INFINITY, -2e100 };
  static list made;
  dice from = dice_seeded(92);
  for (int round = 0; round < ROUNDS; ++round)
  {
    const size_t bad = 1 + (size_t)dice_roll(&from, 0.0, MOST - 1);
    made.count = 0;
    while (made.count < MOST)
    {
      add(&made, &from, 4);
    }
    const int64_t corner = made.starts[bad] + round % 4;
    made.points[made.corners[corner]][round / 4 % 3] = wrong[round / 12 % 4];
    water_fit fit;
    water_fit_begin(upright[2], &fit);
    assert_int_equal(
      water_fit_add_polygons(made.points[0], made.starts, made.corners, MOST, &fit), bad);
    assert_fit(&made, bad, upright, &fit);
  }
}

// 1e100 itself is a coordinate.
TEST(largest_coordinate_is_usable_in_a_row)
{
  static list made;
  dice from = dice_seeded(93);
  while (made.count < 40)
  {
    add(&made, &from, 4);
  }
  made.points[made.corners[50]][2] = -1e100;
  water_fit fit;
  water_fit_begin(upright[2], &fit);
  assert_int_equal(water_fit_add_polygons(made.points[0], made.starts, made.corners, 40, &fit), 40);
  ASSERT_CLOSE(fit.bounds[4], -1e100, 0.0);
}

// Of 40 quads there are two rows of 16, with 1e100 as a coordinate, too; of a list with a pentagon
// in its second row there is one, and none if a number in the first is not usable.
TEST(as_many_quads_are_taken_as_there_are_rows)
{
  static list made;
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const size_t expected[4] = { 32, 32, 16, 0 };
  for (int i = 0; i < 4; ++i)
  {
    dice from = dice_seeded(95);
    memset(&made, 0, sizeof made);
    while (made.count < 40)
    {
      add(&made, &from, i == 2 && made.count == 20 ? 5 : 4);
    }
    double* point = made.points[made.corners[50]];
    point[2] = i == 1 ? 1e100 : i == 3 ? (double)NAN : point[2];
    double bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
    water_fit_integrals sum = { 0.0, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
    assert_int_equal(
      water_fit_rows_add(made.points[0], made.starts, made.corners, 40, origin, bounds, &sum),
      expected[i]);
    assert_true((sum.area > 0.0) == (i < 3));
    assert_true((bounds[5] == 1e100) == (i == 1));
  }
}

// Of a part of a list only its own polygons are added, not those before it.
TEST(a_part_of_a_list_is_its_own)
{
  static list made;
  dice from = dice_seeded(96);
  while (made.count < MOST)
  {
    add(&made, &from, 4);
  }
  water_fit part;
  water_fit alone;
  water_fit_begin(upright[2], &part);
  water_fit_begin(upright[2], &alone);
  assert_int_equal(
    water_fit_add_polygons(made.points[0], made.starts + 16, made.corners, MOST - 16, &part),
    MOST - 16);
  for (size_t i = 16; i < MOST; ++i)
  {
    double corners[4][3];
    for (int k = 0; k < 4; ++k)
    {
      memcpy(corners[k], made.points[made.corners[made.starts[i] + k]], sizeof corners[k]);
    }
    assert_true(water_fit_add_polygon(corners[0], 4, &alone));
  }
  ASSERT_CLOSE(part.area, alone.area, 1e-12 * alone.area);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(part.first[i], alone.first[i], 1e-10);
  }
  assert_memory_equal(part.bounds, alone.bounds, sizeof part.bounds);
}

// Of another up direction heights are along that: here along y.
TEST(rows_may_have_any_up)
{
  static list made;
  static const double up[3] = { 0.0, 1.0, 0.0 };
  dice from = dice_seeded(94);
  while (made.count < 40)
  {
    add(&made, &from, 4);
  }
  water_fit fit;
  water_fit_begin(up, &fit);
  assert_int_equal(water_fit_add_polygons(made.points[0], made.starts, made.corners, 40, &fit), 40);
  double expected[10];
  const double axes[3][3] = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } };
  expect(&made, 40, axes, made.points[made.corners[0]], expected);
  // the two horizontal axes may be any: what does not depend on them
  ASSERT_CLOSE(fit.area, expected[0], 1e-12 * expected[0]);
  ASSERT_CLOSE(fit.first[2], expected[3], 1e-10);
  ASSERT_CLOSE(fit.second[0] + fit.second[2], expected[4] + expected[6], 1e-9);
  ASSERT_CLOSE(fit.second[5], expected[9], 1e-9);
}

TESTS(a_part_of_a_list_is_its_own, as_many_quads_are_taken_as_there_are_rows,
  rows_of_quads_have_the_integrals_of_their_triangles, rows_end_before_a_quad_that_is_not_usable,
  largest_coordinate_is_usable_in_a_row, rows_may_have_any_up)
