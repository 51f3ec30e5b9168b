// SPDX-License-Identifier: BSD-3-Clause
// water_status.c: the text of each status, from the list in water_status.h.
#include "water_status.h"

#include <stddef.h>

const char* water_status_text(water_status status)
{
  static const char* const texts[] = {
#define WATER_STATUS_TEXT(name, text) text,
    WATER_STATUS_LIST(WATER_STATUS_TEXT)
#undef WATER_STATUS_TEXT
  };
  const size_t number = (size_t)status; // a negative value becomes a large one
  return number < WATER_STATUS_COUNT ? texts[number] : "unknown status";
}
