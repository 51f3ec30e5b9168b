// SPDX-License-Identifier: BSD-3-Clause
// water_quality.h: the resolution of a reflection for a target error in pixels, or for a time
// budget.
//
// A ladder of steps, 0 the finest, leads from the full resolution to a sixteenth of the texels. A
// target error selects a step by a model of the lookup's error; a time budget moves along the
// ladder by measured times. Both have hysteresis, so that the picture does not oscillate between
// two steps. Equal inputs give equal outputs; the caller owns all memory. Errors are pixels of the
// picture (not of the reflection texture), times are milliseconds, of one water's reflection: its
// mirrored view and its lookups. Source of all constants: measured,
// Documentation/decisions/010-quality.md.
#ifndef water_quality_h
#define water_quality_h

#include "water_status.h"
#include "water_types.h"

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_QUALITY_STEPS 8      // of the ladder, 0 to 7
#define WATER_QUALITY_NO_STEP (-1) // nothing was chosen yet

// The settings of a step of the ladder. Multisampling is not included: a coarse reflection texture
// needs it most.
typedef struct water_quality
{
  double texture_scale; // texels per pixel along each axis, 1 to 0.25; about 2^(-1/4) a step
  int ray_steps;        // of the march (RayTraceSteps), 24 to 8
  int ray_probes;       // RayTraceProbes, 12 to 3
} water_quality;

// A step of the ladder; a number beyond its ends selects the end.
void water_quality_of_step(int step, water_quality* quality);

// How rough the water looks: all of it finite and >= 0.
typedef struct water_roughness
{
  double slope_rms;         // of all its waves together
  double turn_rad;          // by how much a typical wave turns over a typical pixel of the water:
                            // hypot(k . across, k . down), k in rad/m, the pixel's sides in m
  double pixels_per_radian; // of the picture at its middle, 0.5 height_px view_to_clip[5]; 0 for a
                            // parallel eye
} water_roughness;

// Roughness of the water where its waves are most visible: the error must stay within its target
// there, too.
//
// plan         of the scene, or of the one before it; with a view
// wave_number  typical of the waves, rad/m; 0: not known, all of them are resolved
void water_quality_roughness(
  const water_scene* scene, const water_plan* plan, double wave_number, water_roughness* roughness);

// Median distance, in pixels, between the place that a reflected ray reads and its correct place.
//
// The place is known to a texel: half of the points of a square of side 1 / scale are within 0.4 /
// scale of its middle. Waves turn the ray by up to twice their slope. A share of the rays, which
// grows with the square of the slope, misses its target, and the steps of the march become longer
// with the turn of the ray in the picture.
//
//   sharp = 0.4 / scale (1 + 1.8 seen^2) + 2 seen pixels_per_radian / (280 ray_steps)
//
// seen = slope_rms exp(-turn_rad^2 / 24) is what a pixel resolves of the slopes. The rest of them,
// hidden = sqrt(slope_rms^2 - seen^2), blurs the reflection over blur = 2 hidden pixels_per_radian
// (rms). The blur hides a part of the error (variances add):
//
//   error_px = sqrt(blur^2 + sharp^2) - blur
//
// Grows with the step, falls with the turn, and without a turn grows with the slope.
//
// step  beyond the ends of the ladder it counts as the end
//
// Returns WATER_OK or WATER_BAD_ROUGHNESS; then *error_px is unchanged.
water_status water_quality_error(int step, const water_roughness* roughness, double* error_px);

// The coarsest step whose error (water_quality_error) is within a target, or the finest step if
// there is none. A step in use is kept until its error exceeds the target, or that of a coarser
// step is below 0.9 of it.
//
// target_px  finite, > 0
// step       in: the one in use, or WATER_QUALITY_NO_STEP; out: the one to use
//
// Returns WATER_OK, WATER_BAD_TARGET_ERROR or WATER_BAD_ROUGHNESS. On an error, *step is unchanged.
water_status water_quality_for_error(double target_px, const water_roughness* roughness, int* step);

// State of a time budget from frame to frame. Begin with zeros and any step; the caller may read
// and set only the step.
typedef struct water_quality_state
{
  int step;           // to draw the next frame with
  int settle_count;   // frames whose times are not believed yet
  double over;        // budgets by which frames were too long, less those by which they were not
  double over_ms;     // sum of the times since that was 0
  int over_count;     // and their number
  double under;       // the same for a finer step that would be short enough
  double under_ms;    // sum
  int under_count;    // number
  double fixed_share; // of the finest step's time: what does not depend on the scale
  int patience;       // finer steps are tried 2^patience times as late, 0 to 6
  int calm_count;     // frames since the last change
  bool was_finer;     // the last change was to a finer step
  int before_step;    // of the last change
  double before_ms;   // mean before the last change; 0: not known
  double after_ms;    // sum after it
  int after_count;    // number
} water_quality_state;

