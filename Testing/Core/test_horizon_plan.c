// SPDX-License-Identifier: BSD-3-Clause
// test_horizon_plan.c: how an endless plane is planned and drawn: without bounds, with depths that
// hold it, near planes that do not cut its reflection, and a grid up to the horizon.
#include "test_horizon.h"

#include "water_grid.h"
#include "water_horizon.h"
#include "water_mirror.h"
#include "water_visibility.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };

// An endless surface has no bounds to be wrong or out of view, but is out of view where the eye
// looks away; and is looked up up to the horizon.
TEST(endless_surface_is_planned_without_bounds)
{
  water_scene scene = shore(5.0, -0.5);
  scene.surface_bounds[0] = (double)NAN;
  scene.is_endless = true;
  water_plan plan = plan_of(&scene, NULL);
  assert_int_equal(plan.decision, WATER_REFLECT);
  assert_true(plan.is_endless);
  assert_int_in_range(plan.texture_rect_px[3], 450, 456); // of 600
  assert_int_equal(plan.texture_rect_px[1], 0);
  scene = shore(5.0, 2.0);
  scene.surface_bounds[0] = -1e9;
  scene.surface_bounds[1] = 1e9;
  scene.surface_bounds[2] = -1e9;
  scene.surface_bounds[3] = 1e9;
  scene.is_endless = true;
  plan = plan_of(&scene, NULL);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  assert_false(plan.is_awash);
  scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_UNSEEN; // it is drawn as if all of it were seen
  plan = plan_of(&scene, NULL);
  assert_int_equal(plan.decision, WATER_REFLECT);
  const int whole[4] = { 0, 0, plan.texture_px[0], plan.texture_px[1] };
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(plan.texture_rect_px[i], whole[i]);
  }
}

// The depth of a pixel's surface follows from 1 / w, and in parallel from the pixel; before the
// near plane and beyond the far one, too.
TEST(depth_of_a_pixel_is_the_surfaces)
{
  dice from = dice_seeded(414);
  for (int round = 0; round < 600; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    random.scene.is_endless = true;
    const water_plan plan = plan_of(&random.scene, NULL);
    const double ndc[2] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0) };
    double point[3];
    double clip[4];
    if (!(meet(&random, ndc, point) > 0.0))
    {
      continue;
    }
    project(&random.scene.eye, point, 1.0, clip);
    const double z = plan.pixel_depth[0] * ndc[0] + plan.pixel_depth[1] * ndc[1] +
      plan.pixel_depth[2] + plan.pixel_depth[3] / clip[3];
    ASSERT_CLOSE(z, clip[2] / clip[3], 1e-9 * (1.0 + fabs(z)));
  }
}

// The near plane of the mirrored camera moves before whatever stands over endless water, and depths
// of the picture still lead to those of the reflection texture.
TEST(near_plane_cuts_no_reflection)
{
  dice from = dice_seeded(415);
  int moved = 0;
  for (int round = 0; round < 300; ++round)
  {
    water_scene scene = shore(1.0, dice_roll(&from, 0.1, 0.8));
    const double top = dice_roll(&from, 2.0, 40.0);
    const water_prop prop = { { -2.0, 2.0, 20.0, 22.0, 0.0, top }, WATER_PROP_VISIBLE };
    double near_z = DBL_MAX; // of the prop, as ResetCameraClippingRange finds it
    for (int i = 0; i < 64; ++i)
    {
      double point[3];
      double view[4];
      box_point(prop.bounds, i, point);
      apply(scene.eye.world_to_view, point, 1.0, view);
      near_z = fmin(near_z, -view[2]);
    }
    set_depths(&scene, near_z, 100.0);
    water_cull_reason reason;
    scene.props = &prop;
    scene.prop_count = 1;
    const water_plan bounded = plan_of(&scene, &reason);
    assert_true(bounded.depth_offset == 0.0);
    scene.is_endless = true;
    const water_plan plan = plan_of(&scene, &reason);
    assert_int_equal(reason, WATER_CULL_NONE);
    moved += plan.depth_offset > 0.0;
    for (int i = 0; i < 64; ++i)
    {
      double point[3];
      double clip[4];
      box_point(prop.bounds, i, point);
      project(&plan.mirrored, point, 1.0, clip);
      assert_true(clip[3] < 0.1 || (clip[2] >= -clip[3] && clip[2] <= clip[3]));
      point[2] = 0.0; // on the water: the eye's depth leads to the mirrored one
      double eye_clip[4];
      project(&plan.mirrored, point, 1.0, clip);
      project(&scene.eye, point, 1.0, eye_clip);
      ASSERT_CLOSE(0.5 + 0.5 * clip[2] / clip[3],
        plan.depth_scale * (0.5 + 0.5 * eye_clip[2] / eye_clip[3]) + plan.depth_offset, 1e-9);
    }
  }
  assert_int_in_range(moved, 200, 300);
}

