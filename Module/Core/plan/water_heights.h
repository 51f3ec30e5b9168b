// SPDX-License-Identifier: BSD-3-Clause
// water_heights.h: do a solver's level, depth and bed have one unit, and is its level that of
// water?
//
// With all three, a wrong unit breaks level = bed + depth, at wet places and, where solvers write
// the bed as the level, at dry ones. With depth and bed alone, a unit is wrong if their sum is a
// calm level only after a conversion to another unit. Without a depth, it is wrong if no water can
// have the level: far below the lowest bed, or above the whole land although it would lie among the
// land's heights in another unit. Deep seas, flat tanks, dry basins and high waves are not
// reported. Nothing is reported if there is more than one explanation.
#ifndef water_heights_h
#define water_heights_h

#include <stdbool.h>
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

// Finds a wrong unit among heights of the same places. Values that are not finite are ignored.
//
// levels, depths, beds  count numbers each; NULL: not given. Without two of them nothing is wrong.
water_heights_verdict water_heights_judge(
  const double* levels, const double* depths, const double* beds, size_t count);

// Have depths the wrong sign? None is above 0, and some are below, by more than the noise of a dry
// step if others are 0.
//
// low, high  the range of the finite ones; low > high: there are none
bool water_heights_are_negative(double low, double high, double dry_depth);

// Faces with one level each, and with beds at their corners: of those that the shore cuts, how many
// have their own bed as the level, as solvers write it where a face is dry? Such a level is land,
// which looks like a puddle if the bed is known at the corners only. Begins as 0.
typedef struct water_heights_faces
{
  size_t cut;    // the level is between the lowest and the highest corner
  size_t at_bed; // of these, it is near the mean of the corners
  size_t wet;    // of these, it is over the mean by more than the dry depth
  double relief; // sum of highest less lowest corner of these
  double low;    // of the levels of these
  double high;
} water_heights_faces;

// Adds a face. Nothing is added if the level or a corner is not finite.
void water_heights_add_face(
  double level, const double* beds, size_t count, double dry_depth, water_heights_faces* faces);

// Is the level of most of the cut faces their bed, and are some of them wet? The shore of water
// cuts faces at any height, and at one level: neither is so on land.
bool water_heights_are_beds(const water_heights_faces* faces);

// How far level, depth and bed contradict each other in wet places.
typedef struct water_heights_sum
{
  double off;     // the largest difference of level - bed and depth
  double deepest; // the largest depth
  double share;   // of the deepest that may be off
  int is_wrong;   // is off more than that, and than the dry depth?
} water_heights_sum;

// Compares level - bed with depth where the depth exceeds dry_depth. Values that are not finite are
// ignored.
water_heights_sum water_heights_compare(
  const double* levels, const double* depths, const double* beds, size_t count, double dry_depth);

#ifdef __cplusplus
}
#endif
#endif
