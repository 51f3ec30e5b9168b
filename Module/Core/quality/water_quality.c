// SPDX-License-Identifier: BSD-3-Clause
// water_quality.c: the ladder, the error of its steps, and the way along it for a time budget.
#include "water_quality.h"

#include "water_math.h"
#include "water_plan.h"
#include "water_target.h"

#include <limits.h>

static const water_quality ladder[WATER_QUALITY_STEPS] = {
  { 1.00, 24, 12 },
  { 0.84, 16, 6 },
  { 0.71, 16, 6 },
  { 0.59, 16, 6 },
  { 0.50, 16, 6 },
  { 0.42, 16, 6 },
  { 0.35, 12, 4 },
  { 0.25, 8, 3 },
};

// The error, all measured.
static const double texel_error = 0.4;  // median distance from the middle of a texel, in texels
static const double lost_growth = 1.8;  // of that median by lookups that are lost, over slope^2
static const double turn_part = 280.0;  // of a step of the march is its part in the error
static const double error_margin = 0.9; // of the target, for a coarser step than the one in use

// The budget, all in budgets or frames.
static const double over_limit = 3.0;
static const double under_limit = 8.0;
static const double under_part = 0.8;
static const double over_most = 1.0; // of one frame: a hiccup is not a trend
static const int coarser_most = 2;   // steps at a time, for the same reason
static const int settle_frames = 3;
static const int before_least = 16; // frames that a mean before a change is of
static const int after_frames = 32;
static const int quiet_frames = 1000;
static const int patience_most = 6;
static const double fixed_most = 0.9; // more would promise finer steps for nothing

static int clamp_step(int step)
{
  return step < 0 ? 0 : step < WATER_QUALITY_STEPS ? step : WATER_QUALITY_STEPS - 1;
}

void water_quality_of_step(int step, water_quality* quality)
{
  *quality = ladder[clamp_step(step)];
}

static bool is_length(double value)
{
  return isfinite(value) && value >= 0.0;
}

// The place on the plane of a point of the picture, in NDC.
static void place_of(const water_plan* plan, double x, double y, double place[2])
{
  const double* rows = plan->ndc_to_plane;
  const double w = rows[6] * x + rows[7] * y + rows[8];
  place[0] = (rows[0] * x + rows[1] * y + rows[2]) / w;
  place[1] = (rows[3] * x + rows[4] * y + rows[5]) / w;
}

void water_quality_roughness(
  const water_scene* scene, const water_plan* plan, double wave_number, water_roughness* roughness)
{
  const double* clip = scene->eye.view_to_clip;
  roughness->slope_rms = scene->slope_rms;
  roughness->turn_rad = 0.0;
  roughness->pixels_per_radian =
    clip[14] != 0.0 ? 0.5 * scene->viewport_px[1] * fabs(clip[5]) : 0.0;
  if (!plan->has_view || !water_plan_has_reflection(plan))
  {
    return;
  }
  double box[4];
  water_rect_to_ndc(plan->texture_rect_px, plan->texture_px, box);
  // where the waves are seen best: in one of the corners
  double turn = DBL_MAX;
  for (int corner = 0; corner < 4; ++corner)
  {
    // the reflection texture is flipped in x
    const double x = -box[corner & 1 ? 2 : 0] / plan->reflection_scale[0];
    const double y = box[corner & 2 ? 3 : 1] / plan->reflection_scale[1];
    double here[2];
    double across[2];
    double down[2];
    place_of(plan, x, y, here);
    place_of(plan, x + 2.0 / scene->viewport_px[0], y, across);
    place_of(plan, x, y + 2.0 / scene->viewport_px[1], down);
    const double pixel = hypot(
      hypot(across[0] - here[0], across[1] - here[1]), hypot(down[0] - here[0], down[1] - here[1]));
    // a wave runs along both sides alike, on the mean of all directions
    turn = fmin(turn, wave_number * pixel / sqrt(2.0));
  }
  roughness->turn_rad = isfinite(turn) ? turn : 0.0;
}

water_status water_quality_error(int step, const water_roughness* roughness, double* error_px)
{
  if (!is_length(roughness->slope_rms) || !is_length(roughness->turn_rad) ||
    !is_length(roughness->pixels_per_radian))
  {
    return WATER_BAD_ROUGHNESS;
  }
  const water_quality* quality = &ladder[clamp_step(step)];
  const double kept = exp(-roughness->turn_rad * roughness->turn_rad / 24.0);
  const double seen = roughness->slope_rms * kept;
  const double hidden = roughness->slope_rms * sqrt((1.0 - kept) * (1.0 + kept));
  const double sharp = texel_error / quality->texture_scale * (1.0 + lost_growth * seen * seen) +
    2.0 * seen * roughness->pixels_per_radian / (turn_part * quality->ray_steps);
  const double blur = 2.0 * hidden * roughness->pixels_per_radian;
  // sqrt(blur^2 + sharp^2) - blur without the difference of two large numbers
  const double error = sharp * (sharp / (hypot(blur, sharp) + blur));
  if (!isfinite(error))
  {
    return WATER_BAD_ROUGHNESS; // numbers that no water has
  }
  *error_px = error;
  return WATER_OK;
}

