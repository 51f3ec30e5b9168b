// SPDX-License-Identifier: BSD-3-Clause
// test_choice.c: which step each way of choosing the quality takes, and what it remembers.
#include "test_scene.h"

#include "water_quality.h"

#include <limits.h>

static water_quality_request request_of(water_quality_mode mode)
{
  water_quality_request request;
  memset(&request, 0, sizeof request);
  request.mode = mode;
  request.texture_scale = 0.7;
  request.target_error_px = 1.0;
  request.budget_ms = 10.0;
  request.roughness.slope_rms = 0.05;
  request.roughness.pixels_per_radian = 600.0;
  request.measured_ms = 30.0;
  return request;
}

static water_quality_choice choice_of(
  const water_quality_request* request, water_quality_memory* memory)
{
  water_quality_choice choice;
  memset(&choice, 0x55, sizeof choice);
  water_quality_choose(request, memory, &choice);
  return choice;
}

// A choice is all that its step of the ladder sets.
static void assert_step(const water_quality_choice* choice, int step)
{
  water_quality quality;
  water_quality_of_step(step, &quality);
  assert_int_equal(choice->step, step);
  ASSERT_CLOSE(choice->texture_scale, quality.texture_scale, 0.0);
  assert_int_equal(choice->ray_steps, quality.ray_steps);
  assert_int_equal(choice->ray_probes, quality.ray_probes);
}

// The first frame knows of none before it: no step was chosen, no time was measured.
TEST(first_memory_is_empty)
{
  const water_quality_state fresh = { 0 };
  water_quality_memory memory;
  memset(&memory, 0x55, sizeof memory);
  water_quality_begin(&memory);
  assert_int_equal(memory.error_step, WATER_QUALITY_NO_STEP);
  assert_memory_equal(&memory.budget, &fresh, sizeof fresh);
}

// A fixed quality takes the scale that is given, limits no rays and learns nothing.
TEST(fixed_quality_is_the_users)
{
  water_quality_memory memory;
  water_quality_begin(&memory);
  const water_quality_memory before = memory;
  const water_quality_request request = request_of(WATER_QUALITY_FIXED);
  const water_quality_choice choice = choice_of(&request, &memory);
  assert_int_equal(choice.step, WATER_QUALITY_NO_STEP);
  ASSERT_CLOSE(choice.texture_scale, 0.7, 0.0);
  assert_int_equal(choice.ray_steps, INT_MAX);
  assert_int_equal(choice.ray_probes, INT_MAX);
  assert_memory_equal(&memory, &before, sizeof memory);
}

// A target error takes the coarsest step within it, and remembers that one: within a tenth of the
// target it depends on where it came from. Times do not count.
TEST(target_error_has_its_step_and_keeps_it)
{
  water_quality_request request = request_of(WATER_QUALITY_TARGET_ERROR);
  water_quality_memory memory;
  water_quality_begin(&memory);
  int step = WATER_QUALITY_NO_STEP;
  int kept = 0;
  for (int i = 0; i < 200; ++i)
  {
    request.target_error_px = 1.2 + 0.9 * sin(0.1 * i);
    int fresh = WATER_QUALITY_NO_STEP;
    assert_int_equal(
      water_quality_for_error(request.target_error_px, &request.roughness, &step), WATER_OK);
    assert_int_equal(
      water_quality_for_error(request.target_error_px, &request.roughness, &fresh), WATER_OK);
    const water_quality_choice choice = choice_of(&request, &memory);
    assert_step(&choice, step);
    kept += step != fresh;
  }
  assert_true(kept > 0);
  assert_int_equal(memory.budget.step, 0);

  // what is not accepted changes nothing
  for (int i = 0; i < 2; ++i)
  {
    water_quality_request bad = request;
    bad.target_error_px = i == 0 ? 0.0 : 0.01;
    bad.roughness.slope_rms = i == 1 ? (double)NAN : 0.05;
    const water_quality_choice choice = choice_of(&bad, &memory);
    assert_step(&choice, step);
  }
}

// Where no target was ever accepted, the finest step is taken: only a fixed quality has none.
TEST(bad_first_target_is_the_finest_step)
{
  water_quality_request request = request_of(WATER_QUALITY_TARGET_ERROR);
  request.target_error_px = -1.0;
  water_quality_memory memory;
  water_quality_begin(&memory);
  const water_quality_choice choice = choice_of(&request, &memory);
  assert_step(&choice, 0);
  assert_int_equal(memory.error_step, WATER_QUALITY_NO_STEP);
}

// A budget, of the user's or of a rate of frames, moves along the ladder by the measured times.
TEST(budgets_follow_the_times)
{
  const water_quality_mode modes[2] = { WATER_QUALITY_TIME_BUDGET, WATER_QUALITY_UPDATE_RATE };
  for (int i = 0; i < 2; ++i)
  {
    water_quality_request request = request_of(modes[i]);
    water_quality_memory memory;
    water_quality_begin(&memory);
    water_quality_state state = { 0 };
    for (int frame = 0; frame < 300; ++frame)
    {
      request.measured_ms = frame < 50 ? 30.0 : 1.0;
      (void)water_quality_for_budget(&state, 0, request.budget_ms, request.measured_ms);
      const water_quality_choice choice = choice_of(&request, &memory);
      assert_step(&choice, state.step);
      assert_true(frame != 49 || state.step == WATER_QUALITY_STEPS - 1);
    }
    assert_true(state.step < WATER_QUALITY_STEPS - 1);
    assert_int_equal(memory.error_step, WATER_QUALITY_NO_STEP);

    request.budget_ms = -1.0; // is no budget, and changes nothing
    const water_quality_choice choice = choice_of(&request, &memory);
    assert_step(&choice, state.step);
  }
}

