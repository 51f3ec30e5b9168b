// SPDX-License-Identifier: BSD-3-Clause
// test_lookup.c: places on the plane behind a pixel, rays in the map's window, depths at infinity.
#include "test_scene.h"

#include "water_lookup.h"
#include "water_math.h"
#include "water_plane.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };

static random_scene wavy(dice* from, int round)
{
  random_scene random = scene_rolled(from, round, nearby);
  random.scene.has_waves = true;
  for (int i = 0; i < 3; ++i)
  {
    random.scene.plane_origin[i] = random.target[i];
  }
  return random;
}

// The plane's own axes of a random scene, whose plane the user turned as he liked.
static void axes_of(const random_scene* random, double x_dir[3], double y_dir[3])
{
  double normal[3];
  const double length = sqrt(dot(random->scene.plane.normal, random->scene.plane.normal));
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = random->scene.plane.normal[i] / length;
  }
  water_plane_axes(normal, x_dir, y_dir);
}

// The pixel that shows a place on the plane leads back to that place.
TEST(pixel_of_a_place_leads_back_to_it)
{
  UNUSED;
  dice from = dice_seeded(61);
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = wavy(&from, round);
    const water_plan plan = plan_of(&random.scene, NULL);
    double x_dir[3];
    double y_dir[3];
    axes_of(&random, x_dir, y_dir);
    const double place[2] = { dice_roll(&from, -2.0, 2.0), dice_roll(&from, -2.0, 2.0) };
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      point[i] = random.target[i] + place[0] * x_dir[i] + place[1] * y_dir[i];
    }
    double clip[4];
    project(&random.scene.eye, point, 1.0, clip);
    if (!is_inside(clip))
    {
      continue;
    }
    const double ndc[3] = { clip[0] / clip[3], clip[1] / clip[3], 1.0 };
    const double w = dot(plan.ndc_to_plane + 6, ndc);
    ASSERT_CLOSE(plan.origin_xy[0] + dot(plan.ndc_to_plane, ndc) / w, place[0], 1e-9);
    ASSERT_CLOSE(plan.origin_xy[1] + dot(plan.ndc_to_plane + 3, ndc) / w, place[1], 1e-9);
  }
}

// A point t along a direction from a place on the water is seen where the place's clip coordinates
// plus t times the direction's are; the place's own depth in the map is that of the eye, scaled.
TEST(directions_lead_to_the_pictures_of_points_along_them)
{
  UNUSED;
  dice from = dice_seeded(62);
  for (int round = 0; round < 2000; ++round)
  {
    random_scene random = wavy(&from, round);
    water_prop tall = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, WATER_PROP_VISIBLE };
    water_fate fate = WATER_DRAW;
    for (int i = 0; i < 3; ++i) // far away, so that the map's far plane moves
    {
      tall.bounds[2 * i] = random.target[i] - 300.0;
      tall.bounds[2 * i + 1] = random.target[i] + 300.0;
    }
    random.scene.props = &tall;
    random.scene.prop_count = 1;
    const water_plan plan = plan_of(&random.scene, &fate);
    double x_dir[3];
    double y_dir[3];
    axes_of(&random, x_dir, y_dir);
    const double dir[3] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0), 1.0 };
    const double t = dice_roll(&from, 0.0, 10.0);
    double point[3];
    for (int i = 0; i < 3; ++i)
    {
      point[i] =
        random.target[i] + t * (dir[0] * x_dir[i] + dir[1] * y_dir[i] + dir[2] * random.normal[i]);
    }
    double eye[4];
    double start[4];
    double end[4];
    double seen[4];
    project(&random.scene.eye, random.target, 1.0, eye);
    project(&plan.mirrored, random.target, 1.0, start);
    project(&plan.mirrored, point, 1.0, end);
    project(&random.scene.eye, point, 1.0, seen);
    ASSERT_CLOSE(start[0] / start[3], -eye[0] / eye[3], 1e-10);
    ASSERT_CLOSE(
      0.5 + 0.5 * start[2] / start[3], plan.depth_scale * (0.5 + 0.5 * eye[2] / eye[3]), 1e-10);
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(start[i] + t * dot(plan.dir_to_map + 3 * i, dir), end[i], 1e-9);
      ASSERT_CLOSE(eye[i] + t * dot(plan.dir_to_eye + 3 * i, dir), seen[i], 1e-9);
    }
  }
}

// A ray of a perspective map ends at the depth of infinity; that of a parallel map never does.
TEST(depth_at_infinity_is_where_rays_end)
{
  UNUSED;
  dice from = dice_seeded(63);
  for (int round = 0; round < 300; ++round)
  {
    const random_scene random = wavy(&from, round);
    const water_plan plan = plan_of(&random.scene, NULL);
    if (random.is_parallel)
    {
      ASSERT_CLOSE(plan.map_z_infinity, 2.0, 0.0);
      continue;
    }
    double point[3];
    double clip[4];
    for (int i = 0; i < 3; ++i)
    {
      point[i] = random.target[i] + 1e9 * random.view_dir[i] -
        2e9 * dot(random.view_dir, random.normal) * random.normal[i]; // away from the mirrored eye
    }
    project(&plan.mirrored, point, 1.0, clip);
    ASSERT_CLOSE(0.5 + 0.5 * clip[2] / clip[3], plan.map_z_infinity, 1e-6);
    assert_true(plan.map_z_infinity > 1.0);
  }
}

