// SPDX-License-Identifier: BSD-3-Clause
// test_plan_edges.c: scenes at the ends of what a plan decides: clips under troughs, props in
// several batches, pictures of which nothing counts, near planes at the edge of a prop.
#include "test_scene.h"

#include "water_mirror.h"
#include "water_plan.h"
#include "water_plan_draw.h"
#include "water_select.h"

static const uint32_t visible = WATER_PROP_VISIBLE;

// The clip lies as low as the waves reach, but not lower than the surface's own lowest corner, less
// a thousandth of the way.
TEST(clip_is_under_the_troughs)
{
  water_scene scene = lake();
  const double normal[3] = { 0.36, -0.48, 0.8 };
  const double bounds[6] = { -3.0, 5.0, -2.0, 7.0, -1.0, 0.5 };
  memcpy(scene.plane.normal, normal, sizeof normal);
  memcpy(scene.surface_bounds, bounds, sizeof bounds);
  const double lowest = -3.0 * 0.36 - 7.0 * 0.48 - 1.0 * 0.8;
  const double heights[] = { 0.25, 100.0, 0.0 };
  const double margins[] = { 0.25, 0.999 * -lowest, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    scene.wave_height_max = heights[i];
    ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_world[3], margins[i], 1e-12);
  }
  scene.settings.clip_margin = 1.5; // the larger one counts
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_world[3], 1.5, 1e-12);
  scene.is_endless = true;
  scene.settings.clip_margin = 0.0;
  scene.wave_height_max = 100.0;
  ASSERT_CLOSE(plan_of(&scene, NULL).clip_plane_world[3], 100.0, 1e-9);
}

// A plan takes the largest heights that there may be.
TEST(heights_at_the_end_of_their_range)
{
  water_scene scene = lake();
  water_plan plan;
  scene.surface_height = 1e100;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  scene.surface_height = -1e100;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  scene.surface_height = 1.0000001e100;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_BAD_CLIP_MARGIN);
}

// Tops of what rays may meet: over the troughs in which they may start.
TEST(tops_are_over_the_troughs)
{
  const water_prop props[] = { { { -1.0, 1.0, 4.0, 6.0, 0.0, 3.0 }, visible, 0.0f },
    { { -90.0, 90.0, -90.0, 90.0, -90.0, 90.0 }, visible, 0.0f } };
  water_cull_reason reasons[2];
  water_scene scene = lake();
  scene.props = props;
  scene.wave_height_max = 0.5;
  scene.has_waves = true;
  scene.slope_rms = 0.05;
  scene.prop_count = 1;
  water_plan plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.reflection_top, 3.5, 1e-12);
  ASSERT_CLOSE(plan.rest_top, 0.0, 0.0); // without a dome there is no rest
  assert_false(plan.is_enclosed);
  scene.prop_count = 2;
  plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.reflection_top, 90.5, 1e-12);
  ASSERT_CLOSE(plan.rest_top, 3.5, 1e-12);
  assert_true(plan.is_enclosed && plan.rest_depth > 0.0);
  scene.has_waves = false;
  plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.rest_top, 0.0, 0.0); // calm water looks up no rays
  ASSERT_CLOSE(plan.rest_depth, 0.0, 0.0);
}

// One dome among many props encloses the water, whether it is the first or the last of them.
TEST(one_dome_of_many_props)
{
  enum
  {
    COUNT = 600
  };
  static water_prop props[COUNT];
  static water_cull_reason reasons[COUNT];
  const water_prop dome = { { -90.0, 90.0, -90.0, 90.0, -90.0, 90.0 }, visible, 0.0f };
  const water_prop post = { { -1.0, 1.0, 4.0, 6.0, 0.0, 3.0 }, visible, 0.0f };
  const water_prop beside = { { 0.0, 180.0, -90.0, 90.0, -90.0, 90.0 }, visible, 0.0f };
  const int places[] = { 0, 300, COUNT - 1, -1 };
  for (int i = 0; i < 4; ++i)
  {
    for (int number = 0; number < COUNT; ++number)
    {
      props[number] = number == places[i] ? dome : post;
    }
    water_scene scene = lake();
    scene.props = props;
    scene.prop_count = COUNT;
    const water_plan plan = plan_of(&scene, reasons);
    assert_int_equal(plan.is_enclosed, places[i] >= 0);
    assert_int_equal(plan.is_sky_known, places[i] < 0);
  }
  water_scene scene = lake();
  scene.props = &beside; // the eye is in its side
  scene.prop_count = 1;
  assert_false(plan_of(&scene, reasons).is_enclosed);
}