// The step for the next frame, from the time of the last one.
//
// The step becomes coarser, by one or two, when the excess over the budget adds up to 3 budgets (at
// most one per frame): after 3 frames of twice the budget, or 30 frames of 1.1 times the budget. It
// becomes finer, by one, when the amounts by which the time predicted for the finer step is below
// 0.8 of the budget add up to 8 budgets: after 10 frames that cost nothing, or 80 frames of 0.7
// times the budget. A time between 0.8 and 1 of the budget, with noise, therefore changes nothing.
// The 3 frames after a change are ignored, because they create textures, and GPU timers report
// late. A finer step that had to be undone within 1000 frames is then tried half as often, down to
// a 64th; 1000 frames without a change cancel one such failure.
//
// The model is time = a + b scale^2. Its fixed share a / (a + b) starts at 0, which predicts the
// longest time for a finer step. After each change of step it is computed from two means: of at
// least 16 frames before the change, and of 32 frames after it. The share in use then becomes the
// mean of its old value and this one.
//
// finest_step  no finer one than this, e.g. that of a target error; beyond the ends of the ladder
//              it counts as the end
// budget_ms    finite, > 0
// measured_ms  of the frame that was drawn with state->step; not finite or <= 0: not known, and
//              nothing is learned of it
//
// Returns WATER_OK or WATER_BAD_TIME_BUDGET. On an error, the state is unchanged.
water_status water_quality_for_budget(
  water_quality_state* state, int finest_step, double budget_ms, double measured_ms);

// The budget of all waters, ms, for a rate of frames: half of the time of a frame.
//
// frames_per_s  finite; 1e-6 and less counts as that
double water_quality_budget(double frames_per_s);

// Is a budget that of a still picture? It is then a second or more (VTK's windows set hours). Such
// a picture gets the finest step at once, because no other frame may follow.
bool water_quality_is_still(double budget_ms);

// What a frame is asked for.
typedef struct water_quality_request
{
  water_quality_mode mode;
  double texture_scale;   // of WATER_QUALITY_FIXED
  double target_error_px; // of WATER_QUALITY_TARGET_ERROR
  double budget_ms;       // of the other two
  water_roughness roughness;
  double measured_ms; // of the last frame; not finite or <= 0: not known
} water_quality_request;

// What is remembered from frame to frame; water_quality_begin makes the first.
typedef struct water_quality_memory
{
  water_quality_state budget;
  int error_step;
} water_quality_memory;

typedef struct water_quality_choice
{
  int step; // of the ladder; WATER_QUALITY_NO_STEP: the quality is fixed
  double texture_scale;
  int ray_steps; // at most; INT_MAX when the quality is fixed
  int ray_probes;
} water_quality_choice;

void water_quality_begin(water_quality_memory* memory);

// Chooses the texture's scale and the most steps of rays for a frame. With an invalid target,
// budget or roughness the step does not change; the first step is the finest.
void water_quality_choose(
  const water_quality_request* request, water_quality_memory* memory, water_quality_choice* choice);

// The effort for rays on waves.
typedef struct water_ray_quality
{
  int steps;           // of the march
  int probes;          // between the water and where a ray converged
  int rays;            // of a pixel at an edge
  int layers;          // of the mirrored view that rays see
  double footprint_px; // of the pixel that slopes are means over
} water_ray_quality;

// That of a name: fast, default, high, reference.
//
// Returns WATER_OK or WATER_BAD_QUALITY_NAME. On an error, the quality is unchanged.
// Source: measured, Documentation/decisions/006-lookup.md.
water_status water_quality_of_name(const char* name, water_ray_quality* quality);

// Does a pixel reflect what all of its slopes see, and not only what some facets see? So many rays
// mean that accuracy counts for more than time.
bool water_rays_take_all_slopes(int rays);

// Shift of frame number i of an average, in pixels, each component in [-0.5, 0.5). Any number of
// frames is distributed evenly, and the first is not shifted. Source: Roberts 2018, "The
// Unreasonable Effectiveness of Quasirandom Sequences" (R2).
void water_quality_jitter(unsigned i, double place_px[2]);

// Distributes a budget over many waters: a tenth of it evenly among the visible ones, so that each
// gets some, and the rest by their visible areas.
//
// areas_px   count of them; a water without a finite area over 0 is not seen and gets 0
// budget_ms  finite, > 0
// shares_ms  count of them; their sum is the budget, or 0 if no water is seen
//
// Returns WATER_OK or WATER_BAD_TIME_BUDGET. On an error, the shares are unchanged.
water_status water_quality_share(
  const double* areas_px, size_t count, double budget_ms, double* shares_ms);

// The sum of the shares of some of these waters, ms; the whole budget while none of them is known
// to be visible.
//
// is_own  count of them: which
// work    room for count
double water_quality_share_of(const double* areas_px, const unsigned char* is_own, size_t count,
  double budget_ms, double* work);

#ifdef __cplusplus
}
#endif
#endif
