// SPDX-License-Identifier: BSD-3-Clause
// water_plane.c: the plane: normalise, height of a point, mirror matrix, own axes, sheet.
#include "water_plane.h"

#include "water_math.h"

water_status water_plane_normalise(const water_plane* plane, water_plane* unit)
{
  const double* normal = plane->normal;
  const double largest = fmax(fabs(normal[0]), fmax(fabs(normal[1]), fabs(normal[2])));
  // scaled first, or squares of very long or very short normals overflow or vanish; what is not
  // finite, or has no length, ends as an offset that is no number
  const double scaled[3] = { normal[0] / largest, normal[1] / largest, normal[2] / largest };
  const double length = water_vec3_length(scaled);
  const double offset = plane->offset / largest / length;
  if (!water_all_usable(&offset, 1))
  {
    return WATER_BAD_PLANE;
  }
  for (int i = 0; i < 3; ++i)
  {
    unit->normal[i] = scaled[i] / length;
  }
  unit->offset = offset;
  return WATER_OK;
}

// A unit normal is within 6 u of itself (water_plane.h), u half an epsilon, and an offset is a sum
// of three products with a point: 16 epsilons are more than both.
static const double same_rounding = 16.0 * DBL_EPSILON;

bool water_plane_is_same(const water_plane* a, const water_plane* b, double reach)
{
  const double sign = water_vec3_dot(a->normal, b->normal) < 0.0 ? -1.0 : 1.0;
  double turned = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    turned = fmax(turned, fabs(a->normal[i] - sign * b->normal[i]));
  }
  return turned <= same_rounding && fabs(a->offset - sign * b->offset) <= same_rounding * reach;
}

bool water_plane_is_identical(const water_plane* a, const water_plane* b)
{
  water_plane unit_a;
  water_plane unit_b;
  return water_plane_normalise(a, &unit_a) == WATER_OK &&
    water_plane_normalise(b, &unit_b) == WATER_OK && unit_a.normal[0] == unit_b.normal[0] &&
    unit_a.normal[1] == unit_b.normal[1] && unit_a.normal[2] == unit_b.normal[2] &&
    unit_a.offset == unit_b.offset;
}

bool water_plane_is_shared(
  const water_plane* a, const double origin_a[3], const water_plane* b, const double origin_b[3])
{
  water_plane unit_a;
  water_plane unit_b;
  return water_plane_normalise(a, &unit_a) == WATER_OK &&
    water_plane_normalise(b, &unit_b) == WATER_OK &&
    water_plane_is_same(
      &unit_a, &unit_b, water_vec3_length(origin_a) + water_vec3_length(origin_b));
}

void water_plane_project(const water_plane* unit, const double point[3], double projected[3])
{
  const double height = water_plane_height(unit, point);
  for (int i = 0; i < 3; ++i)
  {
    projected[i] = point[i] - height * unit->normal[i];
  }
}

void water_plane_mirror_matrix(const water_plane* unit, double world_to_mirrored[16])
{
  const double* normal = unit->normal;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      world_to_mirrored[4 * i + j] = (i == j ? 1.0 : 0.0) - 2.0 * normal[i] * normal[j];
    }
    world_to_mirrored[4 * i + 3] = -2.0 * unit->offset * normal[i];
    world_to_mirrored[12 + i] = 0.0;
  }
  world_to_mirrored[15] = 1.0;
}

void water_plane_axes(const double unit_normal[3], double x_dir[3], double y_dir[3])
{
  const int axis = unit_normal[0] * unit_normal[0] > 0.5 ? 1 : 0; // 0.5 = cos^2 of 45 degrees
  double projected[3];
  for (int i = 0; i < 3; ++i)
  {
    projected[i] = (i == axis ? 1.0 : 0.0) - unit_normal[axis] * unit_normal[i];
  }
  const double length = water_vec3_length(projected);
  for (int i = 0; i < 3; ++i)
  {
    x_dir[i] = projected[i] / length;
  }
  water_vec3_cross(unit_normal, x_dir, y_dir);
}

void water_plane_sky_direction(
  const double unit_normal[3], double azimuth_rad, double elevation_rad, double direction[3])
{
  double x_dir[3];
  double y_dir[3];
  water_plane_axes(unit_normal, x_dir, y_dir);
  const double x = sin(azimuth_rad) * cos(elevation_rad);
  const double y = cos(azimuth_rad) * cos(elevation_rad);
  for (int i = 0; i < 3; ++i)
  {
    direction[i] = x * x_dir[i] + y * y_dir[i] + sin(elevation_rad) * unit_normal[i];
  }
}

water_status water_sheet_bounds(const double origin[3], const double x_dir[3],
  const double y_dir[3], const double bounds[6], double sheet[4])
{
  if (!water_all_finite(bounds, 6) || water_bounds_is_empty(bounds))
  {
    return WATER_BAD_SURFACE;
  }
  double rectangle[4] = { DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX };
  for (int number = 0; number < 8; ++number)
  {
    double corner[3];
    water_bounds_corner(bounds, number, corner);
    // relative to the origin before the dot product: small numbers where the world's are large
    const double arm[3] = { corner[0] - origin[0], corner[1] - origin[1], corner[2] - origin[2] };
    const double x = water_vec3_dot(arm, x_dir);
    const double y = water_vec3_dot(arm, y_dir);
    if (!isfinite(x) || !isfinite(y))
    {
      return WATER_BAD_SURFACE;
    }
    rectangle[0] = fmin(rectangle[0], x);
    rectangle[1] = fmax(rectangle[1], x);
    rectangle[2] = fmin(rectangle[2], y);
    rectangle[3] = fmax(rectangle[3], y);
  }
  memcpy(sheet, rectangle, sizeof rectangle);
  return WATER_OK;
}

void water_plane_displaced_bounds(
  const water_plane* unit, const double bounds[6], double height, double reach, double displaced[6])
{
  for (int i = 0; i < 3; ++i)
  {
    const double normal = fmin(fabs(unit->normal[i]), 1.0);
    const double way = height * normal + reach * sqrt(1.0 - normal * normal);
    displaced[2 * i] = bounds[2 * i] - way;
    displaced[2 * i + 1] = bounds[2 * i + 1] + way;
  }
}

water_status water_sheet_around(
  const water_plane* plane, const double origin[3], const double bounds[6], double sheet[4])
{
  water_plane unit;
  const water_status status = water_plane_normalise(plane, &unit);
  if (status != WATER_OK)
  {
    return status;
  }
  double x_dir[3];
  double y_dir[3];
  water_plane_axes(unit.normal, x_dir, y_dir);
  return water_sheet_bounds(origin, x_dir, y_dir, bounds, sheet);
}

water_plane water_plane_turned(const water_plane* plane, water_side side)
{
  const double sign = side == WATER_BELOW ? -1.0 : 1.0;
  const water_plane turned = { { sign * plane->normal[0], sign * plane->normal[1],
                                 sign * plane->normal[2] },
    sign * plane->offset };
  return turned;
}

void water_sheet_corners(const double origin[3], const double x_dir[3], const double y_dir[3],
  const double sheet[4], double corners[12])
{
  const double turn[4][2] = { { sheet[0], sheet[2] }, { sheet[1], sheet[2] },
    { sheet[1], sheet[3] }, { sheet[0], sheet[3] } };
  for (int number = 0; number < 4; ++number)
  {
    for (int i = 0; i < 3; ++i)
    {
      corners[3 * number + i] = origin[i] + turn[number][0] * x_dir[i] + turn[number][1] * y_dir[i];
    }
  }
}
