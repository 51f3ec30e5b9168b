// SPDX-License-Identifier: BSD-3-Clause
// test_horizon.c: the sheet of an endless plane: covers what the eye sees of it and no more, ends
// close under the horizon, is divided where depths end.
#include "test_scene.h"

#include "water_grid.h"
#include "water_horizon.h"
#include "water_mirror.h"
#include "water_select.h"
#include "water_visibility.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };
static const double far_off[3] = { 1e6, -3e5, 2e5 };

static water_horizon sheet_of(const water_scene* scene)
{
  water_horizon horizon;
  assert_true(water_horizon_make(&scene->eye, &scene->plane, NULL, &horizon));
  return horizon;
}

static void corner_of(const water_horizon* horizon, int part, int i, double point[3])
{
  for (int k = 0; k < 3; ++k)
  {
    point[k] = horizon->foot[k] + horizon->corners[part][i][k];
  }
}

// By how much a place in NDC lies inside a part's picture; negative: outside.
static double depth_in_part(
  const water_camera* eye, const water_horizon* horizon, int part, const double ndc[2])
{
  double at[WATER_HORIZON_CORNERS][2];
  const int count = horizon->counts[part];
  for (int i = 0; i < count; ++i)
  {
    double point[3];
    double clip[4];
    corner_of(horizon, part, i, point);
    project(eye, point, 1.0, clip);
    assert_true(clip[3] > 0.0);
    at[i][0] = clip[0] / clip[3];
    at[i][1] = clip[1] / clip[3];
  }
  double turn = 0.0;
  for (int i = 0; i < count; ++i)
  {
    turn += at[i][0] * at[(i + 1) % count][1] - at[i][1] * at[(i + 1) % count][0];
  }
  double least = count > 0 ? DBL_MAX : -DBL_MAX;
  for (int i = 0; i < count; ++i)
  {
    const double* next = at[(i + 1) % count];
    const double side[2] = { next[0] - at[i][0], next[1] - at[i][1] };
    const double length = hypot(side[0], side[1]);
    if (length > 1e-12)
    {
      const double in = side[0] * (ndc[1] - at[i][1]) - side[1] * (ndc[0] - at[i][0]);
      least = fmin(least, (turn > 0.0 ? in : -in) / length);
    }
  }
  return least;
}

// Where the view ray of a place in NDC meets the plane, for a camera of scene_rolled.
//
// Returns how far along the ray that is, over the eye's height; below 0: it does not meet it.
static double meet(const random_scene* random, const double ndc[2], double point[3])
{
  const double* to_clip = random->scene.eye.view_to_clip;
  const double* rows = random->scene.eye.world_to_view;
  double base[3];
  double ray[3];
  for (int k = 0; k < 3; ++k)
  {
    double sum[2] = { 0.0, 0.0 };
    for (int i = 0; i < 2; ++i)
    {
      const double shift = random->is_parallel ? -to_clip[4 * i + 3] : to_clip[4 * i + 2];
      sum[random->is_parallel ? 0 : 1] += (ndc[i] + shift) / to_clip[5 * i] * rows[4 * i + k];
    }
    base[k] = random->eye[k] + sum[0];
    ray[k] = sum[1] - rows[8 + k];
  }
  const double height = height_of(random, base);
  const double fall = -dot(random->normal, ray);
  for (int k = 0; k < 3; ++k)
  {
    point[k] = base[k] + height / fall * ray[k];
  }
  return random->is_parallel ? 1.0 : 1.0 / fall;
}

// Each place of the picture whose view ray meets the plane lies on the sheet, in the part that its
// depth belongs to, and no other place does: any plane, either side, off-axis and parallel, far
// out.
TEST(sheet_is_what_the_eye_sees)
{
  dice from = dice_seeded(411);
  int met = 0;
  int parts[WATER_HORIZON_PARTS] = { 0, 0, 0 };
  for (int round = 0; round < 900; ++round)
  {
    const random_scene random = scene_rolled(&from, round, round % 2 ? far_off : nearby);
    const water_horizon horizon = sheet_of(&random.scene);
    for (int i = 0; i < 60; ++i)
    {
      const double ndc[2] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0) };
      double point[3];
      double clip[4];
      const double far_away = meet(&random, ndc, point);
      project(&random.scene.eye, point, 1.0, clip);
      const double z = clip[2] / clip[3];
      const bool is_met = far_away > 0.0;
      if (fabs(far_away) > 1e4 || fabs(z + 1.0) < 1e-4 || fabs(z - 1.0) < 1e-4)
      {
        continue; // too close to a border
      }
      const int part = z < -1.0 ? 0 : z < 1.0 ? 1 : 2;
      for (int j = 0; j < WATER_HORIZON_PARTS; ++j)
      {
        const double in = depth_in_part(&random.scene.eye, &horizon, j, ndc);
        assert_true(is_met && j == part ? in > -1e-6 : in < 1e-6);
      }
      met += is_met;
      parts[part] += is_met;
    }
  }
  assert_int_in_range(met, 30000, 54000);
  assert_int_in_range(parts[0], 500, 54000);
  assert_int_in_range(parts[2], 500, 54000);
}

