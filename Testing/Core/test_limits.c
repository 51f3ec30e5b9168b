// SPDX-License-Identifier: BSD-3-Clause
// test_limits.c: the ends of what is accepted belong to it, and what lies exactly on a border has
// an answer.
#include "test_scene.h"

#include "water_camera.h"
#include "water_glitter.h"
#include "water_grid.h"
#include "water_lookup.h"
#include "water_medium.h"
#include "water_mirror.h"
#include "water_normals.h"
#include "water_optics.h"
#include "water_plan.h"
#include "water_plane.h"
#include "water_prop.h"
#include "water_select.h"
#include "water_target.h"
#include "water_tile.h"
#include "water_waves.h"
#include "water_whitecap.h"

static const double inf = (double)INFINITY;

// A ray along the surface between equal media goes on along it: no total reflection yet.
TEST(ray_along_a_surface_that_is_none_goes_on)
{
  const double along[3] = { 1.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  double refracted[3] = { 7.0, 7.0, 7.0 };
  assert_int_equal(water_medium_refract(along, up, 1.0, refracted), WATER_OK);
  assert_true(refracted[0] == 1.0 && refracted[1] == 0.0 && refracted[2] == 0.0);
}

// A view may be off from rigid by its tolerance, and no more.
TEST(view_at_its_tolerance_is_rigid)
{
  water_eye eye;
  water_scene scene = lake();
  memset(scene.eye.world_to_view, 0, sizeof scene.eye.world_to_view);
  for (int i = 0; i < 4; ++i)
  {
    scene.eye.world_to_view[5 * i] = 1.0;
  }
  water_camera slanted = scene.eye;
  slanted.world_to_view[4] = 1e-6; // the dot product of the first two rows
  assert_int_equal(water_camera_decompose(&slanted, &eye), WATER_OK);
  slanted.world_to_view[4] = 1.0001e-6;
  assert_int_equal(water_camera_decompose(&slanted, &eye), WATER_BAD_CAMERA);
  for (int i = 0; i < 3; ++i)
  {
    water_camera last = scene.eye;
    last.world_to_view[12 + i] = 1e-12;
    assert_int_equal(water_camera_decompose(&last, &eye), WATER_OK);
    last.world_to_view[12 + i] = 1.0001e-12;
    assert_int_equal(water_camera_decompose(&last, &eye), WATER_BAD_CAMERA);
  }
}

TEST(winds_at_both_ends_are_accepted)
{
  double two[2];
  assert_int_equal(water_glitter_variance(0.1, two), WATER_OK);
  assert_int_equal(water_glitter_variance(100.0, two), WATER_OK);
  assert_int_equal(water_glitter_mean_square(0.1, two), WATER_OK);
  assert_int_equal(water_glitter_mean_square(100.0, two), WATER_OK);
}

// The sun on the horizon lights no glitter, and an eye in the surface sees none.
TEST(glitter_ends_at_the_horizon)
{
  const double variance[2] = { 0.03, 0.02 };
  const double level[3] = { 1.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  double facet = 0.0;
  assert_true(water_glitter_radiance(level, up, 0.0, variance, &facet) == 0.0);
  ASSERT_CLOSE(facet, sqrt(0.5), 1e-15);
  assert_true(water_glitter_radiance(up, level, 0.0, variance, &facet) == 0.0);
}

TEST(seas_at_both_ends_are_accepted)
{
  const water_sea low = { WATER_SEA_JONSWAP, WATER_SPREAD_COS_2S, 0.1, -1e9, 1.0, 1e-9, 1.0, 0.0 };
  const water_sea high = { WATER_SEA_PHILLIPS, WATER_SPREAD_DONELAN_BANNER, 100.0, 1e9, inf, inf,
    20.0, 1000.0 };
  assert_int_equal(water_sea_check(&low), WATER_OK);
  assert_int_equal(water_sea_check(&high), WATER_OK);
  const water_tile small = { 4, 1e-3, 0.0, 0, 0.0, 0.0 };
  const water_tile large = { 16384, 1e9, 1e9, 1, 0.0, 0.0 };
  assert_int_equal(water_tile_check(&small, &low), WATER_OK);
  assert_int_equal(water_tile_check(&large, &high), WATER_OK);
  water_sea none = low;
  none.depth = 0.0;
  assert_int_equal(water_sea_check(&none), WATER_BAD_DEPTH);
}

TEST(normal_maps_at_both_ends_are_accepted)
{
  const water_normal_map low = { 1e-6, 0.0, 0.0, -1000.0 };
  const water_normal_map high = { 1e9, 0.0, 0.0, 1000.0 };
  assert_int_equal(water_normals_check(&low), WATER_OK);
  assert_int_equal(water_normals_check(&high), WATER_OK);
}

TEST(looks_at_both_ends_are_accepted)
{
  const water_look low = { 1.0, 0.0, true };
  const water_look high = { 1e300, 1.0, true };
  assert_int_equal(water_optics_check(&low), WATER_OK);
  assert_int_equal(water_optics_check(&high), WATER_OK);
}

// Waves of steepness 1 whose crests are cusps do not fold; flat waves are waves.
TEST(waves_at_both_ends_are_accepted)
{
  const double two_pi = 6.283185307179586;
  const water_wave waves[2] = { { 1.0, two_pi, 0.0, 0.0, 1.0 }, { 0.0, 1.0, 0.0, 0.0, 0.0 } };
  size_t bad_index = 7;
  assert_int_equal(water_waves_check(waves, 2, &bad_index), WATER_OK);
  assert_true(bad_index == 7);
  double number = 0.0;
  assert_int_equal(water_waves_omega(0.0, 1.0, &number), WATER_OK);
  assert_int_equal(water_waves_wavenumber(0.0, 1.0, &number), WATER_OK);
  assert_true(number == 0.0);
}

// What is a rounding over the steepest waves is not yet folded, and 16 of them are.
TEST(waves_fold_beyond_a_rounding)
{
  for (int i = 0; i < 2; ++i)
  {
    const double steepness = 1.0 + (16 + i) * DBL_EPSILON;
    const water_wave wave = { steepness, 6.283185307179586, 0.0, 0.0, 1.0 };
    size_t bad_index = 7;
    assert_int_equal(water_waves_check(&wave, 1, &bad_index), i == 0 ? WATER_OK : WATER_WAVES_FOLD);
  }
}

// Rays turned to a right angle, which is as good as endless, look up everything.
TEST(rays_turned_by_a_right_angle_reach_everything)
{
  water_camera camera = { .view_to_clip = {
                            1e-300, 0, 0, 0, 0, 1e-300, 0, 0, 0, 0, -1, -1, 0, 0, -1, 0 } };
  double box[4] = { -0.5, -0.5, 0.5, 0.5 };
  water_target_reach(&camera, 1e-300, box);
  for (int i = 0; i < 4; ++i)
  {
    assert_true(box[i] == (i < 2 ? -inf : inf));
  }
}

// Either side of a picture without pixels is refused.
TEST(both_sides_of_the_picture_are_asked)
{
  const int sizes[3][2] = { { 0, 5 }, { 5, 0 }, { 1, 1 } };
  for (int i = 0; i < 3; ++i)
  {
    int size[2] = { 7, 7 };
    assert_int_equal(
      water_target_size(sizes[i], 1.0, 100, size), i < 2 ? WATER_BAD_VIEWPORT : WATER_OK);
  }
}

TEST(scene_at_the_ends_of_its_ranges_is_planned)
{
  water_scene scene = lake();
  scene.viewport_px[0] = scene.viewport_px[1] = 1;
  scene.max_texture_px = 1;
  scene.settings.reflectance_error = 1.0;
  scene.look.constant_reflectance = true;
  scene.look.reflectance = 1.0;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_FAINT); // all may be neglected
  scene.settings.reflectance_error = 0.0;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);
  scene.viewport_px[0] = 2;
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_TEXTURE_TOO_LARGE);
}