water_status water_quality_for_error(double target_px, const water_roughness* roughness, int* step)
{
  if (!isfinite(target_px) || target_px <= 0.0)
  {
    return WATER_BAD_TARGET_ERROR;
  }
  const int present = *step == WATER_QUALITY_NO_STEP ? *step : clamp_step(*step);
  int within = 0; // the coarsest within the target
  int well_within = 0;
  bool is_present_within = false;
  for (int i = 0; i < WATER_QUALITY_STEPS; ++i)
  {
    double error_px = 0.0;
    const water_status status = water_quality_error(i, roughness, &error_px);
    if (status != WATER_OK)
    {
      return status;
    }
    if (error_px <= target_px)
    {
      within = i;
      is_present_within = is_present_within || i == present;
    }
    if (error_px <= error_margin * target_px)
    {
      well_within = i;
    }
  }
  if (is_present_within)
  {
    *step = well_within > present ? well_within : present;
  }
  else
  {
    *step = within;
  }
  return WATER_OK;
}

// Time of a step over that of the finest.
static double relative_time(double fixed_share, int step)
{
  const double scale = ladder[step].texture_scale;
  return fixed_share + (1.0 - fixed_share) * scale * scale;
}

static double predict(const water_quality_state* state, double time_ms, int step)
{
  return time_ms * relative_time(state->fixed_share, step) /
    relative_time(state->fixed_share, state->step);
}

// From two means, at two scales, the share that did not change with the scale.
static void learn(water_quality_state* state)
{
  const double now_ms = state->after_ms / state->after_count;
  const double now = relative_time(0.0, state->step); // scale^2
  const double before = relative_time(0.0, state->before_step);
  const double variable = (now_ms - state->before_ms) / (now - before); // b
  const double fixed = now_ms - variable * now;                         // a
  // a falling time at a rising scale, or a negative rest, is noise or another scene
  const double whole = fixed + variable;
  const double share = whole > 0.0 ? fixed / whole : 0.0;
  const double kept = share > 0.0 ? (share < fixed_most ? share : fixed_most) : 0.0;
  state->fixed_share = 0.5 * (state->fixed_share + kept);
}

static void move(water_quality_state* state, int step, double before_ms, int before_count)
{
  const bool is_finer = step < state->step;
  if (!is_finer && state->was_finer && state->calm_count < quiet_frames &&
    state->patience < patience_most)
  {
    ++state->patience;
  }
  state->was_finer = is_finer;
  state->before_step = state->step;
  state->before_ms = before_count >= before_least ? before_ms / before_count : 0.0;
  state->after_ms = 0.0;
  state->after_count = 0;
  state->calm_count = 0;
  state->over = state->over_ms = 0.0;
  state->under = state->under_ms = 0.0;
  state->over_count = state->under_count = 0;
  state->settle_count = settle_frames;
  state->step = step;
}

// Adds a part to a sum that never falls under 0, and counts the frames since it was 0.
static void gather(double part, double time_ms, double* sum, double* sum_ms, int* count)
{
  *sum += part;
  if (*sum > 0.0)
  {
    *sum_ms += time_ms;
    ++*count;
  }
  else
  {
    *sum = *sum_ms = 0.0;
    *count = 0;
  }
}

// A coarser step for the mean of the frames that were too long.
static int coarser_step(const water_quality_state* state, double budget_ms)
{
  const double mean_ms = state->over_ms / state->over_count;
  const int most = clamp_step(state->step + coarser_most);
  int step = state->step + 1;
  while (step < most && predict(state, mean_ms, step) > budget_ms)
  {
    ++step;
  }
  return step;
}

static void count_calm(water_quality_state* state)
{
  if (++state->calm_count >= quiet_frames)
  {
    state->calm_count = 0;
    state->was_finer = false;
    state->patience -= state->patience > 0 ? 1 : 0;
  }
}

