// SPDX-License-Identifier: BSD-3-Clause
// test_plane.c: the plane, its mirror, its axes and its sheet.
#include "test_scene.h"

#include "water_plane.h"

static const double far_away[3] = { 5e6, -4e6, 300.0 };

// z = 3 written with a normal of any length: a point at z = 5 is 2 above it.
TEST(heights_are_distances_for_normals_of_any_length)
{
  const double lengths[4] = { 1.0, 2.0, 1e-200, 1e200 };
  const double point[3] = { 7.0, -8.0, 5.0 };
  for (int i = 0; i < 4; ++i)
  {
    const water_plane plane = { { 0.0, 0.0, lengths[i] }, -3.0 * lengths[i] };
    water_plane unit;
    assert_int_equal(water_plane_normalise(&plane, &unit), WATER_OK);
    ASSERT_CLOSE(unit.normal[2], 1.0, 1e-15);
    ASSERT_CLOSE(water_plane_height(&unit, point), 2.0, 1e-14);
  }
}

// No direction or no finite number: no plane, and the output is left alone.
TEST(planes_without_direction_are_refused)
{
  const double bad = (double)NAN;
  const double huge = (double)INFINITY;
  const water_plane cases[] = { { { 0.0, 0.0, 0.0 }, 1.0 }, { { bad, 0.0, 1.0 }, 0.0 },
    { { 0.0, bad, 1.0 }, 0.0 }, { { 0.0, 0.0, huge }, 0.0 }, { { 0.0, 0.0, 1.0 }, bad },
    { { 0.0, 0.0, 1.0 }, huge }, { { 0.0, 0.0, 1e-300 }, 1e300 } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_plane unit = { { 1.0, 2.0, 3.0 }, 4.0 };
    assert_int_equal(water_plane_normalise(&cases[i], &unit), WATER_BAD_PLANE);
    assert_true(unit.normal[0] == 1.0 && unit.offset == 4.0);
  }
}

// Mirrored at z = 3, the point (1, 2, 5) is (1, 2, 1).
TEST(mirror_sends_a_known_point_where_it_belongs)
{
  const water_plane unit = { { 0.0, 0.0, 1.0 }, -3.0 };
  const double point[3] = { 1.0, 2.0, 5.0 };
  double mirror[16];
  double image[4];
  water_plane_mirror_matrix(&unit, mirror);
  apply(mirror, point, 1.0, image);
  assert_true(image[0] == 1.0 && image[1] == 2.0 && image[2] == 1.0 && image[3] == 1.0);
}

// A point and its image have the plane halfway between them and the normal as their direction;
// mirroring twice is nothing; a mirror turns right hands into left ones (determinant -1).
TEST(mirror_is_a_reflection_at_any_plane)
{
  dice from = dice_seeded(2);
  for (int round = 0; round < 1000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, far_away);
    water_plane unit;
    double mirror[16];
    double point[3];
    double image[4];
    double again[4];
    double apart[3];
    double middle[3];
    double across[3];
    assert_int_equal(water_plane_normalise(&random.scene.plane, &unit), WATER_OK);
    water_plane_mirror_matrix(&unit, mirror);
    point_near(&from, &random, 50.0, point);
    apply(mirror, point, 1.0, image);
    apply(mirror, image, 1.0, again);
    for (int i = 0; i < 3; ++i)
    {
      apart[i] = image[i] - point[i];
      middle[i] = 0.5 * (image[i] + point[i]);
      ASSERT_CLOSE(again[i], point[i], 1e-7);
    }
    cross(apart, random.normal, across);
    ASSERT_CLOSE(sqrt(dot(across, across)), 0.0, 1e-7);
    ASSERT_CLOSE(height_of(&random, middle), 0.0, 1e-7);
    ASSERT_CLOSE(determinant3(mirror), -1.0, 1e-14);
  }
}

