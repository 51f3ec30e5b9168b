// SPDX-License-Identifier: BSD-3-Clause
// test_fit.c: the plane that lies best in a part of a surface, and which parts share one.
#include "test_main.h"

#include "water_fit.h"
#include "water_math.h"

static const double up_z[3] = { 0.0, 0.0, 1.0 };

typedef double (*surface)(double x, double y);

static double at_seven(double x, double y)
{
  (void)x;
  (void)y;
  return 7.0;
}

static double tilted(double x, double y)
{
  return 3.0 + 0.02 * x - 0.05 * y;
}

static double barely_tilted(double x, double y)
{
  (void)y;
  return 3.0 + 0.5e-4 * x;
}

static double swell(double x, double y)
{
  return 2.0 + 0.3 * sin(2.0 * x + 0.4) + 0.01 * y;
}

static double fall(double x, double y)
{
  (void)y;
  return 0.7 * x;
}

// A grid of cells by cells squares over [x0, x0 + width] x [y0, y0 + height].
static water_fit_plane fit_of(
  surface height_at, double x0, double width, double y0, double height, int cells)
{
  water_fit fit;
  water_fit_begin(up_z, &fit);
  for (int i = 0; i < cells; ++i)
  {
    for (int j = 0; j < cells; ++j)
    {
      double corner[4][3];
      for (int k = 0; k < 4; ++k)
      {
        corner[k][0] = x0 + width * (i + (k & 1)) / cells;
        corner[k][1] = y0 + height * (j + (k >> 1)) / cells;
        corner[k][2] = height_at(corner[k][0], corner[k][1]);
      }
      water_fit_add(corner[0], corner[1], corner[2], &fit);
      water_fit_add(corner[3], corner[1], corner[2], &fit);
    }
  }
  water_fit_plane plane;
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  return plane;
}

// Of a level lake not a digit changes, wherever it is: lakes at one level share one plane.
TEST(a_level_lake_has_its_own_level_exactly)
{
  const double x0[3] = { 0.0, -31.7, 734561.25 };
  for (int i = 0; i < 3; ++i)
  {
    const water_fit_plane plane = fit_of(at_seven, x0[i], 9.3, 4100345.1, 7.7, 5);
    assert_true(plane.is_level);
    assert_true(plane.origin[2] == 7.0 && plane.origin[0] == 0.0 && plane.origin[1] == 0.0);
    assert_true(plane.normal[0] == 0.0 && plane.normal[1] == 0.0 && plane.normal[2] == 1.0);
    ASSERT_CLOSE(plane.area, 9.3 * 7.7, 1e-6);
    ASSERT_CLOSE(plane.rms, 0.0, 0.0);
  }
}

TEST(a_slope_is_found_whatever_the_triangles)
{
  const double length = sqrt(1.0 + 0.02 * 0.02 + 0.05 * 0.05);
  for (int cells = 1; cells <= 7; cells += 3)
  {
    const water_fit_plane plane = fit_of(tilted, 1000.0, 40.0, -3.0, 20.0, cells);
    assert_false(plane.is_level);
    ASSERT_CLOSE(plane.normal[0], -0.02 / length, 1e-12);
    ASSERT_CLOSE(plane.normal[1], 0.05 / length, 1e-12);
    ASSERT_CLOSE(plane.normal[2], 1.0 / length, 1e-12);
    ASSERT_CLOSE(plane.origin[2], tilted(plane.origin[0], plane.origin[1]), 1e-10);
    ASSERT_CLOSE(plane.rms, 0.0, 1e-7);
  }
}

// A thousand kilometres from the world's origin, where sums of squares lose all digits of a metre.
TEST(a_far_place_costs_no_digits)
{
  const water_fit_plane plane = fit_of(tilted, 1e6, 10.0, 2e6, 10.0, 4);
  ASSERT_CLOSE(plane.normal[0] / plane.normal[2], -0.02, 1e-8);
  ASSERT_CLOSE(plane.rms, 0.0, 1e-6);
}

