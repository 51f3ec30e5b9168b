// SPDX-License-Identifier: BSD-3-Clause
#include "water_fit_rows.h"

#include "water_math.h"

#include <math.h>

#define LANES WATER_FIT_LANES

typedef struct lanes
{
  double area[LANES];
  double first[3][LANES];
  double second[6][LANES];
  double low[3][LANES]; // of corners
  double high[3][LANES];
} lanes;

static void lanes_begin(const double bounds[6], lanes* sums)
{
  memset(sums, 0, sizeof *sums);
  for (int lane = 0; lane < LANES; ++lane)
  {
    for (int i = 0; i < 3; ++i)
    {
      sums->low[i][lane] = bounds[2 * i];
      sums->high[i][lane] = bounds[2 * i + 1];
    }
  }
}

// Adds the part of a quad's integrals that the middle of a side stands for: first twice, and second
// four times as much, which the sums of all quads are divided by.
WATER_WIDE_PART static inline void add_side(
  double weight, const double* a, const double* b, water_fit_integrals* quad)
{
  const double x = a[0] + b[0];
  const double y = a[1] + b[1];
  const double z = a[2] + b[2];
  const double wx = weight * x;
  const double wy = weight * y;
  const double wz = weight * z;
  quad->first[0] += wx;
  quad->first[1] += wy;
  quad->first[2] += wz;
  quad->second[0] += wx * x;
  quad->second[1] += wx * y;
  quad->second[2] += wy * y;
  quad->second[3] += wx * z;
  quad->second[4] += wy * z;
  quad->second[5] += wz * z;
}

// The corners of that many quads: [corner][axis][lane].
typedef double lane_places[4][3][LANES];

WATER_WIDE_PART static inline void read_quads(
  const double* points, const int64_t* corners, lane_places place)
{
  for (int lane = 0; lane < LANES; ++lane)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double* point = points + 3 * corners[4 * lane + k];
      place[k][0][lane] = point[0];
      place[k][1][lane] = point[1];
      place[k][2][lane] = point[2];
    }
  }
}

// Adds their bounds, unless a coordinate is not usable. Returns whether it did.
WATER_WIDE_PART static inline bool add_bounds(lane_places place, lanes* restrict sums)
{
  double wrong[LANES];
  double low[3][LANES];
  double high[3][LANES];
  for (int lane = 0; lane < LANES; ++lane)
  {
    double count = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      double least = sums->low[i][lane];
      double most = sums->high[i][lane];
      for (int k = 0; k < 4; ++k)
      {
        const double value = place[k][i][lane];
        least = value < least ? value : least;
        most = value > most ? value : most;
        count += fabs(value) <= water_largest ? 0.0 : 1.0; // NaN neither
      }
      low[i][lane] = least;
      high[i][lane] = most;
    }
    wrong[lane] = count;
  }
  double all = 0.0;
  for (int lane = 0; lane < LANES; ++lane)
  {
    all += wrong[lane];
  }
  if (all > 0.0)
  {
    return false;
  }
  memcpy(sums->low, low, sizeof low);
  memcpy(sums->high, high, sizeof high);
  return true;
}

// Adds that many quads, of an upright fit. A quad is two triangles with the side from its first to
// its third corner in common. The integral of a quadratic function over a triangle is a third of
// the area times the sum over the middles of its sides.
WATER_WIDE_PART static inline void add_quads(
  lane_places place, const double origin[3], lanes* restrict sums)
{
  for (int lane = 0; lane < LANES; ++lane)
  {
    double at[4][3];
    for (int k = 0; k < 4; ++k)
    {
      for (int i = 0; i < 3; ++i)
      {
        at[k][i] = place[k][i][lane] - origin[i];
      }
    }
    const double across[2] = { at[2][0] - at[0][0], at[2][1] - at[0][1] };
    const double one =
      0.5 * ((at[1][0] - at[0][0]) * across[1] - (at[1][1] - at[0][1]) * across[0]);
    const double other =
      0.5 * (across[0] * (at[3][1] - at[0][1]) - across[1] * (at[3][0] - at[0][0]));
    const double third = one + other < 0.0 ? -1.0 / 3.0 : 1.0 / 3.0;
    water_fit_integrals quad = { 0.0, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
    add_side(third * one, at[0], at[1], &quad);
    add_side(third * one, at[1], at[2], &quad);
    add_side(third * other, at[2], at[3], &quad);
    add_side(third * other, at[3], at[0], &quad);
    add_side(third * (one + other), at[0], at[2], &quad);
    sums->area[lane] += fabs(one + other);
    for (int i = 0; i < 3; ++i)
    {
      sums->first[i][lane] += quad.first[i];
    }
    for (int i = 0; i < 6; ++i)
    {
      sums->second[i][lane] += quad.second[i];
    }
  }
}

static void add_lanes(const lanes* sums, water_fit_integrals* sum, double bounds[6])
{
  for (int lane = 0; lane < LANES; ++lane)
  {
    sum->area += sums->area[lane];
    for (int i = 0; i < 3; ++i)
    {
      sum->first[i] += 0.5 * sums->first[i][lane];
      bounds[2 * i] = fmin(bounds[2 * i], sums->low[i][lane]);
      bounds[2 * i + 1] = fmax(bounds[2 * i + 1], sums->high[i][lane]);
    }
    for (int i = 0; i < 6; ++i)
    {
      sum->second[i] += 0.25 * sums->second[i][lane];
    }
  }
}

static bool are_quads(const int64_t* starts)
{
  bool are = true;
  for (size_t i = 0; i < LANES; ++i)
  {
    are = are && starts[i + 1] - starts[i] == 4;
  }
  return are;
}

WATER_WIDE static size_t add_rows(const double* points, const int64_t* starts,
  const int64_t* corners, size_t count, const double origin[3], double bounds[6],
  water_fit_integrals* sum)
{
  size_t done = 0;
  lanes quads;
  lanes_begin(bounds, &quads);
  lane_places place;
  while (count - done >= LANES && are_quads(starts + done))
  {
    read_quads(points, corners + starts[done], place);
    if (!add_bounds(place, &quads))
    {
      break;
    }
    add_quads(place, origin, &quads);
    done += LANES;
  }
  add_lanes(&quads, sum, bounds);
  return done;
}

size_t water_fit_rows_add(const double* points, const int64_t* starts, const int64_t* corners,
  size_t count, const double origin[3], double bounds[6], water_fit_integrals* sum)
{
  return add_rows(points, starts, corners, count, origin, bounds, sum);
}