// A level sheet has the world's axes; a wall facing x takes the world's y; one facing y the world's
// x.
TEST(axes_of_known_planes)
{
  const double normals[4][3] = { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -0.6, 0, 0.8 } };
  const double xs[4][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0.8, 0, 0.6 } };
  const double ys[4][3] = { { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 0, 1, 0 } };
  for (int number = 0; number < 4; ++number)
  {
    double x_dir[3];
    double y_dir[3];
    water_plane_axes(normals[number], x_dir, y_dir);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(x_dir[i], xs[number][i], 1e-15);
      ASSERT_CLOSE(y_dir[i], ys[number][i], 1e-15);
    }
  }
}

// Axes of any plane: unit length, in the plane, right-handed with the normal, and never near a
// degenerate choice: x_dir stays within 45 degrees of the axis it was made from.
TEST(axes_are_a_right_handed_frame)
{
  dice from = dice_seeded(3);
  for (int round = 0; round < 1000; ++round)
  {
    double frame[16] = { 0.0 };
    double normal[3];
    dice_dir(&from, normal);
    water_plane_axes(normal, frame, frame + 4);
    memcpy(frame + 8, normal, sizeof normal);
    ASSERT_CLOSE(dot(frame, frame), 1.0, 1e-14);
    ASSERT_CLOSE(dot(frame, normal), 0.0, 1e-14);
    ASSERT_CLOSE(determinant3(frame), 1.0, 1e-14);
    assert_true(fmax(frame[0], frame[1]) > 0.707);
  }
}

// Over a level plane the sheet of a box is the box's own floor, counted from the origin.
TEST(sheet_of_a_level_plane_is_the_floor_of_the_box)
{
  const double origin[3] = { 100.0, 200.0, 7.0 };
  const double x_dir[3] = { 1.0, 0.0, 0.0 };
  const double y_dir[3] = { 0.0, 1.0, 0.0 };
  const double bounds[6] = { 90.0, 130.0, 195.0, 260.0, -5.0, 5.0 };
  const double expected[12] = { 90, 195, 7, 130, 195, 7, 130, 260, 7, 90, 260, 7 };
  double sheet[4];
  double corners[12];
  assert_int_equal(water_sheet_bounds(origin, x_dir, y_dir, bounds, sheet), WATER_OK);
  water_sheet_corners(origin, x_dir, y_dir, sheet, corners);
  for (int i = 0; i < 12; ++i)
  {
    ASSERT_CLOSE(corners[i], expected[i], 1e-12);
  }
}

// Over any plane the sheet covers the box (no point of it projects outside), touches it on all four
// sides, lies in the plane, and turns counter-clockwise about the normal.
TEST(sheet_of_any_plane_covers_the_box_tightly)
{
  dice from = dice_seeded(4);
  for (int round = 0; round < 500; ++round)
  {
    const random_scene random = scene_rolled(&from, round, far_away);
    const double* box = random.scene.surface_bounds;
    double x_dir[3];
    double y_dir[3];
    double sheet[4];
    double corners[12];
    double first[3];
    double second[3];
    double turn[3];
    double extreme[4] = { 1e9, -1e9, 1e9, -1e9 };
    water_plane_axes(random.normal, x_dir, y_dir);
    assert_int_equal(water_sheet_bounds(random.target, x_dir, y_dir, box, sheet), WATER_OK);
    for (int number = 0; number < 8; ++number)
    {
      const double arm[3] = { box[number & 1] - random.target[0],
        box[2 + ((number >> 1) & 1)] - random.target[1],
        box[4 + ((number >> 2) & 1)] - random.target[2] };
      extreme[0] = fmin(extreme[0], dot(arm, x_dir));
      extreme[1] = fmax(extreme[1], dot(arm, x_dir));
      extreme[2] = fmin(extreme[2], dot(arm, y_dir));
      extreme[3] = fmax(extreme[3], dot(arm, y_dir));
    }
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(sheet[i], extreme[i], 1e-9);
    }
    water_sheet_corners(random.target, x_dir, y_dir, sheet, corners);
    for (int i = 0; i < 3; ++i)
    {
      first[i] = corners[3 + i] - corners[i];
      second[i] = corners[6 + i] - corners[3 + i];
    }
    cross(first, second, turn);
    const double area = (sheet[1] - sheet[0]) * (sheet[3] - sheet[2]);
    ASSERT_CLOSE(dot(turn, random.normal), area, 1e-6 * area);
    ASSERT_CLOSE(height_of(&random, corners + 9), 0.0, 1e-8);
  }
}

