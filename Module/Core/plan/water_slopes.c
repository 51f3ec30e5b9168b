// SPDX-License-Identifier: BSD-3-Clause
#include "water_slopes.h"

#include "water_math.h"

static const double seen = 1e-4;
static const double steepest = 10.0; // as WATER_STEEPEST of vtkWaterMeshPlaceFS.glsl

void water_slopes_begin(const water_plane* unit, water_slopes* slopes)
{
  memset(slopes, 0, sizeof *slopes);
  memcpy(slopes->normal, unit->normal, sizeof slopes->normal);
}

static inline void add_triangle(
  const double a[3], const double b[3], const double c[3], water_slopes* slopes)
{
  const double along[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double across[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  double normal[3];
  water_vec3_cross(along, across, normal);
  const double level = fabs(water_vec3_dot(normal, slopes->normal));
  const double size = water_vec3_dot(normal, normal);
  if (!isfinite(size) || !(size > 0.0))
  {
    return;
  }
  const double rest = size - level * level;
  const double upright = rest > 0.0 ? rest : 0.0; // squared
  const double steep = 0.5 * steepest * steepest * level * level;
  const double area = upright < steep ? level : fmax(level, sqrt(upright) / steepest);
  slopes->area += area;
  slopes->squares += upright / area;
}

void water_slopes_add(const double a[3], const double b[3], const double c[3], water_slopes* slopes)
{
  add_triangle(a, b, c, slopes);
}

void water_slopes_add_polygon(const double* points, const int64_t* corners, size_t count,
  const double mesh_to_world[16], water_slopes* slopes)
{
  double first[4];
  double sides[2][4]; // of the triangle, by turns
  for (size_t i = 0; i < count; ++i)
  {
    double* place = i == 0 ? first : sides[i % 2];
    if (mesh_to_world)
    {
      water_mat4_apply_point(mesh_to_world, points + 3 * corners[i], place);
    }
    else // half of the work
    {
      memcpy(place, points + 3 * corners[i], 3 * sizeof(double));
    }
    if (i >= 2)
    {
      add_triangle(first, sides[1 - i % 2], sides[i % 2], slopes);
    }
  }
}

void water_slopes_join(const water_slopes* other, water_slopes* slopes)
{
  slopes->area += other->area;
  slopes->squares += other->squares;
}

double water_slopes_rms(const water_slopes* slopes)
{
  return slopes->area > 0.0 ? sqrt(slopes->squares / slopes->area) : 0.0;
}

bool water_slopes_are_seen(double rms)
{
  return rms > seen;
}

double water_slopes_together(double rms_a, double rms_b)
{
  return hypot(rms_a, rms_b);
}

void water_slopes_places(const water_axes* axes, const double origin_xy[2],
  const double mesh_to_world[16], double across[4], double down[4])
{
  double rows[2][4];
  for (int i = 0; i < 2; ++i)
  {
    const double* dir = i == 0 ? axes->x_dir : axes->y_dir;
    memcpy(rows[i], dir, 3 * sizeof(double));
    rows[i][3] = -water_vec3_dot(dir, axes->origin) - origin_xy[i];
  }
  water_mat4_apply_row(rows[0], mesh_to_world, across);
  water_mat4_apply_row(rows[1], mesh_to_world, down);
}

void water_slopes_normals(
  const water_axes* axes, const double mesh_to_world[16], double normal_to_plane[9])
{
  const double* dirs[3] = { axes->x_dir, axes->y_dir, axes->normal };
  double inverse[16];
  memset(normal_to_plane, 0, 9 * sizeof(double));
  if (!water_mat4_invert_affine(mesh_to_world, inverse))
  {
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      // normals change space by the inverse, transposed
      for (int k = 0; k < 3; ++k)
      {
        normal_to_plane[3 * i + j] += dirs[i][k] * inverse[4 * j + k];
      }
    }
  }
}