// Corners lie in the plane, relative to their distance; they turn counter-clockwise about the
// normal as the user gave it; parts that meet share two corners, to the last bit.
TEST(sheet_lies_in_the_plane)
{
  dice from = dice_seeded(412);
  int shared = 0;
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_horizon horizon = sheet_of(&random.scene);
    for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
    {
      const int count = horizon.counts[part];
      double area[3] = { 0.0, 0.0, 0.0 };
      for (int i = 0; i < count; ++i)
      {
        const double* corner = horizon.corners[part][i];
        ASSERT_CLOSE(dot(random.normal, corner), 0.0, 1e-14 * (1.0 + sqrt(dot(corner, corner))));
        double turn[3];
        cross(corner, horizon.corners[part][(i + 1) % count], turn);
        for (int k = 0; k < 3; ++k)
        {
          area[k] += turn[k];
        }
      }
      assert_true(count == 0 || dot(area, random.scene.plane.normal) > 0.0);
    }
    ASSERT_CLOSE(height_of(&random, horizon.foot), 0.0, 1e-13);
    for (int part = 0; part + 1 < WATER_HORIZON_PARTS; ++part)
    {
      int same = 0;
      for (int i = 0; i < horizon.counts[part]; ++i)
      {
        for (int j = 0; j < horizon.counts[part + 1]; ++j)
        {
          same += memcmp(horizon.corners[part][i], horizon.corners[part + 1][j],
                    sizeof horizon.corners[part][i]) == 0;
        }
      }
      const bool are_both = horizon.counts[part] > 0 && horizon.counts[part + 1] > 0;
      assert_int_equal(same, are_both ? 2 : 0);
      shared += are_both;
    }
  }
  assert_int_in_range(shared, 200, 1200);
}

// A frustum as that of lake(), with other depths.
static void set_depths(water_scene* scene, double near_z, double far_z)
{
  const double box[4] = { -4.0 / 3.0 * near_z, 4.0 / 3.0 * near_z, -near_z, near_z };
  frustum_matrix(box, near_z, far_z, scene->eye.view_to_clip);
}

// An eye over a level plane, looking along it.
static water_scene shore(double height, double pitch)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, height };
  const double target[3] = { 0.0, height, height * (1.0 + pitch) };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, target, up, scene.eye.world_to_view);
  return scene;
}

// The sheet ends less than a twentieth of a pixel under the horizon, with 16,384 pixels and any
// scale: a millimetre, 10,000 km, and all between.
TEST(sheet_ends_at_the_horizon)
{
  const double heights[5] = { 1e-6, 1e-3, 1.0, 1e4, 1e7 };
  for (int i = 0; i < 10; ++i)
  {
    const double pitch = i < 5 ? -0.1 : 0.3; // the horizon is at y = -pitch
    const water_scene scene = shore(heights[i % 5], pitch);
    const water_horizon horizon = sheet_of(&scene);
    double top = -1.0;
    for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
    {
      for (int j = 0; j < horizon.counts[part]; ++j)
      {
        double point[3];
        double clip[4];
        corner_of(&horizon, part, j, point);
        project(&scene.eye, point, 1.0, clip);
        top = fmax(top, clip[1] / clip[3]);
      }
    }
    const double under_px = 0.5 * 16384.0 * (-pitch - top);
    assert_true(under_px > 0.0);
    assert_true(under_px < 0.05);
  }
}

// There is no sheet for an eye that looks away from the plane, or along it in parallel, nor for
// what is no plane or no camera; a plane that is seen edge-on but for a hair has one.
TEST(unseen_planes_have_no_sheet)
{
  water_horizon horizon;
  water_scene scene = shore(5.0, 2.0);
  assert_false(water_horizon_make(&scene.eye, &scene.plane, NULL, &horizon));
  assert_int_equal(horizon.counts[0] + horizon.counts[1] + horizon.counts[2], 0);
  scene = shore(5.0, 0.0);
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  ortho_matrix(box, 1.0, 100.0, scene.eye.view_to_clip);
  scene.eye.parallel = true;
  assert_false(water_horizon_make(&scene.eye, &scene.plane, NULL, &horizon));
  scene = shore(5.0, -1e-6);
  ortho_matrix(box, 1.0, 100.0, scene.eye.view_to_clip);
  scene.eye.parallel = true;
  assert_true(water_horizon_make(&scene.eye, &scene.plane, NULL, &horizon));
  scene = lake();
  scene.plane.normal[2] = 0.0;
  assert_false(water_horizon_make(&scene.eye, &scene.plane, NULL, &horizon));
  scene = lake();
  scene.eye.view_to_clip[0] = (double)NAN;
  assert_false(water_horizon_make(&scene.eye, &scene.plane, NULL, &horizon));
}

