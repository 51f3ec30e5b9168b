// SPDX-License-Identifier: BSD-3-Clause
// test_eye.c: whether the eye, or its near plane, is in the water.
#include "test_scene.h"

#include "water_lookup.h"
#include "water_math.h"

// Under the sheet is under water; beside it, above it, or with a parallel eye, is not.
TEST(eye_under_the_sheet_is_submerged)
{
  water_scene scene = lake();
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double north[3] = { 0.0, 1.0, 0.0 };
  const double places[4][3] = { { 0.0, -9.0, -5.0 }, { 0.0, -11.0, -5.0 }, { 0.0, -9.0, 5.0 },
    { 9.9, 9.9, -0.1 } };
  const bool expected[4] = { true, false, false, true };
  for (int i = 0; i < 4; ++i)
  {
    const double target[3] = { 0.0, 0.0, 0.0 };
    look_at(places[i], target, up, scene.eye.world_to_view);
    assert_int_equal(plan_of(&scene, NULL).is_submerged, expected[i]);
  }
  const double down[3] = { 0.0, -9.1, -50.0 };
  look_at(places[0], down, up, scene.eye.world_to_view); // the sheet is out of view
  assert_true(plan_of(&scene, NULL).has_view);
  look_at(places[1], down, up, scene.eye.world_to_view);
  assert_false(plan_of(&scene, NULL).has_view);
  // whatever the reason not to draw the mirrored view
  look_at(places[0], places[2], north, scene.eye.world_to_view);
  for (int i = 0; i < 2; ++i)
  {
    scene.is_hidden = i == 0;
    scene.hides_below = i == 1;
    const water_plan plan = plan_of(&scene, NULL);
    assert_int_equal(
      plan.decision, i == 0 ? WATER_NO_REFLECT_HIDDEN : WATER_NO_REFLECT_FACING_AWAY);
    assert_true(plan.has_view && plan.is_submerged);
  }
  scene.hides_below = false;
  const double box[4] = { -5.0, 5.0, -5.0, 5.0 };
  scene.eye.parallel = true;
  ortho_matrix(box, 0.0, 100.0, scene.eye.view_to_clip);
  assert_false(plan_of(&scene, NULL).is_submerged);
}

// An eye over the sheet is awash when its near plane dips in: one that looks down by 45 degrees,
// with a field of view of 90, has the lowest edge of a near plane at 0.5 m straight below,
// 0.5 sqrt(2) m.
TEST(near_plane_in_the_water_is_awash)
{
  water_scene scene = lake();
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double box[4] = { -0.5, 0.5, -0.5, 0.5 };
  const double places[5][3] = { { 0.0, -9.0, 0.708 }, { 0.0, -9.0, 0.707 }, { 0.0, -9.0, 1e-9 },
    { 0.0, -11.0, 0.1 }, { 0.0, -9.0, -0.1 } };
  const bool expected[5] = { false, true, true, false, false };
  frustum_matrix(box, 0.5, 100.0, scene.eye.view_to_clip);
  for (int i = 0; i < 5; ++i)
  {
    const double target[3] = { 0.0, places[i][1] + 1.0, places[i][2] - 1.0 };
    look_at(places[i], target, up, scene.eye.world_to_view);
    const water_plan plan = plan_of(&scene, NULL);
    assert_int_equal(plan.is_awash, expected[i]);
    assert_false(plan.is_awash && plan.is_submerged);
  }
  const double straight_down[3] = { 0.0, -9.0, -50.0 };
  const double north[3] = { 0.0, 1.0, 0.0 };
  look_at(places[2], straight_down, north, scene.eye.world_to_view); // all of the sheet is cut off
  const water_plan plan = plan_of(&scene, NULL);
  assert_true(plan.is_awash && plan.has_view);
}

