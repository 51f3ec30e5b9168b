// SPDX-License-Identifier: BSD-3-Clause
// test_quality.c: the ladder, the error of its steps against the measured one, the budget's way
// along it.
#include "test_scene.h"

#include "water_quality.h"

static const int last_step = WATER_QUALITY_STEPS - 1;

static double scale_of(int step)
{
  water_quality quality;
  water_quality_of_step(step, &quality);
  return quality.texture_scale;
}

static double error_of(int step, double slope, double turn, double pixels_per_radian)
{
  const water_roughness roughness = { slope, turn, pixels_per_radian };
  double error_px = -1.0;
  assert_int_equal(water_quality_error(step, &roughness, &error_px), WATER_OK);
  return error_px;
}

// From step to step texels grow by a fifth to a half, work never grows, and beyond the ends there
// is nothing else.
TEST(ladder_leads_down_evenly)
{
  UNUSED;
  water_quality finer;
  water_quality_of_step(0, &finer);
  assert_true(finer.texture_scale == 1.0);
  for (int step = 1; step < WATER_QUALITY_STEPS; ++step)
  {
    water_quality quality;
    water_quality_of_step(step, &quality);
    const double ratio = finer.texture_scale / quality.texture_scale;
    assert_true(ratio > 1.15 && ratio < 1.45);
    assert_true(quality.ray_steps <= finer.ray_steps && quality.ray_steps >= 8);
    assert_true(quality.ray_probes <= finer.ray_probes && quality.ray_probes >= 3);
    finer = quality;
  }
  assert_true(finer.texture_scale == 0.25);
  assert_true(scale_of(-5) == 1.0 && scale_of(1000) == 0.25);
}

// What Utilities/Accuracy/quality.py measured: the median distance of the texel that is read from
// the right place, three views of the islands, 16 steps. Pixels per radian by the picture's height.
static const double measured_slopes[5] = { 0.0, 0.02, 0.05, 0.10, 0.20 };
static const double measured_px[3][5][3] = { // height, slope; scales 1, 0.5, 0.25
  { { 0.000, 0.707, 1.581 }, { 0.346, 0.754, 1.599 }, { 0.380, 0.781, 1.619 },
    { 0.407, 0.823, 1.675 }, { 0.451, 0.910, 1.816 } },
  { { 0.000, 0.707, 1.581 }, { 0.374, 0.779, 1.598 }, { 0.396, 0.800, 1.614 },
    { 0.423, 0.837, 1.674 }, { 0.482, 0.922, 1.815 } },
  { { 0.000, 0.707, 1.581 }, { 0.385, 0.788, 1.600 }, { 0.407, 0.806, 1.616 },
    { 0.454, 0.859, 1.679 }, { 0.541, 0.965, 1.841 } }
};

// Of waves, the predicted error is 8 % under to 20 % over the measured one, at every scale, slope
// and size of the picture; of calm water it is never under it by more than 1 %.
TEST(predicted_error_is_the_measured_one)
{
  UNUSED;
  const int steps[3] = { 0, 4, 7 }; // scales 1, 0.5, 0.25
  for (int height = 0; height < 3; ++height)
  {
    const double pixels_per_radian = 335.9 * (1 << height);
    for (int slope = 0; slope < 5; ++slope)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double expected = measured_px[height][slope][i];
        const double predicted = error_of(steps[i], measured_slopes[slope], 0.0, pixels_per_radian);
        const double low = slope == 0 ? 0.99 : 0.92;
        if (predicted < low * expected || (slope > 0 && predicted > 1.20 * expected))
        {
          print_error("slope %g, step %d, height %d: %g px, measured %g\n", measured_slopes[slope],
            steps[i], height, predicted, expected);
          fail();
        }
      }
    }
  }
}

