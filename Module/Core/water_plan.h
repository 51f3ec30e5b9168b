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

// Plans one frame. Pure: same scene, same plan.
//
// fates  prop_count entries, written only when the plan reflects; NULL if prop_count is 0
//
// Returns WATER_OK, or the first of the statuses in water_status.h that applies, in their order;
// then plan->decision is WATER_NO_REFLECT_FAILED and the fates are untouched.
water_status water_plan_make(const water_scene* scene, water_plan* plan, water_fate* fates);

// Short English text of a fate or a decision, never NULL; static storage.
const char* water_fate_text(water_fate fate);
const char* water_decision_text(water_decision decision);

#ifdef __cplusplus
}
#endif
#endif
