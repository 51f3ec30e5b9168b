// SPDX-License-Identifier: BSD-3-Clause
// water_heights.c: do a solver's level, depth and bed have one unit, and is its level that of
// water?
#include "water_heights.h"

#include <math.h>
#include <stdbool.h>

// Of one unit in another: mm, cm and feet in metres, and the other way round.
static const double factors[] = { 1000.0, 100.0, 1.0 / 0.3048, 0.3048, 0.01, 0.001 };
static const double off_max =
  2e-3; // of a height: feet of 12 inches and those of surveys differ less
static const double share_all = 0.9; // of the places, that an explanation must hold for
static const double share_dry = 0.1; // of those whose level is their bed
static const double share_under = 0.05;
static const double tiny = 1e-3; // of the largest height: one that is no evidence of a factor
static const double balance =
  0.1;                          // of the variation of depth and bed: how much a calm level varies
static const size_t least = 10; // places, or faces that are wet
// Of the heights of a face's corners: how near to their mean a solver's own bed of a face is. A
// shore is there in a fifth of the faces that it cuts.
static const double near_mean = 0.1;
static const double most_at_bed = 0.5; // of the cut faces
static const size_t least_faces = 20;  // cut
static const double spread_of_land =
  4.0;                                // times a face's relief, from the lowest level to the highest
static const double share_off = 0.01; // of the largest depth, that level, depth and bed may be off

typedef struct range
{
  double low;
  double high;
} range;

static range range_of(const double* values, size_t count)
{
  range found = { (double)INFINITY, -(double)INFINITY };
  for (size_t i = 0; values != NULL && i < count; ++i)
  {
    if (isfinite(values[i]))
    {
      found.low = fmin(found.low, values[i]);
      found.high = fmax(found.high, values[i]);
    }
  }
  return found;
}

static double size_of(range of)
{
  return of.low > of.high ? 0.0 : fmax(fabs(of.low), fabs(of.high));
}

static bool is_times(double value, double factor, double other)
{
  return fabs(value - factor * other) <= off_max * fabs(factor * other);
}

// What a height should be, by the other two.
static double expected(
  water_height which, const double* levels, const double* depths, const double* beds, size_t i)
{
  switch (which)
  {
    case WATER_HEIGHT_LEVEL:
      return beds[i] + depths[i];
    case WATER_HEIGHT_DEPTH:
      return levels[i] - beds[i];
    default:
      return levels[i] - depths[i];
  }
}

// The share of places at which values are factor times what they should be by the other two.
static double share_of(water_height which, double factor, const double* levels,
  const double* depths, const double* beds, size_t count)
{
  const double* values = which == WATER_HEIGHT_LEVEL ? levels
    : which == WATER_HEIGHT_DEPTH                    ? depths
                                                     : beds;
  const double enough = tiny * size_of(range_of(values, count)) / fmax(factor, 1.0);
  size_t all = 0;
  size_t fits = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const double right = expected(which, levels, depths, beds, i);
    // a dry place tells nothing: its level may be anything
    const bool counts =
      depths[i] > 0.0 && isfinite(right) && isfinite(values[i]) && fabs(right) > enough;
    all += counts ? 1 : 0;
    fits += counts && is_times(values[i], factor, right) ? 1 : 0;
  }
  return all < least ? 0.0 : (double)fits / (double)all;
}

// By all three.
static water_heights_verdict judge_sum(
  const double* levels, const double* depths, const double* beds, size_t count)
{
  water_heights_verdict verdict = { WATER_HEIGHT_NONE, 0.0 };
  double best = share_all;
  for (water_height which = WATER_HEIGHT_LEVEL; which <= WATER_HEIGHT_BED; ++which)
  {
    // places that are right under any explanation, as calm water at 0 is, are evidence of none
    if (share_of(which, 1.0, levels, depths, beds, count) >= 1.0 - share_all)
    {
      continue;
    }
    for (size_t i = 0; i < sizeof factors / sizeof factors[0]; ++i)
    {
      const double share = share_of(which, factors[i], levels, depths, beds, count);
      if (share > best)
      {
        best = share;
        verdict.wrong = which;
        verdict.factor = factors[i];
      }
    }
  }
  return verdict;
}