// A coarser step is never nearer; rougher waves never are; a blur hides error, and all of it in the
// end.
TEST(error_is_monotone)
{
  UNUSED;
  dice rolled = dice_seeded(20261201);
  for (int i = 0; i < 20000; ++i)
  {
    const double slope = dice_roll(&rolled, 0.0, 0.5);
    const double turn = dice_roll(&rolled, 0.0, 20.0);
    const double pixels_per_radian = dice_roll(&rolled, 0.0, 5000.0);
    const int step = (int)dice_roll(&rolled, 0.0, 7.0);
    const double error = error_of(step, slope, turn, pixels_per_radian);
    assert_true(error > 0.0);
    assert_true(error_of(step + 1, slope, turn, pixels_per_radian) > error);
    assert_true(error_of(step, slope, turn + 0.1, pixels_per_radian) <= error * (1.0 + 1e-12));
    assert_true(error_of(step, slope + 0.01, 0.0, pixels_per_radian) >
      error_of(step, slope, 0.0, pixels_per_radian));
    assert_true(error_of(step, slope, 0.0, pixels_per_radian + 10.0) >=
      error_of(step, slope, 0.0, pixels_per_radian));
  }
  // 0.1 of slope that no pixel resolves blurs over 200 pixels: 1.6 of them less or more is unseen
  assert_true(error_of(7, 0.1, 100.0, 1000.0) < 0.01);
  ASSERT_CLOSE(error_of(7, 0.0, 100.0, 1000.0), 1.6, 1e-12);
}

static int step_for(double target_px, double slope, double turn, int step)
{
  const water_roughness roughness = { slope, turn, 1000.0 };
  assert_int_equal(water_quality_for_error(target_px, &roughness, &step), WATER_OK);
  return step;
}

// The step is within its target, the next coarser one is not; a target that none reaches gives the
// finest, a generous one the coarsest.
TEST(coarsest_step_within_the_target)
{
  UNUSED;
  for (double target = 0.41; target < 1.6; target += 0.01)
  {
    const int step = step_for(target, 0.0, 0.0, WATER_QUALITY_NO_STEP);
    assert_true(error_of(step, 0.0, 0.0, 1000.0) <= target);
    assert_true(step == last_step || error_of(step + 1, 0.0, 0.0, 1000.0) > target);
  }
  assert_int_equal(step_for(1e-9, 0.05, 0.0, WATER_QUALITY_NO_STEP), 0);
  assert_int_equal(step_for(1e-9, 0.05, 0.0, 5), 0);
  assert_int_equal(step_for(1e9, 0.05, 0.0, WATER_QUALITY_NO_STEP), last_step);
  assert_int_equal(step_for(1.0, 0.0, 0.0, WATER_QUALITY_NO_STEP), 5);
  assert_int_equal(step_for(1.0, 0.2, 0.0, WATER_QUALITY_NO_STEP), 4);         // rougher: finer
  assert_int_equal(step_for(1.0, 0.2, 9.0, WATER_QUALITY_NO_STEP), last_step); // but blurred
}

// Waves whose slope sways by a tenth about a limit change the step once, and a slow swell of the
// slope there and back comes back.
TEST(step_for_an_error_does_not_pump)
{
  UNUSED;
  int step = WATER_QUALITY_NO_STEP;
  int changes = -1; // the first choice is none
  for (int frame = 0; frame < 1000; ++frame)
  {
    // step 4 is at its target of 0.86 with a slope of about 0.1
    const int before = step;
    step = step_for(0.86, 0.13 + 0.013 * sin(0.3 * frame), 0.0, step);
    changes += step != before;
  }
  assert_true(changes <= 1);
  assert_int_equal(step_for(0.86, 0.3, 0.0, step), 2);
  assert_int_equal(step_for(0.86, 0.0, 0.0, 2), 3); // 0.8 is more than 0.9 of 0.86
  assert_int_equal(step_for(0.9, 0.0, 0.0, 2), 4);
}

// A cost of a + b scale^2 ms with noise.
typedef struct machine
{
  double fixed_ms;
  double scaled_ms;
  double noise; // share, even
} machine;

static double time_of(const machine* cost, int step, dice* rolled)
{
  const double scale = scale_of(step);
  return (cost->fixed_ms + cost->scaled_ms * scale * scale) *
    (1.0 + dice_roll(rolled, -cost->noise, cost->noise));
}

