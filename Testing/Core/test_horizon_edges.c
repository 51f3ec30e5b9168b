// SPDX-License-Identifier: BSD-3-Clause
// test_horizon_edges.c: sheets that are cut through corners or away, eyes at the waves' height or
// on the plane, and views whose eye is not the camera's origin.
#include "test_scene.h"

#include "water_horizon.h"

// Straight down from 10: the picture is a square of the plane.
static water_scene above(void)
{
  return pool(10.0);
}

static int corners_of(const water_horizon* horizon)
{
  int count = 0;
  for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
  {
    count += horizon->counts[part];
  }
  return count;
}

// A line through two corners of the picture leaves a triangle with half of its area, whichever side
// is kept.
TEST(a_diagonal_leaves_a_triangle)
{
  const water_scene scene = above();
  const double end = 10.0 * (1.0 + 1.0 / 128.0);
  for (int turn = 0; turn < 4; ++turn)
  {
    const double kept[4] = { turn & 1 ? -1.0 : 1.0, turn & 2 ? -1.0 : 1.0, 0.0, 0.0 };
    water_horizon horizon;
    assert_true(water_horizon_make(&scene.eye, &scene.plane, kept, &horizon));
    const int count = horizon.counts[1];
    assert_int_equal(count, corners_of(&horizon));
    double twice = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const double* here = horizon.corners[1][i];
      const double* next = horizon.corners[1][(i + 1) % count];
      twice += here[0] * next[1] - here[1] * next[0];
      assert_true(kept[0] * here[0] + kept[1] * here[1] >= -1e-9);
      ASSERT_CLOSE(fabs(here[0]), end, 1e-9);
      ASSERT_CLOSE(fabs(here[1]), end, 1e-9);
    }
    ASSERT_CLOSE(0.5 * twice, 2.0 * end * end, 1e-9);
  }
}

TEST(nothing_is_left_of_a_sheet_that_is_not_wanted)
{
  const water_scene scene = above();
  const double kept[4] = { 1.0, 0.0, 0.0, -100.0 };
  water_horizon horizon;
  assert_false(water_horizon_make(&scene.eye, &scene.plane, kept, &horizon));
  assert_int_equal(corners_of(&horizon), 0);
}

TEST(reach_is_that_of_the_farthest_corner)
{
  dice from = dice_seeded(17);
  const double center[3] = { 4.0, -2.0, 1.0 };
  for (int number = 0; number < 50; ++number)
  {
    const random_scene random = scene_rolled(&from, number, center);
    water_horizon horizon;
    assert_true(water_horizon_make(&random.scene.eye, &random.scene.plane, NULL, &horizon));
    for (int k = 0; k < 3; ++k)
    {
      double reach = 0.0;
      for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
      {
        for (int i = 0; i < horizon.counts[part]; ++i)
        {
          reach = fmax(reach, fabs(horizon.corners[part][i][k]));
        }
      }
      ASSERT_CLOSE(horizon.reach[k], reach, 0.0);
    }
  }
}

// What is infinitely far away has the greatest depth, and a 50th of the way from there to the far
// plane, before it, depths are as they are.
TEST(depths_of_waves_end_at_infinity)
{
  const double near_z = 2.0;
  const double far_z = 300.0;
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  double clip[16];
  double depths[3];
  frustum_matrix(box, near_z, far_z, clip);
  water_horizon_depths(clip, true, depths);
  const double beyond = 2.0 * near_z / (far_z - near_z); // infinity's depth, less the far plane's
  ASSERT_CLOSE(depths[1], 1.0 - 0.02 * beyond, 1e-12);
  ASSERT_CLOSE(depths[1] + depths[2] * (1.0 + beyond - depths[1]), 1.0 - 1.0 / 4194304.0, 1e-12);
}

static bool box_of(const water_scene* scene, double height, double box[4])
{
  water_eye eye;
  assert_int_equal(water_camera_decompose(&scene->eye, &eye), WATER_OK);
  return water_horizon_box(&eye, &scene->plane, WATER_ABOVE, height, box);
}

static void look_level(double height, water_scene* scene)
{
  const double eye[3] = { 0.0, 0.0, height };
  const double target[3] = { 0.0, 1.0, height };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, target, up, scene->eye.world_to_view);
}

// An eye as high as the waves is among them: they may be anywhere in the picture. Over them they
// end at the horizon, and so does a calm plane, even under an eye that is on it.
TEST(an_eye_as_high_as_the_waves_is_among_them)
{
  static const double whole[4] = { -1.0, -1.0, 1.0, 1.0 };
  water_scene scene = lake();
  const double heights[] = { 4.0, 0.0 }; // of the eye
  for (int i = 0; i < 2; ++i)
  {
    look_level(heights[i], &scene);
    double box[4];
    assert_true(box_of(&scene, fmax(heights[i], 1e-3), box));
    assert_memory_equal(box, whole, sizeof box);
    assert_true(box_of(&scene, heights[i] - (i == 0 ? 1e-6 : 0.0), box));
    ASSERT_CLOSE(box[0], -1.0, 1e-12);
    ASSERT_CLOSE(box[1], -1.0, 1e-12);
    ASSERT_CLOSE(box[2], 1.0, 1e-12);
    ASSERT_CLOSE(box[3], 0.0, 1e-12);
  }
}

