// SPDX-License-Identifier: BSD-3-Clause
// test_plan.c: the plan as a whole: what is refused, in which order, what is decided, and that it
// is a pure function.
#include "test_scene.h"

static void assert_status(const water_scene* scene, water_status expected)
{
  water_plan plan;
  water_cull_reason reason = WATER_CULL_REASON_COUNT;
  memset(&plan, 0xff, sizeof plan);
  const water_status status = water_plan_make(scene, &plan, &reason);
  assert_string_equal(water_status_text(status), water_status_text(expected));
  assert_int_equal(plan.decision, WATER_NO_REFLECT_FAILED);
  assert_int_equal(reason, WATER_CULL_REASON_COUNT);
}

// A prop that may be anywhere is named, and drawn.
static void assert_unbounded(const water_scene* scene)
{
  water_plan plan;
  water_cull_reason reason = WATER_CULL_REASON_COUNT;
  assert_int_equal(water_plan_make(scene, &plan, &reason), WATER_BAD_PROP_BOUNDS);
  assert_int_equal(plan.decision, WATER_REFLECT);
  assert_int_equal(reason, WATER_CULL_NONE);
}

static water_decision decision_of(const water_scene* scene)
{
  water_plan plan;
  water_cull_reason reason = WATER_CULL_REASON_COUNT;
  assert_int_equal(water_plan_make(scene, &plan, &reason), WATER_OK);
  assert_int_equal(reason == WATER_CULL_REASON_COUNT, plan.decision != WATER_REFLECT);
  return plan.decision;
}

// A lake with one prop over it, on which the reasons can be seen.
static water_scene lake_with_prop(void)
{
  static const water_prop tree = { { -1.0, 1.0, 2.0, 4.0, 0.0, 3.0 }, WATER_PROP_VISIBLE };
  water_scene scene = lake();
  scene.props = &tree;
  scene.prop_count = 1;
  return scene;
}

// A scene with everything wrong reports the first fault of the list; repaired one by one, the next.
TEST(faults_are_reported_in_the_order_of_the_list)
{
  const double nan_value = (double)NAN;
  const water_prop bad = { { nan_value, 1.0, 0.0, 1.0, 0.0, 1.0 }, WATER_PROP_VISIBLE };
  const water_scene good = lake();
  water_scene scene = good;
  scene.plane.normal[2] = 0.0;
  scene.surface_bounds[0] = 20.0;
  scene.viewport_px[1] = 0;
  scene.settings.texture_scale = 0.0;
  scene.settings.clip_margin = -1.0;
  scene.settings.prop_px_min = nan_value;
  scene.settings.reflectance_error = 2.0;
  scene.look.index_of_refraction = 0.9;
  scene.look.reflectance = 1.5;
  scene.eye.world_to_view[0] = nan_value;
  scene.props = &bad;
  scene.prop_count = 1;
  assert_status(&scene, WATER_BAD_PLANE);
  scene.plane = good.plane;
  assert_status(&scene, WATER_BAD_SURFACE);
  scene.surface_bounds[0] = good.surface_bounds[0];
  assert_status(&scene, WATER_BAD_VIEWPORT);
  scene.viewport_px[1] = 600;
  assert_status(&scene, WATER_BAD_TEXTURE_SCALE);
  scene.settings.texture_scale = 100.0;
  assert_status(&scene, WATER_TEXTURE_TOO_LARGE);
  scene.settings.texture_scale = 1.0;
  assert_status(&scene, WATER_BAD_CLIP_MARGIN);
  scene.settings.clip_margin = 0.0;
  assert_status(&scene, WATER_BAD_PROP_SIZE);
  scene.settings.prop_px_min = 0.0;
  assert_status(&scene, WATER_BAD_REFLECTANCE_ERROR);
  scene.settings.reflectance_error = 0.0;
  assert_status(&scene, WATER_BAD_INDEX);
  scene.look.index_of_refraction = 1.0;
  assert_status(&scene, WATER_BAD_REFLECTANCE);
  scene.look.reflectance = 1.0;
  assert_status(&scene, WATER_BAD_CAMERA);
  scene.eye = good.eye;
  assert_unbounded(&scene);
  scene.props = NULL;
  scene.prop_count = 0;
  assert_int_equal(plan_of(&scene, NULL).decision, WATER_REFLECT);
}