// The corners of the near plane, one by one: in NDC as view, planes that rise from -2 in one corner
// by 2 and 4 to the others, lifted; what touches is not cut.
TEST(each_corner_of_the_near_plane_is_asked)
{
  const double lifts[4] = { 1.0, 1.999, 2.0, 2.5 };
  for (int corner = 0; corner < 4; ++corner)
  {
    for (int i = 0; i < 4; ++i)
    {
      const water_eye eye = { .clip_to_view = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
      const double plane[4] = { corner & 1 ? -1.0 : 1.0, corner & 2 ? -1.0 : 1.0, 0.0, lifts[i] };
      assert_int_equal(water_lookup_cuts_surface(&eye, plane), i < 2);
    }
  }
}

// A flat sheet has a rim of a millionth: the eye is over it up to its very end, at either side.
TEST(eye_is_over_the_rim_of_the_sheet)
{
  const water_camera camera = { .parallel = false };
  const water_plane plane = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double rims[2] = { 1e-6, nextafter(1e-6, 1.0) };
  water_eye eye = { { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 5, 0, 0, 0, 1 } };
  eye.has_center = true;
  for (int side = 0; side < 6; ++side)
  {
    for (int i = 0; i < 2; ++i)
    {
      double bounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
      bounds[side] = side % 2 ? -rims[i] : rims[i];
      assert_int_equal(water_lookup_is_at_surface(&camera, &eye, &plane, bounds), i == 0);
    }
  }
}

// Under a crest is under water, over a trough is over it, whatever the plane at rest says; where
// there is no sheet the plane decides.
TEST(waves_decide_where_the_eye_is)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  // y, z of the eye, height of the surface there
  const double cases[][3] = { { -9.0, 0.3, 0.5 }, { -9.0, 0.7, 0.5 }, { -9.0, -0.3, -0.5 },
    { -9.0, -0.7, -0.5 }, { -9.0, 0.5, 0.5 }, { -9.0, -0.1, 0.5 }, { -9.0, 0.1, -0.5 },
    { -11.0, 0.3, 0.5 } };
  const bool is_under[] = { true, false, false, true, false, true, false, false };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    for (int tilt = -1; tilt <= 1; tilt += 2) // looks up or down
    {
      water_scene scene = lake();
      const double place[3] = { 0.0, cases[i][0], cases[i][1] };
      const double target[3] = { 0.0, 0.0, cases[i][1] + tilt };
      look_at(place, target, up, scene.eye.world_to_view);
      scene.surface_bounds[4] = -1.0;
      scene.surface_bounds[5] = scene.wave_height_max = 1.0;
      scene.surface_height = cases[i][2];
      const water_plan plan = plan_of(&scene, NULL);
      assert_int_equal(plan.side, is_under[i] ? WATER_BELOW : WATER_ABOVE);
      assert_int_equal(plan.is_submerged, is_under[i]);
      // its level there: a point of it has no height, one that is 0.2 nearer to the eye's side has
      const double level = cases[i][0] < -10.0 ? 0.0 : cases[i][2];
      const double towards = is_under[i] ? -1.0 : 1.0;
      const double point[4] = { 3.0, 4.0, level + 0.2 * towards, 1.0 };
      double view[4];
      double clip[4];
      water_mat4_apply(scene.eye.world_to_view, point, view);
      water_mat4_apply(scene.eye.view_to_clip, view, clip);
      double height = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        height += plan.surface_clip[k] * clip[k];
      }
      ASSERT_CLOSE(height, 0.2, 1e-12);
    }
  }
  // the near plane dips into a crest
  water_scene scene = lake();
  const double box[4] = { -0.5, 0.5, -0.5, 0.5 };
  frustum_matrix(box, 0.5, 100.0, scene.eye.view_to_clip);
  const double eye[3] = { 0.0, -9.0, 0.8 };
  const double ahead[3] = { 0.0, -8.0, -0.2 };
  look_at(eye, ahead, up, scene.eye.world_to_view);
  scene.surface_bounds[4] = -1.0;
  scene.surface_bounds[5] = scene.wave_height_max = 1.0;
  assert_false(plan_of(&scene, NULL).is_awash);
  scene.surface_height = 0.2;
  assert_true(plan_of(&scene, NULL).is_awash);
  water_plan bad;
  scene.surface_height = (double)NAN;
  assert_int_equal(water_plan_make(&scene, &bad, NULL), WATER_BAD_CLIP_MARGIN);
  scene.surface_height = 1e100; // the largest
  assert_int_not_equal(water_plan_make(&scene, &bad, NULL), WATER_BAD_CLIP_MARGIN);
}

TESTS(eye_under_the_sheet_is_submerged, near_plane_in_the_water_is_awash,
  each_corner_of_the_near_plane_is_asked, eye_is_over_the_rim_of_the_sheet,
  waves_decide_where_the_eye_is)
