// SPDX-License-Identifier: BSD-3-Clause
// test_budget.c: a time budget: how it is shared, how long it waits, what it learns and forgets.
#include "test_scene.h"

#include "water_quality.h"

static const int last_step = WATER_QUALITY_STEPS - 1;
static const double scale_1 = 0.84; // of step 1
static const double budget = 8.0;   // ms

static void draw_frames(water_quality_state* state, int count, double measured_ms)
{
  for (int i = 0; i < count; ++i)
  {
    assert_int_equal(water_quality_for_budget(state, 0, budget, measured_ms), WATER_OK);
  }
}

static int frames_until_change(int step, double measured_ms)
{
  water_quality_state control = { 0 };
  control.step = step;
  int frames = 0;
  while (control.step == step && frames < 1000)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, 10.0, measured_ms), WATER_OK);
    ++frames;
  }
  return frames;
}

// The waits that the header names; between 0.8 and 1 of the budget nothing happens.
TEST(waits_are_as_promised)
{
  const double to_finer = 0.71 / 0.84 * 0.71 / 0.84; // of time, without a fixed share
  assert_int_equal(frames_until_change(2, 1000.0), 3);
  assert_int_equal(frames_until_change(2, 20.0), 3);
  assert_int_in_range(frames_until_change(2, 11.0), 30, 31);
  assert_int_in_range(frames_until_change(2, 1e-9), 10, 11);
  assert_int_in_range(frames_until_change(2, 7.0 * to_finer), 80, 81);
  assert_int_equal(frames_until_change(2, 8.01 * to_finer), 1000);
  assert_int_equal(frames_until_change(2, 9.99), 1000);

  water_quality_state control = { 0 };
  for (int i = 0; i < 3; ++i)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, 10.0, 1000.0), WATER_OK);
  }
  assert_int_equal(control.step, 2); // two at a time
  for (int i = 0; i < 3; ++i)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, 10.0, 1000.0), WATER_OK);
    assert_int_equal(control.step, 2); // late times of the old step
  }
}

// Frames that take just the budget are neither too long nor too short: after any number of them
// long ones are answered as if they were the first.
TEST(frames_of_just_the_budget_count_for_nothing)
{
  const double long_ms[3] = { 14.0, 20.0, 40.0 };
  for (int i = 0; i < 3; ++i)
  {
    water_quality_state fresh = { 0 };
    water_quality_state used = { 0 };
    for (int frame = 0; frame < 25; ++frame)
    {
      assert_int_equal(water_quality_for_budget(&used, 0, 10.0, 10.0), WATER_OK);
      assert_int_equal(used.step, 0);
    }
    int frames = 0;
    for (; fresh.step == 0 && frames < 100; ++frames)
    {
      assert_int_equal(used.step, 0);
      assert_int_equal(water_quality_for_budget(&fresh, 0, 10.0, long_ms[i]), WATER_OK);
      assert_int_equal(water_quality_for_budget(&used, 0, 10.0, long_ms[i]), WATER_OK);
    }
    assert_int_in_range(fresh.step, 1, WATER_QUALITY_STEPS - 1);
    assert_int_equal(used.step, fresh.step);
  }
}

// A frame without a time keeps all as it is: the first one, one that drew nothing, a timer's error.
TEST(no_measurement_no_change)
{
  const double none[5] = { (double)NAN, 0.0, -1.0, (double)INFINITY, -(double)INFINITY };
  water_quality_state control = { 0 };
  control.step = 3;
  const water_quality_state before = control;
  for (int i = 0; i < 100; ++i)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, 10.0, none[i % 5]), WATER_OK);
    assert_memory_equal(&control, &before, sizeof control);
  }
}

// Never finer than asked; a step that a caller set wrongly is brought onto the ladder.
TEST(finest_step_is_kept)
{
  water_quality_state control = { 0 };
  for (int i = 0; i < 1000; ++i)
  {
    assert_int_equal(water_quality_for_budget(&control, 3, 10.0, 0.001), WATER_OK);
    assert_int_equal(control.step, 3);
  }
  assert_int_equal(water_quality_for_budget(&control, 100, 10.0, 0.001), WATER_OK);
  assert_int_equal(control.step, last_step);
  control.step = -7;
  assert_int_equal(water_quality_for_budget(&control, 0, 10.0, 1.0), WATER_OK);
  assert_int_equal(control.step, 0);
  control.step = 99;
  assert_int_equal(water_quality_for_budget(&control, 0, 10.0, 1.0), WATER_OK);
  assert_int_equal(control.step, last_step);
}

