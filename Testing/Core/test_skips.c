// SPDX-License-Identifier: BSD-3-Clause
// test_skips.c: what a plan leaves undone, why, and that each of it can be forced.
#include "test_scene.h"

#include "water_math.h"

static const uint32_t visible = WATER_PROP_VISIBLE;

static water_decision decision_of(const water_scene* scene)
{
  return plan_of(scene, NULL).decision;
}

// Each reason not to draw has its switch; with the switch off the mirrored view is drawn.
TEST(every_reason_has_its_switch)
{
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double away[3] = { 0.0, -20.0, 10.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  water_scene scenes[4] = { lake(), lake(), lake(), pool(1.0) };
  look_at(eye, away, up, scenes[0].eye.world_to_view);
  scenes[1].hides_above = true;
  scenes[2].is_hidden = true;
  scenes[3].settings.reflectance_error = 0.03;
  const water_decision reasons[4] = { WATER_NO_REFLECT_OUT_OF_VIEW, WATER_NO_REFLECT_FACING_AWAY,
    WATER_NO_REFLECT_HIDDEN, WATER_NO_REFLECT_FAINT };
  const unsigned switches[4] = { WATER_MAY_SKIP_UNSEEN, WATER_MAY_SKIP_UNSEEN,
    WATER_MAY_SKIP_HIDDEN, WATER_MAY_SKIP_FAINT };
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(decision_of(&scenes[i]), reasons[i]);
    assert_int_equal(plan_of(&scenes[i], NULL).has_view, i == 3);
    scenes[i].settings.skips = WATER_MAY_SKIP_ALL & ~switches[i];
    assert_int_equal(decision_of(&scenes[i]), WATER_REFLECT);
    scenes[i].settings.skips = 0;
    assert_int_equal(decision_of(&scenes[i]), WATER_REFLECT);
  }
}

TEST(all_skips_are_all_of_them)
{
  const unsigned all = WATER_MAY_SKIP_UNSEEN | WATER_MAY_SKIP_HIDDEN | WATER_MAY_SKIP_FAINT |
    WATER_MAY_SKIP_UNCHANGED | WATER_MAY_SKIP_SHARED | WATER_MAY_SKIP_PROPS |
    WATER_MAY_SKIP_CLUSTERS | WATER_MAY_SKIP_PIXELS;
  assert_int_equal(WATER_MAY_SKIP_ALL, all);
}

// A surface that is not drawn from above is drawn from below, and the other way round.
TEST(facing_away_depends_on_the_side)
{
  water_scene scene = lake();
  scene.hides_below = true;
  assert_int_equal(decision_of(&scene), WATER_REFLECT);
  scene.plane.normal[2] = -1.0; // turned over: the eye is below
  assert_int_equal(decision_of(&scene), WATER_NO_REFLECT_FACING_AWAY);
}

// A share of the light rounds a pixel up that lacks less than it.
TEST(nothing_is_faint_that_reflects_unless_an_error_is_allowed)
{
  water_scene mirror = pool(1e-3);
  mirror.look.constant_reflectance = true;
  mirror.settings.reflectance_error = 0.0;
  mirror.look.reflectance = 1e-12;
  assert_int_equal(decision_of(&mirror), WATER_REFLECT);
  mirror.look.reflectance = 0.0;
  assert_int_equal(decision_of(&mirror), WATER_NO_REFLECT_NO_REFLECTANCE);
}

// Straight down water reflects 2.04 %; a pond that reaches 45 degrees from there 2.8 %: Fresnel's
// equations by hand, cos 45 = 0.70711, refracted 32.04 degrees, s 0.0530, p 0.0028.
TEST(faint_is_what_the_steepest_and_the_flattest_ray_reflect)
{
  water_scene small = pool(1e-3);
  small.settings.reflectance_error = 0.0205;
  assert_int_equal(decision_of(&small), WATER_NO_REFLECT_FAINT);
  small.settings.reflectance_error = 0.0200;
  assert_int_equal(decision_of(&small), WATER_REFLECT);
  water_scene large = pool(10.0 / sqrt(2.0)); // its corners lie at 45 degrees
  large.settings.reflectance_error = 0.0285;
  assert_int_equal(decision_of(&large), WATER_NO_REFLECT_FAINT);
  large.settings.reflectance_error = 0.0270;
  assert_int_equal(decision_of(&large), WATER_REFLECT);
  // waves turn the surface; of unknown slope, as far as may be
  small.settings.reflectance_error = 0.0285;
  assert_int_equal(decision_of(&small), WATER_NO_REFLECT_FAINT);
  small.has_waves = true;
  small.slope_max = 1.1; // more than 45 degrees
  assert_int_equal(decision_of(&small), WATER_REFLECT);
  small.slope_max = 0.9;
  assert_int_equal(decision_of(&small), WATER_NO_REFLECT_FAINT);
  small.slope_max = (double)INFINITY;
  assert_int_equal(decision_of(&small), WATER_REFLECT);
  // a mirror reflects what it is told to
  water_scene mirror = pool(1e-3);
  mirror.look.constant_reflectance = true;
  mirror.look.reflectance = 0.001;
  mirror.settings.reflectance_error = 0.5 / 255.0;
  assert_int_equal(decision_of(&mirror), WATER_NO_REFLECT_FAINT);
  mirror.look.reflectance = 0.002;
  assert_int_equal(decision_of(&mirror), WATER_REFLECT);
}