TEST(a_level_is_kept_unless_a_tilt_is_what_heights_are_made_of)
{
  assert_true(fit_of(barely_tilted, 0.0, 30.0, 0.0, 30.0, 3).is_level);
  assert_true(fit_of(fall, 0.0, 30.0, 0.0, 30.0, 3).is_level); // 35 degrees
  const water_fit_plane plane = fit_of(swell, 0.0, 7.0, 0.0, 7.0, 64);
  assert_true(plane.is_level);
  ASSERT_CLOSE(plane.rms, 0.3 / sqrt(2.0), 0.02);
}

// The plane of least squares: no other one is closer.
TEST(no_plane_is_closer)
{
  const double area = 2.0;
  const double corners[4][3] = { { 0, 0, 0.1 }, { 2, 0, 0.5 }, { 0, 2, 0.2 }, { 2, 2, 0.4 } };
  water_fit fit;
  water_fit_begin(up_z, &fit);
  water_fit_add(corners[0], corners[1], corners[2], &fit);
  water_fit_add(corners[3], corners[1], corners[2], &fit);
  water_fit_plane plane;
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  assert_false(plane.is_level);
  double best = 0.0;
  for (int trial = 0; trial < 27; ++trial) // the first is the plane, others lean or lie beside it
  {
    const double lean[3] = { (trial % 3) * 0.02, (trial / 3 % 3) * 0.02, (trial / 9) * 0.01 };
    double sum = 0.0;
    for (int half = 0; half < 2; ++half)
    {
      double heights[3];
      double first = 0.0;
      double squares = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double* p = corners[k == 0 ? 3 * half : k];
        const double off[2] = { p[0] - plane.origin[0], p[1] - plane.origin[1] };
        heights[k] = p[2] - plane.origin[2] -
          (-plane.normal[0] / plane.normal[2] + lean[0]) * off[0] -
          (-plane.normal[1] / plane.normal[2] + lean[1]) * off[1] - lean[2];
        first += heights[k];
        squares += heights[k] * heights[k];
      }
      sum += area / 12.0 * (squares + first * first);
    }
    best = trial == 0 ? sum : best;
    assert_true(sum >= best);
  }
  ASSERT_CLOSE(plane.rms, sqrt(best / (2.0 * area)) * plane.normal[2], 1e-12);
}

// Along a canal its tilt is known, across it is not.
TEST(a_line_of_triangles_leans_along_itself_alone)
{
  const double corners[3][3] = { { 0, 0, 0 }, { 1000, 0, 10 }, { 1000, 1e-3, 10.5 } };
  water_fit fit;
  water_fit_begin(up_z, &fit);
  water_fit_add(corners[0], corners[1], corners[2], &fit);
  water_fit_plane plane;
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  ASSERT_CLOSE(-plane.normal[0] / plane.normal[2], 0.01, 1e-3);
  ASSERT_CLOSE(plane.normal[1], 0.0, 1e-3);
}

TEST(up_may_be_any_direction)
{
  const double up[3] = { 0.0, 1.0, 0.0 };
  const double corners[3][3] = { { 0, 5, 0 }, { 3, 5, 0 }, { 0, 5, 3 } };
  water_fit fit;
  water_fit_begin(up, &fit);
  water_fit_add(corners[0], corners[1], corners[2], &fit);
  water_fit_plane plane;
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  assert_true(plane.is_level && plane.origin[1] == 5.0 && plane.normal[1] == 1.0);
  ASSERT_CLOSE(plane.area, 4.5, 1e-12);
}

TEST(what_is_upright_but_for_rounding_has_no_plane)
{
  const double corners[9] = { 0, 0, 0, 4e-17, 1, 0, 4e-17, 1, 1 };
  water_fit fit;
  water_fit_plane plane;
  water_fit_begin(up_z, &fit);
  assert_true(water_fit_add_polygon(corners, 3, &fit));
  const double more[9] = { 0, 0, 0, 4e-17, 1, 1, 4e-17, 0, 1 };
  assert_true(water_fit_add_polygon(more, 3, &fit));
  assert_true(fit.area > 0.0);
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_BAD_SURFACE);
}

TEST(what_has_no_area_has_no_plane)
{
  const double upright[3][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
  const double broken[3] = { 0, (double)NAN, 0 };
  water_fit fit;
  water_fit_plane plane = { .rms = 42.0 };
  water_fit_begin(up_z, &fit);
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_BAD_SURFACE);
  water_fit_add(upright[0], upright[1], upright[2], &fit);
  water_fit_add(upright[0], broken, upright[1], &fit);
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_BAD_SURFACE);
  assert_true(plane.rms == 42.0);
}

