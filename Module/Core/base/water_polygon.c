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

// A corner of a polygon; without a list of corners, the points are the polygon's.
static inline const double* corner_of(const double* points, const int64_t* corners, size_t number)
{
  return points + 3 * (corners ? corners[number] : (int64_t)number);
}

static inline bool find_normal(
  const double* points, const int64_t* corners, size_t count, double normal[3])
{
  double area[3] = { 0.0, 0.0, 0.0 };
  const double* first = count > 0 ? corner_of(points, corners, 0) : NULL;
  if (count == 4) // half of the work: a quad's area vector is the product of its diagonals
  {
    cross_of(first, corner_of(points, corners, 2), corner_of(points, corners, 1),
      corner_of(points, corners, 3), area);
  }
  for (size_t i = 2; i < count && count != 4; ++i)
  {
    double product[3];
    cross_of(
      first, corner_of(points, corners, i - 1), first, corner_of(points, corners, i), product);
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

bool water_polygon_normal(const double* corners, size_t count, double normal[3])
{
  return find_normal(corners, NULL, count, normal);
}

void water_polygon_add_normals(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, float* sums)
{
  for (size_t polygon = 0; polygon < count; ++polygon)
  {
    const int64_t* own = corners + starts[polygon];
    const size_t size = (size_t)(starts[polygon + 1] - starts[polygon]);
    double normal[3];
    find_normal(points, own, size, normal);
    const float rounded[3] = { (float)normal[0], (float)normal[1], (float)normal[2] };
    for (size_t k = 0; k < size; ++k)
    {
      float* sum = sums + 3 * own[k];
      sum[0] += rounded[0];
      sum[1] += rounded[1];
      sum[2] += rounded[2];
    }
  }
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
