// SPDX-License-Identifier: BSD-3-Clause
// test_seen.c: how much of the picture waters cover, and which of many have a mirrored view.
#include "test_main.h"
#include "test_scene.h"

#include "water_seen.h"

static const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };

static water_camera over_the_water(void)
{
  const double eye[3] = { 0.0, -20.0, 10.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  water_camera camera = { { 0.0 } };
  look_at(eye, target, up, camera.world_to_view);
  const double box[4] = { -0.36, 0.36, -0.36, 0.36 };
  frustum_matrix(box, 1.0, 100.0, camera.view_to_clip);
  return camera;
}

TEST(what_is_nearer_or_larger_covers_more)
{
  const water_camera eye = over_the_water();
  const double near_box[6] = { -1, 1, -3, -1, 0, 0 };
  const double far_box[6] = { -1, 1, 3, 5, 0, 0 };
  const double large[6] = { -3, 3, -3, 3, 0, 0 };
  const double behind[6] = { -1, 1, -60, -50, 0, 0 };
  const double none[6] = { 1, -1, 1, -1, 1, -1 };
  const double all[6] = { -900, 900, -900, 900, 0, 0 };
  const double share = water_seen_share(&eye, &level, near_box);
  assert_true(share > water_seen_share(&eye, &level, far_box));
  assert_true(water_seen_share(&eye, &level, far_box) > 0.0);
  assert_true(water_seen_share(&eye, &level, large) > share);
  ASSERT_CLOSE(water_seen_share(&eye, &level, behind), 0.0, 0.0);
  ASSERT_CLOSE(water_seen_share(&eye, &level, none), 0.0, 0.0);
  assert_true(water_seen_share(&eye, &level, all) <= 1.0);
}

// Parts far apart cover what each of them covers, also of a mesh that is moved.
TEST(parts_have_boxes_of_their_own)
{
  const water_camera eye = over_the_water();
  const double boxes[3][6] = { { -5, -4, -1, 1, 0, 0 }, { 4, 5, -1, 1, 0, 0 },
    { -1, 1, -60, -50, 0, 0 } };
  const double moved[3][6] = { { -12, -11, -2, 0, 0, 0 }, { -3, -2, -2, 0, 0, 0 },
    { -8, -6, -61, -51, 0, 0 } };
  const double all[6] = { -5, 5, -1, 1, 0, 0 };
  const double to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double shift[16] = { 1, 0, 0, 7, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double sum =
    water_seen_share(&eye, &level, boxes[0]) + water_seen_share(&eye, &level, boxes[1]);
  const double share = water_seen_share_of_parts(&eye, &level, boxes[0], 3, to_world);
  assert_true(share > 0.0 && share < 0.5 * water_seen_share(&eye, &level, all));
  ASSERT_CLOSE(share, sum, 1e-12);
  ASSERT_CLOSE(water_seen_share_of_parts(&eye, &level, moved[0], 3, shift), sum, 1e-12);
  ASSERT_CLOSE(water_seen_share_of_parts(&eye, &level, boxes[0], 0, to_world), 0.0, 0.0);
  const double aside[2][6] = { { -900, -890, -1, 1, 0, 0 }, { 890, 900, -1, 1, 0, 0 } };
  const double between = water_seen_share_of_parts(&eye, &level, aside[0], 2, to_world);
  assert_true(between > 0.0 && between < 1e-6 * share);
  const double wide[2][6] = { { -900, 900, -900, 900, 0, 0 }, { -900, 900, -900, 900, 0, 0 } };
  assert_true(water_seen_share_of_parts(&eye, &level, wide[0], 2, to_world) <= 1.0);
}

TEST(the_largest_have_a_mirrored_view)
{
  const double shares[6] = { 0.1, 0.0, 0.3, 0.1, 0.2, 0.05 };
  bool has_view[6];
  water_seen_choose(shares, 6, 3, has_view);
  const bool three[6] = { true, true, true, false, true, false };
  for (int i = 0; i < 6; ++i)
  {
    assert_true(has_view[i] == three[i]);
  }
  water_seen_choose(shares, 6, 6, has_view);
  for (int i = 0; i < 6; ++i)
  {
    assert_true(has_view[i]);
  }
}

// The distance is that from the plane, whatever its scale and the eye's side; a plane without a
// normal has none.
TEST(distances_are_from_the_plane)
{
  const water_plane plane = { { 0.0, 3.0, 4.0 }, -10.0 };
  const water_plane none = { { 0.0, 0.0, 0.0 }, 1.0 };
  const double eye[3] = { 7.0, 6.0, 8.0 };
  const double under[3] = { 7.0, -6.0, -8.0 };
  ASSERT_CLOSE(water_seen_distance(&plane, eye), 8.0, 1e-12);
  ASSERT_CLOSE(water_seen_distance(&plane, under), 12.0, 1e-12);
  ASSERT_CLOSE(water_seen_distance(&none, eye), 0.0, 0.0);
}

// A box that is not finite, and a plane without a normal, are out of view.
TEST(what_has_no_place_is_not_seen)
{
  const water_camera eye = over_the_water();
  const double right[6] = { -3, 3, -3, 3, 0, 0 };
  const double endless[6] = { -3, (double)INFINITY, -3, 3, 0, 0 };
  const water_plane none = { { 0.0, 0.0, 0.0 }, 0.0 };
  assert_true(water_seen_share(&eye, &level, right) > 0.0);
  ASSERT_CLOSE(water_seen_share(&eye, &level, endless), 0.0, 0.0);
  ASSERT_CLOSE(water_seen_share(&eye, &none, right), 0.0, 0.0);
}

TESTS(what_has_no_place_is_not_seen, what_is_nearer_or_larger_covers_more,
  parts_have_boxes_of_their_own, the_largest_have_a_mirrored_view, distances_are_from_the_plane)
