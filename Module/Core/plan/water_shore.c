// SPDX-License-Identifier: BSD-3-Clause
// water_shore.c: where a solver's water is, and where it ends.
#include "water_shore.h"

#include "water_math.h"

#include <float.h>
#include <math.h>

static const double roundings = 4.0; // of a level, in floats
static const double around = 4.0;    // neighbours from one side of a place to the other
static const double far_off = 1.0;   // depth, of any sign, where nothing else is known

static inline bool is_beyond(double height)
{
  return fabs(height) > water_shore_highest; // not of NaN
}

double water_shore_known(double height)
{
  return is_beyond(height) ? (double)NAN : height;
}

static inline double given_of(double height)
{
  return isnan(height) ? (double)INFINITY : height;
}

double water_shore_given(double height)
{
  return given_of(height);
}

static inline water_column column_of(double level, double bed, double depth, double dry_depth)
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
  column.is_wet = fabs(column.level) <= water_shore_highest && column.depth > dry_depth &&
    !(has_depth && is_beyond(depth)) && !(has_bed && is_beyond(bed));
  return column;
}

water_column water_shore_column(double level, double bed, double depth, double dry_depth)
{
  return column_of(level, bed, depth, dry_depth);
}

static inline double depth_of(bool is_wet, double level, double bed)
{
  const double depth = level - bed;
  if (isnan(depth) || is_beyond(depth))
  {
    return is_wet ? far_off : -far_off;
  }
  return is_wet ? depth : -fabs(depth);
}

double water_shore_depth(bool is_wet, double level, double bed)
{
  return depth_of(is_wet, level, bed);
}

// Mean of the finite ones; NaN without any.
static double mean_of(const double* heights, size_t count)
{
  double sum = 0.0;
  size_t known = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const bool counts = isfinite(heights[i]);
    sum += counts ? heights[i] : 0.0;
    known += counts ? 1 : 0;
  }
  return known > 0 ? sum / (double)known : (double)NAN;
}

bool water_shore_is_dyke(
  double bed, const double* levels, const double* beds, size_t count, double dry_depth)
{
  // beds of corners are means over the cells around them: on a rounded bank they lie lower
  const double own = isfinite(bed) ? bed : mean_of(beds, count);
  return !(own + dry_depth >= mean_of(levels, count)); // also where one is not known
}

bool water_shore_are_apart(double level, double other, double dry_depth)
{
  const double rounding = roundings * (double)FLT_EPSILON * fmax(fabs(level), fabs(other));
  return fabs(level - other) > fmax(dry_depth, rounding);
}

bool water_shore_are_of_lakes(double level, double other, double dry_depth)
{
  return water_shore_are_apart(level, other, around * dry_depth);
}

bool water_shore_are_lakes(size_t level, size_t uneven)
{
  return uneven == 0 || level > 2 * uneven;
}

double water_shore_before_divide(double depth, double level, double bed)
{
  return depth / (depth - depth_of(false, level, bed));
}

double water_shore_level(double level, double bed)
{
  return isfinite(level) ? level : (fabs(bed) <= water_shore_highest ? bed : 0.0);
}

WATER_WIDE static bool find_columns(const water_shore_rows* rows, size_t count, double dry_depth)
{
  size_t odd = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const water_column column =
      column_of(rows->given_levels ? given_of(rows->given_levels[i]) : (double)NAN,
        rows->given_beds ? given_of(rows->given_beds[i]) : (double)NAN,
        rows->given_depths ? given_of(rows->given_depths[i]) : (double)NAN, dry_depth);
    const double level = column.is_wet ? column.level : (double)NAN;
    const double depth = depth_of(column.is_wet, level, column.bed);
    rows->are_wet[i] = column.is_wet;
    rows->beds[i] = column.bed;
    rows->levels[i] = water_shore_level(level, column.bed);
    rows->depths[i] = depth;
    odd += column.is_wet && !(depth > 0.0) ? 1 : 0;
  }
  return odd > 0;
}

bool water_shore_columns(const water_shore_rows* rows, size_t count, double dry_depth)
{
  return find_columns(rows, count, dry_depth);
}

// Adds a corner, unless it is the one before it.
static size_t add_corner(
  size_t from, size_t to, double share, water_shore_corner* corners, size_t count)
{
  const water_shore_corner made = { from, to, share };
  if (count > 0 && from == to && corners[count - 1].from == from && corners[count - 1].to == to)
  {
    return count;
  }
  corners[count] = made;
  return count + 1;
}

size_t water_shore_cut(const double* depths, size_t count, water_shore_corner* corners)
{
  size_t made = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const size_t next = (i + 1) % count;
    const bool is_wet = depths[i] > 0.0;
    if (is_wet)
    {
      made = add_corner(i, i, 0.0, corners, made);
    }
    if (is_wet == (depths[next] > 0.0))
    {
      continue;
    }
    const size_t wet = is_wet ? i : next;
    const size_t dry = is_wet ? next : i;
    const double share = depths[wet] / (depths[wet] - depths[dry]);
    // the shore at a corner is that corner, whatever edge leads there
    made = share < 1.0 ? add_corner(wet, dry, share, corners, made)
                       : add_corner(dry, dry, 0.0, corners, made);
  }
  const bool is_closed = made > 1 && corners[0].from == corners[0].to &&
    corners[made - 1].from == corners[0].from && corners[made - 1].to == corners[0].to;
  made -= is_closed ? 1 : 0;
  return made < 3 ? 0 : made;
}

void water_shore_point(const double from[3], const double to[3], double share, double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] = from[i] + share * (to[i] - from[i]);
  }
}

void water_shore_triangle(size_t number, size_t corners[3])
{
  corners[0] = 0;
  corners[1] = number + 1;
  corners[2] = number + 2;
}

bool water_shore_is_split(const double* depths, size_t count)
{
  size_t changes = 0;
  for (size_t i = 0; i < count; ++i)
  {
    changes += (depths[i] > 0.0) != (depths[(i + 1) % count] > 0.0) ? 1 : 0;
  }
  return changes > 2;
}