// An eye on the plane, anywhere, has the sheet of one a little over it: all under the horizon.
TEST(eye_on_the_plane_has_a_sheet)
{
  for (int i = 0; i < 3; ++i)
  {
    water_scene scene = shore(5.0, 0.0);
    const double east[3] = { i * 1e6, 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      scene.eye.world_to_view[4 * k + 3] -= dot(scene.eye.world_to_view + 4 * k, east);
    }
    scene.plane.offset = -5.0;
    const water_horizon horizon = sheet_of(&scene);
    ASSERT_CLOSE(horizon.foot[2], 5.0 - 1e-4, 1e-6); // the near plane is at 1
    const double ndc[3][2] = { { 0.0, -0.9 }, { 0.9, -0.001 }, { 0.0, 0.001 } };
    for (int j = 0; j < 3; ++j)
    {
      double in = -1.0;
      for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
      {
        in = fmax(in, depth_in_part(&scene.eye, &horizon, part, ndc[j]));
      }
      assert_true(j < 2 ? in >= 0.0 : in < 0.0);
    }
    scene.surface_bounds[0] = 1.0; // not asked for
    scene.surface_bounds[1] = -1.0;
    scene.is_endless = true;
    const water_plan plan = plan_of(&scene, NULL);
    assert_int_equal(plan.decision, WATER_REFLECT);
    assert_int_equal(plan.side, WATER_ABOVE);
  }
}

// The kept side alone has a sheet.
TEST(sheet_is_cut_at_another_plane)
{
  dice from = dice_seeded(413);
  int cut = 0;
  for (int round = 0; round < 300; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    double kept[4];
    dice_dir(&from, kept);
    kept[3] = -dot(kept, random.target);
    water_horizon whole = sheet_of(&random.scene);
    water_horizon horizon;
    (void)water_horizon_make(&random.scene.eye, &random.scene.plane, kept, &horizon);
    for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
    {
      for (int i = 0; i < horizon.counts[part]; ++i)
      {
        double point[3];
        corner_of(&horizon, part, i, point);
        const double* corner = horizon.corners[part][i];
        assert_true(dot(kept, point) + kept[3] > -1e-9 * (1.0 + sqrt(dot(corner, corner))));
      }
    }
    for (int i = 0; i < 20; ++i)
    {
      const double ndc[2] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0) };
      double point[3];
      const double far_away = meet(&random, ndc, point);
      double in[2] = { -1.0, -1.0 };
      for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
      {
        in[0] = fmax(in[0], depth_in_part(&random.scene.eye, &whole, part, ndc));
        in[1] = fmax(in[1], depth_in_part(&random.scene.eye, &horizon, part, ndc));
      }
      const double height = dot(kept, point) + kept[3];
      if (far_away > 0.0 && far_away < 1e3 && fabs(height) > 1e-3 && in[0] > 1e-3)
      {
        assert_int_equal(in[1] > -1e-5, height > 0.0);
        cut += height < 0.0;
      }
    }
  }
  assert_int_in_range(cut, 1000, 6000);
}