// A dome far from the world's origin is as wide as one about it.
TEST(a_dome_far_from_the_origin)
{
  const double far[3] = { 5e3, 7e3, 3e3 };
  for (int axis = 0; axis < 3; ++axis)
  {
    water_scene scene = lake();
    double eye[3] = { 0.0, -10.0, 5.0 };
    double target[3] = { 0.0, 0.0, 0.0 };
    const double up[3] = { 0.0, 0.0, 1.0 };
    water_prop dome = { { -90.0, 90.0, -90.0, 90.0, -90.0, 90.0 }, visible, 0.0f };
    eye[axis] += far[axis];
    target[axis] += far[axis];
    for (int i = 0; i < 2; ++i)
    {
      dome.bounds[2 * axis + i] += far[axis];
      scene.surface_bounds[2 * axis + i] += far[axis];
    }
    scene.plane.offset = axis == 2 ? -far[2] : 0.0;
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.props = &dome;
    scene.prop_count = 1;
    water_cull_reason reason;
    assert_true(plan_of(&scene, &reason).is_enclosed);
  }
}

// A wide point beside the water reaches into its reflection, by half of its width, on every side.
TEST(wide_points_reach_in_from_all_sides)
{
  for (int side = 0; side < 4; ++side)
  {
    for (int is_wide = 0; is_wide < 2; ++is_wide)
    {
      water_scene scene =
        pool(5.0); // half of the picture; from 10 below, a point 1 high is 11 away
      const double place = (side & 1 ? -0.53 : 0.53) * 11.0;
      const double x = side & 2 ? 0.0 : place;
      const double y = side & 2 ? place : 0.0;
      const water_prop point = { { x, x, y, y, 1.0, 1.0 }, visible, is_wide ? 60.0f : 1.0f };
      scene.props = &point;
      scene.prop_count = 1;
      water_cull_reason reason;
      (void)plan_of(&scene, &reason);
      assert_int_equal(reason, is_wide ? WATER_CULL_NONE : WATER_CULL_OUT_OF_WATER);
    }
  }
}

// An eye 10 over the middle of a pond, 90 degrees wide both ways, whose water looks up the middle
// half of its picture of 100 x 100 pixels: what is beside that by x or y pixels, 1 high, and its
// reason.
static water_cull_reason reason_beside(
  double x_px, double y_px, const double size_px[2], float width_px, double px_min)
{
  const water_scene scene = pool(5.0);
  const water_selection selection = {
    .box = { -0.5, -0.5, 0.5, 0.5 }, .prop_px_min = px_min, .texture_px = { 100, 100 }
  };
  const double pixel = 9.0 / 50.0; // at the height of 1
  water_prop prop = { { 0.0, 0.0, 0.0, 0.0, 1.0, 1.0 }, visible, width_px };
  for (int i = 0; i < 2; ++i)
  {
    const double place = pixel * (i ? y_px : x_px);
    prop.bounds[2 * i] = place - 0.5 * pixel * size_px[i];
    prop.bounds[2 * i + 1] = place + 0.5 * pixel * size_px[i];
  }
  water_cull_reason reason;
  assert_int_equal(water_select_props(&scene.eye, &scene.plane, &selection, &prop, 1, &reason), 1);
  return reason;
}

// A point 10 pixels wide reaches in from 5 pixels, and one more for antialiasing, on every side.
TEST(a_wide_point_reaches_half_its_width_and_a_pixel)
{
  const double none[2] = { 0.0, 0.0 };
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double away = (side & 1 ? -1.0 : 1.0) * (i ? 31.1 : 30.9); // 25 of them inside
      const double x = side & 2 ? 0.0 : away;
      const double y = side & 2 ? away : 0.0;
      assert_int_equal(
        reason_beside(x, y, none, 10.0f, 0.0), i ? WATER_CULL_OUT_OF_WATER : WATER_CULL_NONE);
    }
  }
}

// What is as large as the smallest prop in one direction is drawn, wherever it is.
TEST(a_prop_is_small_if_it_is_so_both_ways)
{
  const double sizes[3][2] = { { 1.0, 5.1 }, { 5.1, 1.0 }, { 4.9, 4.9 } };
  const double places[3] = { -20.0, 0.0, 20.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int place = 0; place < 9; ++place)
    {
      assert_int_equal(reason_beside(places[place % 3], places[place / 3], sizes[i], 1.0f, 5.0),
        i == 2 ? WATER_CULL_TOO_SMALL : WATER_CULL_NONE);
    }
  }
}

// Water that reflects nothing needs no mirrored view. Of the views for other ends it says nothing.
TEST(only_the_mirrored_view_asks_what_is_reflected)
{
  for (int i = 0; i < 4; ++i)
  {
    water_scene scene = lake();
    water_plan plan;
    scene.look.constant_reflectance = true;
    scene.look.reflectance = 0.0;
    scene.is_beyond = i == 1;
    scene.is_from_sun = i == 2;
    scene.is_of_sky = i == 3;
    (void)water_plan_make(&scene, &plan, NULL);
    assert_int_equal(plan.decision == WATER_NO_REFLECT_NO_REFLECTANCE, i == 0);
  }
}