// What stands in front of the near plane keeps it where it is, and one about the eye moves it to a
// thousandth of the far plane's distance.
TEST(near_plane_has_an_end)
{
  water_scene scene = shore(1.0, 0.0);
  const water_prop props[2] = { { { -2.0, 2.0, 20.0, 22.0, 0.0, 3.0 }, WATER_PROP_VISIBLE },
    { { -2.0, 2.0, -20.0, 22.0, 0.0, 3.0 }, WATER_PROP_VISIBLE } };
  set_depths(&scene, 5.0, 1000.0);
  for (int i = 0; i < 2; ++i)
  {
    water_camera camera = scene.eye;
    const double scale = water_mirror_near(&scene.plane, props + i, 1, &camera);
    const double* clip = camera.view_to_clip;
    ASSERT_CLOSE(clip[11] / (clip[10] - 1.0), i == 0 ? 5.0 : 1.0, 1e-3); // the near plane
    ASSERT_CLOSE(clip[11] / (clip[10] + 1.0), 1000.0, 1e-6);             // and the far one
    assert_int_equal(scale < 1.0, i == 1);
  }
}

static double held(const double depths[3], double t)
{
  return t < -1.0   ? -1.0 - depths[0] / t
    : t > depths[1] ? depths[1] + depths[2] * (t - depths[1])
                    : fmax(t, depths[0] - 1.0);
}

// Held depths lie within the range, and before the background's; those of waves keep their order,
// however far before or beyond the planes they are, and all but the ends of the range are as they
// were. Those of flat water end at the planes.
TEST(held_depths_keep_their_order)
{
  dice from = dice_seeded(416);
  for (int round = 0; round < 200; ++round)
  {
    water_scene scene = lake();
    const double near_z = pow(10.0, dice_roll(&from, -3.0, 2.0));
    const double far_z = near_z * pow(10.0, dice_roll(&from, 0.1, 6.0));
    set_depths(&scene, near_z, far_z);
    const double* clip = scene.eye.view_to_clip;
    double depths[3];
    water_horizon_depths(clip, false, depths);
    ASSERT_CLOSE(held(depths, -5.0), -1.0, 0.0);
    ASSERT_CLOSE(held(depths, 1.5), WATER_HORIZON_DEPTH, 0.0);
    water_horizon_depths(clip, true, depths);
    const bool are_apart = depths[2] > 0.0;
    assert_true(are_apart || near_z / far_z < 1e-5);
    double before = -1.0;
    for (double w = 1e-3 * near_z; w < 1e3 * far_z; w *= 1.01)
    {
      const double t = -clip[10] + clip[11] / w;
      const double now = held(depths, t);
      assert_true(now >= before && now <= WATER_HORIZON_DEPTH + 1e-15);
      assert_true(now > before || (!are_apart && t > depths[1]) || fabs(w / near_z - 1.0) < 0.011);
      if (w > 1.001 * near_z && t <= depths[1])
      {
        ASSERT_CLOSE(now, t, 0.0);
      }
      before = now;
    }
  }
}

