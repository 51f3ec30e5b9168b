// SPDX-License-Identifier: BSD-3-Clause
// water_plan.h: the interface of the core: scene in, plan out.
#ifndef water_plan_h
#define water_plan_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

struct water_visibility;

// Plans one frame. Pure: same scene, same plan.
//
// reasons  prop_count entries, written only when the plan reflects; NULL if prop_count is 0
//
// Returns WATER_OK, or the first of the statuses in water_status.h that applies, in their order;
// then plan->decision is WATER_NO_REFLECT_FAILED and the reasons are unchanged. Exception: with
// WATER_BAD_PROP_BOUNDS the plan is made, and such a prop is drawn, because it may be anywhere.
water_status water_plan_make(
  const water_scene* scene, water_plan* plan, water_cull_reason* reasons);

// Is it worthwhile to determine, before the plan is revised, which parts of the reflection texture
// visible water looks up?
//
// last  the plan that the reflection texture was drawn by; all 0: there is none
bool water_plan_wants_visibility(const water_plan* last, const water_plan* plan);

// Revises a plan by what is known once it is made; nothing changes it afterwards. A plan that
// reflects uses the last reflection texture again (WATER_REUSE) if that shows the same. In an
// unchanged view no mask is used, so that the reflection texture can be used again. Props that no
// visible water shows are culled.
//
// scene         of the plan
// last          as above
// is_unchanged  everything that a plan does not know is unchanged, too: what the drawn props look
//               like, the lights, the background
// visible       NULL: any part may be looked up
// reasons       of the plan
void water_plan_revise(const water_scene* scene, const water_plan* last, bool is_unchanged,
  const struct water_visibility* visible, water_plan* plan, water_cull_reason* reasons);

// May the clip at the water cut an object in this box? No, if the box is on the kept side by more
// than the error of single precision. True for numbers that are not finite, and for an empty box
// (min > max).
bool water_plan_cuts(const water_plan* plan, const double bounds[6]);

// Is it worthwhile to draw the next reflection texture only after the eye's picture? That picture
// shows whether the water is hidden and, in software, which cells of the reflection texture it
// looks up. A GPU draws that picture at the same time: there it is always worthwhile.
//
// last         the plan of the last reflection texture
// visible_px   pixels of the water that were seen in the frame before; < 0: not known
// is_software  of the scene
// skips        of the scene
bool water_plan_should_wait(
  const water_plan* last, double visible_px, bool is_software, unsigned skips);

// Is the water wholly invisible? False for an eye in the water.
bool water_decision_is_unseen(water_decision decision);

// Is there a reflection texture to look up, drawn or used again?
bool water_plan_has_reflection(const water_plan* plan);

// Short English text of a reason or a decision, never NULL; static storage.
const char* water_cull_reason_text(water_cull_reason reason);
const char* water_decision_text(water_decision decision);

#ifdef __cplusplus
}
#endif
#endif
