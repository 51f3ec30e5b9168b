// SPDX-License-Identifier: BSD-3-Clause
// water_plan_text.c: decisions and reasons in words.
#include "water_plan.h"

const char* water_cull_reason_text(water_cull_reason reason)
{
  static const char* const texts[] = {
#define WATER_CULL_REASON_TEXT(name, text) text,
    WATER_CULL_REASON_LIST(WATER_CULL_REASON_TEXT)
#undef WATER_CULL_REASON_TEXT
  };
  const size_t number = (size_t)reason; // a negative value becomes a large one
  return number < WATER_CULL_REASON_COUNT ? texts[number] : "unknown reason";
}

const char* water_decision_text(water_decision decision)
{
  static const char* const texts[] = {
#define WATER_DECISION_TEXT(name, text) text,
    WATER_DECISION_LIST(WATER_DECISION_TEXT)
#undef WATER_DECISION_TEXT
  };
  const size_t number = (size_t)decision;
  return number < WATER_DECISION_COUNT ? texts[number] : "unknown decision";
}