// Over the background endless water is seen, beyond the far plane; of a sheet with an end the depth
// alone tells.
TEST(background_is_seen_through_endless_water)
{
  const int size_px[2] = { 4, 4 };
  const int rect_px[4] = { 0, 0, 4, 4 };
  const double plane_clip[4] = { 0.0, 0.0, 0.0, 1.0 }; // all that the picture shows is over it
  const int rows[2] = { 0, 4 };
  float depths[16];
  int32_t work[4];
  uint8_t cells[16];
  water_visibility seen;
  water_visibility_begin(size_px, rect_px, &seen);
  for (int i = 0; i < 16; ++i)
  {
    depths[i] = i < 8 ? 0.5f : 1.0f;
  }
  for (int is_endless = 0; is_endless < 2; ++is_endless)
  {
    water_visibility_mark(&seen, size_px, is_endless, plane_clip, 0.0, rows, depths, work, cells);
    assert_int_equal(cells[0], 0);
    assert_int_equal(cells[seen.size[0] * seen.size[1] - 1], is_endless);
  }
}

enum
{
  GRID = 32
};

// Where the rows of a grid lie, straight away from the eye, as clip.
static void row_clip(const water_scene* scene, double (*points)[3], int row, double clip[4])
{
  project(&scene->eye, points[row * (GRID + 1) + GRID / 2], 1.0, clip);
}

// A grid without an end goes from before the picture to the horizon, has rows where the near and
// the far plane meet it, and most of its rows where waves are seen.
TEST(grid_reaches_to_the_horizon)
{
  static double points[(GRID + 1) * (GRID + 1)][3];
  static float cells[(GRID + 1) * (GRID + 1)][2];
  const double all_heights[4] = { 1e-3, 2.0, 300.0, 1e6 };
  for (int i = 0; i < 8; ++i) // along an axis of the plane, and between both
  {
    const double height = all_heights[i % 4];
    water_scene scene = shore(height, -0.2);
    set_depths(&scene, 5.0 * height, 400.0 * height);
    if (i >= 4)
    {
      const double eye[3] = { 0.0, 0.0, height };
      const double target[3] = { 0.6 * height, 0.8 * height, 0.8 * height };
      const double up[3] = { 0.0, 0.0, 1.0 };
      look_at(eye, target, up, scene.eye.world_to_view);
    }
    water_grid_view view;
    const double origin[3] = { 0.0, 0.0, 0.0 };
    assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
    double row_dir[2];
    assert_true(
      water_grid_lay(&view, NULL, 0.05 * height, 0.0, GRID, points[0], cells[0], row_dir));
    int at_near = 0;
    int at_far = 0;
    int near_rows = 0;
    double clip[4];
    for (int row = 0; row <= GRID; ++row)
    {
      row_clip(&scene, points, row, clip);
      at_near += fabs(clip[2] / clip[3] + 1.0) < 1e-9;
      at_far += fabs(clip[2] / clip[3] - view.far_depth) < 1e-9;
      near_rows += clip[3] < 100.0 * height;
    }
    assert_int_equal(at_near, 1);
    assert_int_equal(at_far, 1);
    assert_int_in_range(near_rows, GRID / 2, GRID);
    row_clip(&scene, points, 0, clip);
    assert_true(clip[1] < -clip[3]);
    row_clip(&scene, points, GRID, clip);
    ASSERT_CLOSE(clip[1] / clip[3], 0.2, 1e-5);
  }
}

