// SPDX-License-Identifier: BSD-3-Clause
// water_units.c: what a metre is in a scene.
#include "water_units.h"

#include <math.h>
#include <string.h>

static const double softest = 0.1;   // of the depth of the bed
static const double smallest = 1e-9; // metres of a unit
static const double largest = 1e9;
static const double waves_across = 400.0;
static const double most_dim = 16.0;
static const double least_dim = 1.0 / 64.0;
static const double in_a_tank = 1.0 / 6.0; // of the natural depth
static const double in_the_open = 1.0 / 3.0;

typedef struct named_unit
{
  const char* name;
  double metres;
} named_unit;

static const named_unit units[] = {
#define WATER_UNIT_ENTRY(name, metres) { name, metres },
  WATER_UNIT_LIST(WATER_UNIT_ENTRY)
#undef WATER_UNIT_ENTRY
};

const char* water_units_name(size_t i)
{
  return i < sizeof units / sizeof units[0] ? units[i].name : NULL;
}

water_status water_units_find(const char* name, double* metres)
{
  for (size_t i = 0; name != NULL && i < sizeof units / sizeof units[0]; ++i)
  {
    if (strcmp(name, units[i].name) == 0)
    {
      *metres = units[i].metres;
      return WATER_OK;
    }
  }
  return WATER_BAD_UNITS;
}

double water_units_fit(double diagonal, const double natural_m[2])
{
  if (!(diagonal > 0.0) || !isfinite(diagonal))
  {
    return 1.0;
  }
  int exponent = 0;
  (void)frexp(diagonal, &exponent);
  const double size = ldexp(1.0, exponent);
  const double metres = fmin(fmax(size, natural_m[0]), natural_m[1]) / size;
  return fmin(fmax(metres, smallest), largest);
}

void water_units_dim(const double extinction[3], double bed_depth, double diagonal,
  double natural_depth, water_units_bed bed, double dimmed[3])
{
  double times = 1.0;
  if (bed_depth > 0.0 && natural_depth > 0.0)
  {
    const double flatness = fmin(fmax(2.0 - 10.0 * bed_depth / diagonal, 0.0), 1.0);
    const double parts[] = { 1.0 + 3.0 * flatness, in_a_tank, in_the_open };
    times = parts[bed] * natural_depth / bed_depth;
    times = fmin(fmax(times, least_dim), most_dim);
  }
  for (int i = 0; i < 3; ++i)
  {
    dimmed[i] = times * extinction[i];
  }
}

double water_units_show_foam(double depth, double diagonal)
{
  return diagonal > 0.0 && isfinite(diagonal) ? fmax(depth, diagonal / waves_across) : depth;
}

double water_units_soften(double depth, double bed_depth)
{
  return bed_depth > 0.0 ? fmin(depth, softest * bed_depth) : depth;
}

bool water_units_show_waves(double wavelength, double diagonal)
{
  return !(wavelength * waves_across < diagonal);
}
