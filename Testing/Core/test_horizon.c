// SPDX-License-Identifier: BSD-3-Clause
// test_horizon.c: the sheet of an endless plane: covers what the eye sees of it and no more, ends
// close under the horizon, is divided where depths end.
#include "test_horizon.h"

#include "water_horizon.h"

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

TESTS(bounds_are_around_what_is_seen, sheet_is_what_the_eye_sees, sheet_lies_in_the_plane,
  sheet_ends_at_the_horizon, unseen_planes_have_no_sheet, eye_on_the_plane_has_a_sheet,
  sheet_is_cut_at_another_plane, box_is_what_the_surface_covers)