// By the places whose level is their bed: dry land, if it is no plane.
static double dry_factor(const double* levels, const double* beds, size_t count)
{
  const double enough = 10.0 * tiny * size_of(range_of(beds, count));
  for (size_t i = 0; i < sizeof factors / sizeof factors[0]; ++i)
  {
    size_t all = 0;
    size_t fits = 0;
    range land = { (double)INFINITY, -(double)INFINITY };
    for (size_t j = 0; j < count; ++j)
    {
      if (isfinite(levels[j]) && isfinite(beds[j]))
      {
        const bool is_dry = fabs(beds[j]) > enough && is_times(levels[j], factors[i], beds[j]);
        ++all;
        fits += is_dry ? 1 : 0;
        land.low = is_dry ? fmin(land.low, beds[j]) : land.low;
        land.high = is_dry ? fmax(land.high, beds[j]) : land.high;
      }
    }
    // that many heights fit a calm level by chance if they hardly differ
    if (fits >= least && (double)fits >= share_dry * (double)all &&
      land.high - land.low > 0.05 * size_of(land))
    {
      return factors[i];
    }
  }
  return 0.0;
}

// Is a large part of the water, not only what marks dry places, far under the lowest bed?
static bool is_under_all(const double* levels, range beds, size_t count)
{
  const double limit = beds.low - 2.0 * (beds.high - beds.low);
  range under = { (double)INFINITY, -(double)INFINITY };
  size_t all = 0;
  size_t deep = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const bool is_deep = isfinite(levels[i]) && levels[i] < limit;
    all += isfinite(levels[i]) ? 1 : 0;
    deep += is_deep ? 1 : 0;
    under.low = is_deep ? fmin(under.low, levels[i]) : under.low;
    under.high = is_deep ? fmax(under.high, levels[i]) : under.high;
  }
  return deep >= least && (double)deep > share_under * (double)all &&
    under.high - under.low > 0.5 * (beds.high - beds.low) && beds.high > beds.low;
}

// The factor of a level that is far over all of a high land, and among its heights in another unit.
static double land_factor(range levels, range beds)
{
  const double relief = beds.high - beds.low;
  if (!(levels.low > beds.high + 3.0 * relief) || !(beds.low > relief) || !(relief > 0.0))
  {
    return 0.0;
  }
  for (size_t i = 0; i < sizeof factors / sizeof factors[0]; ++i)
  {
    if (levels.low / factors[i] >= beds.low && levels.high / factors[i] <= beds.high)
    {
      return factors[i];
    }
  }
  return 0.0;
}

// The factor by which depths are too large for a calm level: without it depth and bed do not
// balance, with it they do. A flat bed balances nothing.
static double balance_factor(const double* depths, const double* beds, size_t count)
{
  double mean[2] = { 0.0, 0.0 };
  double sum[3] = { 0.0, 0.0, 0.0 }; // of squares: of depths and of beds; of products
  size_t wet = 0;
  for (size_t i = 0; i < count; ++i)
  {
    if (isfinite(depths[i]) && isfinite(beds[i]) && depths[i] > 0.0)
    {
      // Welford 1962, which keeps the digits of heights far from 0
      const double off[2] = { depths[i] - mean[0], beds[i] - mean[1] };
      ++wet;
      mean[0] += off[0] / (double)wet;
      mean[1] += off[1] / (double)wet;
      sum[0] += off[0] * (depths[i] - mean[0]);
      sum[1] += off[1] * (beds[i] - mean[1]);
      sum[2] += off[0] * (beds[i] - mean[1]);
    }
  }
  for (size_t i = 0; wet >= least && i < sizeof factors / sizeof factors[0]; ++i)
  {
    const double by = 1.0 / factors[i];
    const double level = by * by * sum[0] + sum[1] + 2.0 * by * sum[2];
    if (level < balance * balance * fmin(by * by * sum[0], sum[1]))
    {
      return factors[i];
    }
  }
  return 0.0;
}