// Waves of any slope may look a pixel's ray up anywhere in the map, so all of it is drawn.
TEST(waves_use_the_whole_map)
{
  UNUSED;
  water_scene scene = lake();
  scene.surface_bounds[0] = scene.surface_bounds[2] = -1.0;
  scene.surface_bounds[1] = scene.surface_bounds[3] = 1.0;
  assert_true(plan_of(&scene, NULL).texture_rect_px[2] < 800);
  scene.has_waves = true;
  scene.slope_max = (double)INFINITY;
  const water_plan plan = plan_of(&scene, NULL);
  assert_int_equal(plan.texture_rect_px[2], 800);
  assert_int_equal(plan.texture_rect_px[3], 600);
}

// A guard band shows more of the same: what the map saw at a place it sees at map_scale times it.
TEST(guard_band_widens_the_map_about_its_middle)
{
  UNUSED;
  dice from = dice_seeded(64);
  for (int round = 0; round < 1000; ++round)
  {
    random_scene random = wavy(&from, round);
    const water_plan plain = plan_of(&random.scene, NULL);
    random.scene.guard_band = dice_roll(&from, 1.0, 2.0);
    const water_plan wide = plan_of(&random.scene, NULL);
    double point[3];
    double before[4];
    double after[4];
    point_near(&from, &random, 2.0, point);
    project(&plain.mirrored, point, 1.0, before);
    project(&wide.mirrored, point, 1.0, after);
    ASSERT_CLOSE(after[3], before[3], 1e-12);
    ASSERT_CLOSE(after[2], before[2], 1e-9);
    for (int i = 0; i < 2; ++i)
    {
      // texels keep their size, and the margins are whole texels
      assert_true(wide.texture_px[i] >= random.scene.guard_band * plain.texture_px[i]);
      assert_int_equal((wide.texture_px[i] - plain.texture_px[i]) % 2, 0);
      ASSERT_CLOSE(after[i] * wide.texture_px[i], before[i] * plain.texture_px[i], 1e-8);
      ASSERT_CLOSE(wide.map_scale[i] * wide.texture_px[i], plain.texture_px[i], 1e-9);
    }
    // the sky of a direction does not depend on the band
    const double ndc[3] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0), 1.0 };
    const double in_wide[3] = { wide.map_scale[0] * ndc[0], wide.map_scale[1] * ndc[1], 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(
        dot(wide.map_ndc_to_eye + 3 * i, in_wide), dot(plain.map_ndc_to_eye + 3 * i, ndc), 1e-9);
    }
  }
}

// By itself the band grows with the waves up to a quarter, and stops at the GPU's limit.
TEST(guard_band_follows_the_waves)
{
  UNUSED;
  water_scene scene = lake();
  scene.has_waves = true;
  assert_int_equal(plan_of(&scene, NULL).texture_px[0], 800);
  scene.slope_rms = 0.01;
  const int some = plan_of(&scene, NULL).texture_px[0];
  assert_true(some > 800 && some < 1000);
  scene.slope_rms = 1.0;
  assert_int_equal(plan_of(&scene, NULL).texture_px[0], 1000);
  scene.max_texture_px = 901;
  assert_int_equal(plan_of(&scene, NULL).texture_px[0], 900);
  scene.has_waves = false;
  assert_int_equal(plan_of(&scene, NULL).texture_px[0], 800);
}

// Over the highest corner of what is drawn there is only sky; what is not drawn does not count, and
// a prop without bounds may reach anywhere.
TEST(top_is_the_highest_drawn_corner)
{
  UNUSED;
  water_scene scene = lake();
  scene.has_waves = true;
  water_prop props[3] = { { { -1.0, 1.0, -1.0, 1.0, -2.0, 3.0 }, WATER_PROP_VISIBLE },
    { { -2.0, 2.0, -2.0, 2.0, 0.0, 4.0 }, WATER_PROP_VISIBLE },
    { { -1.0, 1.0, -1.0, 1.0, 0.0, 9.0 }, 0u } };
  water_fate fates[3];
  scene.props = props;
  scene.prop_count = 3;
  ASSERT_CLOSE(plan_of(&scene, fates).map_top, 4.0, 1e-12);
  scene.plane.offset = -1.0; // the water rises by 1
  ASSERT_CLOSE(plan_of(&scene, fates).map_top, 3.0, 1e-12);
  props[0].flags |= WATER_PROP_NO_BOUNDS;
  assert_true(isinf(plan_of(&scene, fates).map_top));
  scene.prop_count = 0;
  ASSERT_CLOSE(plan_of(&scene, NULL).map_top, 0.0, 0.0);
}

