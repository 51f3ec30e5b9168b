// SPDX-License-Identifier: BSD-3-Clause
#include "water_placement.h"

#include "water_math.h"
#include "water_plane.h"

#include <math.h>

// Of a surface's diagonal: a reflection that is off by so much is seen, and no sea is off so much.
static const double height_share = 0.01;
// No wave is steeper: Stokes's highest one has crests of 120 degrees.
static const double angle_max = 0.52359877559829887308; // 30 degrees

void water_placement_begin(const water_plane* unit, water_placement* placement)
{
  const water_placement none = { *unit, 0.0, 0.0, 0.0, { 0.0 } };
  *placement = none;
  water_bounds_begin(placement->bounds);
}

void water_placement_add(
  const double a[3], const double b[3], const double c[3], water_placement* placement)
{
  const double* corners[3] = { a, b, c };
  const double along[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double across[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  double normal[3];
  water_vec3_cross(along, across, normal);
  const double area = water_vec3_length(normal);
  double height = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    height += water_plane_height(&placement->unit, corners[i]) / 3.0;
  }
  if (!isfinite(area * height))
  {
    return;
  }
  placement->area += area;
  placement->level_area += fabs(water_vec3_dot(normal, placement->unit.normal));
  placement->area_height += area * height;
  for (int i = 0; i < 3; ++i)
  {
    water_bounds_add_point(placement->bounds, corners[i]);
  }
}

water_placement_verdict water_placement_judge(const water_placement* placement)
{
  water_placement_verdict verdict = { 0.0, 0.0, 0.0, angle_max, false, false };
  if (!(placement->area > 0.0))
  {
    return verdict;
  }
  const double* bounds = placement->bounds;
  const double diagonal[3] = { bounds[1] - bounds[0], bounds[3] - bounds[2],
    bounds[5] - bounds[4] };
  verdict.height = placement->area_height / placement->area;
  verdict.height_max = height_share * water_vec3_length(diagonal);
  verdict.angle_rad = acos(fmin(placement->level_area / placement->area, 1.0));
  verdict.is_off = fabs(verdict.height) > verdict.height_max;
  verdict.is_upright = verdict.angle_rad > verdict.angle_max_rad;
  return verdict;
}