typedef struct history
{
  int change_count; // frames at which the step changed
  int turn_count;   // of these, those that led the other way than the one before
} history;

static history draw(
  water_quality_state* control, const machine* cost, double budget_ms, int frames, dice* rolled)
{
  history seen = { 0, 0 };
  int last_way = 0;
  for (int i = 0; i < frames; ++i)
  {
    const int before = control->step;
    const double measured_ms = time_of(cost, before, rolled);
    assert_int_equal(water_quality_for_budget(control, 0, budget_ms, measured_ms), WATER_OK);
    assert_true(control->step >= 0 && control->step < WATER_QUALITY_STEPS);
    if (control->step != before)
    {
      const int way = control->step > before ? 1 : -1;
      ++seen.change_count;
      seen.turn_count += last_way == -way;
      last_way = way;
    }
  }
  return seen;
}

// Whatever the cost, with noise of 20 %: in 10000 frames the step goes along the ladder once and
// hardly ever turns back; it ends within its budget, or nearly, or at the coarsest.
TEST(noise_does_not_make_it_oscillate)
{
  UNUSED;
  dice rolled = dice_seeded(20261202);
  history most = { 0, 0 };
  int turned = 0;
  const int rounds = 300;
  for (int i = 0; i < rounds; ++i)
  {
    const double whole = dice_roll(&rolled, 1.0, 60.0);
    const double fixed = dice_roll(&rolled, 0.0, 1.0);
    const machine cost = { fixed * whole, (1.0 - fixed) * whole, 0.2 };
    const machine quiet = { cost.fixed_ms, cost.scaled_ms, 0.0 };
    water_quality_state control = { 0 };
    control.step = (int)dice_roll(&rolled, 0.0, 8.0);
    const history seen = draw(&control, &cost, 10.0, 10000, &rolled);
    most.change_count =
      seen.change_count > most.change_count ? seen.change_count : most.change_count;
    most.turn_count = seen.turn_count > most.turn_count ? seen.turn_count : most.turn_count;
    turned += seen.turn_count > 0;
    assert_true(seen.change_count <= 9);
    assert_true(seen.turn_count <= 1);
    assert_true(control.step == last_step || time_of(&quiet, control.step, &rolled) < 1.05 * 10.0);
    if (control.step > 0)
    {
      // and the next finer one would be too long, or near to it as far as one can know
      const double ratio = scale_of(control.step - 1) / scale_of(control.step);
      assert_true(time_of(&quiet, control.step, &rolled) * ratio * ratio > 0.75 * 10.0);
    }
  }
  assert_true(turned < rounds / 20);
  print_message("at the most %d changes, %d turns; %d of %d turned\n", most.change_count,
    most.turn_count, turned, rounds);
}

// Four times the budget: the first change after 3 frames, within the budget after 40.
TEST(a_step_of_the_cost_is_answered_at_once)
{
  UNUSED;
  dice rolled = dice_seeded(20261203);
  const machine light = { 0.5, 7.0, 0.1 };
  const machine heavy = { 2.0, 38.0, 0.1 };
  water_quality_state control = { 0 };
  assert_int_equal(draw(&control, &light, 10.0, 1000, &rolled).change_count, 0);
  assert_true(draw(&control, &heavy, 10.0, 3, &rolled).change_count > 0);
  draw(&control, &heavy, 10.0, 37, &rolled);
  const machine quiet = { 2.0, 38.0, 0.0 };
  assert_true(time_of(&quiet, control.step, &rolled) <= 10.0);
  assert_in_range(control.step, 5, 6);
  assert_true(draw(&control, &heavy, 10.0, 5000, &rolled).change_count <= 1);
  draw(&control, &light, 10.0, 3000, &rolled);
  assert_true(control.step <= 1); // 0 would take 0.75 of the budget
}

