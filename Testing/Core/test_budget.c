// SPDX-License-Identifier: BSD-3-Clause
// test_budget.c: what a time budget learns and forgets, and how rough a view looks, by other means.
#include "test_scene.h"

#include "water_quality.h"

static const double scale_1 = 0.84; // of step 1
static const double budget = 8.0;   // ms

static void frames(water_quality_state* state, int count, double measured_ms)
{
  for (int i = 0; i < count; ++i)
  {
    assert_int_equal(water_quality_for_budget(state, 0, budget, measured_ms), WATER_OK);
  }
}

// Of 4 ms that stay and 5.5 that follow the area: 16 frames before and 32 after a change tell the
// share that stays, and half of it is believed.
TEST(fixed_share_is_learned_from_a_change)
{
  UNUSED;
  water_quality_state course;
  memset(&course, 0, sizeof course);
  frames(&course, 15, 9.5); // 3/16 of a budget too long, each
  assert_int_equal(course.step, 0);
  frames(&course, 1, 9.5);
  assert_int_equal(course.step, 1);
  frames(&course, 3, 100.0); // not believed yet
  const double after_ms = 4.0 + 5.5 * scale_1 * scale_1;
  frames(&course, 31, after_ms);
  assert_true(course.fixed_share == 0.0);
  frames(&course, 1, after_ms);
  ASSERT_CLOSE(course.fixed_share, 0.5 * 4.0 / 9.5, 1e-12);
  frames(&course, 100, after_ms);
  ASSERT_CLOSE(course.fixed_share, 0.5 * 4.0 / 9.5, 1e-12); // once
  assert_int_equal(course.step, 1);
}

// Frames that all cost the same, whatever the scale: no more than 0.9 is believed to stay; and time
// that falls where the scale rises teaches nothing.
TEST(fixed_share_has_its_limits)
{
  UNUSED;
  water_quality_state course;
  memset(&course, 0, sizeof course);
  frames(&course, 16, 9.5);
  frames(&course, 3, 9.5);
  course.step = 1;
  for (int i = 0; i < 32; ++i)
  {
    (void)water_quality_for_budget(&course, 0, 9.5, 9.5); // within this budget
  }
  ASSERT_CLOSE(course.fixed_share, 0.45, 1e-12);
  memset(&course, 0, sizeof course);
  frames(&course, 16, 9.5);
  frames(&course, 3, 9.5);
  for (int i = 0; i < 32; ++i)
  {
    (void)water_quality_for_budget(&course, 0, 4.0, 4.0); // less than the area's share
  }
  ASSERT_CLOSE(course.fixed_share, 0.0, 1e-12);
}

// A finer step that is taken back makes the next try later, by powers of two up to 64; a thousand
// quiet frames forget one failure.
TEST(patience_grows_with_failures_and_is_forgotten)
{
  UNUSED;
  water_quality_state course;
  memset(&course, 0, sizeof course);
  course.step = 1;
  for (int failure = 1; failure <= 8; ++failure)
  {
    int count = 0;
    while (course.step == 1 && count < 2000)
    {
      frames(&course, 1, 1e-9); // 0.8 of a budget short
      ++count;
    }
    assert_int_equal(course.step, 0);
    frames(&course, 3 + 15, 1.2001 * budget); // 0.2 too long each: one step is enough
    assert_int_equal(course.step, 1);
    assert_int_equal(course.patience, failure < 6 ? failure : 6);
  }
  const double quiet_ms = 0.9 * budget;
  for (int left = 6; left >= 0; --left)
  {
    frames(&course, left == 6 ? 3 + 999 : 999, quiet_ms);
    assert_int_equal(course.patience, left);
    frames(&course, 1, quiet_ms);
    assert_int_equal(course.patience, left > 0 ? left - 1 : 0);
  }
  assert_int_equal(course.step, 1);
}

// A step from beyond the ladder is put on it, and that is no try of a finer one.
TEST(step_from_beyond_is_no_failure)
{
  UNUSED;
  water_quality_state course;
  memset(&course, 0, sizeof course);
  course.step = -5;
  frames(&course, 1, 1.0);
  assert_int_equal(course.step, 0);
  assert_false(course.was_finer);
  course.step = 99;
  frames(&course, 1, 1.0);
  assert_int_equal(course.step, WATER_QUALITY_STEPS - 1);
  assert_false(course.was_finer);
}

// A step whose error is the very target is within it.
TEST(error_at_the_target_is_within)
{
  UNUSED;
  const water_roughness roughness = { 0.05, 0.3, 800.0 };
  for (int i = 0; i < WATER_QUALITY_STEPS; ++i)
  {
    double error_px = 0.0;
    int step = WATER_QUALITY_NO_STEP;
    assert_int_equal(water_quality_error(i, &roughness, &error_px), WATER_OK);
    assert_int_equal(water_quality_for_error(error_px, &roughness, &step), WATER_OK);
    assert_int_equal(step, i);
  }
}

