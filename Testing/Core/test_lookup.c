// SPDX-License-Identifier: BSD-3-Clause
// test_lookup.c: places on the plane behind a pixel, rays in
// the reflection texture's window, depths at infinity.
#include "test_scene.h"

#include "water_lookup.h"
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
// plus t times the direction's are; the place's own depth in the reflection texture is that of the
// eye, scaled.
TEST(directions_lead_to_the_pictures_of_points_along_them)
{
  dice from = dice_seeded(62);
  for (int round = 0; round < 2000; ++round)
  {
    random_scene random = wavy(&from, round);
    water_prop tall = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 }, WATER_PROP_VISIBLE };
    water_cull_reason reason = WATER_CULL_NONE;
    for (int i = 0; i < 3; ++i) // far away, so that the reflection texture's far plane moves
    {
      tall.bounds[2 * i] = random.target[i] - 300.0;
      tall.bounds[2 * i + 1] = random.target[i] + 300.0;
    }
    random.scene.props = &tall;
    random.scene.prop_count = 1;
    const water_plan plan = plan_of(&random.scene, &reason);
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
      ASSERT_CLOSE(start[i] + t * dot(plan.dir_to_reflection + 3 * i, dir), end[i], 1e-9);
      ASSERT_CLOSE(eye[i] + t * dot(plan.dir_to_eye + 3 * i, dir), seen[i], 1e-9);
    }
  }
}

// A ray of a perspective reflection texture ends at the depth of infinity; that of a parallel
// reflection texture never does.
TEST(depth_at_infinity_is_where_rays_end)
{
  dice from = dice_seeded(63);
  for (int round = 0; round < 300; ++round)
  {
    const random_scene random = wavy(&from, round);
    const water_plan plan = plan_of(&random.scene, NULL);
    if (random.is_parallel)
    {
      ASSERT_CLOSE(plan.reflection_z_infinity, 2.0, 0.0);
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
    ASSERT_CLOSE(0.5 + 0.5 * clip[2] / clip[3], plan.reflection_z_infinity, 1e-6);
    assert_true(plan.reflection_z_infinity > 1.0);
  }
}

// Waves of any slope may look a pixel's ray up anywhere in the reflection texture, so all of it is
// drawn.
TEST(waves_use_the_whole_map)
{
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

// A guard band shows more of the same: what the reflection texture saw at a place it sees at
// reflection_scale times it.
TEST(guard_band_widens_the_map_about_its_middle)
{
  dice from = dice_seeded(64);
  for (int round = 0; round < 1000; ++round)
  {
    random_scene random = wavy(&from, round);
    const water_plan plain = plan_of(&random.scene, NULL);
    random.scene.settings.guard_band = dice_roll(&from, 1.0, 2.0);
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
      assert_true(wide.texture_px[i] >= random.scene.settings.guard_band * plain.texture_px[i]);
      assert_int_equal((wide.texture_px[i] - plain.texture_px[i]) % 2, 0);
      ASSERT_CLOSE(after[i] * wide.texture_px[i], before[i] * plain.texture_px[i], 1e-8);
      ASSERT_CLOSE(wide.reflection_scale[i] * wide.texture_px[i], plain.texture_px[i], 1e-9);
    }
    // the sky of a direction does not depend on the band
    const double ndc[3] = { dice_roll(&from, -1.0, 1.0), dice_roll(&from, -1.0, 1.0), 1.0 };
    const double in_wide[3] = { wide.reflection_scale[0] * ndc[0],
      wide.reflection_scale[1] * ndc[1], 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(dot(wide.reflection_ndc_to_eye + 3 * i, in_wide),
        dot(plain.reflection_ndc_to_eye + 3 * i, ndc), 1e-9);
    }
  }
}

// By itself the band grows with the waves up to a quarter, and stops at the GPU's limit.
TEST(guard_band_follows_the_waves)
{
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
  water_scene scene = lake();
  scene.has_waves = true;
  water_prop props[3] = { { { -1.0, 1.0, -1.0, 1.0, -2.0, 3.0 }, WATER_PROP_VISIBLE },
    { { -2.0, 2.0, -2.0, 2.0, 0.0, 4.0 }, WATER_PROP_VISIBLE },
    { { -1.0, 1.0, -1.0, 1.0, 0.0, 9.0 }, 0u } };
  water_cull_reason reasons[3];
  scene.props = props;
  scene.prop_count = 3;
  ASSERT_CLOSE(plan_of(&scene, reasons).reflection_top, 4.0, 1e-12);
  scene.plane.offset = -1.0; // the water rises by 1
  ASSERT_CLOSE(plan_of(&scene, reasons).reflection_top, 3.0, 1e-12);
  props[0].flags |= WATER_PROP_NO_BOUNDS;
  assert_true(isinf(plan_of(&scene, reasons).reflection_top));
  scene.prop_count = 0;
  ASSERT_CLOSE(plan_of(&scene, NULL).reflection_top, 0.0, 0.0);
}

// Rays end above the top, or rounding would tell whether they meet what lies there.
TEST(rays_end_above_the_top)
{
  ASSERT_CLOSE(water_lookup_end(3.0), 3.3, 1e-12);
  ASSERT_CLOSE(water_lookup_end(0.0), 0.0, 0.0);
  assert_true(isinf(water_lookup_end((double)INFINITY)));
}

// VTK's default environment has the world's axes; with +z up and +x right, back is -y.
TEST(environment_has_its_own_axes)
{
  water_scene scene = lake();
  scene.has_environment = true;
  water_plan plan = plan_of(&scene, NULL); // no directions: the world's
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE(plan.environment_map.to_map[i], i % 4 == 0 ? 1.0 : 0.0, 1e-15);
  }
  const double up[3] = { 0.0, 0.0, 2.0 };
  const double right[3] = { 3.0, 0.0, 1.0 }; // not at right angles
  memcpy(scene.environment_up, up, sizeof up);
  memcpy(scene.environment_right, right, sizeof right);
  plan = plan_of(&scene, NULL);
  const double expected[9] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, -1.0, 0.0 };
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE(plan.environment_map.to_map[i], expected[i], 1e-15);
  }
}