static void bounds_of(const water_scene* scene, double height, double bounds[6])
{
  assert_true(water_horizon_bounds(&scene->eye, &scene->plane, height, 0.0, bounds));
}

// The bounds of an eye among waves are those of all it sees between near and far plane, those of
// any other are as thick as the waves.
TEST(bounds_of_an_eye_among_waves_are_its_view)
{
  water_scene scene = above(); // from z = 10, 45 degrees to each side, from 1 to 1000
  double bounds[6];
  bounds_of(&scene, 10.0 - 1e-6, bounds);
  ASSERT_CLOSE(bounds[4], -10.0, 1e-5);
  ASSERT_CLOSE(bounds[5], 10.0, 1e-5);
  bounds_of(&scene, 10.0, bounds);
  const double view[6] = { -1000.0, 1000.0, -1000.0, 1000.0, 10.0 - 1000.0, 10.0 - 1.0 };
  for (int i = 0; i < 6; ++i)
  {
    const double moved = i < 4 ? 0.0 : (i == 4 ? -10.0 : 10.0); // by the waves
    ASSERT_CLOSE(bounds[i], view[i] + moved, 1e-6);
  }
  // a parallel view sees waves of any height, but a calm plane as it is
  const double box[4] = { -3.0, 5.0, -2.0, 7.0 };
  ortho_matrix(box, 1.0, 1000.0, scene.eye.view_to_clip);
  scene.eye.parallel = true;
  bounds_of(&scene, 1.0, bounds);
  ASSERT_CLOSE(bounds[4], -991.0, 1e-9);
  ASSERT_CLOSE(bounds[0], -3.0 - 8.0 / 256.0, 1e-9);
  bounds_of(&scene, 0.0, bounds);
  ASSERT_CLOSE(bounds[4], 0.0, 1e-12);
  ASSERT_CLOSE(bounds[5], 0.0, 1e-12);
}

// Engines cut the bounds at the near plane. Where water is nearer, they reach to that plane over
// it.
TEST(bounds_reach_the_near_plane_over_nearer_water)
{
  water_scene scene = lake();
  look_level(2.0, &scene);
  const double near_z[] = { 1.0, 10.0 }; // the picture's lower side meets the water at 2
  for (int i = 0; i < 2; ++i)
  {
    const double half = near_z[i];
    const double box[4] = { -half, half, -half, half };
    frustum_matrix(box, near_z[i], 1000.0, scene.eye.view_to_clip);
    double bounds[6];
    bounds_of(&scene, 0.0, bounds);
    const double end = 1.0 + 1.0 / 128.0; // of the picture, as of the sheet
    ASSERT_CLOSE(bounds[4], i == 0 ? 0.0 : 2.0 - end * half, 1e-9);
    ASSERT_CLOSE(bounds[5], 0.0, 1e-9);
    ASSERT_CLOSE(bounds[2], 2.0 / end, 1e-9);
  }
}

TEST(an_eye_on_a_calm_plane_sees_no_higher)
{
  water_scene scene = lake();
  double bounds[6];
  look_level(0.0, &scene);
  if (water_horizon_bounds(&scene.eye, &scene.plane, 0.0, 0.0, bounds))
  {
    assert_true(fabs(bounds[5]) < 1.0);
    assert_true(bounds[4] > -1.0 - 1.0 / 64.0); // the lower side of the near plane
  }
}

// A projection may have its eye beside the camera's origin, as those of head-mounted displays do:
// the eye's own height counts.
TEST(the_eye_is_where_the_projection_has_it)
{
  water_scene scene = above();
  for (int i = 0; i < 4; ++i) // the eye is 2 behind the camera, 12 over the water
  {
    scene.eye.view_to_clip[4 * i + 3] -= 2.0 * scene.eye.view_to_clip[4 * i + 2];
  }
  double bounds[6];
  bounds_of(&scene, 11.0, bounds);
  ASSERT_CLOSE(bounds[5], 11.0, 1e-9);
  bounds_of(&scene, 12.5, bounds);
  assert_true(bounds[5] > 13.0);
  double box[4];
  static const double whole[4] = { -1.0, -1.0, 1.0, 1.0 };
  assert_true(box_of(&scene, 12.5, box));
  assert_memory_equal(box, whole, sizeof box);
}

TESTS(a_diagonal_leaves_a_triangle, nothing_is_left_of_a_sheet_that_is_not_wanted,
  reach_is_that_of_the_farthest_corner, depths_of_waves_end_at_infinity,
  an_eye_as_high_as_the_waves_is_among_them, bounds_of_an_eye_among_waves_are_its_view,
  bounds_reach_the_near_plane_over_nearer_water, an_eye_on_a_calm_plane_sees_no_higher,
  the_eye_is_where_the_projection_has_it)