// Over the very border of the sheet the eye is at its surface, however far out; one whose view is
// called parallel never is.
TEST(eye_at_the_border_is_at_the_surface)
{
  water_scene scene = lake();
  const double eye_at[3] = { 10.0, -10.0, -1.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye_at, target, up, scene.eye.world_to_view);
  const water_plane towards = { { 0.0, 0.0, -1.0 }, 0.0 };
  water_eye eye;
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  assert_true(water_lookup_is_at_surface(&scene.eye, &eye, &towards, scene.surface_bounds));
  scene.eye.parallel = true;
  assert_false(water_lookup_is_at_surface(&scene.eye, &eye, &towards, scene.surface_bounds));
}

// No place on a plane that is seen edge-on, nor where the numbers overflow: the outputs are kept.
TEST(edge_on_and_endless_views_have_no_places)
{
  water_scene scene = lake();
  const double eye_at[3] = { 0.0, -10.0, 1.0 };
  const double target[3] = { 0.0, 0.0, 1.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  const water_axes axes = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
    { 0.0, 0.0, 0.0 } };
  water_eye eye;
  double origin[2] = { 7.0, 7.0 };
  double places[9] = { 7.0 };
  water_camera level = scene.eye;
  look_at(eye_at, target, up, level.world_to_view);
  ortho_matrix(box, 1.0, 100.0, level.view_to_clip);
  level.parallel = true;
  assert_int_equal(water_camera_decompose(&level, &eye), WATER_OK);
  assert_int_equal(
    water_lookup_places(&level, &eye, &scene.plane, &axes, origin, places), WATER_BAD_CAMERA);
  water_grid_view view;
  assert_int_equal(
    water_grid_view_make(&level, &scene.plane, axes.origin, &view), WATER_BAD_CAMERA);
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  for (int i = 0; i < 16; ++i)
  {
    scene.eye.view_to_clip[i] *= 1e160; // the same picture; its products overflow
  }
  assert_int_equal(
    water_lookup_places(&scene.eye, &eye, &scene.plane, &axes, origin, places), WATER_BAD_CAMERA);
  assert_int_equal(
    water_grid_view_make(&scene.eye, &scene.plane, axes.origin, &view), WATER_BAD_CAMERA);
  assert_true(origin[0] == 7.0 && places[0] == 7.0);
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_BAD_CAMERA);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_FAILED);
  assert_false(plan.has_view);
}