static water_fit_plane lake(double level, double lean, double reach)
{
  const water_fit_plane made = { .normal = { -sin(lean), 0.0, cos(lean) },
    .origin = { 0.0, 0.0, level },
    .middle = { 0.0, 0.0, level },
    .reach = reach };
  return made;
}

TEST(lakes_at_one_level_share_a_plane)
{
  const water_fit_plane parts[5] = { lake(3.0, 0.0, 10.0), lake(2.0, 0.0, 10.0),
    lake(3.0 + 5e-5, 0.0, 10.0), lake(2.0, 1e-3, 10.0), lake(3.0, 0.0, 1.0) };
  size_t plane[5];
  size_t first[5];
  assert_int_equal(water_fit_share(parts, 5, 1e-4, 5, plane, first), 3);
  const size_t expected[5] = { 0, 1, 0, 2, 0 };
  for (int i = 0; i < 5; ++i)
  {
    assert_int_equal(plane[i], expected[i]);
  }
  assert_int_equal(first[0], 0);
  assert_int_equal(first[1], 1);
  assert_int_equal(first[2], 3);
}

// It has none, however near another plane is; the next one in a plane still joins that.
TEST(beyond_the_most_planes_a_part_shares_only_its_own)
{
  const water_fit_plane parts[5] = { lake(0.0, 0.0, 1.0), lake(10.0, 0.0, 1.0), lake(7.0, 0.0, 1.0),
    lake(3.0, 0.0, 1.0), lake(10.0, 0.0, 1.0) };
  size_t plane[5];
  size_t first[2];
  assert_int_equal(water_fit_share(parts, 5, 1e-6, 2, plane, first), 2);
  const size_t expected[5] = { 0, 1, 2, 2, 1 };
  for (int i = 0; i < 5; ++i)
  {
    assert_int_equal(plane[i], expected[i]);
  }
}

TEST(parts_without_a_plane_are_seen_from_over_the_lowest)
{
  const water_fit_plane parts[4] = { lake(-5.0, 0.0, 1.0), lake(7.0, 0.0, 1.0), lake(3.0, 0.1, 1.0),
    lake(4.0, 0.0, 1.0) };
  const size_t plane[4] = { 0, 1, 1, 1 };
  water_fit_plane rest = { .rms = 42.0 };
  assert_true(water_fit_rest(parts, 4, plane, 1, up_z, &rest));
  assert_true(rest.normal[0] == 0.0 && rest.normal[1] == 0.0 && rest.normal[2] == 1.0);
  assert_true(rest.origin[0] == 0.0 && rest.origin[1] == 0.0 && rest.origin[2] == 3.0);
  assert_true(rest.is_level);
  rest.rms = 42.0;
  assert_false(water_fit_rest(parts, 1, plane, 1, up_z, &rest));
  assert_true(rest.rms == 42.0);
}

TEST(tolerance_is_what_is_not_seen_or_not_known)
{
  ASSERT_CLOSE(water_fit_tolerance(1000.0, 0.0, false), 1e-3, 1e-15);
  // a float of 4e6 has steps of half a unit
  assert_true(water_fit_tolerance(1.0, 4e6, true) > 0.5);
  assert_true(water_fit_tolerance(1.0, 4e6, false) < 1e-5);
}

// A fan about the first corner leaves a concave polygon, and comes back.
TEST(a_concave_polygon_has_its_own_area)
{
  const double dart[15] = { 0, 0, 1, 4, 0, 1, 4, 4, 1, 2, 1, 1, 0, 4, 1 };
  for (size_t start = 0; start < 5; ++start)
  {
    for (int turn = -1; turn <= 1; turn += 2)
    {
      double corners[15];
      for (size_t i = 0; i < 5; ++i)
      {
        memcpy(
          corners + 3 * i, dart + 3 * ((start + (turn > 0 ? i : 4 - i)) % 5), 3 * sizeof *dart);
      }
      water_fit fit;
      water_fit_plane plane;
      water_fit_begin(up_z, &fit);
      assert_true(water_fit_add_polygon(corners, 5, &fit));
      assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
      ASSERT_CLOSE(plane.area, 10.0, 1e-12);
      ASSERT_CLOSE(plane.middle[0], 2.0, 1e-12);
    }
  }
}