// The sun in the plane's axes; a light without a direction is none.
TEST(sun_is_seen_in_the_axes_of_the_plane)
{
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

// The reflection texture's depth says how high what it shows is over the plane, on the eye's side.
TEST(depth_of_the_map_tells_heights)
{
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
      height += plan.reflection_height[i] * clip[i] / clip[3];
      w += plan.reflection_w[i] * clip[i] / clip[3];
    }
    ASSERT_CLOSE(height / w, height_of(&random, point), 1e-8);
  }
}

// Waves that move the surface: what stands in a trough is drawn, and rays from one may rise
// further.
TEST(mirrored_view_reaches_down_into_troughs)
{
  water_scene scene = lake();
  scene.has_waves = true;
  scene.settings.clip_margin = 0.1;
  const double flat = plan_of(&scene, NULL).clip_plane_view[3];
  scene.wave_height_max = 0.75;
  scene.surface_bounds[4] = -0.76;
  scene.surface_bounds[5] = 0.75;
  const water_plan plan = plan_of(&scene, NULL);
  ASSERT_CLOSE(plan.clip_plane_view[3] - flat, 0.65, 1e-12);
  ASSERT_CLOSE(plan.reflection_top, 0.75, 1e-12);
  scene.settings.clip_margin = 1.0; // the user's, if that is more
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.9, 1e-12);
  water_prop low = { { -1.0, 1.0, -1.0, 1.0, -2.0, -0.5 }, WATER_PROP_VISIBLE };
  water_cull_reason reason = WATER_CULL_NONE;
  scene.props = &low;
  scene.prop_count = 1;
  scene.settings.clip_margin = 0.0;
  plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_NONE);
  scene.wave_height_max = 0.25;
  plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_BEHIND_PLANE);
  water_plan bad;
  scene.wave_height_max = (double)NAN;
  assert_int_equal(water_plan_make(&scene, &bad, &reason), WATER_BAD_CLIP_MARGIN);
}