// NaN or infinity in any number of the scene has the status of the part it stands in.
TEST(numbers_that_are_not_finite_are_named)
{
  const double bad[3] = { (double)NAN, (double)INFINITY, -(double)INFINITY };
  for (int i = 0; i < 3; ++i)
  {
    water_scene scene;
    for (int j = 0; j < 6; ++j)
    {
      scene = lake_with_prop();
      scene.surface_bounds[j] = bad[i];
      assert_status(&scene, WATER_BAD_SURFACE);
      const water_prop prop = { { bad[i], bad[i], bad[i], bad[i], bad[i], bad[i] }, 1 };
      water_prop one = { { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 }, WATER_PROP_VISIBLE };
      one.bounds[j] = prop.bounds[j];
      scene = lake();
      scene.props = &one;
      scene.prop_count = 1;
      assert_unbounded(&scene);
    }
    for (int j = 0; j < 16; ++j)
    {
      scene = lake_with_prop();
      scene.eye.world_to_view[j] = bad[i];
      assert_status(&scene, WATER_BAD_CAMERA);
      scene = lake_with_prop();
      scene.eye.view_to_clip[j] = bad[i];
      assert_status(&scene, WATER_BAD_CAMERA);
    }
    scene = lake_with_prop();
    scene.plane.offset = bad[i];
    assert_status(&scene, WATER_BAD_PLANE);
    scene = lake_with_prop();
    scene.plane.normal[0] = bad[i];
    assert_status(&scene, WATER_BAD_PLANE);
    scene = lake_with_prop();
    scene.settings.texture_scale = bad[i];
    assert_status(&scene, WATER_BAD_TEXTURE_SCALE);
    scene = lake_with_prop();
    scene.settings.clip_margin = bad[i];
    assert_status(&scene, WATER_BAD_CLIP_MARGIN);
    scene = lake_with_prop();
    scene.look.index_of_refraction = bad[i];
    assert_status(&scene, WATER_BAD_INDEX);
    scene = lake_with_prop();
    scene.look.reflectance = bad[i];
    assert_status(&scene, WATER_BAD_REFLECTANCE);
  }
}

// Water in view reflects; looked away from, or with a reflectance of 0, it does not, which is no
// error, and the reasons stay as they were.
TEST(decision_says_why_nothing_is_drawn)
{
  water_scene scene = lake_with_prop();
  assert_int_equal(decision_of(&scene), WATER_REFLECT);
  scene.look.reflectance = 0.0; // Fresnel is in use: of no importance
  assert_int_equal(decision_of(&scene), WATER_REFLECT);
  scene.look.constant_reflectance = true;
  assert_int_equal(decision_of(&scene), WATER_NO_REFLECT_NO_REFLECTANCE);
  scene.look.reflectance = 1e-3;
  assert_int_equal(decision_of(&scene), WATER_REFLECT);
  scene.has_environment = true;
  assert_int_equal(decision_of(&scene), WATER_NO_REFLECT_ENVIRONMENT);
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double away[3] = { 0.0, -20.0, 10.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, away, up, scene.eye.world_to_view);
  assert_int_equal(decision_of(&scene), WATER_NO_REFLECT_OUT_OF_VIEW);
}

// A prop with bad bounds does not matter while nothing is drawn.
TEST(props_are_not_looked_at_when_nothing_is_drawn)
{
  const water_prop bad = { { (double)NAN, 1.0, 0.0, 1.0, 0.0, 1.0 }, WATER_PROP_VISIBLE };
  water_scene scene = lake();
  scene.props = &bad;
  scene.prop_count = 1;
  scene.look.constant_reflectance = true;
  assert_int_equal(decision_of(&scene), WATER_NO_REFLECT_NO_REFLECTANCE);
}

// What looks through the water needs the eye's view whether a mirrored view is drawn or not; it is
// the same view.
TEST(view_is_planned_without_a_mirror)
{
  water_scene scene = lake();
  const water_plan mirror = plan_of(&scene, NULL);
  assert_true(mirror.has_view);
  scene.has_environment = true;
  const water_plan environment = plan_of(&scene, NULL);
  assert_true(environment.has_view);
  const size_t begin = offsetof(water_plan, normal_clip);
  assert_memory_equal((const char*)&environment + begin, (const char*)&mirror + begin,
    offsetof(water_plan, mirrored) - begin);
  scene.look.constant_reflectance = true;
  assert_true(plan_of(&scene, NULL).has_view);
  scene.plane.normal[2] = 0.0;
  water_plan failed;
  assert_int_equal(water_plan_make(&scene, &failed, NULL), WATER_BAD_PLANE);
  assert_false(failed.has_view);
}

// Same scene, same plan, bit by bit; and the scene is not written to.
TEST(plan_is_a_pure_function)
{
  dice from = dice_seeded(24);
  const double center[3] = { 0.0, 0.0, 0.0 };
  for (int round = 0; round < 100; ++round)
  {
    const random_scene random = scene_rolled(&from, round, center);
    water_scene copy;
    water_plan first;
    water_plan second;
    memset(&first, 0x00, sizeof first);
    memset(&second, 0xff, sizeof second);
    memcpy(&copy, &random.scene, sizeof copy);
    assert_int_equal(water_plan_make(&random.scene, &first, NULL), WATER_OK);
    assert_int_equal(water_plan_make(&random.scene, &second, NULL), WATER_OK);
    assert_memory_equal(&copy, &random.scene, sizeof copy);
    assert_int_equal(first.decision, WATER_REFLECT);
    assert_memory_equal(
      &first.normal_clip, &second.normal_clip, sizeof first - offsetof(water_plan, normal_clip));
  }
}

