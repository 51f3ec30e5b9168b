// SPDX-License-Identifier: BSD-3-Clause
// water_shore.c: where a solver's water is, and where it ends.
#include "water_shore.h"

#include <math.h>

static const double far_off = 1.0; // depth, of any sign, where nothing else is known

water_column water_shore_column(double level, double bed, double depth, double dry_depth)
{
  const bool has_depth = !isnan(depth);
  const bool has_bed = !isnan(bed);
  water_column column = { level, has_bed ? bed : -(double)INFINITY,
    has_depth ? depth : (double)INFINITY, false };
  if (isnan(level))
  {
    column.level = bed + depth;
  }
  if (!has_bed && has_depth)
  {
    column.bed = column.level - depth;
  }
  if (!has_depth && has_bed)
  {
    column.depth = column.level - bed;
  }
  column.is_wet = isfinite(column.level) && column.depth > dry_depth;
  return column;
}

double water_shore_depth(bool is_wet, double level, double bed)
{
  const double depth = level - bed;
  if (isnan(depth) || isinf(depth))
  {
    return is_wet ? far_off : -far_off;
  }
  return is_wet ? depth : -fabs(depth);
}