// A pond in the middle of a view straight down is reflected in by what stands over it, as the
// mirrored eye sees it through the pond; what only the rest of the picture would mirror is not.
TEST(props_outside_the_pyramid_are_left_out)
{
  const water_prop props[3] = { { { -0.1, 0.1, -0.1, 0.1, 1.0, 2.0 }, visible },
    { { 4.0, 4.2, 0.0, 0.2, 1.0, 2.0 }, visible },
    { { 40.0, 41.0, 0.0, 1.0, 1.0, 2.0 }, visible } };
  water_cull_reason reasons[3];
  water_scene scene = pool(1.0);
  scene.props = props;
  scene.prop_count = 3;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_NONE);
  assert_int_equal(reasons[1], WATER_CULL_OUT_OF_WATER);
  assert_int_equal(reasons[2], WATER_CULL_OUT_OF_VIEW);
  // pixels drawn or not, the props' reasons are theirs
  scene.settings.skips = WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PIXELS;
  const water_plan plan = plan_of(&scene, reasons);
  assert_int_equal(reasons[1], WATER_CULL_OUT_OF_WATER);
  assert_int_equal(plan.texture_rect_px[2], 800);
  assert_int_equal(plan.texture_rect_px[3], 600);
  scene.settings.skips = WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PROPS;
  (void)plan_of(&scene, reasons);
  for (int i = 0; i < 3; ++i)
  {
    assert_int_equal(reasons[i], WATER_CULL_NONE);
  }
}

// Rays are traced alike with all props and without those that the water does not show: tall ones
// beside it, and far ones beyond the eye's far plane.
TEST(rays_take_the_same_steps_with_all_props)
{
  const water_prop props[3] = { { { -0.1, 0.1, -0.1, 0.1, 1.0, 2.0 }, visible },
    { { 4.0, 4.2, 0.0, 0.2, 1.0, 9.0 }, visible },
    { { 4000.0, 4001.0, 0.0, 1.0, 1.0, 9000.0 }, visible } };
  water_cull_reason reasons[3];
  water_scene scene = pool(1.0);
  scene.props = props;
  scene.prop_count = 3;
  const water_plan some = plan_of(&scene, reasons);
  assert_int_equal(reasons[1], WATER_CULL_OUT_OF_WATER);
  scene.settings.skips = WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PROPS;
  const water_plan all = plan_of(&scene, reasons);
  assert_int_equal(reasons[2], WATER_CULL_NONE);
  assert_memory_equal(&some, &all, sizeof some);
}

// What is wide on the screen is drawn as far as it may reach: a point 20 pixels beside the pyramid.
TEST(wide_points_are_drawn_beside_the_pyramid)
{
  // 12 from the mirrored eye 0.05 of half the picture is 0.6: the pool reaches to 0.1, or 1.2
  water_prop props[1] = { { { 1.8, 1.8, 0.0, 0.0, 2.0, 2.0 }, visible, 1.0f } };
  water_cull_reason reasons[1];
  water_scene scene = pool(1.0);
  scene.props = props;
  scene.prop_count = 1;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_OUT_OF_WATER);
  props[0].width_px = 50.0f;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_NONE);
  props[0].width_px = 20.0f;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_OUT_OF_WATER);
}