// A budget that nothing meets ends at the coarsest step, and soon; a cost that is gone brings the
// finest back within 150 frames.
TEST(ends_of_the_ladder_are_reached)
{
  UNUSED;
  dice rolled = dice_seeded(20261204);
  const machine slow = { 100.0, 10.0, 0.2 };
  const machine gone = { 1e-6, 1e-6, 0.2 };
  water_quality_state control = { 0 };
  draw(&control, &slow, 10.0, 30, &rolled);
  assert_int_equal(control.step, last_step);
  assert_int_equal(draw(&control, &slow, 10.0, 10000, &rolled).change_count, 0);
  draw(&control, &gone, 10.0, 150, &rolled);
  assert_int_equal(control.step, 0);
  assert_int_equal(draw(&control, &gone, 10.0, 10000, &rolled).change_count, 0);
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
  UNUSED;
  const double to_finer = 0.71 / 0.84 * 0.71 / 0.84; // of time, without a fixed share
  assert_int_equal(frames_until_change(2, 1000.0), 3);
  assert_int_equal(frames_until_change(2, 20.0), 3);
  assert_in_range(frames_until_change(2, 11.0), 30, 31);
  assert_in_range(frames_until_change(2, 1e-9), 10, 11);
  assert_in_range(frames_until_change(2, 7.0 * to_finer), 80, 81);
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

// A machine that fits no model, where every finer step costs four times as much: what failed is
// tried again more and more seldom.
TEST(failed_attempts_become_rare)
{
  UNUSED;
  water_quality_state control = { 0 };
  int changes = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const int before = control.step;
    const double measured_ms = before < 5 ? 14.0 : 3.0;
    assert_int_equal(water_quality_for_budget(&control, 0, 10.0, measured_ms), WATER_OK);
    changes += control.step != before;
  }
  print_message("%d changes in 100000 frames\n", changes);
  assert_true(changes < 400);
}

// The fixed share is found from the changes: where most of the time does not depend on the scale,
// finer steps are taken that a share of 0 would not allow.
TEST(fixed_share_is_learned)
{
  UNUSED;
  dice rolled = dice_seeded(20261205);
  const machine heavy = { 12.0, 4.0, 0.05 };
  const machine light = { 6.0, 0.3, 0.05 };
  water_quality_state control = { 0 };
  draw(&control, &heavy, 14.0, 300, &rolled);
  assert_true(control.step > 0);
  print_message("step %d, fixed share %g\n", control.step, control.fixed_share);
  assert_in_range(control.step, 2, 3);
  assert_true(control.fixed_share > 0.3 && control.fixed_share < 0.8); // it is 0.75
  const double ratio = scale_of(1) / scale_of(2);
  assert_true(6.1 * ratio * ratio > 0.8 * 10.0); // what a share of 0 would expect
  const double expensive = control.fixed_share;
  draw(&control, &light, 10.0, 3000, &rolled);
  assert_true(control.fixed_share > expensive);
  assert_int_equal(control.step, 0);
}

