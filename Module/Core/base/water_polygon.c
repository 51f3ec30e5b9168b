// SPDX-License-Identifier: BSD-3-Clause
#include "water_polygon.h"

#include "water_math.h"

bool water_polygon_normal(const double* corners, size_t count, double normal[3])
{
  double area[3] = { 0.0, 0.0, 0.0 };
  for (size_t i = 2; i < count; ++i)
  {
    double edges[2][3];
    double product[3];
    for (size_t axis = 0; axis < 3; ++axis)
    {
      edges[0][axis] = corners[3 * (i - 1) + axis] - corners[axis];
      edges[1][axis] = corners[3 * i + axis] - corners[axis];
    }
    water_vec3_cross(edges[0], edges[1], product);
    for (size_t axis = 0; axis < 3; ++axis)
    {
      area[axis] += product[axis];
    }
  }
  const double length = water_vec3_length(area);
  const bool is_known = length > 0.0 && isfinite(length);
  for (size_t axis = 0; axis < 3; ++axis)
  {
    normal[axis] = is_known ? area[axis] / length : 0.0;
  }
  return is_known;
}