// Numbers whose products would overflow are refused, and 1e100 is not yet one: a projection with an
// inverse of 1e307, a plane, a surface, a margin out there.
TEST(numbers_too_large_to_multiply_are_refused)
{
  const double large[2] = { 1e100, 1.0001e100 };
  for (int i = 0; i < 2; ++i)
  {
    water_plan plan;
    water_plane unit;
    water_eye eye;
    const water_plane plane = { { 0.0, 0.0, 1.0 }, large[i] };
    assert_int_equal(water_plane_normalise(&plane, &unit), i == 0 ? WATER_OK : WATER_BAD_PLANE);
    water_scene scene = lake();
    scene.surface_bounds[1] = large[i];
    assert_int_equal(water_plan_make(&scene, &plan, NULL), i == 0 ? WATER_OK : WATER_BAD_SURFACE);
    scene = lake();
    scene.settings.clip_margin = large[i];
    assert_int_equal(
      water_plan_make(&scene, &plan, NULL), i == 0 ? WATER_OK : WATER_BAD_CLIP_MARGIN);
    scene = lake();
    scene.wave_height_max = large[i];
    assert_int_equal(
      water_plan_make(&scene, &plan, NULL), i == 0 ? WATER_OK : WATER_BAD_CLIP_MARGIN);
    scene = lake();
    scene.eye.view_to_clip[0] = large[i];
    assert_int_equal(
      water_camera_decompose(&scene.eye, &eye), i == 0 ? WATER_OK : WATER_BAD_CAMERA);
  }
  water_scene scene = lake();
  water_plan plan;
  scene.eye.view_to_clip[11] = DBL_MIN;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_BAD_CAMERA);
  // and numbers whose products vanish: where they are places on the plane are lost
  scene = lake();
  for (int i = 0; i < 16; ++i)
  {
    scene.eye.view_to_clip[i] *= 1e-95;
  }
  water_eye eye;
  water_grid_view view;
  const double origin[3] = { 0.0, 0.0, 0.0 };
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  assert_int_equal(water_grid_view_make(&scene.eye, &scene.plane, origin, &view), WATER_BAD_CAMERA);
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_BAD_CAMERA);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_FAILED);
  assert_false(plan.has_view);
}

