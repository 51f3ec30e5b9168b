// SPDX-License-Identifier: BSD-3-Clause
#include "water_polygon.h"

#include "water_math.h"

// The cross product of two differences of points.
static inline void cross_of(
  const double* from, const double* to, const double* start, const double* end, double product[3])
{
  const double a[3] = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  const double b[3] = { end[0] - start[0], end[1] - start[1], end[2] - start[2] };
  water_vec3_cross(a, b, product);
}

bool water_polygon_normal(const double* corners, size_t count, double normal[3])
{
  double area[3] = { 0.0, 0.0, 0.0 };
  if (count == 4) // half of the work: a quad's area vector is the product of its diagonals
  {
    cross_of(corners, corners + 6, corners + 3, corners + 9, area);
  }
  for (size_t i = 2; i < count && count != 4; ++i)
  {
    double product[3];
    cross_of(corners, corners + 3 * (i - 1), corners, corners + 3 * i, product);
    for (size_t axis = 0; axis < 3; ++axis)
    {
      area[axis] += product[axis];
    }
  }
  const double length = water_vec3_length(area);
  const bool is_known = length > 0.0 && isfinite(length);
  const double scale = is_known ? 1.0 / length : 0.0;
  for (size_t axis = 0; axis < 3; ++axis)
  {
    normal[axis] = is_known ? scale * area[axis] : 0.0;
  }
  return is_known;
}

void water_polygon_unit_normals(float* normals, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    float* row = normals + 3 * i;
    const double sum[3] = { (double)row[0], (double)row[1], (double)row[2] };
    const double length = water_vec3_length(sum);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    for (size_t axis = 0; axis < 3; ++axis)
    {
      row[axis] = (float)(scale * sum[axis]);
    }
  }
}