// The part of the picture that is under the horizon, and all of it for an eye among the waves.
TEST(box_is_what_the_surface_covers)
{
  const double pitches[3] = { -0.25, 0.25, 2.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int below = 0; below < 2; ++below)
    {
      water_scene scene = shore(5.0, pitches[i]);
      scene.plane.offset = below ? -10.0 : 0.0; // then the eye is 5 under it, and sees it above
      water_eye eye;
      assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
      double box[4];
      const bool is_any =
        water_horizon_box(&eye, &scene.plane, below ? WATER_BELOW : WATER_ABOVE, 1.0, box);
      assert_int_equal(is_any, i < 2 || below);
      if (i < 2)
      {
        ASSERT_CLOSE(box[below ? 1 : 3], -pitches[i], 1e-12);
        ASSERT_CLOSE(box[below ? 3 : 1], below ? 1.0 : -1.0, 0.0);
        ASSERT_CLOSE(box[0], -1.0, 0.0);
        ASSERT_CLOSE(box[2], 1.0, 0.0);
      }
      assert_true(
        water_horizon_box(&eye, &scene.plane, below ? WATER_BELOW : WATER_ABOVE, 5.5, box));
      ASSERT_CLOSE(box[3] - box[1], 2.0, 0.0);
    }
  }
}

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
  const double heights[4] = { 1e-3, 2.0, 300.0, 1e6 };
  for (int i = 0; i < 4; ++i)
  {
    water_scene scene = shore(heights[i], -0.2);
    set_depths(&scene, 5.0 * heights[i], 400.0 * heights[i]);
    water_grid_view view;
    const double origin[3] = { 0.0, 0.0, 0.0 };
    assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
    double row_dir[2];
    assert_true(
      water_grid_lay(&view, NULL, 0.05 * heights[i], 0.0, GRID, points[0], cells[0], row_dir));
    int at_near = 0;
    int at_far = 0;
    int near_rows = 0;
    double clip[4];
    for (int row = 0; row <= GRID; ++row)
    {
      row_clip(&scene, points, row, clip);
      at_near += fabs(clip[2] / clip[3] + 1.0) < 1e-9;
      at_far += fabs(clip[2] / clip[3] - view.far_depth) < 1e-9;
      near_rows += clip[3] < 100.0 * heights[i];
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

// Two points more put the middle of a grid's box under the eye.
TEST(grid_is_balanced_about_the_eye)
{
  const water_scene scene = shore(2.0, -0.2);
  const double points[3][3] = { { 1.0, 7.0, 0.0 }, { -3.0, 2.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  const double origin[3] = { 10.0, 20.0, 0.0 };
  water_grid_view view;
  assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_OK);
  double corners[2][3];
  water_grid_balance(&view, points[0], 3, 1.0, corners[0]);
  water_grid_balance(&view, points[0], 3, -1.0, corners[1]);
  const double expected[3] = { 3.0, 7.0, 0.0 };
  for (int k = 0; k < 3; ++k)
  {
    ASSERT_CLOSE(corners[0][k], expected[k], 1e-12);
    ASSERT_CLOSE(corners[1][k], -expected[k], 1e-12);
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

// The box around what is seen holds all corners of the sheet, lies in its plane, and is as thick as
// the waves; an eye among them is in it, whatever it looks at. Without a horizon there is none.
TEST(bounds_are_around_what_is_seen)
{
  const water_scene scene = shore(5.0, 0.0);
  const water_horizon horizon = sheet_of(&scene);
  double bounds[6];
  assert_true(water_horizon_bounds(&scene.eye, &scene.plane, 0.0, 0.0, bounds));
  ASSERT_CLOSE(bounds[4], 0.0, 0.0);
  ASSERT_CLOSE(bounds[5], 0.0, 0.0);
  assert_true(fmax(bounds[1] - bounds[0], bounds[3] - bounds[2]) > 1e6); // to the horizon
  for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
  {
    for (int i = 0; i < horizon.counts[part]; ++i)
    {
      double point[3];
      corner_of(&horizon, part, i, point);
      for (int k = 0; k < 2; ++k)
      {
        assert_true(point[k] >= bounds[2 * k] && point[k] <= bounds[2 * k + 1]);
      }
    }
  }
  double waves[6];
  assert_true(water_horizon_bounds(&scene.eye, &scene.plane, 0.5, 0.25, waves));
  ASSERT_CLOSE(waves[4], -0.5, 1e-9);
  ASSERT_CLOSE(waves[5], 0.5, 1e-9);
  ASSERT_CLOSE(waves[0], bounds[0] - 0.25, 1e-6);
  const water_scene sky = shore(5.0, 2.0);
  assert_false(water_horizon_bounds(&sky.eye, &sky.plane, 4.5, 0.0, bounds));
  assert_true(water_horizon_bounds(&sky.eye, &sky.plane, 5.5, 0.0, bounds));
  assert_true(bounds[4] <= 5.0 && bounds[5] >= 5.0);
  const double point[4] = { 0.0, 0.0, 0.0, 1.0 };
  water_scene flat = shore(5.0, 0.0);
  memcpy(flat.plane.normal, point, sizeof flat.plane.normal);
  assert_false(water_horizon_bounds(&flat.eye, &flat.plane, 0.0, 0.0, bounds));
}

TESTS(bounds_are_around_what_is_seen, near_plane_stays_for_props_without_an_image,
  sheet_is_what_the_eye_sees, sheet_lies_in_the_plane, sheet_ends_at_the_horizon,
  unseen_planes_have_no_sheet, eye_on_the_plane_has_a_sheet, sheet_is_cut_at_another_plane,
  box_is_what_the_surface_covers, endless_surface_is_planned_without_bounds,
  depth_of_a_pixel_is_the_surfaces, near_plane_cuts_no_reflection, near_plane_has_an_end,
  held_depths_keep_their_order, background_is_seen_through_endless_water,
  grid_reaches_to_the_horizon, grid_is_balanced_about_the_eye)