// VTK's default environment has the world's axes; with +z up and +x right, back is -y.
TEST(environment_has_its_own_axes)
{
  UNUSED;
  water_scene scene = lake();
  scene.has_environment = true;
  water_plan plan = plan_of(&scene, NULL); // no directions: the world's
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE(plan.dir_to_environment[i], i % 4 == 0 ? 1.0 : 0.0, 1e-15);
  }
  const double up[3] = { 0.0, 0.0, 2.0 };
  const double right[3] = { 3.0, 0.0, 1.0 }; // not at right angles
  memcpy(scene.environment_up, up, sizeof up);
  memcpy(scene.environment_right, right, sizeof right);
  plan = plan_of(&scene, NULL);
  const double expected[9] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0 };
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE(plan.dir_to_environment[i], expected[i], 1e-15);
  }
}

// Under the sheet is under water; beside it, above it, or with a parallel eye, is not.
TEST(eye_under_the_sheet_is_submerged)
{
  UNUSED;
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
  UNUSED;
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
  UNUSED;
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
  UNUSED;
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

// The sun in the plane's axes; a light without a direction is none.
TEST(sun_is_seen_in_the_axes_of_the_plane)
{
  UNUSED;
  water_scene scene = lake();
  const double sun[3] = { 3.0, 0.0, 4.0 };
  memcpy(scene.sun_dir, sun, sizeof sun);
  assert_false(plan_of(&scene, NULL).has_sun);
  scene.has_sun = true;
  const water_plan plan = plan_of(&scene, NULL);
  assert_true(plan.has_sun);
  ASSERT_CLOSE(plan.sun_dir[0], 0.6, 1e-15);
  ASSERT_CLOSE(plan.sun_dir[1], 0.0, 1e-15);
  ASSERT_CLOSE(plan.sun_dir[2], 0.8, 1e-15);
  memset(scene.sun_dir, 0, sizeof sun);
  assert_false(plan_of(&scene, NULL).has_sun);
}

// The map's depth says how high what it shows is over the plane, on the eye's side.
TEST(depth_of_the_map_tells_heights)
{
  UNUSED;
  dice from = dice_seeded(66);
  for (int round = 0; round < 1000; ++round)
  {
    const random_scene random = wavy(&from, round);
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    point_near(&from, &random, 2.0, point);
    double clip[4];
    project(&plan.mirrored, point, 1.0, clip);
    if (clip[3] < 0.1)
    {
      continue;
    }
    double height = 0.0;
    double w = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      height += plan.map_height[i] * clip[i] / clip[3];
      w += plan.map_w[i] * clip[i] / clip[3];
    }
    ASSERT_CLOSE(height / w, height_of(&random, point), 1e-8);
  }
}

// Waves that move the surface: what stands in a trough is drawn, and rays from one may rise
// further.
TEST(mirrored_view_reaches_down_into_troughs)
{
  UNUSED;
  water_scene scene = lake();
  scene.has_waves = true;
  scene.clip_margin = 0.1;
  const double flat = plan_of(&scene, NULL).clip_plane_view[3];
  scene.wave_height_max = 0.75;
  const water_plan plan = plan_of(&scene, NULL);
  ASSERT_CLOSE(plan.clip_plane_view[3] - flat, 0.65, 1e-12);
  ASSERT_CLOSE(plan.map_top, 0.75, 1e-12);
  scene.clip_margin = 1.0; // the user's, if that is more
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.9, 1e-12);
  water_prop low = { { -1.0, 1.0, -1.0, 1.0, -2.0, -0.5 }, WATER_PROP_VISIBLE };
  water_fate fate = WATER_DRAW;
  scene.props = &low;
  scene.prop_count = 1;
  scene.clip_margin = 0.0;
  plan_of(&scene, &fate);
  assert_int_equal(fate, WATER_DRAW);
  scene.wave_height_max = 0.25;
  plan_of(&scene, &fate);
  assert_int_equal(fate, WATER_SKIP_BEHIND_PLANE);
  water_plan bad;
  scene.wave_height_max = (double)NAN;
  assert_int_equal(water_plan_make(&scene, &bad, &fate), WATER_BAD_CLIP_MARGIN);
}

// Under a crest is under water, over a trough is over it, whatever the plane at rest says; where
// there is no sheet the plane decides.
TEST(waves_decide_where_the_eye_is)
{
  UNUSED;
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

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(pixel_of_a_place_leads_back_to_it),
    RUN(directions_lead_to_the_pictures_of_points_along_them),
    RUN(depth_at_infinity_is_where_rays_end),
    RUN(waves_use_the_whole_map),
    RUN(guard_band_widens_the_map_about_its_middle),
    RUN(guard_band_follows_the_waves),
    RUN(environment_has_its_own_axes),
    RUN(eye_under_the_sheet_is_submerged),
    RUN(near_plane_in_the_water_is_awash),
    RUN(waves_decide_where_the_eye_is),
    RUN(each_corner_of_the_near_plane_is_asked),
    RUN(eye_is_over_the_rim_of_the_sheet),
    RUN(sun_is_seen_in_the_axes_of_the_plane),
    RUN(top_is_the_highest_drawn_corner),
    RUN(depth_of_the_map_tells_heights),
    RUN(mirrored_view_reaches_down_into_troughs),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
