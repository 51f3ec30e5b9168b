// SPDX-License-Identifier: BSD-3-Clause
// water_relief.c: how high a surface is at the corners of a grid's cells, at least.
#include "water_relief.h"

#include "water_math.h"

static const double slack = 1e-6; // cells: a surface's rim is rounded, and so is the grid's border

void water_relief_begin(water_relief* relief)
{
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    relief->height[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS] = (double)INFINITY;
  }
  for (int i = 0; i < WATER_FOOTPRINT_CELLS * WATER_FOOTPRINT_CELLS; ++i)
  {
    relief->below[i / WATER_FOOTPRINT_CELLS][i % WATER_FOOTPRINT_CELLS] = (double)INFINITY;
  }
}

static double clamped(double value, double low, double high)
{
  return fmin(fmax(value, low), high);
}

// Twice the area of a triangle in the plane; positive if it is counter-clockwise.
static double area_of(const double* a, const double* b, const double* c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

void water_relief_add_triangle(double corners[3][3], water_relief* relief)
{
  const double area = area_of(corners[0], corners[1], corners[2]);
  double from[2];
  double to[2];
  bool is_finite = true;
  for (int axis = 0; axis < 2; ++axis)
  {
    from[axis] = fmin(fmin(corners[0][axis], corners[1][axis]), corners[2][axis]);
    to[axis] = fmax(fmax(corners[0][axis], corners[1][axis]), corners[2][axis]);
  }
  for (int i = 0; i < 9; ++i)
  {
    is_finite = is_finite && isfinite(corners[i / 3][i % 3]);
  }
  if (!is_finite || fabs(area) < slack * slack) // a wall has no height
  {
    return;
  }
  const double last = WATER_RELIEF_CORNERS - 1.0;
  const int x_last = (int)clamped(floor(to[0] + slack), -1.0, last);
  const int y_last = (int)clamped(floor(to[1] + slack), -1.0, last);
  for (int y = (int)clamped(ceil(from[1] - slack), 0.0, last + 1.0); y <= y_last; ++y)
  {
    for (int x = (int)clamped(ceil(from[0] - slack), 0.0, last + 1.0); x <= x_last; ++x)
    {
      const double at[2] = { clamped(x, from[0], to[0]), clamped(y, from[1], to[1]) };
      const double parts[3] = { area_of(at, corners[1], corners[2]) / area,
        area_of(corners[0], at, corners[2]) / area, area_of(corners[0], corners[1], at) / area };
      if (fmin(fmin(parts[0], parts[1]), parts[2]) >= -slack)
      {
        const double height =
          parts[0] * corners[0][2] + parts[1] * corners[1][2] + parts[2] * corners[2][2];
        relief->height[y][x] = fmin(relief->height[y][x], height);
      }
    }
  }
}

void water_relief_add_point(const double point[3], water_relief* relief)
{
  if (!isfinite(point[0] + point[1] + point[2]))
  {
    return;
  }
  const double last = WATER_FOOTPRINT_CELLS - 1.0;
  const int x = (int)clamped(floor(point[0]), 0.0, last);
  const int y = (int)clamped(floor(point[1]), 0.0, last);
  const double u = clamped(point[0] - x, 0.0, 1.0);
  const double v = clamped(point[1] - y, 0.0, 1.0);
  const double h[4] = { relief->height[y][x], relief->height[y][x + 1], relief->height[y + 1][x],
    relief->height[y + 1][x + 1] };
  if (isinf(h[0] + h[1] + h[2] + h[3]))
  {
    return;
  }
  const double even = (1.0 - v) * ((1.0 - u) * h[0] + u * h[1]) + v * ((1.0 - u) * h[2] + u * h[3]);
  const double miss = fmax(even - point[2], 0.0);
  relief->below[y][x] = isinf(relief->below[y][x]) ? miss : fmax(relief->below[y][x], miss);
}

static bool is_cell(int x, int y)
{
  return x >= 0 && x < WATER_FOOTPRINT_CELLS && y >= 0 && y < WATER_FOOTPRINT_CELLS;
}

// The height at a corner, less what the surface reaches under it in the cells around it.
static double lowered(const water_relief* relief, int x, int y)
{
  double most = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const int column = x - i % 2;
    const int row = y - i / 2;
    most = is_cell(column, row) ? fmax(most, relief->below[row][column]) : most;
  }
  return isinf(most) || isinf(relief->height[y][x]) ? -(double)INFINITY
                                                    : relief->height[y][x] - most;
}

double water_relief_at(const water_relief* relief, int x, int y)
{
  const double height = lowered(relief, x, y);
  // corners are lowered unevenly: straight lines between them are off by their twist
  double most = 0.0;
  for (int i = 0; i < 4 && isfinite(height); ++i)
  {
    const int column = x - i % 2;
    const int row = y - i / 2;
    if (is_cell(column, row))
    {
      const double twist = lowered(relief, column, row) - lowered(relief, column + 1, row) -
        lowered(relief, column, row + 1) + lowered(relief, column + 1, row + 1);
      most = isfinite(twist) ? fmax(most, 0.25 * fabs(twist)) : most;
    }
  }
  return height - most;
}

void water_relief_join_heights(const double* heights, water_relief* relief)
{
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    double* height = &relief->height[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS];
    *height = fmin(*height, heights[i]);
  }
}

void water_relief_join_below(const double* below, water_relief* relief)
{
  for (int i = 0; i < WATER_FOOTPRINT_CELLS * WATER_FOOTPRINT_CELLS; ++i)
  {
    double* miss = &relief->below[i / WATER_FOOTPRINT_CELLS][i % WATER_FOOTPRINT_CELLS];
    if (isfinite(below[i]))
    {
      *miss = isinf(*miss) ? below[i] : fmax(*miss, below[i]);
    }
  }
}