// A frame without a time keeps all as it is: the first one, one that drew nothing, a timer's error.
TEST(no_measurement_no_change)
{
  UNUSED;
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
  UNUSED;
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

// Equal inputs give equal outputs, to the last bit.
TEST(same_times_same_steps)
{
  UNUSED;
  const machine cost = { 5.0, 20.0, 0.2 };
  water_quality_state states[2];
  memset(states, 0, sizeof states);
  for (int i = 0; i < 2; ++i)
  {
    dice rolled = { 20261206 };
    draw(&states[i], &cost, 10.0, 3000, &rolled);
  }
  assert_memory_equal(&states[0], &states[1], sizeof states[0]);
}

// Shares add up to the budget, follow the areas, leave none to what is not seen and a little to
// what is hardly seen.
TEST(budget_is_shared_by_area)
{
  UNUSED;
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

// What makes no sense is named and changes nothing.
TEST(bad_input_is_refused)
{
  UNUSED;
  const double bad[5] = { 0.0, -1.0, (double)NAN, (double)INFINITY, -(double)INFINITY };
  const water_roughness calm = { 0.0, 0.0, 1000.0 };
  water_quality_state control = { 0 };
  control.step = 2;
  const water_quality_state before = control;
  const double area = 7.0;
  double share = -1.0;
  int step = 4;
  for (int i = 0; i < 5; ++i)
  {
    assert_int_equal(water_quality_for_budget(&control, 0, bad[i], 100.0), WATER_BAD_TIME_BUDGET);
    assert_int_equal(water_quality_share(&area, 1, bad[i], &share), WATER_BAD_TIME_BUDGET);
    assert_int_equal(water_quality_for_error(bad[i], &calm, &step), WATER_BAD_TARGET_ERROR);
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 1; j < 5; ++j)
    {
      double values[3] = { 0.1, 0.1, 1000.0 };
      values[i] = bad[j];
      const water_roughness rough = { values[0], values[1], values[2] };
      double error_px = 3.0;
      assert_int_equal(water_quality_error(0, &rough, &error_px), WATER_BAD_ROUGHNESS);
      assert_true(error_px == 3.0);
      assert_int_equal(water_quality_for_error(1.0, &rough, &step), WATER_BAD_ROUGHNESS);
    }
  }
  const water_roughness huge = { DBL_MAX, 0.0, DBL_MAX };
  assert_int_equal(water_quality_for_error(1.0, &huge, &step), WATER_BAD_ROUGHNESS);
  assert_memory_equal(&control, &before, sizeof control);
  assert_true(share == -1.0);
  assert_int_equal(step, 4);
  assert_non_null(strstr(water_status_text(WATER_BAD_TIME_BUDGET), "TimeBudget"));
  assert_non_null(strstr(water_status_text(WATER_BAD_TARGET_ERROR), "TargetError"));
}

// Seen straight down from 10 over a pool, a quarter of a turn of view: a pixel of 100 is 0.2 on
// each side, and turns a wave of 0.5 rad per unit by 0.1 on the mean of its directions.
TEST(roughness_is_of_a_pixel_on_the_water)
{
  UNUSED;
  water_scene scene = pool(10.0);
  scene.viewport_px[0] = scene.viewport_px[1] = 100;
  scene.has_waves = true;
  scene.slope_rms = 0.05;
  scene.slope_max = (double)INFINITY;
  const water_plan plan = plan_of(&scene, NULL);
  water_roughness roughness;
  water_quality_look(&scene, &plan, 0.5, &roughness);
  ASSERT_CLOSE(roughness.slope_rms, 0.05, 0.0);
  ASSERT_CLOSE(roughness.turn_rad, 0.1, 1e-9);
  ASSERT_CLOSE(roughness.pixels_per_radian, 50.0, 1e-9);
  // nothing is known of the first frame, nor of water that is not seen
  water_plan none;
  memset(&none, 0, sizeof none);
  water_quality_look(&scene, &none, 0.5, &roughness);
  ASSERT_CLOSE(roughness.turn_rad, 0.0, 0.0);
}

// In a view that is tilted and rolled the pixel that counts is the smallest in a corner of what the
// map is drawn for: view rays through it, the pixel to its right and the one above meet the water
// at places that far apart. The map is flipped.
TEST(roughness_is_of_the_smallest_pixel_in_a_corner)
{
  UNUSED;
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.3, 0.0, 1.0 };
  for (int side = -1; side <= 1; side += 2)
  {
    water_scene scene = lake();
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.surface_bounds[0] = side < 0 ? -6.0 : 2.0;
    scene.surface_bounds[1] = side < 0 ? -2.0 : 6.0;
    scene.surface_bounds[3] = -2.0; // its picture's corners are under the horizon
    scene.viewport_px[0] = 80;
    scene.viewport_px[1] = 60;
    const water_plan plan = plan_of(&scene, NULL);
    const int* rect = plan.texture_rect_px;
    const double* view = scene.eye.world_to_view;
    double least = DBL_MAX;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x_px = plan.texture_px[0] - (rect[0] + (corner & 1 ? rect[2] : 0));
      const double y_px = rect[1] + (corner & 2 ? rect[3] : 0);
      double places[3][2];
      for (int ray = 0; ray < 3; ++ray)
      {
        const double x = 4.0 / 3.0 * (2.0 * (x_px + (ray == 1)) / 80.0 - 1.0);
        const double y = 2.0 * (y_px + (ray == 2)) / 60.0 - 1.0;
        double dir[3];
        for (int i = 0; i < 3; ++i)
        {
          dir[i] = x * view[i] + y * view[4 + i] - view[8 + i];
        }
        assert_true(dir[2] < 0.0);
        places[ray][0] = eye[0] - eye[2] / dir[2] * dir[0];
        places[ray][1] = eye[1] - eye[2] / dir[2] * dir[1];
      }
      const double across = hypot(places[1][0] - places[0][0], places[1][1] - places[0][1]);
      const double along = hypot(places[2][0] - places[0][0], places[2][1] - places[0][1]);
      least = fmin(least, hypot(across, along));
    }
    water_roughness roughness;
    water_quality_look(&scene, &plan, 3.0, &roughness);
    ASSERT_CLOSE(roughness.turn_rad, 3.0 * least / sqrt(2.0), 1e-9);
  }
}