// A step from beyond the ladder is put on it, and that is no try of a finer one.
TEST(step_from_beyond_is_no_failure)
{
  water_quality_state course;
  memset(&course, 0, sizeof course);
  course.step = -5;
  draw_frames(&course, 1, 1.0);
  assert_int_equal(course.step, 0);
  assert_false(course.was_finer);
  course.step = 99;
  draw_frames(&course, 1, 1.0);
  assert_int_equal(course.step, last_step);
  assert_false(course.was_finer);
}

// Of 4 ms that stay and 5.5 that follow the area: 16 frames before and 32 after a change tell the
// share that stays, and half of it is believed.
TEST(fixed_share_is_learned_from_a_change)
{
  water_quality_state course;
  memset(&course, 0, sizeof course);
  draw_frames(&course, 15, 9.5); // 3/16 of a budget too long, each
  assert_int_equal(course.step, 0);
  draw_frames(&course, 1, 9.5);
  assert_int_equal(course.step, 1);
  draw_frames(&course, 3, 100.0); // not believed yet
  const double after_ms = 4.0 + 5.5 * scale_1 * scale_1;
  draw_frames(&course, 31, after_ms);
  assert_true(course.fixed_share == 0.0);
  draw_frames(&course, 1, after_ms);
  ASSERT_CLOSE(course.fixed_share, 0.5 * 4.0 / 9.5, 1e-12);
  draw_frames(&course, 100, after_ms);
  ASSERT_CLOSE(course.fixed_share, 0.5 * 4.0 / 9.5, 1e-12); // once
  assert_int_equal(course.step, 1);
}

// Frames that all cost the same, whatever the scale: no more than 0.9 is believed to stay; and time
// that falls where the scale rises teaches nothing.
TEST(fixed_share_has_its_limits)
{
  water_quality_state course;
  memset(&course, 0, sizeof course);
  draw_frames(&course, 16, 9.5);
  draw_frames(&course, 3, 9.5);
  course.step = 1;
  for (int i = 0; i < 32; ++i)
  {
    (void)water_quality_for_budget(&course, 0, 9.5, 9.5); // within this budget
  }
  ASSERT_CLOSE(course.fixed_share, 0.45, 1e-12);
  memset(&course, 0, sizeof course);
  draw_frames(&course, 16, 9.5);
  draw_frames(&course, 3, 9.5);
  for (int i = 0; i < 32; ++i)
  {
    (void)water_quality_for_budget(&course, 0, 4.0, 4.0); // less than the area's share
  }
  ASSERT_CLOSE(course.fixed_share, 0.0, 1e-12);
}

// With half of the time fixed a finer step, 0.84 of the scale for 0.71, costs 1.134 times as much:
// frames of 6.6 ms lead to one of 7.5 in a budget of 10, frames of 7.2 to none; and what was
// measured on too few frames teaches nothing about that share.
TEST(fixed_share_is_believed)
{
  const double times_ms[2] = { 6.6, 7.2 };
  for (int i = 0; i < 2; ++i)
  {
    water_quality_state control = { .step = 2, .before_step = 1, .fixed_share = 0.5 };
    for (int frame = 0; frame < 1000 && control.step == 2; ++frame)
    {
      assert_int_equal(water_quality_for_budget(&control, 0, 10.0, times_ms[i]), WATER_OK);
      assert_true(control.fixed_share == 0.5);
    }
    assert_int_equal(control.step, i == 0 ? 1 : 2);
  }
}

// A finer step that is taken back makes the next try later, by powers of two up to 64; a thousand
// quiet frames forget one failure.
TEST(patience_grows_with_failures_and_is_forgotten)
{
  water_quality_state course;
  memset(&course, 0, sizeof course);
  course.step = 1;
  for (int failure = 1; failure <= 8; ++failure)
  {
    int count = 0;
    while (course.step == 1 && count < 2000)
    {
      draw_frames(&course, 1, 1e-9); // 0.8 of a budget short
      ++count;
    }
    assert_int_equal(course.step, 0);
    draw_frames(&course, 3 + 15, 1.2001 * budget); // 0.2 too long each: one step is enough
    assert_int_equal(course.step, 1);
    assert_int_equal(course.patience, failure < 6 ? failure : 6);
  }
  const double quiet_ms = 0.9 * budget;
  for (int left = 6; left >= 0; --left)
  {
    draw_frames(&course, left == 6 ? 3 + 999 : 999, quiet_ms);
    assert_int_equal(course.patience, left);
    draw_frames(&course, 1, quiet_ms);
    assert_int_equal(course.patience, left > 0 ? left - 1 : 0);
  }
  assert_int_equal(course.step, 1);
}