// A splash that stands high over the plane takes nothing from what hides the bed from the mirrored
// eye; seen from under it, it does.
TEST(mirrored_view_begins_at_the_lowest_point)
{
  water_scene scene = lake();
  scene.has_waves = true;
  const double flat = plan_of(&scene, NULL).clip_plane_view[3];
  scene.wave_height_max = 0.6;
  scene.surface_bounds[4] = -0.25;
  scene.surface_bounds[5] = 0.6;
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.25 * 0.999, 1e-12);
  scene.surface_bounds[4] = 0.1; // all of it over the plane
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.0, 1e-12);
  scene.is_endless = true; // of bounds that nobody knows
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.6, 1e-12);
  scene.is_endless = false;
  scene.surface_bounds[4] = -0.25;
  scene.plane.normal[2] = -1.0; // the eye is on the other side of the plane that points down
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_view[3] - flat, 0.25 * 0.999, 1e-12);
}

// What lies under the plane, and what a ray comes to that goes down from it, is in the part of the
// picture under the horizon; straight over the middle of that the view goes up.
TEST(what_is_under_water_is_under_the_horizon)
{
  dice from = dice_seeded(71);
  int seen = 0;
  int smaller = 0;
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = wavy(&from, round);
    const water_plan plan = plan_of(&random.scene, NULL);
    const int viewport_px[2] = { 400, 300 };
    int rect[4];
    water_lookup_under(&plan, true, viewport_px, rect);
    assert_true(
      rect[0] >= 0 && rect[1] >= 0 && rect[0] + rect[2] <= 400 && rect[1] + rect[3] <= 300);
    smaller += rect[2] * rect[3] < 400 * 300 ? 1 : 0;
    const double length = sqrt(dot(random.scene.plane.normal, random.scene.plane.normal));
    // a point on the plane, and a way down from it, away from the eye's side
    double x_dir[3];
    double y_dir[3];
    axes_of(&random, x_dir, y_dir);
    const double side = plan.side == WATER_BELOW ? -1.0 : 1.0;
    double point[3];
    const double roll[3] = { dice_roll(&from, -3.0, 3.0), dice_roll(&from, -3.0, 3.0),
      dice_roll(&from, 0.0, 4.0) };
    for (int i = 0; i < 3; ++i)
    {
      point[i] = random.target[i] + roll[0] * x_dir[i] + roll[1] * y_dir[i] -
        side * roll[2] * random.scene.plane.normal[i] / length;
    }
    double clip[4];
    project(&random.scene.eye, point, 1.0, clip);
    if (!is_inside(clip))
    {
      continue;
    }
    ++seen;
    const double px[2] = { 200.0 * (clip[0] / clip[3] + 1.0), 150.0 * (clip[1] / clip[3] + 1.0) };
    for (int i = 0; i < 2; ++i)
    {
      assert_true(px[i] >= rect[i] && px[i] <= rect[i] + rect[2 + i]);
    }
  }
  assert_true(seen > 300 && smaller > 100);
}