// Rows of a grid without an end are even up to where waves are a thousandth of half the picture
// high, but at least as far as the eye is high, from where the grid begins: there is a row, too.
TEST(rows_are_even_where_waves_are_seen)
{
  static double points[(GRID + 1) * (GRID + 1)][3];
  static float cells[(GRID + 1) * (GRID + 1)][2];
  const double eye_height = 2.0;
  const double heights[2] = { 0.0, 0.1 };
  for (int i = 0; i < 2; ++i)
  {
    water_scene scene = shore(eye_height, -0.2);
    set_depths(&scene, 0.01, 1e5);
    water_grid_view view;
    const double origin[3] = { 0.0, 0.0, 0.0 };
    assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
    double ahead[3] = { 0.0, 0.0, 0.0 };
    assert_true(water_grid_lay(&view, NULL, heights[i], 0.0, GRID, points[0], cells[0], ahead));
    double up_clip[4];
    double ahead_clip[4];
    double foot_clip[4];
    const double up[3] = { 0.0, 0.0, 1.0 };
    project(&scene.eye, up, 0.0, up_clip);
    project(&scene.eye, ahead, 0.0, ahead_clip);
    project(&scene.eye, origin, 1.0, foot_clip);
    const double first = dot(points[0], ahead);
    const double seen_w = heights[i] * hypot(up_clip[0], up_clip[1]) / 1e-3;
    const double end =
      i == 0 ? fmax(first, 0.0) + eye_height : (seen_w - foot_clip[3]) / ahead_clip[3];
    assert_true(first > 0.1 && end > first + 1.0);
    int at_end = 0;
    double widest = 0.0; // in the measure by which rows are even
    double last = 2.0 * first / (sqrt(eye_height + first) + sqrt(eye_height));
    const double begun = last;
    for (int row = 1; row <= GRID; ++row)
    {
      const double way = dot(points[row * (GRID + 1)], ahead);
      const double even = 2.0 * way / (sqrt(eye_height + way) + sqrt(eye_height));
      at_end += fabs(way - end) < 1e-9 * end;
      widest = way < end * (1.0 + 1e-9) ? fmax(widest, even - last) : widest;
      last = even;
    }
    const double whole = 2.0 * end / (sqrt(eye_height + end) + sqrt(eye_height)) - begun;
    assert_true(at_end >= 1);
    assert_true(widest < 1.001 * whole / (GRID + 1 - 13));
  }
}

// Two points more put the middle of a grid's box under the eye.
TEST(grid_is_balanced_about_the_eye)
{
  const water_scene scene = lake(); // from over (0, -10)
  const double points[3][3] = { { 1.0, 7.0, 0.0 }, { -3.0, 2.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  const double origin[3] = { 10.0, 20.0, 0.0 };
  water_grid_view view;
  assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
  double corners[2][3];
  water_grid_balance(&view, points[0], 3, 1.0, corners[0]);
  water_grid_balance(&view, points[0], 3, -1.0, corners[1]);
  const double expected[2][3] = { { 3.0, 7.0, 0.0 }, { -3.0, -27.0, 0.0 } };
  for (int k = 0; k < 6; ++k)
  {
    ASSERT_CLOSE(corners[k / 3][k % 3], expected[k / 3][k % 3], 1e-12);
  }
}

// Only props that are shown, have bounds and reach over the water move the near plane.
TEST(near_plane_stays_for_props_without_an_image)
{
  water_scene scene = shore(1.0, 0.0);
  set_depths(&scene, 5.0, 1000.0);
  const water_prop props[5] = { { { -2.0, 2.0, -20.0, 22.0, 0.0, 3.0 }, 0 },
    { { -2.0, 2.0, -20.0, 22.0, 0.0, 3.0 }, WATER_PROP_VISIBLE | WATER_PROP_NOT_REFLECTED },
    { { -2.0, 2.0, -20.0, 22.0, 0.0, 3.0 }, WATER_PROP_VISIBLE | WATER_PROP_NO_BOUNDS },
    { { 2.0, -2.0, -20.0, 22.0, 0.0, 3.0 }, WATER_PROP_VISIBLE },
    { { -2.0, 2.0, -20.0, 22.0, -3.0, -1.0 }, WATER_PROP_VISIBLE } };
  water_camera camera = scene.eye;
  ASSERT_CLOSE(water_mirror_near(&scene.plane, props, 5, &camera), 1.0, 0.0);
  assert_memory_equal(&camera, &scene.eye, sizeof camera);
}

TESTS(rows_are_even_where_waves_are_seen, near_plane_stays_for_props_without_an_image,
  endless_surface_is_planned_without_bounds, depth_of_a_pixel_is_the_surfaces,
  near_plane_cuts_no_reflection, near_plane_has_an_end, held_depths_keep_their_order,
  background_is_seen_through_endless_water, grid_reaches_to_the_horizon,
  grid_is_balanced_about_the_eye)
