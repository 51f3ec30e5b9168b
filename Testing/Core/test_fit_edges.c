// SPDX-License-Identifier: BSD-3-Clause
// test_fit_edges.c: the best plane of slanted, narrow and pointed parts, and parts at exactly the
// tolerance of a shared plane. Slopes and means are those of the shapes, found by hand.
#include "test_main.h"

#include "water_fit.h"
#include "water_math.h"

static const double up_z[3] = { 0.0, 0.0, 1.0 };

static water_fit_plane plane_of(const double* corners, size_t triangles)
{
  water_fit fit;
  water_fit_plane plane;
  water_fit_begin(up_z, &fit);
  for (size_t i = 0; i < triangles; ++i)
  {
    const double* own = corners + 9 * i;
    water_fit_add(own, own + 3, own + 6, &fit);
  }
  assert_int_equal(water_fit_judge(&fit, &plane), WATER_OK);
  return plane;
}

// A triangle lies in its own plane, in whatever direction it is long.
TEST(a_slanted_triangle_keeps_its_slope)
{
  const double turns[] = { 0.0, 0.7, 1.9, 2.8 };
  for (size_t i = 0; i < sizeof turns / sizeof *turns; ++i)
  {
    const double shape[3][2] = { { 0.0, 0.0 }, { 4.0, 1.0 }, { 3.0, 1.5 } };
    double corners[9];
    for (int k = 0; k < 3; ++k)
    {
      double* own = corners + 3 * k;
      own[0] = cos(turns[i]) * shape[k][0] - sin(turns[i]) * shape[k][1];
      own[1] = sin(turns[i]) * shape[k][0] + cos(turns[i]) * shape[k][1];
      own[2] = 3.0 + 0.02 * own[0] - 0.05 * own[1];
    }
    const water_fit_plane plane = plane_of(corners, 1);
    assert_false(plane.is_level);
    ASSERT_CLOSE(-plane.normal[0] / plane.normal[2], 0.02, 1e-12);
    ASSERT_CLOSE(-plane.normal[1] / plane.normal[2], -0.05, 1e-12);
  }
}

// A canal 1000 long and a thousandth wide, in any direction. One end is 10 and 10.5 high, the other
// 0: along it, it rises by 10.25, and what is left is even on both of its sides.
TEST(a_slanted_canal_leans_along_itself_alone)
{
  for (int i = 0; i < 12; ++i)
  {
    const double angle = 0.1 + 0.5 * i;
    const double dir[2] = { cos(angle), sin(angle) };
    const double corners[9] = { 0.0, 0.0, 0.0, 1000.0 * dir[0] + 5e-4 * dir[1],
      1000.0 * dir[1] - 5e-4 * dir[0], 10.0, 1000.0 * dir[0] - 5e-4 * dir[1],
      1000.0 * dir[1] + 5e-4 * dir[0], 10.5 };
    const water_fit_plane plane = plane_of(corners, 1);
    assert_false(plane.is_level);
    ASSERT_CLOSE(-plane.normal[0] / plane.normal[2], 0.01025 * dir[0], 1e-7);
    ASSERT_CLOSE(-plane.normal[1] / plane.normal[2], 0.01025 * dir[1], 1e-7);
  }
}

// A pyramid, 1 high over a square at 7: the mean of its heights is a third, of their squares a
// sixth. It begins at its foot.
TEST(a_pyramid_is_level_at_its_mean)
{
  const double feet[4][3] = { { -1, -1, 7 }, { 1, -1, 7 }, { 1, 1, 7 }, { -1, 1, 7 } };
  double corners[36];
  for (int i = 0; i < 4; ++i)
  {
    const double top[3] = { 0.0, 0.0, 8.0 };
    memcpy(corners + 9 * i, feet[i], sizeof feet[i]);
    memcpy(corners + 9 * i + 3, feet[(i + 1) % 4], sizeof feet[i]);
    memcpy(corners + 9 * i + 6, top, sizeof top);
  }
  const water_fit_plane plane = plane_of(corners, 4);
  assert_true(plane.is_level);
  ASSERT_CLOSE(plane.origin[2], 7.0 + 1.0 / 3.0, 1e-14);
  ASSERT_CLOSE(plane.middle[2], 7.0 + 1.0 / 3.0, 1e-14);
  ASSERT_CLOSE(plane.rms, sqrt(1.0 / 6.0 - 1.0 / 9.0), 1e-14);
}

static water_fit_plane level_at(double height)
{
  const water_fit_plane made = { .normal = { 0.0, 0.0, 1.0 },
    .origin = { 0.0, 0.0, height },
    .middle = { 0.0, 0.0, height },
    .reach = 1.0 };
  return made;
}

// A part no farther than the tolerance joins the first such plane, although a later one is nearer.
TEST(a_part_at_the_tolerance_shares_the_plane)
{
  const water_fit_plane parts[3] = { level_at(0.0), level_at(1.5), level_at(1.0) };
  size_t plane[3];
  size_t first[3];
  assert_int_equal(water_fit_share(parts, 3, 1.0, 3, plane, first), 2);
  assert_int_equal(plane[2], 0);
  const water_fit_plane two[2] = { level_at(0.0), level_at(1.0) };
  assert_int_equal(water_fit_share(two, 2, 1.0, 2, plane, first), 1);
}

TEST(of_planes_at_one_distance_the_first_is_joined)
{
  const water_fit_plane parts[3] = { level_at(0.0), level_at(2.0), level_at(1.0) };
  size_t plane[3];
  size_t first[2];
  assert_int_equal(water_fit_share(parts, 3, 1.0, 2, plane, first), 2);
  assert_int_equal(plane[2], 0);
  assert_int_equal(water_fit_share(parts, 3, 0.9, 2, plane, first), 2);
  assert_int_equal(plane[2], 2);
}

TESTS(a_slanted_triangle_keeps_its_slope, a_slanted_canal_leans_along_itself_alone,
  a_pyramid_is_level_at_its_mean, a_part_at_the_tolerance_shares_the_plane,
  of_planes_at_one_distance_the_first_is_joined)