TEST(a_polygon_that_is_not_finite_is_ignored)
{
  const double flat[9] = { 0, 0, 7, 2, 0, 7, 0, 2, 7 };
  const double bad[] = { (double)INFINITY, -(double)INFINITY, (double)NAN, 1e200, -1e300 };
  water_fit fit;
  water_fit_begin(up_z, &fit);
  for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
  {
    double corners[9];
    memcpy(corners, flat, sizeof corners);
    corners[3 + i % 3] = bad[i];
    assert_false(water_fit_add_polygon(corners, 3, &fit));
  }
  assert_false(water_fit_add_polygon(flat, 2, &fit));
  assert_true(water_fit_add_polygon(flat, 3, &fit));
  water_fit_plane plane;
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  assert_true(plane.origin[2] == 7.0 && plane.area == 2.0);
  ASSERT_CLOSE(plane.reach, sqrt(8.0), 1e-12);
}

static void assert_no_plane(const double corners[9])
{
  water_fit fit;
  water_fit_plane plane = { .rms = 42.0 };
  water_fit_begin(up_z, &fit);
  assert_true(water_fit_add_polygon(corners, 3, &fit));
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_BAD_SURFACE);
  assert_true(plane.rms == 42.0);
}

TEST(the_first_part_begins_a_plane_whatever_the_tolerance)
{
  const water_fit_plane parts[2] = { lake(3.0, 0.0, 10.0), lake(2.0, 0.0, (double)NAN) };
  const double tolerances[] = { (double)INFINITY, (double)NAN };
  for (int i = 0; i < 2; ++i)
  {
    size_t plane[2] = { 9, 9 };
    size_t first[1] = { 9 };
    assert_int_equal(water_fit_share(parts, 2, tolerances[i], 1, plane, first), 1);
    assert_true(plane[0] == 0 && plane[1] == 1 && first[0] == 0);
  }
}

static double tilted_swell(double x, double y)
{
  return 3.0 + 0.02 * x + 0.3 * sin(0.9 * x) * cos(1.3 * y);
}

// Triangles of a square of 12 x 12 cells, added to three fits in turn, which are joined; and to
// one.
static void fit_in_blocks(
  double (*height_at)(double, double), double x0, water_fit* joined, water_fit* whole)
{
  water_fit blocks[3];
  for (int i = 0; i < 3; ++i)
  {
    water_fit_begin(up_z, &blocks[i]);
  }
  water_fit_begin(up_z, joined);
  water_fit_begin(up_z, whole);
  for (int i = 0; i < 144; ++i)
  {
    double corners[12];
    for (int k = 0; k < 4; ++k)
    {
      corners[3 * k] = x0 + i % 12 + (k == 1 || k == 2);
      corners[3 * k + 1] = i / 12 + (k >= 2);
      corners[3 * k + 2] = height_at(corners[3 * k], corners[3 * k + 1]);
    }
    assert_true(water_fit_add_polygon(corners, 4, &blocks[i % 7 % 3]));
    assert_true(water_fit_add_polygon(corners, 4, whole));
  }
  for (int i = 0; i < 3; ++i)
  {
    water_fit_join(&blocks[i], joined);
  }
}

TEST(blocks_of_a_part_are_joined)
{
  water_fit joined;
  water_fit whole;
  water_fit_plane planes[2];
  for (int i = 0; i < 2; ++i)
  {
    fit_in_blocks(tilted_swell, i * 1e6, &joined, &whole);
    assert_int_equal(water_fit_judge(&joined, &planes[0]), WATER_OK);
    assert_int_equal(water_fit_judge(&whole, &planes[1]), WATER_OK);
    ASSERT_CLOSE(planes[0].area, 144.0, 1e-9);
    ASSERT_CLOSE(planes[0].rms, planes[1].rms, 1e-10);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_CLOSE(planes[0].normal[k], planes[1].normal[k], 1e-12);
      ASSERT_CLOSE(planes[0].origin[k], planes[1].origin[k], 1e-8);
    }
    assert_memory_equal(joined.bounds, whole.bounds, sizeof whole.bounds);
  }
}

