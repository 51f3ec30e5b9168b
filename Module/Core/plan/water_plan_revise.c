// SPDX-License-Identifier: BSD-3-Clause
// water_plan_revise.c: what only the last frame, or the picture so far, can decide of a plan.
#include "water_plan.h"

#include "water_frustum.h"
#include "water_math.h"
#include "water_visibility.h"

#include <string.h>

// The GPU's arithmetic, relative to the numbers that it sums.
static const double clip_rounding = 16.0 * (double)FLT_EPSILON;

// Would the mirrored view of a plan show the same things from the same place as the last one?
static bool is_same_view(const water_plan* last, const water_plan* plan)
{
  return memcmp(last->mirrored.world_to_view, plan->mirrored.world_to_view,
           sizeof last->mirrored.world_to_view) == 0 &&
    memcmp(last->mirrored.view_to_clip, plan->mirrored.view_to_clip,
      sizeof last->mirrored.view_to_clip) == 0 &&
    memcmp(last->clip_plane_view, plan->clip_plane_view, sizeof last->clip_plane_view) == 0 &&
    memcmp(last->texture_px, plan->texture_px, sizeof last->texture_px) == 0;
}

static bool is_covered(const int had[4], const int wanted[4])
{
  return had[0] <= wanted[0] && had[1] <= wanted[1] && had[0] + had[2] >= wanted[0] + wanted[2] &&
    had[1] + had[3] >= wanted[1] + wanted[3];
}

bool water_plan_wants_visibility(const water_plan* last, const water_plan* plan)
{
  return plan->decision == WATER_REFLECT && plan->has_visibility && !is_same_view(last, plan);
}

void water_plan_revise(const water_scene* scene, const water_plan* last, bool is_unchanged,
  const water_visibility* visible, water_plan* plan, water_cull_reason* reasons)
{
  const bool is_same = is_same_view(last, plan);
  // What hides the water is not part of what the reflection texture shows. A reflection texture
  // that leaves out the hidden part can therefore be used only once; that of a view that does not
  // change is complete.
  plan->has_visibility = plan->has_visibility && !is_same;
  if (plan->decision == WATER_REFLECT && (scene->settings.skips & WATER_MAY_SKIP_UNCHANGED) &&
    is_unchanged && is_same && water_plan_has_reflection(last) &&
    is_covered(last->texture_rect_px, plan->texture_rect_px) && !last->has_visibility)
  {
    plan->decision = WATER_REUSE;
  }
  if (plan->decision == WATER_REFLECT && visible)
  {
    water_visibility_cull(
      visible, &plan->mirrored, scene->props, scene->prop_count, scene->settings.skips, reasons);
  }
}

bool water_plan_cuts(const water_plan* plan, const double bounds[6])
{
  if (water_bounds_is_empty(bounds) || !water_bounds_are_finite(bounds))
  {
    return true;
  }
  double behind[4]; // the plane the other way around
  water_mat4_apply_row(plan->clip_plane_view, plan->mirrored.world_to_view, behind);
  for (int i = 0; i < 4; ++i)
  {
    behind[i] = -behind[i];
  }
  const double* view = plan->mirrored.world_to_view;
  const double eye[3] = { view[3], view[7], view[11] };
  return !water_frustum_is_behind(behind, bounds, water_vec3_length(eye), clip_rounding);
}

bool water_plan_should_wait(
  const water_plan* last, double visible_px, bool is_software, unsigned skips)
{
  if (!is_software || visible_px < 0.0)
  {
    return !is_software;
  }
  return ((skips & WATER_MAY_SKIP_HIDDEN) && visible_px <= 0.0) ||
    ((skips & WATER_MAY_SKIP_PIXELS) && water_plan_has_reflection(last) &&
      visible_px < last->visible_px_max);
}