// However small the ratio of the indices, a ray along the normal goes straight on.
TEST(ray_along_the_normal_is_not_refracted)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double down[3] = { 0.0, 0.0, -1.0 };
  const double ratios[4] = { 3e-319, 1e-200, 1.0, 1e300 };
  for (int i = 0; i < 4; ++i)
  {
    double refracted[3];
    assert_int_equal(water_medium_refract(down, up, ratios[i], refracted), WATER_OK);
    assert_true(refracted[0] == 0.0 && refracted[1] == 0.0 && refracted[2] == -1.0);
  }
  const double nearly[3] = { 0.0, DBL_MIN, -1.0 }; // as far off as the ratio: along the surface
  double refracted[3];
  assert_int_equal(water_medium_refract(nearly, up, DBL_MIN, refracted), WATER_OK);
  assert_true(refracted[0] == 0.0 && refracted[1] == 1.0 && refracted[2] == 0.0);
}

// Bounds whose sum overflows are bounds.
TEST(bounds_may_be_as_large_as_doubles)
{
  water_scene scene = lake();
  const water_prop hall = { { 1.0, DBL_MAX, 1.0, DBL_MAX, 1.0, DBL_MAX }, WATER_PROP_VISIBLE };
  water_cull_reason reason = WATER_CULL_EMPTY;
  scene.props = &hall;
  scene.prop_count = 1;
  assert_false(water_prop_is_unbounded(&hall));
  plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_NONE);
}

TEST(waves_and_winds_at_both_ends_are_accepted)
{
  const water_wave waves[2] = { { 0.0, 1e-9, 0.0, 0.0, 1.0 }, { 1e9, 1e9, 0.0, 0.0, 0.0 } };
  size_t bad_index = 7;
  assert_int_equal(water_waves_check(waves, 2, &bad_index), WATER_OK);
  double cover = 7.0;
  assert_int_equal(water_whitecap_cover(0.1, &cover), WATER_OK);
  ASSERT_CLOSE(cover, 3.84e-6 * pow(0.1, 3.41), 1e-15);
  assert_int_equal(water_whitecap_cover(100.0, &cover), WATER_OK);
  ASSERT_CLOSE(cover, 1.0, 0.0);
}

TESTS(waves_and_winds_at_both_ends_are_accepted, ray_along_a_surface_that_is_none_goes_on,
  view_at_its_tolerance_is_rigid, winds_at_both_ends_are_accepted, glitter_ends_at_the_horizon,
  seas_at_both_ends_are_accepted, normal_maps_at_both_ends_are_accepted,
  looks_at_both_ends_are_accepted, waves_at_both_ends_are_accepted, waves_fold_beyond_a_rounding,
  rays_turned_by_a_right_angle_reach_everything, both_sides_of_the_picture_are_asked,
  scene_at_the_ends_of_its_ranges_is_planned, eye_at_the_border_is_at_the_surface,
  edge_on_and_endless_views_have_no_places, numbers_too_large_to_multiply_are_refused,
  ray_along_the_normal_is_not_refracted, bounds_may_be_as_large_as_doubles)