TEST(a_level_lake_in_blocks_keeps_its_level_exactly)
{
  water_fit joined;
  water_fit whole;
  water_fit_plane plane;
  fit_in_blocks(at_seven, 734561.25, &joined, &whole);
  assert_int_equal(water_fit_judge(&joined, &plane), WATER_OK);
  assert_true(plane.is_level && plane.origin[2] == 7.0);
  ASSERT_CLOSE(plane.rms, 0.0, 0.0);
}

TEST(a_block_without_polygons_changes_nothing)
{
  water_fit joined;
  water_fit whole;
  water_fit empty;
  fit_in_blocks(tilted_swell, 0.0, &joined, &whole);
  water_fit_begin(up_z, &empty);
  const water_fit before = whole;
  water_fit_join(&empty, &whole);
  assert_memory_equal(&before, &whole, sizeof whole);
  water_fit_join(&whole, &empty);
  assert_memory_equal(&empty, &whole, sizeof whole);
}

// A triangle, a quad that turns clockwise and a concave pentagon, then one that is not finite and
// one that is whole: as lists of a mesh, and one by one. Turned axes, too.
TEST(polygons_of_a_mesh_are_those_that_are_added_one_by_one)
{
  const double points[] = { 100.0, 50.0, 3.0, 101.0, 50.0, 3.1, 101.0, 51.0, 3.2, 100.0, 51.0, 3.3,
    100.4, 50.4, 3.1, (double)NAN, 0.0, 0.0 };
  const int64_t starts[] = { 0, 3, 7, 12, 15, 18 };
  const int64_t corners[] = { 0, 1, 2, 3, 2, 1, 0, 0, 1, 2, 4, 3, 0, 1, 5, 1, 2, 3 };
  const double ups[2][3] = { { 0.0, 0.0, 1.0 }, { 0.6, 0.0, 0.8 } };
  for (int turned = 0; turned < 2; ++turned)
  {
    water_fit listed;
    water_fit single;
    water_fit_begin(ups[turned], &listed);
    water_fit_begin(ups[turned], &single);
    assert_int_equal(water_fit_add_polygons(points, starts, corners, 5, &listed), 3);
    assert_int_equal(water_fit_add_polygons(points, starts + 4, corners, 1, &listed), 1);
    for (int polygon = 0; polygon < 5; ++polygon)
    {
      double own[15];
      const int64_t count = starts[polygon + 1] - starts[polygon];
      for (int64_t k = 0; k < count; ++k)
      {
        memcpy(own + 3 * k, points + 3 * corners[starts[polygon] + k], 3 * sizeof *own);
      }
      assert_true(water_fit_add_polygon(own, (size_t)count, &single) == (polygon != 3));
    }
    assert_memory_equal(&listed, &single, sizeof listed);
  }
}

// Each coordinate may be, but not their squares' squares.
TEST(what_overflows_has_no_plane)
{
  const double corners[9] = { 0, 0, 0, 1e99, 0, 0, 0, 1e99, 1e99 };
  assert_no_plane(corners);
}

TEST(a_point_has_no_plane)
{
  const double corners[9] = { 3, 4, 5, 3, 4, 5, 3, 4, 5 };
  assert_no_plane(corners);
}

TESTS(polygons_of_a_mesh_are_those_that_are_added_one_by_one, blocks_of_a_part_are_joined,
  a_level_lake_in_blocks_keeps_its_level_exactly, a_block_without_polygons_changes_nothing,
  a_level_lake_has_its_own_level_exactly, a_slope_is_found_whatever_the_triangles,
  a_far_place_costs_no_digits, a_level_is_kept_unless_a_tilt_is_what_heights_are_made_of,
  no_plane_is_closer, a_line_of_triangles_leans_along_itself_alone, up_may_be_any_direction,
  what_has_no_area_has_no_plane, lakes_at_one_level_share_a_plane,
  beyond_the_most_planes_a_part_shares_only_its_own,
  parts_without_a_plane_are_seen_from_over_the_lowest, tolerance_is_what_is_not_seen_or_not_known,
  a_concave_polygon_has_its_own_area, a_polygon_that_is_not_finite_is_ignored,
  what_overflows_has_no_plane, a_point_has_no_plane, what_is_upright_but_for_rounding_has_no_plane,
  the_first_part_begins_a_plane_whatever_the_tolerance)