// Turning the plane over moves the eye to its other side and changes nothing else of the picture:
// the scene is mirrored where the eye is, whichever side the normal calls up.
TEST(turning_the_plane_over_only_changes_the_side)
{
  dice from = dice_seeded(25);
  const double center[3] = { 1.0, 2.0, 3.0 };
  for (int round = 0; round < 300; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    for (int i = 0; i < 3; ++i)
    {
      random.scene.plane.normal[i] *= -1.0;
    }
    random.scene.plane.offset *= -1.0;
    const water_plan turned = plan_of(&random.scene, NULL);
    assert_int_equal(turned.side, plan.side == WATER_ABOVE ? WATER_BELOW : WATER_ABOVE);
    for (int i = 0; i < 16; ++i)
    {
      ASSERT_CLOSE(turned.mirrored.world_to_view[i], plan.mirrored.world_to_view[i], 0.0);
      ASSERT_CLOSE(turned.mirrored.view_to_clip[i], plan.mirrored.view_to_clip[i], 0.0);
    }
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(turned.plane_clip[i], plan.plane_clip[i], 0.0);
      ASSERT_CLOSE(turned.clip_plane_window[i], plan.clip_plane_window[i], 0.0);
    }
    ASSERT_CLOSE(turned.eta * plan.eta, 1.0, 1e-15);
  }
}

// Of many props each has the reason that it has alone; they reach as far, and as high, as the
// farthest and the highest of them, and the first without an end is named. They are looked at some
// hundreds at a time.
TEST(many_props_are_each_decided_as_alone)
{
  enum
  {
    COUNT = 700
  };
  static water_prop props[COUNT];
  static water_cull_reason all_reasons[3 * COUNT]; // around them no prop is drawn
  water_cull_reason* reasons = all_reasons + COUNT;
  for (int i = 0; i < 3 * COUNT; ++i)
  {
    all_reasons[i] = WATER_CULL_REFUSED;
  }
  dice from = dice_seeded(90);
  for (int i = 0; i < COUNT; ++i)
  {
    props[i].flags = WATER_PROP_VISIBLE;
    for (int j = 0; j < 6; j += 2)
    {
      props[i].bounds[j] = dice_roll(&from, -30.0, 30.0);
      props[i].bounds[j + 1] = props[i].bounds[j] + dice_roll(&from, 0.0, 9.0);
    }
  }
  const double far_out[6] = { -9000.0, 9000.0, 3000.0, 3001.0, 1.0, 2000.0 };
  const double high[6] = { -1.0, 1.0, 2.0, 3.0, 1.0, 4000.0 };
  memcpy(props[300].bounds, far_out, sizeof far_out);
  memcpy(props[400].bounds, high, sizeof high);
  for (int way = 0; way < 2; ++way)
  {
    water_scene scene = lake();
    scene.settings.skips =
      way == 0 ? WATER_MAY_SKIP_ALL : WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PROPS;
    scene.props = props;
    scene.prop_count = COUNT;
    const water_plan all = plan_of(&scene, reasons);
    double top = 0.0;
    double scale = 1.0;
    int skipped = 0;
    scene.prop_count = 1;
    for (int i = 0; i < COUNT; ++i)
    {
      water_cull_reason reason = WATER_CULL_REASON_COUNT;
      scene.props = props + i;
      const water_plan one = plan_of(&scene, &reason);
      assert_int_equal(reason, reasons[i]);
      top = fmax(top, one.reflection_top);
      scale = fmin(scale, one.depth_scale);
      skipped += reason != WATER_CULL_NONE;
    }
    assert_int_in_range(skipped, way == 0 ? 100 : 0, way == 0 ? COUNT - 100 : 0);
    assert_true(top == 4000.0 && scale < 1.0);
    ASSERT_CLOSE(all.reflection_top, top, 0.0);
    ASSERT_CLOSE(all.depth_scale, scale, 0.0);
  }
  const int bad[2] = { 600, 301 };
  for (int i = 0; i < 2; ++i)
  {
    water_scene scene = lake();
    water_plan plan;
    props[bad[i]].bounds[0] = (double)NAN;
    scene.props = props;
    scene.prop_count = COUNT;
    assert_int_equal(water_plan_make(&scene, &plan, reasons), WATER_BAD_PROP_BOUNDS);
    assert_int_equal(plan.bad_index, bad[i]);
    assert_int_equal(reasons[bad[i]], WATER_CULL_NONE);
  }
}

TESTS(faults_are_reported_in_the_order_of_the_list, numbers_that_are_not_finite_are_named,
  decision_says_why_nothing_is_drawn, props_are_not_looked_at_when_nothing_is_drawn,
  view_is_planned_without_a_mirror, plan_is_a_pure_function,
  turning_the_plane_over_only_changes_the_side, many_props_are_each_decided_as_alone)