water_status water_quality_for_budget(
  water_quality_state* state, int finest_step, double budget_ms, double measured_ms)
{
  if (!isfinite(budget_ms) || budget_ms <= 0.0)
  {
    return WATER_BAD_TIME_BUDGET;
  }
  const int finest = clamp_step(finest_step);
  const int present = clamp_step(state->step);
  if (present != state->step || present < finest)
  {
    state->step = present;
    state->was_finer = false; // nothing failed
    move(state, present < finest ? finest : present, 0.0, 0);
    return WATER_OK; // the time was that of another step
  }
  if (!isfinite(measured_ms) || measured_ms <= 0.0)
  {
    return WATER_OK;
  }
  if (state->settle_count > 0)
  {
    --state->settle_count;
    return WATER_OK;
  }
  count_calm(state);
  if (state->before_ms > 0.0)
  {
    state->after_ms += measured_ms;
    if (++state->after_count == after_frames)
    {
      learn(state);
      state->before_ms = 0.0;
    }
  }
  if (state->step < WATER_QUALITY_STEPS - 1)
  {
    const double part = measured_ms / budget_ms - 1.0;
    gather(part < over_most ? part : over_most, measured_ms, &state->over, &state->over_ms,
      &state->over_count);
  }
  if (state->step > finest)
  {
    gather(under_part - predict(state, measured_ms, state->step - 1) / budget_ms, measured_ms,
      &state->under, &state->under_ms, &state->under_count);
  }
  if (state->over >= over_limit)
  {
    move(state, coarser_step(state, budget_ms), state->over_ms, state->over_count);
  }
  else if (state->under >= ldexp(under_limit, state->patience))
  {
    move(state, state->step - 1, state->under_ms, state->under_count);
  }
  return WATER_OK;
}

static bool is_seen(double area_px)
{
  return isfinite(area_px) && area_px > 0.0;
}

double water_quality_budget(double frames_per_s)
{
  return 0.5 * 1000.0 / fmax(frames_per_s, 1e-6);
}

bool water_quality_is_still(double budget_ms)
{
  return budget_ms >= 1000.0;
}

water_status water_quality_share(
  const double* areas_px, size_t count, double budget_ms, double* shares_ms)
{
  static const double even_part = 0.1;
  if (!isfinite(budget_ms) || budget_ms <= 0.0)
  {
    return WATER_BAD_TIME_BUDGET;
  }
  double largest = 0.0;
  size_t seen_count = 0;
  for (size_t i = 0; i < count; ++i)
  {
    if (is_seen(areas_px[i]))
    {
      largest = fmax(largest, areas_px[i]);
      ++seen_count;
    }
  }
  double total = 0.0; // of the areas over the largest: a sum of large ones is finite, too
  for (size_t i = 0; i < count; ++i)
  {
    total += is_seen(areas_px[i]) ? areas_px[i] / largest : 0.0;
  }
  for (size_t i = 0; i < count; ++i)
  {
    shares_ms[i] = is_seen(areas_px[i]) ? budget_ms *
        (even_part / (double)seen_count + (1.0 - even_part) * (areas_px[i] / largest / total))
                                        : 0.0;
  }
  return WATER_OK;
}

double water_quality_share_of(
  const double* areas_px, const unsigned char* is_own, size_t count, double budget_ms, double* work)
{
  for (size_t i = 0; i < count; ++i)
  {
    work[i] = 0.0;
  }
  (void)water_quality_share(areas_px, count, budget_ms, work); // none of a bad budget
  double sum = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    sum += is_own[i] ? work[i] : 0.0;
  }
  return sum > 0.0 ? sum : budget_ms;
}

void water_quality_begin(water_quality_memory* memory)
{
  memset(memory, 0, sizeof *memory);
  memory->error_step = WATER_QUALITY_NO_STEP;
}

void water_quality_choose(
  const water_quality_request* request, water_quality_memory* memory, water_quality_choice* choice)
{
  if (request->mode == WATER_QUALITY_FIXED)
  {
    const water_quality_choice fixed = { WATER_QUALITY_NO_STEP, request->texture_scale, INT_MAX,
      INT_MAX };
    *choice = fixed;
    return;
  }
  choice->step = 0;
  if (request->mode == WATER_QUALITY_TARGET_ERROR)
  {
    (void)water_quality_for_error(
      request->target_error_px, &request->roughness, &memory->error_step);
    choice->step = clamp_step(memory->error_step); // the finest while no target was accepted
  }
  else if (request->mode != WATER_QUALITY_UPDATE_RATE ||
    !water_quality_is_still(request->budget_ms))
  {
    (void)water_quality_for_budget(&memory->budget, 0, request->budget_ms, request->measured_ms);
    choice->step = memory->budget.step;
  }
  water_quality quality;
  water_quality_of_step(choice->step, &quality);
  choice->texture_scale = quality.texture_scale;
  choice->ray_steps = quality.ray_steps;
  choice->ray_probes = quality.ray_probes;
}