// Bounds that are empty or not finite make no sheet, nor do such whose sheet is not finite.
TEST(sheet_needs_bounds)
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double x_dir[3] = { 0.8, 0.6, 0.0 };
  const double y_dir[3] = { -0.6, 0.8, 0.0 };
  const double cases[5][6] = { { 1, -1, 1, -1, 1, -1 }, { 0, 1.5e308, 0, 1.5e308, 0, 1 },
    { 0, 1, 0, 1, 3, 2 }, { 0, (double)INFINITY, 0, 1, 0, 1 }, { 0, 1, (double)NAN, 1, 0, 1 } };
  for (int number = 0; number < 5; ++number)
  {
    double sheet[4] = { 5.0, 6.0, 7.0, 8.0 };
    assert_int_equal(
      water_sheet_bounds(origin, x_dir, y_dir, cases[number], sheet), WATER_BAD_SURFACE);
    assert_true(sheet[0] == 5.0 && sheet[3] == 8.0);
  }
}

// The nearest point of a plane lies on it, straight below the point; a point of the plane stays.
TEST(projection_is_the_nearest_point)
{
  const water_plane tilted = { { 2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0 }, -9.0 };
  const double point[3] = { 12.0, 6.0, 12.0 }; // 9 above the foot (6, 3, 6)
  double foot[3];
  water_plane_project(&tilted, point, foot);
  ASSERT_CLOSE(foot[0], 6.0, 1e-14);
  ASSERT_CLOSE(foot[1], 3.0, 1e-14);
  ASSERT_CLOSE(foot[2], 6.0, 1e-14);
  water_plane_project(&tilted, foot, foot);
  ASSERT_CLOSE(foot[0], 6.0, 1e-14);
}

// Whatever moves within its reach stays within the bounds, and some of it touches them.
TEST(displaced_bounds_hold_what_moves)
{
  dice from = dice_seeded(29);
  const double bounds[6] = { -1.0, 2.0, -3.0, 4.0, 5.0, 5.5 };
  for (int round = 0; round < 1000; ++round)
  {
    water_plane unit = { { 0.0, 0.0, 0.0 }, 0.0 };
    dice_dir(&from, unit.normal);
    const double height = dice_roll(&from, 0.0, 1.0);
    const double reach = dice_roll(&from, 0.0, 1.0);
    double wide[6];
    water_plane_displaced_bounds(&unit, bounds, height, reach, wide);
    double x_dir[3];
    double y_dir[3];
    water_plane_axes(unit.normal, x_dir, y_dir);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double way = height * fabs(unit.normal[axis]) + reach * hypot(x_dir[axis], y_dir[axis]);
      ASSERT_CLOSE(wide[2 * axis], bounds[2 * axis] - way, 1e-12);
      ASSERT_CLOSE(wide[2 * axis + 1], bounds[2 * axis + 1] + way, 1e-12);
    }
  }
}