// By hand: level, 90 degrees high and wide, turned down by atan(0.5): the horizon is at 3/4 of the
// height.
TEST(horizon_of_a_level_camera)
{
  const int viewport_px[2] = { 200, 100 };
  int rect[4];
  const water_plan level = { .ndc_to_ray = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, -0.5 } };
  water_lookup_under(&level, true, viewport_px, rect);
  const int expected[4] = { 0, 0, 200, 77 };
  assert_memory_equal(rect, expected, sizeof rect);
  const water_plan down = { .ndc_to_ray = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0 } };
  const int all[4] = { 0, 0, 200, 100 };
  water_lookup_under(&down, true, viewport_px, rect);
  assert_memory_equal(rect, all, sizeof rect);
  const water_plan up = { .ndc_to_ray = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 } };
  const int none[4] = { 0, 0, 0, 0 };
  water_lookup_under(&up, true, viewport_px, rect);
  assert_memory_equal(rect, none, sizeof rect);
  const water_plan rolled = { .ndc_to_ray = { 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0 } };
  const int left[4] = { 0, 0, 102, 100 };
  water_lookup_under(&rolled, true, viewport_px, rect);
  assert_memory_equal(rect, left, sizeof rect);
  // waves that move the surface, and an eye in it, see all
  water_lookup_under(&level, false, viewport_px, rect);
  assert_memory_equal(rect, all, sizeof rect);
  water_plan in_water = level;
  in_water.is_submerged = true;
  water_lookup_under(&in_water, true, viewport_px, rect);
  assert_memory_equal(rect, all, sizeof rect);
  in_water.is_submerged = false;
  in_water.is_awash = true;
  water_lookup_under(&in_water, true, viewport_px, rect);
  assert_memory_equal(rect, all, sizeof rect);
}

// What a texel more to the right, or up, gains in height at one depth.
TEST(waterline_follows_from_heights_of_texels)
{
  const int texture_px[2] = { 320, 240 };
  // height / w of a place in NDC, as for an eye that looks down, and is rolled
  const double heights[4] = { 0.03, -0.4, 0.7, -0.2 };
  double waterline[4];
  water_lookup_waterline(heights, texture_px, waterline);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double texel[2] = { 100.0, 70.0 };
    const double here = 2.0 * texel[axis] / texture_px[axis] - 1.0;
    const double next = 2.0 * (texel[axis] + 1.0) / texture_px[axis] - 1.0;
    ASSERT_CLOSE(waterline[axis], heights[axis] * next - heights[axis] * here, 1e-15);
    ASSERT_CLOSE(waterline[2 + axis], texture_px[axis], 0.0);
  }
}

// Foam is after 12 s as it was, before the time 0, too.
TEST(foam_comes_back)
{
  ASSERT_CLOSE(water_lookup_pattern_turn(3.0), 0.25, 1e-15);
  ASSERT_CLOSE(water_lookup_pattern_turn(-3.0), 0.75, 1e-15);
  ASSERT_CLOSE(water_lookup_pattern_turn(1200003.0), 0.25, 1e-9);
}

// Pixels under the horizon: a corner of the picture exactly on it is where the horizon crosses the
// border, and a picture of which no more than that is under it has none.
TEST(a_corner_on_the_horizon_is_where_it_crosses)
{
  const int viewport_px[2] = { 100, 80 };
  const double rises[3][3] = { { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 1.0 }, { 1.0, 1.0, 2.0 } };
  for (int i = 0; i < 3; ++i)
  {
    int rect_px[4] = { 7, 7, 7, 7 };
    water_plan plan;
    memset(&plan, 0, sizeof plan);
    memcpy(plan.ndc_to_ray + 6, rises[i], sizeof rises[i]);
    water_lookup_under(&plan, true, viewport_px, rect_px);
    assert_int_equal(rect_px[0], 0);
    assert_int_equal(rect_px[1], 0);
    assert_int_equal(rect_px[2], i == 0 ? 100 : 0);
    assert_int_equal(rect_px[3], i == 0 ? 80 : 0);
  }
}

TESTS(rays_end_above_the_top, a_corner_on_the_horizon_is_where_it_crosses,
  waterline_follows_from_heights_of_texels, foam_comes_back, pixel_of_a_place_leads_back_to_it,
  what_is_under_water_is_under_the_horizon, horizon_of_a_level_camera,
  directions_lead_to_the_pictures_of_points_along_them, depth_at_infinity_is_where_rays_end,
  waves_use_the_whole_map, guard_band_widens_the_map_about_its_middle, guard_band_follows_the_waves,
  top_is_the_highest_drawn_corner, environment_has_its_own_axes,
  sun_is_seen_in_the_axes_of_the_plane, depth_of_the_map_tells_heights,
  mirrored_view_reaches_down_into_troughs, mirrored_view_begins_at_the_lowest_point)
