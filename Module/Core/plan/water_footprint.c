// SPDX-License-Identifier: BSD-3-Clause
// water_footprint.c: is a thing seen from above a surface or a solid?
#include "water_footprint.h"

#include "water_math.h"

// Within a cell the heights of a surface differ about as much as between neighbours; a gap between
// a base and a top is wider than that.
static const double wider = 2.0;
static const double most = 0.5;         // share of the cells that have a gap, in a solid
static const double upright = 0.8;      // of the thickness one cell further in: a circle has 0.71
static const double walled = 2.0 / 3.0; // share of the rim that has walls, in a block
static const double part = 0.02;        // of a top that is under the water
static const int few_cells = 16;

void water_footprint_begin(water_footprint* footprint)
{
  for (int i = 0; i < WATER_FOOTPRINT_CELLS * WATER_FOOTPRINT_CELLS; ++i)
  {
    footprint->low[i / WATER_FOOTPRINT_CELLS][i % WATER_FOOTPRINT_CELLS] = (double)INFINITY;
    footprint->high[i / WATER_FOOTPRINT_CELLS][i % WATER_FOOTPRINT_CELLS] = -(double)INFINITY;
  }
  for (int i = 0; i < 2; ++i)
  {
    footprint->first[i] = WATER_FOOTPRINT_CELLS;
    footprint->last[i] = -1;
  }
}

void water_footprint_add(int x, int y, double height, water_footprint* footprint)
{
  const int cell[2] = { x, y };
  footprint->low[y][x] = fmin(footprint->low[y][x], height);
  footprint->high[y][x] = fmax(footprint->high[y][x], height);
  for (int i = 0; i < 2; ++i)
  {
    footprint->first[i] = cell[i] < footprint->first[i] ? cell[i] : footprint->first[i];
    footprint->last[i] = cell[i] > footprint->last[i] ? cell[i] : footprint->last[i];
  }
}

bool water_footprint_has(const water_footprint* footprint, int x, int y)
{
  return x >= 0 && x < WATER_FOOTPRINT_CELLS && y >= 0 && y < WATER_FOOTPRINT_CELLS &&
    footprint->low[y][x] <= footprint->high[y][x];
}

static double thickness(const water_footprint* footprint, int x, int y)
{
  return footprint->high[y][x] - footprint->low[y][x];
}

static bool has_gap(const water_footprint* footprint, int x, int y)
{
  static const int beside[4][2] = { { -1, 0 }, { 1, 0 }, { 0, -1 }, { 0, 1 } };
  double slope = 0.0; // the highest step to a neighbour, of both heights
  for (int i = 0; i < 4; ++i)
  {
    const int column = x + beside[i][0];
    const int row = y + beside[i][1];
    if (water_footprint_has(footprint, column, row))
    {
      slope = fmax(slope, fabs(footprint->low[row][column] - footprint->low[y][x]));
      slope = fmax(slope, fabs(footprint->high[row][column] - footprint->high[y][x]));
    }
  }
  return thickness(footprint, x, y) > wider * slope;
}

// Ends of the rows (axis 0) or columns: how many have a cell further in, and how many of those are
// a wall.
static void count_walls(const water_footprint* footprint, int axis, int* count, int* wall_count)
{
  for (int line = footprint->first[1 - axis]; line <= footprint->last[1 - axis]; ++line)
  {
    for (int end = 0; end < 2; ++end)
    {
      double thick[2]; // of the outermost two
      int found = 0;
      const int from = end == 0 ? footprint->first[axis] : footprint->last[axis];
      const int range = footprint->last[axis] - footprint->first[axis];
      for (int i = 0; i <= range && found < 2; ++i)
      {
        const int at = end == 0 ? from + i : from - i;
        const int x = axis == 0 ? at : line;
        const int y = axis == 0 ? line : at;
        if (water_footprint_has(footprint, x, y))
        {
          thick[found++] = thickness(footprint, x, y);
        }
      }
      *count += found == 2 ? 1 : 0;
      *wall_count += found == 2 && thick[0] > 0.0 && thick[0] >= upright * thick[1] ? 1 : 0;
    }
  }
}

water_footprint_shape water_footprint_shape_of(const water_footprint* footprint)
{
  int cell_count = 0;
  int gap_count = 0;
  for (int y = footprint->first[1]; y <= footprint->last[1]; ++y)
  {
    for (int x = footprint->first[0]; x <= footprint->last[0]; ++x)
    {
      const bool has_cell = water_footprint_has(footprint, x, y);
      cell_count += has_cell ? 1 : 0;
      gap_count += has_cell && has_gap(footprint, x, y) ? 1 : 0;
    }
  }
  if (cell_count < few_cells || gap_count < most * cell_count)
  {
    return WATER_FOOTPRINT_SURFACE;
  }
  int rim_count = 0;
  int wall_count = 0;
  count_walls(footprint, 0, &rim_count, &wall_count);
  count_walls(footprint, 1, &rim_count, &wall_count);
  return wall_count >= walled * rim_count ? WATER_FOOTPRINT_BLOCK : WATER_FOOTPRINT_OBJECT;
}

// How many cells have their top up to a height; all of them for an infinite one.
static int count_under(const water_footprint* footprint, double height)
{
  int count = 0;
  for (int y = footprint->first[1]; y <= footprint->last[1]; ++y)
  {
    for (int x = footprint->first[0]; x <= footprint->last[0]; ++x)
    {
      count += water_footprint_has(footprint, x, y) && footprint->high[y][x] <= height ? 1 : 0;
    }
  }
  return count;
}

double water_footprint_wet_from(const water_footprint* footprint)
{
  double low = (double)INFINITY;
  double high = -(double)INFINITY;
  for (int i = 0; i < WATER_FOOTPRINT_CELLS * WATER_FOOTPRINT_CELLS; ++i)
  {
    const int y = i / WATER_FOOTPRINT_CELLS;
    const int x = i % WATER_FOOTPRINT_CELLS;
    if (water_footprint_has(footprint, x, y))
    {
      low = fmin(low, footprint->high[y][x]);
      high = fmax(high, footprint->high[y][x]);
    }
  }
  if (low > high)
  {
    return (double)INFINITY;
  }
  const double enough = part * count_under(footprint, (double)INFINITY);
  for (int i = 0; i < 24; ++i) // bisection, to a ten millionth
  {
    const double middle = 0.5 * (low + high);
    if (count_under(footprint, middle) >= enough)
    {
      high = middle;
    }
    else
    {
      low = middle;
    }
  }
  return high;
}