water_heights_verdict water_heights_judge(
  const double* levels, const double* depths, const double* beds, size_t count)
{
  water_heights_verdict verdict = { WATER_HEIGHT_NONE, 0.0 };
  if (beds == NULL || (levels == NULL && depths == NULL))
  {
    return verdict;
  }
  if (levels == NULL)
  {
    verdict.factor = balance_factor(depths, beds, count);
    verdict.wrong = verdict.factor > 0.0 ? WATER_HEIGHT_DEPTH : WATER_HEIGHT_NONE;
    return verdict;
  }
  if (depths != NULL)
  {
    verdict = judge_sum(levels, depths, beds, count);
    // calm water at 0 tells nothing; the dry places around it may
    const bool is_told = verdict.wrong != WATER_HEIGHT_NONE ||
      share_of(WATER_HEIGHT_LEVEL, 1.0, levels, depths, beds, count) > 0.0;
    verdict.factor = is_told ? verdict.factor : dry_factor(levels, beds, count);
    verdict.wrong = !is_told && verdict.factor > 0.0 ? WATER_HEIGHT_LEVEL : verdict.wrong;
    return verdict;
  }
  const range of_levels = range_of(levels, count);
  const range of_beds = range_of(beds, count);
  if (of_levels.low > of_levels.high || of_beds.low > of_beds.high)
  {
    return verdict;
  }
  const double by_land = dry_factor(levels, beds, count);
  verdict.factor = by_land > 0.0 ? by_land : land_factor(of_levels, of_beds);
  const bool is_wrong = verdict.factor > 0.0 || is_under_all(levels, of_beds, count);
  verdict.wrong = is_wrong ? WATER_HEIGHT_LEVEL : WATER_HEIGHT_NONE;
  return verdict;
}

bool water_heights_are_negative(double low, double high, double dry_depth)
{
  const double noise = high < 0.0 ? 0.0 : dry_depth;
  return low <= high && high <= 0.0 && low < -noise;
}

void water_heights_add_face(
  double level, const double* beds, size_t count, double dry_depth, water_heights_faces* faces)
{
  const range corners = range_of(beds, count);
  double mean = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    mean += beds[i] / (double)count; // not finite if a corner is not
  }
  if (!isfinite(mean) || !(level > corners.low) || !(level < corners.high))
  {
    return;
  }
  ++faces->cut;
  const double relief = corners.high - corners.low;
  if (fabs(level - mean) <= near_mean * relief)
  {
    faces->low = faces->at_bed == 0 ? level : fmin(faces->low, level);
    faces->high = faces->at_bed == 0 ? level : fmax(faces->high, level);
    faces->relief += relief;
    ++faces->at_bed;
    faces->wet += level > mean + dry_depth ? 1 : 0;
  }
}

bool water_heights_are_beds(const water_heights_faces* faces)
{
  return faces->cut >= least_faces && faces->wet >= least &&
    (double)faces->at_bed > most_at_bed * (double)faces->cut &&
    (faces->high - faces->low) * (double)faces->at_bed > spread_of_land * faces->relief;
}

water_heights_sum water_heights_compare(
  const double* levels, const double* depths, const double* beds, size_t count, double dry_depth)
{
  water_heights_sum sum = { 0.0, 0.0, share_off, 0 };
  for (size_t i = 0; i < count; ++i)
  {
    const double off = fabs(levels[i] - beds[i] - depths[i]);
    if (depths[i] > dry_depth && isfinite(off))
    {
      sum.off = fmax(sum.off, off);
      sum.deepest = fmax(sum.deepest, depths[i]);
    }
  }
  sum.is_wrong = sum.off > fmax(sum.share * sum.deepest, dry_depth);
  return sum;
}
