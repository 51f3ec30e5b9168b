// SPDX-License-Identifier: BSD-3-Clause
// test_machines.c: a time budget on simulated machines: the way along the ladder, frame by frame.
#include "test_scene.h"

#include "water_quality.h"

static const int last_step = WATER_QUALITY_STEPS - 1;

static double scale_of(int step)
{
  water_quality quality;
  water_quality_of_step(step, &quality);
  return quality.texture_scale;
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
  dice rolled = dice_seeded(20261203);
  const machine light = { 0.5, 7.0, 0.1 };
  const machine heavy = { 2.0, 38.0, 0.1 };
  water_quality_state control = { 0 };
  assert_int_equal(draw(&control, &light, 10.0, 1000, &rolled).change_count, 0);
  assert_true(draw(&control, &heavy, 10.0, 3, &rolled).change_count > 0);
  draw(&control, &heavy, 10.0, 37, &rolled);
  const machine quiet = { 2.0, 38.0, 0.0 };
  assert_true(time_of(&quiet, control.step, &rolled) <= 10.0);
  assert_int_in_range(control.step, 5, 6);
  assert_true(draw(&control, &heavy, 10.0, 5000, &rolled).change_count <= 1);
  draw(&control, &light, 10.0, 3000, &rolled);
  assert_true(control.step <= 1); // 0 would take 0.75 of the budget
}

// A budget that nothing meets ends at the coarsest step, and soon; a cost that is gone brings the
// finest back within 150 frames.
TEST(ends_of_the_ladder_are_reached)
{
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

// A machine that fits no model, where every finer step costs four times as much: what failed is
// tried again more and more seldom.
TEST(failed_attempts_become_rare)
{
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
  dice rolled = dice_seeded(20261205);
  const machine heavy = { 12.0, 4.0, 0.05 };
  const machine light = { 6.0, 0.3, 0.05 };
  water_quality_state control = { 0 };
  draw(&control, &heavy, 14.0, 300, &rolled);
  assert_true(control.step > 0);
  print_message("step %d, fixed share %g\n", control.step, control.fixed_share);
  assert_int_in_range(control.step, 2, 3);
  assert_true(control.fixed_share > 0.3 && control.fixed_share < 0.8); // it is 0.75
  const double ratio = scale_of(1) / scale_of(2);
  assert_true(6.1 * ratio * ratio > 0.8 * 10.0); // what a share of 0 would expect
  const double expensive = control.fixed_share;
  draw(&control, &light, 10.0, 3000, &rolled);
  assert_true(control.fixed_share > expensive);
  assert_int_equal(control.step, 0);
}

// Equal inputs give equal outputs, to the last bit.
TEST(same_times_same_steps)
{
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

TESTS(noise_does_not_make_it_oscillate, a_step_of_the_cost_is_answered_at_once,
  ends_of_the_ladder_are_reached, failed_attempts_become_rare, fixed_share_is_learned,
  same_times_same_steps)