// A picture that stands still has the finest step at once, and a time budget of seconds has not:
// it is one of frames.
TEST(still_picture_has_the_finest_step)
{
  water_quality_request request = request_of(WATER_QUALITY_UPDATE_RATE);
  water_quality_memory memory;
  water_quality_begin(&memory);
  memory.budget.step = 5;
  request.budget_ms = 1000.0;
  const water_quality_memory before = memory;
  const water_quality_choice still = choice_of(&request, &memory);
  assert_step(&still, 0);
  assert_memory_equal(&memory, &before, sizeof memory);
  request.budget_ms = 999.0;
  const water_quality_choice moving = choice_of(&request, &memory);
  assert_step(&moving, 5);
  request.mode = WATER_QUALITY_TIME_BUDGET;
  request.budget_ms = 2000.0;
  const water_quality_choice budget = choice_of(&request, &memory);
  assert_step(&budget, 5);
}

// Some of the waters get together what they would get one by one; all of the budget while none of
// them is seen, or where the budget is none.
TEST(own_waters_get_their_shares)
{
  const double areas[5] = { 3e5, 1e5, 0.0, 2e5, (double)NAN };
  double shares[5];
  double work[5];
  assert_int_equal(water_quality_share(areas, 5, 12.0, shares), WATER_OK);
  for (int own = 0; own < 32; ++own)
  {
    unsigned char is_own[5];
    double sum = 0.0;
    for (int i = 0; i < 5; ++i)
    {
      is_own[i] = (unsigned char)(own >> i & 1);
      sum += is_own[i] ? shares[i] : 0.0;
    }
    ASSERT_CLOSE(
      water_quality_share_of(areas, is_own, 5, 12.0, work), (own & 11) ? sum : 12.0, 1e-13);
    ASSERT_CLOSE(water_quality_share_of(areas, is_own, 5, -3.0, work), -3.0, 0.0);
  }
}

// Four names, each of more work than the last, and no other; a wrong one changes nothing.
TEST(qualities_have_names)
{
  static const char* const names[4] = { "fast", "default", "high", "reference" };
  water_ray_quality last = { 0, 0, 0, 0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    water_ray_quality quality;
    assert_int_equal(water_quality_of_name(names[i], &quality), WATER_OK);
    assert_true(quality.steps > last.steps && quality.probes > last.probes);
    assert_true(quality.layers >= last.layers);
    assert_true(quality.footprint_px == (i < 3 ? 1.0 : 0.0));
    last = quality;
  }
  water_ray_quality kept = last;
  assert_int_equal(water_quality_of_name("High", &kept), WATER_BAD_QUALITY_NAME);
  assert_int_equal(water_quality_of_name("", &kept), WATER_BAD_QUALITY_NAME);
  assert_memory_equal(&kept, &last, sizeof last);
}

// All slopes of a pixel are for "high" alone, and for whoever asks for more rays than the
// default's.
TEST(many_rays_take_all_slopes)
{
  static const char* const names[4] = { "fast", "default", "high", "reference" };
  for (int i = 0; i < 4; ++i)
  {
    water_ray_quality quality;
    assert_int_equal(water_quality_of_name(names[i], &quality), WATER_OK);
    assert_int_equal(water_rays_take_all_slopes(quality.rays), i == 2);
  }
  assert_false(water_rays_take_all_slopes(4));
  assert_true(water_rays_take_all_slopes(5));
}

// The first frame of an average looks through the pixels' middles, and 64 are spread so evenly that
// each ninth of the pixel has 5 to 10.
TEST(frames_of_an_average_are_spread_evenly)
{
  int counts[9] = { 0 };
  double place[2];
  water_quality_jitter(0, place);
  assert_true(place[0] == 0.0 && place[1] == 0.0);
  water_quality_jitter(1, place); // 1 / 1.32471796, and that squared, of which wholes are taken off
  ASSERT_CLOSE(place[0], 0.75487767 - 1.0, 1e-8);
  ASSERT_CLOSE(place[1], 0.56984029 - 1.0, 1e-8);
  for (unsigned i = 0; i < 64; ++i)
  {
    water_quality_jitter(i, place);
    assert_true(place[0] >= -0.5 && place[0] < 0.5 && place[1] >= -0.5 && place[1] < 0.5);
    ++counts[(int)(3.0 * (place[0] + 0.5)) + 3 * (int)(3.0 * (place[1] + 0.5))];
  }
  for (int i = 0; i < 9; ++i)
  {
    assert_true(counts[i] >= 5 && counts[i] <= 10);
  }
}

TESTS(qualities_have_names, many_rays_take_all_slopes, frames_of_an_average_are_spread_evenly,
  first_memory_is_empty, fixed_quality_is_the_users, target_error_has_its_step_and_keeps_it,
  bad_first_target_is_the_finest_step, budgets_follow_the_times, still_picture_has_the_finest_step,
  own_waters_get_their_shares)