// On each side of what is looked up, 10 pixels off: 18 pixels wide, and one for antialiasing,
// reaches it; 2 pixels wide is thin, and none of it is asked.
TEST(half_a_width_and_a_pixel_reach_on_each_side)
{
  water_scene scene = pool(1.0);
  const water_plan plan = plan_of(&scene, NULL);
  const int* rect = plan.texture_rect_px;
  const double off_px[3] = { 10.0, 10.0, 1.5 };
  const float width_px[3] = { 18.02f, 17.98f, 2.0f };
  for (int round = 0; round < 3; ++round)
  {
    water_prop props[9];
    water_cull_reason reasons[5];
    for (int i = 0; i < 9; ++i)
    {
      double place[2] = { rect[0] + 0.5 * rect[2], rect[1] + 0.5 * rect[3] };
      if (i >= 5)
      {
        const int side = i - 5;
        place[side % 2] =
          side < 2 ? rect[side] - off_px[round] : rect[side - 2] + rect[side] + off_px[round];
      }
      // 12 over the mirrored eye, to which left is right
      const double x = -12.0 * (2.0 * place[0] / plan.texture_px[0] - 1.0);
      const double y = 12.0 * (2.0 * place[1] / plan.texture_px[1] - 1.0);
      const water_prop prop = { { x, x, y, y, 2.0, 2.0 }, visible, width_px[round] };
      props[i] = prop;
    }
    scene.props = props + 4; // what is before it is in the middle of what is looked up
    scene.prop_count = 5;
    (void)plan_of(&scene, reasons);
    assert_int_equal(reasons[0], WATER_CULL_NONE);
    for (int i = 1; i < 5; ++i)
    {
      assert_int_equal(reasons[i], round == 0 ? WATER_CULL_NONE : WATER_CULL_OUT_OF_WATER);
    }
  }
}

// A box of 1 at a distance of 12 is 1 / 12 of half the picture: 33 pixels wide, 25 high.
TEST(small_props_are_left_out_below_the_stated_size)
{
  const water_prop props[2] = { { { -0.5, 0.5, -0.5, 0.5, 2.0, 2.0 }, visible },
    { { -0.5, 0.5, -0.5, 0.5, 2.0, 2.0 }, visible | WATER_PROP_NO_BOUNDS } };
  water_cull_reason reasons[2];
  water_scene scene = pool(5.0);
  scene.props = props;
  scene.prop_count = 2;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_NONE); // 0: none is left out
  scene.settings.prop_px_min = 32.0;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_NONE);
  scene.settings.prop_px_min = 34.0;
  (void)plan_of(&scene, reasons);
  assert_int_equal(reasons[0], WATER_CULL_TOO_SMALL);
  assert_int_equal(reasons[1], WATER_CULL_NONE);
}

// Small is what is below the stated size both ways: a box of 2 at a distance of 16 is an eighth of
// half the picture, 50 pixels wide and 37.5 high, wherever it is; none is smaller than it is.
TEST(either_side_of_a_box_may_be_its_size)
{
  const double boxes[3][4] = { { -1.0, 1.0, -0.25, 0.25 }, { -0.25, 0.25, -1.0, 1.0 },
    { 2.0, 4.0, -4.0, -3.5 } };
  const double size_px[3] = { 50.0, 37.5, 50.0 };
  for (int i = 0; i < 3; ++i)
  {
    const double* box = boxes[i];
    const water_prop prop = { { box[0], box[1], box[2], box[3], 6.0, 6.0 }, visible };
    water_cull_reason reason;
    water_scene scene = pool(5.0);
    scene.props = &prop;
    scene.prop_count = 1;
    scene.settings.prop_px_min = size_px[i];
    (void)plan_of(&scene, &reason);
    assert_int_equal(reason, WATER_CULL_NONE);
    scene.settings.prop_px_min = nextafter(size_px[i], 100.0);
    (void)plan_of(&scene, &reason);
    assert_int_equal(reason, WATER_CULL_TOO_SMALL);
  }
  // a pole up from the mirrored eye itself has no size
  const water_prop pole = { { 0.0, 0.0, 0.0, 0.0, -10.0, 2.0 }, visible };
  water_cull_reason reason;
  water_scene scene = pool(5.0);
  scene.props = &pole;
  scene.prop_count = 1;
  scene.settings.prop_px_min = 1.0;
  (void)plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_NONE);
}

// A prop that reaches behind the eye has no size in the picture: it is never too small.
TEST(prop_around_the_eye_is_never_too_small)
{
  water_scene scene = lake();
  water_prop hall = { { -1000.0, 1000.0, -1000.0, 1000.0, -1000.0, 1000.0 }, WATER_PROP_VISIBLE };
  water_prop ball = { { -0.1, 0.1, -0.1, 0.1, 1.0, 1.2 }, WATER_PROP_VISIBLE };
  water_cull_reason reason = WATER_CULL_EMPTY;
  scene.settings.prop_px_min = 1e9;
  scene.prop_count = 1;
  scene.props = &hall;
  plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_NONE);
  scene.props = &ball;
  plan_of(&scene, &reason);
  assert_int_equal(reason, WATER_CULL_TOO_SMALL);
}

