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

// So many quads at once: compilers use wide instructions then.
#define LANES 16

static bool are_quads(const int64_t* starts)
{
  bool are = true;
  for (size_t i = 0; i < LANES; ++i)
  {
    are = are && starts[i + 1] - starts[i] == 4;
  }
  return are;
}

// The same as find_normal, of that many quads.
WATER_WIDE_PART static inline void find_quad_normals(
  const double* points, const int64_t* corners, float normals[3][LANES])
{
  double across[2][3][LANES]; // the diagonals
  for (int lane = 0; lane < LANES; ++lane)
  {
    for (int k = 0; k < 2; ++k)
    {
      const double* from = points + 3 * corners[4 * lane + k];
      const double* to = points + 3 * corners[4 * lane + k + 2];
      across[k][0][lane] = to[0] - from[0];
      across[k][1][lane] = to[1] - from[1];
      across[k][2][lane] = to[2] - from[2];
    }
  }
  for (int lane = 0; lane < LANES; ++lane)
  {
    const double a[3] = { across[0][0][lane], across[0][1][lane], across[0][2][lane] };
    const double b[3] = { across[1][0][lane], across[1][1][lane], across[1][2][lane] };
    double area[3];
    water_vec3_cross(a, b, area);
    const double length = water_vec3_length(area);
    const bool is_known = length > 0.0 && length <= DBL_MAX;
    const double scale = is_known ? 1.0 / length : 0.0;
    normals[0][lane] = (float)(is_known ? scale * area[0] : 0.0);
    normals[1][lane] = (float)(is_known ? scale * area[1] : 0.0);
    normals[2][lane] = (float)(is_known ? scale * area[2] : 0.0);
  }
}

// share  NULL: all points
WATER_WIDE_PART static inline void add_normal(const int64_t* corners, size_t count, float x,
  float y, float z, const water_polygon_share* share, float* sums)
{
  for (size_t k = 0; k < count; ++k)
  {
    if (share && (share->owners[corners[k]] == share->owner) != share->is_owned)
    {
      continue;
    }
    float* sum = sums + 3 * corners[k];
    sum[0] += x;
    sum[1] += y;
    sum[2] += z;
  }
}

WATER_WIDE_PART static inline void add_normals(const double* points, const int64_t* starts,
  const int64_t* corners, size_t count, const water_polygon_share* share, float* sums)
{
  for (size_t polygon = 0; polygon < count;)
  {
    const int64_t* own = corners + starts[polygon];
    if (count - polygon >= LANES && are_quads(starts + polygon))
    {
      float normals[3][LANES];
      find_quad_normals(points, own, normals);
      for (int lane = 0; lane < LANES; ++lane)
      {
        add_normal(
          own + 4 * lane, 4, normals[0][lane], normals[1][lane], normals[2][lane], share, sums);
      }
      polygon += LANES;
      continue;
    }
    const size_t size = (size_t)(starts[polygon + 1] - starts[polygon]);
    double normal[3];
    find_normal(points, own, size, normal);
    add_normal(own, size, (float)normal[0], (float)normal[1], (float)normal[2], share, sums);
    ++polygon;
  }
}

WATER_WIDE static void add_all_normals(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, float* sums)
{
  add_normals(points, starts, corners, count, NULL, sums);
}

void water_polygon_add_normals(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, float* sums)
{
  add_all_normals(points, starts, corners, count, sums);
}

WATER_WIDE static void add_shared_normals(const double* points, const int64_t* starts,
  const int64_t* corners, size_t count, const water_polygon_share* share, float* sums)
{
  add_normals(points, starts, corners, count, share, sums);
}

void water_polygon_add_shared_normals(const double* points, const int64_t* starts,
  const int64_t* corners, size_t count, const water_polygon_share* share, float* sums)
{
  add_shared_normals(points, starts, corners, count, share, sums);
}

// Gives that many rows the length 1.
WATER_WIDE_PART static inline void unit_rows(float* normals)
{
  double sums[3][LANES];
  for (int lane = 0; lane < LANES; ++lane)
  {
    sums[0][lane] = (double)normals[3 * lane];
    sums[1][lane] = (double)normals[3 * lane + 1];
    sums[2][lane] = (double)normals[3 * lane + 2];
  }
  for (int lane = 0; lane < LANES; ++lane)
  {
    const double sum[3] = { sums[0][lane], sums[1][lane], sums[2][lane] };
    const double length = water_vec3_length(sum);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    sums[0][lane] *= scale;
    sums[1][lane] *= scale;
    sums[2][lane] *= scale;
  }
  for (int lane = 0; lane < LANES; ++lane)
  {
    normals[3 * lane] = (float)sums[0][lane];
    normals[3 * lane + 1] = (float)sums[1][lane];
    normals[3 * lane + 2] = (float)sums[2][lane];
  }
}

WATER_WIDE static void make_unit_normals(float* normals, size_t count)
{
  size_t done = 0;
  for (; count - done >= LANES; done += LANES)
  {
    unit_rows(normals + 3 * done);
  }
  if (done < count)
  {
    float last[3 * LANES] = { 0.0f };
    const size_t size = 3 * (count - done) * sizeof(float);
    memcpy(last, normals + 3 * done, size);
    unit_rows(last);
    memcpy(normals + 3 * done, last, size);
  }
}

void water_polygon_unit_normals(float* normals, size_t count)
{
  make_unit_normals(normals, count);
}
