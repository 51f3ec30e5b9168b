// SPDX-License-Identifier: BSD-3-Clause
// water_foam_measure.c: what data say of foam.
#include "water_foam_measure.h"

#include "water_math.h"

static const double most = 1e15; // a float's squares stay finite
static const double rounding = 1e-6;

const char* water_foam_measure_text(water_foam_measure measure)
{
  static const char* const texts[] = {
#define WATER_FOAM_MEASURE_TEXT(name, first, last, text) text,
    WATER_FOAM_MEASURE_LIST(WATER_FOAM_MEASURE_TEXT)
#undef WATER_FOAM_MEASURE_TEXT
  };
  const size_t number = (size_t)measure; // a negative value becomes a large one
  return number < WATER_FOAM_MEASURE_COUNT ? texts[number] : "unknown measure";
}

water_foam_measure water_foam_measure_of(const char* text)
{
  for (int i = 0; text && i < WATER_FOAM_MEASURE_COUNT; ++i)
  {
    if (strcmp(text, water_foam_measure_text((water_foam_measure)i)) == 0)
    {
      return (water_foam_measure)i;
    }
  }
  return WATER_FOAM_MEASURE_COUNT;
}

void water_foam_measure_ends(water_foam_measure measure, double ends[2])
{
  static const double all[][2] = {
#define WATER_FOAM_MEASURE_ENDS(name, first, last, text) { first, last },
    WATER_FOAM_MEASURE_LIST(WATER_FOAM_MEASURE_ENDS)
#undef WATER_FOAM_MEASURE_ENDS
  };
  const size_t number = (size_t)measure;
  memcpy(ends, all[number < WATER_FOAM_MEASURE_COUNT ? number : 0], sizeof all[0]);
}

double water_foam_measure_value(water_foam_measure measure, double value)
{
  if (!isfinite(value) || value < 0.0)
  {
    return 0.0;
  }
  return measure == WATER_FOAM_COVER && value > 1.0 + rounding ? 1.0 : fmin(value, most);
}