// The clip at the water cuts what lies across it, or where nobody knows, and nothing over it.
TEST(the_clip_cuts_what_is_across_the_water)
{
  const double huge = (double)INFINITY;
  const double boxes[6][6] = { { -1.0, 1.0, -1.0, 1.0, 0.1, 2.0 },
    { -1.0, 1.0, -1.0, 1.0, -0.1, 2.0 }, { -1.0, 1.0, -1.0, 1.0, 0.1, huge },
    { huge, -huge, huge, -huge, huge, -huge }, { -1.0, 1.0, -1.0, 1.0, 0.1, (double)NAN },
    { 1.0, -1.0, 1.0, -1.0, 3.0, 2.0 } };
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  for (int i = 0; i < 6; ++i)
  {
    assert_int_equal(water_plan_cuts(&plan, boxes[i]), i > 0);
  }
}

// A prop of exactly the smallest size is drawn: half a unit, 8 under the eye, is 3.125 of 100
// pixels.
TEST(a_prop_of_the_smallest_size_is_drawn)
{
  const water_scene scene = pool(5.0);
  const water_prop prop = { { -0.25, 0.25, -0.25, 0.25, 2.0, 2.0 }, visible, 1.0f };
  for (int i = 0; i < 2; ++i)
  {
    const water_selection selection = { .box = { -0.5, -0.5, 0.5, 0.5 },
      .prop_px_min = i ? nextafter(3.125, 4.0) : 3.125,
      .texture_px = { 100, 100 } };
    water_cull_reason reason;
    assert_int_equal(
      water_select_props(&scene.eye, &scene.plane, &selection, &prop, 1, &reason), 1);
    assert_int_equal(reason, i ? WATER_CULL_TOO_SMALL : WATER_CULL_NONE);
  }
}

// Only a part of the picture counts, such as that of a reflection's reflection: none, if it has no
// width or height.
TEST(nothing_counts_in_a_rectangle_without_an_area)
{
  water_scene scene = pool(30.0);
  const int rects[][4] = { { 100, 100, 50, 50 }, { 100, 100, 0, 50 }, { 100, 100, 50, 0 } };
  for (int i = 0; i < 3; ++i)
  {
    scene.viewport_rect_px = rects[i];
    assert_int_equal(
      plan_of(&scene, NULL).decision, i == 0 ? WATER_REFLECT : WATER_NO_REFLECT_OUT_OF_VIEW);
  }
}

// With the skip off, endless water that is not seen is planned for all of the picture.
TEST(unseen_endless_water_may_be_drawn)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, 5.0 };
  const double target[3] = { 0.0, 1.0, 8.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, target, up, scene.eye.world_to_view);
  scene.is_endless = true;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_UNSEEN;
  const water_plan plan = plan_of(&scene, NULL);
  assert_int_equal(plan.decision, WATER_REFLECT);
  const int whole[4] = { 0, 0, 800, 600 };
  assert_memory_equal(plan.texture_rect_px, whole, sizeof whole);
}

// Which tone mapping follows is the host's, and told as it is.
TEST(light_rolls_off_where_nothing_maps_it)
{
  water_scene scene = lake();
  scene.may_tone_map = false;
  assert_true(plan_of(&scene, NULL).rolls_off);
  scene.may_tone_map = true;
  assert_false(plan_of(&scene, NULL).rolls_off);
}

// Near and far plane may both move: depths of the picture lead to those of the reflection texture.
TEST(depths_with_both_planes_moved)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, 1.0 };
  const double target[3] = { 0.0, 1.0, 0.7 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double box[4] = { -4.0, 4.0, -3.0, 3.0 };
  see_from(&scene, eye, target, up, box, 3.0, 50.0);
  const water_prop props[2] = { { { -2.0, 2.0, 1.0, 2.0, 0.0, 1.0 }, visible, 0.0f },
    { { -2.0, 2.0, 100.0, 120.0, 0.0, 30.0 }, visible, 0.0f } };
  water_cull_reason reasons[2];
  scene.props = props;
  scene.prop_count = 2;
  scene.is_endless = true;
  const water_plan plan = plan_of(&scene, reasons);
  assert_true(plan.depth_offset > 0.0 && plan.depth_scale + plan.depth_offset < 1.0);
  for (int i = 1; i < 20; ++i)
  {
    const double point[3] = { 0.3 * i, 2.0 * i, 0.0 };
    double seen[4];
    double mirrored[4];
    project(&scene.eye, point, 1.0, seen);
    project(&plan.mirrored, point, 1.0, mirrored);
    ASSERT_CLOSE(0.5 + 0.5 * mirrored[2] / mirrored[3],
      plan.depth_scale * (0.5 + 0.5 * seen[2] / seen[3]) + plan.depth_offset, 1e-12);
  }
}

