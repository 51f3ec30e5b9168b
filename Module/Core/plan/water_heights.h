// SPDX-License-Identifier: BSD-3-Clause
// water_heights.h: do a solver's level, depth and bed have one unit?
//
// level = bed + depth tells a wrong one, at wet places and, where solvers write the bed as the
// level, at dry ones. Depth and bed alone tell it if their sum is a calm level in one unit, and not
// in the unit that they have. Without a depth, only a level that no water has: far under the lowest
// bed, or over a land whose heights it lies among in another unit. Deep seas, flat tanks, dry
// basins and high waves are none of these. What fits more than one explanation is no mistake.
#ifndef water_heights_h
#define water_heights_h

#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The height that is in another unit than the others.
typedef enum water_height
{
  WATER_HEIGHT_NONE,
  WATER_HEIGHT_LEVEL,
  WATER_HEIGHT_DEPTH,
  WATER_HEIGHT_BED
} water_height;

typedef struct water_heights_verdict
{
  water_height wrong;
  double factor; // it is this many times too large; 0: not known
} water_heights_verdict;

// What is wrong with heights of the same places. Values that are not finite are ignored.
//
// levels, depths, beds  count numbers each; NULL: not given. Without two of them nothing is wrong.
water_heights_verdict water_heights_judge(
  const double* levels, const double* depths, const double* beds, size_t count);

#ifdef __cplusplus
}
#endif
#endif