// Shares add up to the budget, follow the areas, leave none to what is not seen and a little to
// what is hardly seen.
TEST(budget_is_shared_by_area)
{
  const double areas[6] = { 3e5, 1e5, 0.0, 1.0, -5.0, (double)NAN };
  double shares[6];
  assert_int_equal(water_quality_share(areas, 6, 12.0, shares), WATER_OK);
  double sum = 0.0;
  for (int i = 0; i < 6; ++i)
  {
    sum += shares[i];
  }
  ASSERT_CLOSE(sum, 12.0, 1e-13);
  ASSERT_CLOSE((shares[0] - 0.4) / (shares[1] - 0.4), 3.0, 1e-12); // 0.1 of 12 among 3
  assert_true(shares[2] == 0.0 && shares[4] == 0.0 && shares[5] == 0.0);
  ASSERT_CLOSE(shares[3], 0.4, 1e-4);

  const double huge[2] = { DBL_MAX, DBL_MAX };
  assert_int_equal(water_quality_share(huge, 2, 10.0, shares), WATER_OK);
  ASSERT_CLOSE(shares[0], 5.0, 1e-12);
  ASSERT_CLOSE(shares[1], 5.0, 1e-12);
  const double none[2] = { 0.0, 0.0 };
  assert_int_equal(water_quality_share(none, 2, 10.0, shares), WATER_OK);
  assert_true(shares[0] == 0.0 && shares[1] == 0.0);
  assert_int_equal(water_quality_share(NULL, 0, 10.0, NULL), WATER_OK);

  dice rolled = dice_seeded(20261207);
  for (int round = 0; round < 1000; ++round)
  {
    double many[50];
    double some_ms[50];
    double all_ms = 0.0;
    for (int i = 0; i < 50; ++i)
    {
      many[i] = fmax(0.0, dice_roll(&rolled, -1e5, 1e6));
    }
    many[0] = 1.0;
    const double budget_ms = dice_roll(&rolled, 0.1, 100.0);
    assert_int_equal(water_quality_share(many, 50, budget_ms, some_ms), WATER_OK);
    for (int i = 0; i < 50; ++i)
    {
      all_ms += some_ms[i];
      assert_true(many[i] > 0.0 ? some_ms[i] >= 0.1 / 50.0 * budget_ms : some_ms[i] == 0.0);
    }
    ASSERT_CLOSE(all_ms, budget_ms, 1e-12 * budget_ms);
  }
}

// Half of a frame's time is the water's; what VTK asks for a picture that stands still is no
// budget.
TEST(update_rates_have_their_budgets)
{
  ASSERT_CLOSE(water_quality_budget(50.0), 10.0, 1e-12);
  assert_false(water_quality_is_still(water_quality_budget(15.0)));
  assert_true(water_quality_is_still(water_quality_budget(0.0001)));
  assert_true(water_quality_is_still(water_quality_budget(0.0)));
  assert_true(isfinite(water_quality_budget(0.0)));
}

TEST(a_second_is_a_still_picture)
{
  assert_true(water_quality_is_still(1000.0));
  assert_false(water_quality_is_still(999.0));
}

static double time_of(int step)
{
  water_quality quality;
  water_quality_of_step(step, &quality);
  return quality.texture_scale * quality.texture_scale;
}

// A step at which the budget would be kept to the last digit is coarse enough.
TEST(a_step_of_just_the_budget_is_taken)
{
  water_quality_state control = { 0 };
  const double just = 16.0 * time_of(1) / time_of(0);
  for (int frames = 0; control.step == 0 && frames < 100; ++frames)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, just, 16.0), WATER_OK);
  }
  assert_int_equal(control.step, 1);
}

// A finer step is taken when what is left adds up to 8 budgets: 16 times a half.
TEST(eight_budgets_are_enough_for_a_finer_step)
{
  const double measured_ms = 4.0;
  const double finer_ms = measured_ms * time_of(1) / time_of(2);
  const double budget_ms = finer_ms / 0.3;
  ASSERT_CLOSE(0.8 - finer_ms / budget_ms, 0.5, 0.0);
  water_quality_state control = { 0 };
  control.step = 2;
  for (int frame = 1; frame <= 16; ++frame)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, budget_ms, measured_ms), WATER_OK);
    assert_int_equal(control.step, frame < 16 ? 2 : 1);
  }
}

TESTS(a_step_of_just_the_budget_is_taken, eight_budgets_are_enough_for_a_finer_step,
  waits_are_as_promised, frames_of_just_the_budget_count_for_nothing, no_measurement_no_change,
  finest_step_is_kept, step_from_beyond_is_no_failure, fixed_share_is_learned_from_a_change,
  fixed_share_has_its_limits, fixed_share_is_believed,
  patience_grows_with_failures_and_is_forgotten, budget_is_shared_by_area,
  update_rates_have_their_budgets, a_second_is_a_still_picture)
