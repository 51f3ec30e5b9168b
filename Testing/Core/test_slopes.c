// SPDX-License-Identifier: BSD-3-Clause
// test_slopes.c: how steep a user's surface is against the plane, and what its vertices need.
#include "test_scene.h"

#include "water_flatness.h"
#include "water_slopes.h"

static const water_plane level = { { 0.0, 0.0, 1.0 }, -3.0 };

static double rms_of(const double corners[][3], int triangles)
{
  water_slopes slopes;
  water_slopes_begin(&level, &slopes);
  for (int i = 0; i < triangles; ++i)
  {
    water_slopes_add(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2], &slopes);
  }
  return water_slopes_rms(&slopes);
}

// By the area over the plane: 3 of slope 0.1 and 1 of 0.4.
TEST(slopes_are_weighed_by_area)
{
  const double corners[6][3] = { { 0, 0, 9 }, { 2, 0, 9.2 }, { 0, 3, 9 }, { 0, 0, 0 }, { 2, 0, 0 },
    { 0, -1, -0.4 } };
  ASSERT_CLOSE(rms_of(corners, 1), 0.1, 1e-12);
  ASSERT_CLOSE(rms_of(corners, 2), sqrt((3 * 0.01 + 0.16) / 4), 1e-12);
}

// Either side may be up; what has no area has no slope; a wall is steep, and not infinitely so.
TEST(any_triangle_has_a_slope)
{
  const double turned[3][3] = { { 2, 0, 0.2 }, { 0, 0, 0 }, { 0, 3, 0 } };
  const double point[3][3] = { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } };
  const double wall[3][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 1 } };
  const double broken[3][3] = { { 0, 0, 0 }, { (double)NAN, 0, 0 }, { 0, 0, 1 } };
  ASSERT_CLOSE(rms_of(turned, 1), 0.1, 1e-12);
  ASSERT_CLOSE(rms_of(point, 1), 0.0, 0.0);
  ASSERT_CLOSE(rms_of(wall, 1), 10.0, 1e-12);
  ASSERT_CLOSE(rms_of(broken, 1), 0.0, 0.0);
  ASSERT_CLOSE(water_slopes_together(0.3, 0.4), 0.5, 1e-12);
  assert_false(water_slopes_are_seen(1e-4));
  assert_true(water_slopes_are_seen(1.01e-4));
}

// Vertices as a GPU has them find their places and heights along the plane's axes.
TEST(vertices_know_their_places)
{
  dice seed = dice_seeded(7);
  for (int trial = 0; trial < 200; ++trial)
  {
    water_plane unit;
    dice_dir(&seed, unit.normal);
    unit.offset = dice_roll(&seed, -5, 5);
    double to_world[16] = { 0.0 };
    double bounds[6];
    double origin_xy[2];
    double shift[3];
    double scale[3];
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        to_world[4 * i + j] = dice_roll(&seed, -2, 2);
      }
      to_world[5 * i] += 4.0;
      bounds[2 * i] = dice_roll(&seed, -9, 0);
      bounds[2 * i + 1] = bounds[2 * i] + 5.0;
      shift[i] = dice_roll(&seed, -9, 9);
      scale[i] = dice_roll(&seed, 0.1, 3);
      point[i] = dice_roll(&seed, -9, 9);
      origin_xy[i % 2] = dice_roll(&seed, -9, 9);
    }
    to_world[15] = 1.0;
    water_axes axes;
    double on_plane[3] = { -unit.offset * unit.normal[0], -unit.offset * unit.normal[1],
      -unit.offset * unit.normal[2] };
    water_lookup_axes(&unit, WATER_ABOVE, on_plane, &axes);
    for (int i = 0; i < 3; ++i) // the axes begin beside the world's origin
    {
      on_plane[i] += 2.0 * axes.x_dir[i] - 3.0 * axes.y_dir[i];
    }
    water_lookup_axes(&unit, WATER_ABOVE, on_plane, &axes);
    double across[4];
    double down[4];
    double origin[3];
    double rise[4];
    double height[4];
    assert_true(water_flatness_heights(&unit, to_world, height));
    water_flatness_vertices(height, WATER_ABOVE, bounds, shift, scale, origin, rise);
    water_slopes_places(&axes, origin_xy, to_world, across, down);
    water_flatness_row(across, shift, scale, origin, across);
    water_flatness_row(down, shift, scale, origin, down);
    double world[4];
    apply(to_world, point, 1.0, world);
    double off[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      off[i] = (point[i] - shift[i]) * scale[i] - origin[i];
      world[i] -= on_plane[i];
    }
    double found[2] = { 0.0, 0.0 };
    for (int i = 0; i < 4; ++i)
    {
      found[0] += across[i] * off[i];
      found[1] += down[i] * off[i];
    }
    ASSERT_CLOSE(found[0], dot(axes.x_dir, world) - origin_xy[0], 1e-9);
    ASSERT_CLOSE(found[1], dot(axes.y_dir, world) - origin_xy[1], 1e-9);
  }
}