// The error is the formula of the header, for a step of scale 1 and 24 steps of the march.
TEST(error_is_the_formula)
{
  UNUSED;
  for (int i = 0; i < 5; ++i)
  {
    const double slope = 0.02 * (i + 1);
    const double turn = 0.7 * i;
    const water_roughness roughness = { slope, turn, 500.0 };
    const double seen = slope * exp(-turn * turn / 24.0);
    const double hidden = sqrt(slope * slope - seen * seen);
    const double sharp = 0.4 * (1.0 + 1.8 * seen * seen) + 2.0 * seen * 500.0 / (280.0 * 24.0);
    const double blur = 2.0 * hidden * 500.0;
    double error_px = 0.0;
    assert_int_equal(water_quality_error(0, &roughness, &error_px), WATER_OK);
    ASSERT_CLOSE(error_px, sqrt(blur * blur + sharp * sharp) - blur, 1e-12);
  }
}

// Where the ray of a pixel meets the lake's level, by the camera's own axes.
static void place_of_pixel(
  const water_scene* scene, const double eye[3], double x, double y, double place[2])
{
  const double* view = scene->eye.world_to_view;
  double dir[3];
  for (int i = 0; i < 3; ++i)
  {
    dir[i] = view[i] * x / scene->eye.view_to_clip[0] +
      view[4 + i] * y / scene->eye.view_to_clip[5] - view[8 + i];
  }
  for (int i = 0; i < 2; ++i)
  {
    place[i] = eye[i] - eye[2] / dir[2] * dir[i];
  }
}

// The turn of a wave over a pixel where it is seen best: the corner of the map's drawn part whose
// pixel is the smallest on the water. For a pond to one side of the picture.
TEST(roughness_is_that_of_the_nearest_corner)
{
  UNUSED;
  water_scene scene = lake();
  scene.slope_rms = 0.1;
  for (int round = 0; round < 2; ++round)
  {
    const double eye[3] = { round == 0 ? -4.0 : 3.0, -10.0, 5.0 };
    const double target[3] = { 0.0, 0.0, 0.0 };
    const double up[3] = { 0.0, 0.0, 1.0 };
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.surface_bounds[0] = round == 0 ? 0.5 : -4.0;
    scene.surface_bounds[1] = round == 0 ? 4.0 : -0.5;
    scene.surface_bounds[2] = -7.0;
    scene.surface_bounds[3] = -3.0;
    const water_plan plan = plan_of(&scene, NULL);
    const int* rect = plan.texture_rect_px;
    double least = DBL_MAX;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = 1.0 - 2.0 * (rect[0] + (corner & 1 ? rect[2] : 0)) / 800.0; // flipped
      const double y = 2.0 * (rect[1] + (corner & 2 ? rect[3] : 0)) / 600.0 - 1.0;
      double here[2];
      double across[2];
      double down[2];
      place_of_pixel(&scene, eye, x, y, here);
      place_of_pixel(&scene, eye, x + 2.0 / 800.0, y, across);
      place_of_pixel(&scene, eye, x, y + 2.0 / 600.0, down);
      least = fmin(least,
        hypot(hypot(across[0] - here[0], across[1] - here[1]),
          hypot(down[0] - here[0], down[1] - here[1])));
    }
    water_roughness roughness;
    water_quality_look(&scene, &plan, 3.0, &roughness);
    ASSERT_CLOSE(roughness.turn_rad, 3.0 * least / sqrt(2.0), 1e-9);
    ASSERT_CLOSE(roughness.pixels_per_radian, 300.0, 1e-9);
    assert_true(roughness.slope_rms == 0.1);
  }
  scene.look.constant_reflectance = true; // a view, but no map
  const water_plan dull = plan_of(&scene, NULL);
  water_roughness roughness;
  water_quality_look(&scene, &dull, 3.0, &roughness);
  assert_true(roughness.turn_rad == 0.0);
}

TEST(a_second_is_a_still_picture)
{
  UNUSED;
  assert_true(water_quality_is_still(1000.0));
  assert_false(water_quality_is_still(999.0));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(fixed_share_is_learned_from_a_change),
    RUN(fixed_share_has_its_limits),
    RUN(patience_grows_with_failures_and_is_forgotten),
    RUN(step_from_beyond_is_no_failure),
    RUN(error_at_the_target_is_within),
    RUN(error_is_the_formula),
    RUN(roughness_is_that_of_the_nearest_corner),
    RUN(a_second_is_a_still_picture),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