// No ray that waves of a slope turn leaves the part that it is said to reach: rays of the eye,
// mirrored at normals tilted at random, against the reflection texture's own projection.
TEST(waves_look_nothing_up_beyond_their_reach)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(51);
  int looked_up = 0;
  for (int round = 0; round < 3000; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    if (random.is_parallel)
    {
      continue;
    }
    random.scene.has_waves = true;
    random.scene.slope_max = dice_roll(&from, 0.0, 0.1);
    random.scene.settings.guard_band = 1.0;
    for (int i = 0; i < 6; ++i)
    {
      random.scene.surface_bounds[i] = random.target[i / 2];
    }
    const water_plan plan = plan_of(&random.scene, NULL);
    const int* rect = plan.texture_rect_px;
    for (int ray = 0; ray < 20; ++ray)
    {
      double tilt[3];
      double normal[3];
      dice_dir(&from, tilt);
      const double along = dot(tilt, random.normal);
      double length = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        tilt[i] -= along * random.normal[i];
        length += tilt[i] * tilt[i];
      }
      for (int i = 0; i < 3; ++i)
      {
        normal[i] = random.normal[i] + random.scene.slope_max * tilt[i] / sqrt(length);
      }
      const double twice = 2.0 * dot(normal, random.view_dir) / dot(normal, normal);
      double point[3];
      double clip[4];
      const double distance = dice_roll(&from, 0.0, 50.0);
      for (int i = 0; i < 3; ++i)
      {
        point[i] = random.target[i] + distance * (random.view_dir[i] - twice * normal[i]);
      }
      project(&plan.mirrored, point, 1.0, clip);
      const double x = 0.5 * (1.0 + clip[0] / clip[3]) * plan.texture_px[0];
      const double y = 0.5 * (1.0 + clip[1] / clip[3]) * plan.texture_px[1];
      if (clip[3] > 0.0 && x >= 0.0 && x <= plan.texture_px[0] && y >= 0.0 &&
        y <= plan.texture_px[1])
      {
        assert_true(x >= rect[0] && x <= rect[0] + rect[2]);
        assert_true(y >= rect[1] && y <= rect[1] + rect[3]);
        looked_up += rect[2] < plan.texture_px[0];
      }
    }
  }
  assert_int_in_range(looked_up, 10000, 60000);
}

// What may be cut has a corner on the other side of the plane, but for rounding; what is not known
// may be cut.
TEST(only_what_crosses_the_plane_is_cut)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(83);
  int cut = 0;
  int whole = 0;
  for (int round = 0; round < 4000; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    if (plan.decision != WATER_REFLECT)
    {
      continue;
    }
    double bounds[6];
    double point[3];
    point_near(&from, &random, 5.0, point);
    for (int i = 0; i < 3; ++i)
    {
      bounds[2 * i] = point[i] - dice_roll(&from, 0.0, 3.0);
      bounds[2 * i + 1] = point[i] + dice_roll(&from, 0.0, 3.0);
    }
    double lowest = (double)INFINITY;
    for (int i = 0; i < 64; ++i)
    {
      double corner[3];
      box_point(bounds, i, corner);
      lowest = fmin(lowest, height_of(&random, corner));
    }
    const bool is_cut = water_plan_cuts(&plan, bounds);
    assert_true(is_cut || lowest > 0.0);
    assert_true(!is_cut || lowest < 1e-3 * (1.0 + water_vec3_length(point)));
    cut += is_cut;
    whole += !is_cut;
  }
  assert_int_in_range(cut, 500, 3500);
  assert_int_in_range(whole, 200, 3500);
  random_scene random = scene_rolled(&from, 0, center);
  const water_plan plan = plan_of(&random.scene, NULL);
  const double unknown[3][6] = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 },
    { (double)NAN, 1.0, 0.0, 1.0, 0.0, 1.0 }, { 0.0, (double)INFINITY, 0.0, 1.0, 0.0, 1.0 } };
  for (int i = 0; i < 3; ++i)
  {
    assert_true(water_plan_cuts(&plan, unknown[i]));
  }
}

TESTS(every_reason_has_its_switch, all_skips_are_all_of_them, facing_away_depends_on_the_side,
  nothing_is_faint_that_reflects_unless_an_error_is_allowed,
  faint_is_what_the_steepest_and_the_flattest_ray_reflect, props_outside_the_pyramid_are_left_out,
  rays_take_the_same_steps_with_all_props, wide_points_are_drawn_beside_the_pyramid,
  half_a_width_and_a_pixel_reach_on_each_side, small_props_are_left_out_below_the_stated_size,
  either_side_of_a_box_may_be_its_size, prop_around_the_eye_is_never_too_small,
  waves_look_nothing_up_beyond_their_reach, only_what_crosses_the_plane_is_cut)
