// SPDX-License-Identifier: BSD-3-Clause
// test_frustum.c: boxes against half-spaces: to either side of the rounding that is allowed for.
#include "test_scene.h"

#include "water_frustum.h"

// A box is behind a plane if its furthest corner is, by more than the rounding of the numbers
// summed: of each axis the larger end counts, and the reach as often as the plane has entries.
TEST(behind_by_more_than_rounding)
{
  const double plane[4] = { 1.0, -2.0, 0.5, 0.0 };
  // furthest corner: x 3, y 7, z 2: 3 - 14 + 1 = -10; sizes: 4 + 2 * 9 + 0.5 * 8 = 26
  const double bounds[6] = { -4.0, 3.0, 7.0, 9.0, -8.0, 2.0 };
  assert_true(water_frustum_is_behind(plane, bounds, 0.0, 0.38));
  assert_false(water_frustum_is_behind(plane, bounds, 0.0, 0.39));
  // the reach 2 adds 3.5 * 2
  assert_true(water_frustum_is_behind(plane, bounds, 2.0, 0.30));
  assert_false(water_frustum_is_behind(plane, bounds, 2.0, 0.31));
  const double shifted[4] = { 1.0, -2.0, 0.5, -6.0 }; // -16 of 32
  assert_true(water_frustum_is_behind(shifted, bounds, 0.0, 0.49));
  assert_false(water_frustum_is_behind(shifted, bounds, 0.0, 0.5));
  assert_false(water_frustum_is_behind(shifted, bounds, 0.0, 0.51));
}

// A box that touches a plane is not behind it, nor is one whose sum overflows.
TEST(touching_is_not_behind)
{
  const double plane[4] = { 1.0, 0.0, 0.0, -3.0 };
  const double touching[6] = { -4.0, 3.0, 0.0, 1.0, 0.0, 1.0 };
  const double endless[6] = { -DBL_MAX, -DBL_MAX, -DBL_MAX, DBL_MAX, 0.0, 1.0 };
  const double steep[4] = { 2.0, 2.0, 0.0, 0.0 };
  assert_false(water_frustum_is_behind(plane, touching, 0.0, 0.0));
  assert_false(water_frustum_is_behind(steep, endless, 0.0, 0.0));
}

// Each of a frustum's planes divides off what is beyond it, and its number is told; five planes
// leave the far one out.
TEST(every_plane_divides)
{
  const water_scene scene =
    pool(1.0); // 45 degrees to each side, near 1, far 1000, looking down from 10
  const double box[4] = { -1.0, -1.0, 1.0, 1.0 };
  water_frustum frustum;
  water_frustum_make(&scene.eye, box, &frustum);
  const double beyond[6][6] = { { -21.0, -20.5, -1.0, 1.0, -1.0, 0.0 },
    { 20.5, 21.0, -1.0, 1.0, -1.0, 0.0 }, { -1.0, 1.0, -21.0, -20.5, -1.0, 0.0 },
    { -1.0, 1.0, 20.5, 21.0, -1.0, 0.0 }, { -0.1, 0.1, -0.1, 0.1, 9.5, 9.9 },
    { -1.0, 1.0, -1.0, 1.0, -1000.0, -995.0 } };
  for (int i = 0; i < 6; ++i)
  {
    assert_int_equal(water_frustum_divides(&frustum, 6, beyond[i], 1e-12), i);
    assert_false(water_frustum_meets(&frustum, 6, beyond[i], 1e-12));
    assert_int_equal(water_frustum_meets(&frustum, 5, beyond[i], 1e-12), i == 5);
  }
  const double inside[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 0.0 };
  assert_true(water_frustum_meets(&frustum, 6, inside, 1e-12));
  const double half[4] = { 0.0, -1.0, 1.0, 1.0 }; // the right half of the picture
  water_frustum_make(&scene.eye, half, &frustum);
  const double left[6] = { -3.0, -1.0, -1.0, 1.0, -1.0, 0.0 };
  assert_int_equal(water_frustum_divides(&frustum, 6, left, 1e-12), 0);
}

// What is behind a plane by less than rounding is not divided off: here by 0.05 of 1.95.
TEST(rounding_divides_nothing_off)
{
  water_frustum frustum = { { { 1.0, 0.0, 0.0, -1.0 } }, 0.0, { { 0 } } };
  const double hardly_behind[6] = { -0.5, 0.95, 0.0, 1.0, 0.0, 1.0 };
  water_frustum_prepare(&frustum);
  assert_int_equal(water_frustum_divides(&frustum, 6, hardly_behind, 0.1), -1);
  assert_int_equal(water_frustum_divides(&frustum, 6, hardly_behind, 0.01), 0);
}

// A box is held if its lowest corner is before each plane: at 1 + 2 + 3 - 4 = 2 of the slanted one.
// Each of its three coordinates can take it behind.
TEST(lowest_corner_decides_what_is_held)
{
  static const double box[6] = { 1.0, 5.0, 1.0, 5.0, 1.0, 5.0 };
  static const double lower[3] = { -2.0, -0.5, 0.0 };
  for (int i = 0; i < 6; ++i)
  {
    water_frustum frustum;
    memset(&frustum, 0, sizeof frustum); // the other planes are touched
    const double plane[4] = { 1.0, 2.0, 3.0, -4.0 };
    memcpy(frustum.planes[i], plane, sizeof plane);
    water_frustum_prepare(&frustum);
    assert_true(water_frustum_holds(&frustum, box));
    for (int axis = 0; axis < 3; ++axis)
    {
      double moved[6];
      memcpy(moved, box, sizeof moved);
      moved[2 * axis] = lower[axis];
      assert_false(water_frustum_holds(&frustum, moved));
    }
  }
}

// Of a view in NDC the sides are those of the part of the picture, before and behind it -1 and 1.
TEST(sides_are_those_of_the_part)
{
  const water_camera camera = { .world_to_view = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },
    .view_to_clip = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
  const double box[4] = { -0.5, -0.25, 0.125, 0.75 };
  const double expected[6][4] = { { 1, 0, 0, 0.5 }, { -1, 0, 0, 0.125 }, { 0, 1, 0, 0.25 },
    { 0, -1, 0, 0.75 }, { 0, 0, 1, 1 }, { 0, 0, -1, 1 } };
  water_frustum made;
  water_frustum_make(&camera, box, &made);
  for (int i = 0; i < 24; ++i)
  {
    assert_true(made.planes[i / 4][i % 4] == expected[i / 4][i % 4]);
  }
}

TESTS(behind_by_more_than_rounding, touching_is_not_behind, every_plane_divides,
  rounding_divides_nothing_off, lowest_corner_decides_what_is_held, sides_are_those_of_the_part)