// Planes are identical if they are bit by bit the same at unit length; a plane that is none is not
// even identical to itself.
TEST(identical_planes_are_the_same_to_the_last_bit)
{
  const water_plane one = { { 1.0, 2.0, 2.0 }, -6.0 };
  const water_plane longer = { { 4.0, 8.0, 8.0 }, -24.0 };
  assert_true(water_plane_is_identical(&one, &one));
  assert_true(water_plane_is_identical(&one, &longer));
  for (int i = 0; i < 8; ++i)
  {
    water_plane other = longer;
    double* entry = i % 4 < 3 ? &other.normal[i % 4] : &other.offset;
    *entry = i < 4 ? *entry * (1.0 + 4.0 * DBL_EPSILON) : (double)NAN;
    assert_false(water_plane_is_identical(&one, &other));
    assert_false(water_plane_is_identical(&other, &one));
    assert_int_equal(water_plane_is_identical(&other, &other), i < 4);
  }
  for (int i = 0; i < 4; ++i)
  {
    water_plane other = one;
    *(i < 3 ? &other.normal[i] : &other.offset) *= -1.0;
    assert_false(water_plane_is_identical(&one, &other));
  }
  const water_plane turned = { { -1.0, -2.0, -2.0 }, 6.0 };
  assert_false(water_plane_is_identical(&one, &turned));
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  assert_false(water_plane_is_identical(&none, &none));
}

// Planes are shared, either way round, if they pass each other by no more than rounding where their
// origins are; a plane that is none is not even shared with itself.
TEST(shared_planes_are_the_same_to_rounding)
{
  const double reach = 1e6;
  dice from = dice_seeded(31);
  for (int round = 0; round < 1000; ++round)
  {
    double normal[3];
    double origin[3];
    water_plane planes[4];
    dice_dir(&from, normal);
    for (int i = 0; i < 3; ++i)
    {
      origin[i] = dice_roll(&from, -reach, reach);
    }
    for (int i = 0; i < 4; ++i)
    {
      const double scale = (i == 1 ? -1.0 : 1.0) * dice_roll(&from, 0.1, 10.0);
      for (int j = 0; j < 3; ++j)
      {
        planes[i].normal[j] = scale * (normal[j] + (i == 2 && j == round % 3 ? 1e-13 : 0.0));
      }
      planes[i].offset = -dot(planes[i].normal, origin) + (i == 3 ? scale * 1e-7 : 0.0);
    }
    assert_true(water_plane_is_shared(&planes[0], origin, &planes[1], origin));
    assert_false(water_plane_is_shared(&planes[0], origin, &planes[3], origin));
    assert_false(water_plane_is_shared(&planes[3], origin, &planes[0], origin));
    double side[3]; // as long as the sine of the angle that it was turned by
    cross(normal, planes[2].normal, side);
    if (sqrt(dot(side, side)) > 5e-14 * sqrt(dot(planes[2].normal, planes[2].normal)))
    {
      assert_false(water_plane_is_shared(&planes[0], origin, &planes[2], origin));
    }
  }
  // the farther of the two origins, too, says how far the planes are looked at
  const water_plane level = { { 0.0, 0.0, 1.0 }, -1.0 };
  const water_plane above = { { 0.0, 0.0, 1.0 }, -1.0 - 1e-12 };
  const double near_by[3] = { 0.0, 0.0, 1.0 };
  const double far_off[3] = { 1e6, 0.0, 1.0 };
  assert_false(water_plane_is_shared(&level, near_by, &above, near_by));
  assert_true(water_plane_is_shared(&level, far_off, &above, near_by));
  assert_true(water_plane_is_shared(&level, near_by, &above, far_off));
  // 16 epsilons of the normal, and of the reach, are rounding still
  const double most = 16.0 * DBL_EPSILON;
  const water_plane through = { { 0.0, 0.0, 1.0 }, 0.0 };
  for (int i = 16; i <= 17; ++i)
  {
    const water_plane turned = { { i * DBL_EPSILON, 0.0, 1.0 }, 0.0 };
    const water_plane lifted = { { 0.0, 0.0, 1.0 }, 8.0 * i * DBL_EPSILON };
    assert_int_equal(water_plane_is_same(&through, &turned, 8.0), i * DBL_EPSILON <= most);
    assert_int_equal(water_plane_is_same(&through, &lifted, 8.0), i * DBL_EPSILON <= most);
  }
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  assert_false(water_plane_is_shared(&none, near_by, &none, near_by));
  assert_false(water_plane_is_shared(&level, near_by, &none, near_by));
}