// A level eye 1 over the water that looks along y, with a near plane at 1 and a far plane at 3.
static water_scene level_view(void)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, 1.0 };
  const double target[3] = { 0.0, 1.0, 1.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  see_from(&scene, eye, target, up, box, 1.0, 3.0);
  return scene;
}

// What ends at the water, in the eye's plane or on the near plane moves no near plane; what is
// before it does, whichever it is in the list.
TEST(near_plane_stays_at_the_edges_of_props)
{
  const water_scene scene = level_view();
  const water_prop edges[] = { { { -1.0, 1.0, 0.5, 2.0, -1.0, 0.0 }, visible, 0.0f },
    { { -1.0, 1.0, -2.0, 0.0, 0.0, 2.0 }, visible, 0.0f },
    { { -1.0, 1.0, 1.0, 2.0, 0.0, 2.0 }, visible, 0.0f } };
  const water_prop before = { { -1.0, 1.0, 0.5, 2.0, 0.0, 2.0 }, visible, 0.0f };
  for (int i = 0; i < 3; ++i)
  {
    water_camera camera = scene.eye;
    ASSERT_CLOSE(water_mirror_near(&scene.plane, edges + i, 1, &camera), 1.0, 0.0);
    assert_memory_equal(&camera, &scene.eye, sizeof camera);
    const water_prop both[2] = { edges[i], before };
    const double scale = water_mirror_near(&scene.plane, both, 2, &camera);
    // z' = s z + (1 - s) w is -w, but for the margin, at a distance of a half: z is -2, w a half
    ASSERT_CLOSE(scale, 0.4, 1e-6);
  }
}

// A projection whose far plane is beyond infinity has no least distance to keep.
TEST(near_plane_stays_without_a_far_plane)
{
  const water_scene scene = level_view();
  const water_prop before = { { -1.0, 1.0, 0.5, 2.0, 0.0, 2.0 }, visible, 0.0f };
  const double slopes[] = { -1.0, -0.99 };
  for (int i = 0; i < 2; ++i)
  {
    water_camera camera = scene.eye;
    camera.view_to_clip[10] = slopes[i];
    camera.view_to_clip[11] = -2.0;
    const water_camera own = camera;
    ASSERT_CLOSE(water_mirror_near(&scene.plane, &before, 1, &camera), 1.0, 0.0);
    assert_memory_equal(&camera, &own, sizeof camera);
  }
}

// A view along the sun of a box that rises so little over the plane has no matrices: its range of
// depths has no inverse. Found by the fuzzer of plans.
TEST(sun_view_whose_matrices_are_no_numbers)
{
  const double world_to_view[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, -0.9614231729407493,
    -0.27507359475700693, 0.0, 0.0, 0.27507359475700693, -0.9614231729407493,
    6.4685791714588124e-317, 0.0, 0.0, 0.0, 1.0 };
  const double view_to_clip[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.3, 0.0, 0.0, 0.0, 0.0, -1.01, -2.01,
    0.0, 0.0, -1.0, 0.0 };
  const double sun[3] = { 1.0, 1.0, 1.0 };
  const water_prop box = { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.483509328541691e-306 }, visible, 0.0f };
  water_scene scene = lake();
  memcpy(scene.eye.world_to_view, world_to_view, sizeof world_to_view);
  memcpy(scene.eye.view_to_clip, view_to_clip, sizeof view_to_clip);
  memcpy(scene.sun_dir, sun, sizeof sun);
  scene.is_from_sun = scene.has_sun = true;
  scene.settings.skips = 0;
  scene.props = &box;
  scene.prop_count = 1;
  water_cull_reason reason;
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, &reason), WATER_BAD_CAMERA);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_FAILED);
}

TESTS(sun_view_whose_matrices_are_no_numbers, the_clip_cuts_what_is_across_the_water,
  only_the_mirrored_view_asks_what_is_reflected, a_prop_of_the_smallest_size_is_drawn,
  a_wide_point_reaches_half_its_width_and_a_pixel, a_prop_is_small_if_it_is_so_both_ways,
  clip_is_under_the_troughs, heights_at_the_end_of_their_range, tops_are_over_the_troughs,
  one_dome_of_many_props, a_dome_far_from_the_origin, wide_points_reach_in_from_all_sides,
  nothing_counts_in_a_rectangle_without_an_area, unseen_endless_water_may_be_drawn,
  light_rolls_off_where_nothing_maps_it, depths_with_both_planes_moved,
  near_plane_stays_at_the_edges_of_props, near_plane_stays_without_a_far_plane)