// With half of the time fixed a finer step, 0.84 of the scale for 0.71, costs 1.134 times as much:
// frames of 6.6 ms lead to one of 7.5 in a budget of 10, frames of 7.2 to none; and what was
// measured on too few frames teaches nothing about that share.
TEST(fixed_share_is_believed)
{
  UNUSED;
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

// A coarser step must have an error of nine tenths of the target, and that is enough.
TEST(margin_of_a_coarser_step_is_a_tenth)
{
  UNUSED;
  const water_roughness calm = { 0.0, 0.0, 0.0 };
  int found = 0;
  for (int step = 1; step < WATER_QUALITY_STEPS; ++step)
  {
    double error_px = 0.0;
    assert_int_equal(water_quality_error(step, &calm, &error_px), WATER_OK);
    const double target_px = error_px / 0.9;
    if (0.9 * target_px == error_px) // as doubles round
    {
      int chosen = 0;
      assert_int_equal(water_quality_for_error(target_px, &calm, &chosen), WATER_OK);
      assert_int_equal(chosen, step);
      ++found;
    }
  }
  assert_in_range(found, 1, WATER_QUALITY_STEPS);
}

// Frames that take just the budget are neither too long nor too short: after any number of them
// long ones are answered as if they were the first.
TEST(frames_of_just_the_budget_count_for_nothing)
{
  UNUSED;
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
    assert_in_range(fresh.step, 1, WATER_QUALITY_STEPS - 1);
    assert_int_equal(used.step, fresh.step);
  }
}

// Half of a frame's time is the water's; what VTK asks for a picture that stands still is no
// budget.
TEST(update_rates_have_their_budgets)
{
  UNUSED;
  ASSERT_CLOSE(water_quality_budget(50.0), 10.0, 1e-12);
  assert_false(water_quality_is_still(water_quality_budget(15.0)));
  assert_true(water_quality_is_still(water_quality_budget(0.0001)));
  assert_true(water_quality_is_still(water_quality_budget(0.0)));
  assert_true(isfinite(water_quality_budget(0.0)));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(ladder_leads_down_evenly),
    RUN(predicted_error_is_the_measured_one),
    RUN(error_is_monotone),
    RUN(coarsest_step_within_the_target),
    RUN(step_for_an_error_does_not_pump),
    RUN(noise_does_not_make_it_oscillate),
    RUN(a_step_of_the_cost_is_answered_at_once),
    RUN(ends_of_the_ladder_are_reached),
    RUN(waits_are_as_promised),
    RUN(failed_attempts_become_rare),
    RUN(fixed_share_is_learned),
    RUN(no_measurement_no_change),
    RUN(finest_step_is_kept),
    RUN(same_times_same_steps),
    RUN(budget_is_shared_by_area),
    RUN(bad_input_is_refused),
    RUN(roughness_is_of_a_pixel_on_the_water),
    RUN(roughness_is_of_the_smallest_pixel_in_a_corner),
    RUN(fixed_share_is_believed),
    RUN(margin_of_a_coarser_step_is_a_tenth),
    RUN(frames_of_just_the_budget_count_for_nothing),
    RUN(update_rates_have_their_budgets),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
