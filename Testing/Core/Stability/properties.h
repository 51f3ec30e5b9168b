// SPDX-License-Identifier: BSD-3-Clause
// properties.h: what must hold in every case. Each function keeps its errors in the record.
//
// Bounds are in roundings u = 2^-53 and are those that the headers of the core state; the steps
// that lead to them are at the functions. First order: terms of u^2 are left out, which the round
// numbers cover.
#ifndef properties_h
#define properties_h

#include "cases.h"
#include "record.h"
#include "water_plan.h"

static const double stress_u = 1.1102230246251565e-16; // 2^-53

void stress_plane(const stress_case* of, stress_record* record);
void stress_optics(stress_case* of, stress_record* record);

// May the eye not be told from the plane? It is taken to be over it then (water_select_level).
bool stress_is_on_plane(const stress_case* of);

// The plan is made, or is refused as *status says.
void stress_decision(
  const stress_case* of, const water_plan* plan, water_status status, stress_record* record);

// The plan reflects.
void stress_picture(stress_case* of, const water_plan* plan, stress_record* record);
void stress_clip(stress_case* of, const water_plan* plan, stress_record* record);
void stress_props(
  stress_case* of, const water_plan* plan, const water_cull_reason* reasons, stress_record* record);

#endif