// North is the plane's second axis and east its first: a compass, and the zenith along the normal.
TEST(sky_directions_are_those_of_a_compass)
{
  const double level[3] = { 0.0, 0.0, 1.0 };
  const double quarter = 0.5 * 3.14159265358979323846;
  const double cases[4][5] = { { 0.0, 0.0, 0.0, 1.0, 0.0 }, { quarter, 0.0, 1.0, 0.0, 0.0 },
    { 1.0, quarter, 0.0, 0.0, 1.0 }, { -quarter, 0.5 * quarter, -sqrt(0.5), 0.0, sqrt(0.5) } };
  for (int i = 0; i < 4; ++i)
  {
    double direction[3];
    water_plane_sky_direction(level, cases[i][0], cases[i][1], direction);
    for (int j = 0; j < 3; ++j)
    {
      ASSERT_CLOSE(direction[j], cases[i][2 + j], 1e-15);
    }
  }
}

// In any plane's own axes a direction has its sines and cosines as parts, and unit length.
TEST(sky_directions_stand_in_the_planes_own_axes)
{
  dice from = dice_seeded(32);
  for (int round = 0; round < 1000; ++round)
  {
    double normal[3];
    double x_dir[3];
    double y_dir[3];
    double direction[3];
    dice_dir(&from, normal);
    const double azimuth = dice_roll(&from, -7.0, 7.0);
    const double elevation = dice_roll(&from, -1.5, 1.5);
    water_plane_axes(normal, x_dir, y_dir);
    water_plane_sky_direction(normal, azimuth, elevation, direction);
    ASSERT_CLOSE(dot(direction, direction), 1.0, 1e-14);
    ASSERT_CLOSE(dot(direction, normal), sin(elevation), 1e-14);
    ASSERT_CLOSE(dot(direction, x_dir), sin(azimuth) * cos(elevation), 1e-14);
    ASSERT_CLOSE(dot(direction, y_dir), cos(azimuth) * cos(elevation), 1e-14);
  }
}

// The sheet is over the box for a plane of any scale, and nothing is written without one.
TEST(sheet_around_takes_planes_of_any_scale)
{
  const double origin[3] = { 1.0, 2.0, 3.0 };
  const double bounds[6] = { 0.0, 4.0, 0.0, 2.0, 0.0, 5.0 };
  const double right[4] = { -1.0, 3.0, -2.0, 0.0 };
  const water_plane plane = { { 0.0, 0.0, 2.0 }, -6.0 };
  double sheet[4] = { 7.0, 7.0, 7.0, 7.0 };
  assert_int_equal(water_sheet_around(&plane, origin, bounds, sheet), WATER_OK);
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_CLOSE(sheet[i], right[i], 1e-12);
  }
  const water_plane none = { { 0.0, 0.0, 0.0 }, 1.0 };
  const double empty[6] = { 4.0, 0.0, 0.0, 2.0, 0.0, 5.0 };
  assert_int_equal(water_sheet_around(&none, origin, bounds, sheet), WATER_BAD_PLANE);
  assert_int_equal(water_sheet_around(&plane, origin, empty, sheet), WATER_BAD_SURFACE);
  ASSERT_CLOSE(sheet[0], right[0], 1e-12);
}

TESTS(sheet_around_takes_planes_of_any_scale, heights_are_distances_for_normals_of_any_length,
  planes_without_direction_are_refused, mirror_sends_a_known_point_where_it_belongs,
  mirror_is_a_reflection_at_any_plane, axes_of_known_planes, axes_are_a_right_handed_frame,
  sheet_of_a_level_plane_is_the_floor_of_the_box, sheet_of_any_plane_covers_the_box_tightly,
  sheet_needs_bounds, projection_is_the_nearest_point, displaced_bounds_hold_what_moves,
  identical_planes_are_the_same_to_the_last_bit, shared_planes_are_the_same_to_rounding,
  sky_directions_are_those_of_a_compass, sky_directions_stand_in_the_planes_own_axes)