// A normal stays at right angles to its triangle, whatever a matrix does to that.
TEST(normals_stay_normal)
{
  dice seed = dice_seeded(8);
  for (int trial = 0; trial < 200; ++trial)
  {
    double to_world[16] = { 0.0 };
    double sides[2][3];
    water_plane unit;
    dice_dir(&seed, unit.normal);
    unit.offset = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        to_world[4 * i + j] = dice_roll(&seed, -1, 1) + (i == j ? 3.0 : 0.0);
      }
      to_world[4 * i + 3] = dice_roll(&seed, -9, 9); // moves no normal
      sides[0][i] = dice_roll(&seed, -1, 1);
      sides[1][i] = dice_roll(&seed, -1, 1);
    }
    to_world[15] = 1.0;
    double normal[3];
    cross(sides[0], sides[1], normal);
    water_axes axes;
    const double nowhere[3] = { 0.0, 0.0, 0.0 };
    water_lookup_axes(&unit, WATER_BELOW, nowhere, &axes);
    double rows[9];
    water_slopes_normals(&axes, to_world, rows);
    double found[3];
    for (int i = 0; i < 3; ++i)
    {
      found[i] = dot(rows + 3 * i, normal);
    }
    for (int k = 0; k < 2; ++k)
    {
      double world[4];
      apply(to_world, sides[k], 0.0, world);
      const double local[3] = { dot(axes.x_dir, world), dot(axes.y_dir, world),
        dot(axes.normal, world) };
      ASSERT_CLOSE(dot(local, found), 0.0, 1e-9);
    }
    assert_true(dot(found, found) > 0.0);
  }
  const double flat[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  const double wide[16] = { 2, 0, 0, 7, 0, 4, 0, 8, 0, 0, 5, 9, 0, 0, 0, 1 };
  water_axes axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } };
  double rows[9];
  water_slopes_normals(&axes, wide, rows); // they keep their side
  for (int i = 0; i < 9; ++i)
  {
    const double by[3] = { 0.5, 0.25, 0.2 };
    ASSERT_CLOSE(rows[i], i % 4 == 0 ? by[i / 4] : 0.0, 1e-15);
  }
  water_slopes_normals(&axes, flat, rows);
  for (int i = 0; i < 9; ++i)
  {
    assert_true(rows[i] == 0.0);
  }
}

// A polygon is the fan about its first corner; a matrix moves it; parts are joined.
TEST(polygons_are_fans)
{
  const double points[15] = { 0, 0, 0, 2, 0, 0.2, 3, 2, 0.9, 1, 3, 0.1, 0, 2, -0.3 };
  const int64_t corners[5] = { 4, 0, 1, 2, 3 };
  const double places[9][3] = { { 0, 2, -0.3 }, { 0, 0, 0 }, { 2, 0, 0.2 }, { 0, 2, -0.3 },
    { 2, 0, 0.2 }, { 3, 2, 0.9 }, { 0, 2, -0.3 }, { 3, 2, 0.9 }, { 1, 3, 0.1 } };
  const double wide[16] = { 2, 0, 0, 5, 0, 2, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1 };
  water_slopes slopes;
  water_slopes_begin(&level, &slopes);
  water_slopes_add_polygon(points, corners, 5, NULL, &slopes);
  ASSERT_CLOSE(water_slopes_rms(&slopes), rms_of(places, 3), 0.0);
  water_slopes moved;
  water_slopes_begin(&level, &moved);
  water_slopes_add_polygon(points, corners, 5, wide, &moved);
  ASSERT_CLOSE(water_slopes_rms(&moved), 0.5 * rms_of(places, 3), 1e-12);
  water_slopes_add_polygon(points, corners, 2, wide, &moved); // no triangle
  ASSERT_CLOSE(water_slopes_rms(&moved), 0.5 * rms_of(places, 3), 1e-12);
  water_slopes both;
  water_slopes_begin(&level, &both);
  water_slopes_add(places[0], places[1], places[2], &both);
  water_slopes rest;
  water_slopes_begin(&level, &rest);
  water_slopes_add(places[3], places[4], places[5], &rest);
  water_slopes_add(places[6], places[7], places[8], &rest);
  water_slopes_join(&rest, &both);
  ASSERT_CLOSE(water_slopes_rms(&both), water_slopes_rms(&slopes), 1e-15);
}

// Triangles without an area, and those whose area is no number, change nothing of the others.
TEST(triangles_without_a_size_do_not_count)
{
  const double corners[9][3] = { { 0, 0, 0 }, { 2, 0, 0.2 }, { 0, 3, 0 }, { 1, 1, 1 }, { 1, 1, 1 },
    { 1, 1, 1 }, { 0, 0, 0 }, { 1e200, 0, 0 }, { 0, 1e200, 0 } };
  ASSERT_CLOSE(rms_of(corners, 3), 0.1, 1e-12);
}

TESTS(triangles_without_a_size_do_not_count, slopes_are_weighed_by_area, any_triangle_has_a_slope,
  vertices_know_their_places, normals_stay_normal, polygons_are_fans)
