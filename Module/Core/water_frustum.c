// SPDX-License-Identifier: BSD-3-Clause
// water_frustum.c: boxes against half-spaces and frusta.
#include "water_frustum.h"

#include "water_math.h"

void water_frustum_make(const water_camera* camera, const double box[4], water_frustum* made)
{
  double world_to_clip[16];
  water_mat4_multiply(camera->view_to_clip, camera->world_to_view, world_to_clip);
  // low w <= x, y, z <= high w: rows of the matrix (Gribb and Hartmann 2001, "Fast Extraction of
  // Viewing Frustum Planes from the World-View-Projection Matrix")
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = axis < 2 ? box[axis] : -1.0;
    const double high = axis < 2 ? box[2 + axis] : 1.0;
    for (int j = 0; j < 4; ++j)
    {
      made->planes[2 * axis][j] = world_to_clip[4 * axis + j] - low * world_to_clip[12 + j];
      made->planes[2 * axis + 1][j] = high * world_to_clip[12 + j] - world_to_clip[4 * axis + j];
    }
  }
  const double* view = camera->world_to_view;
  const double origin[3] = { view[3], view[7], view[11] };
  made->reach = water_vec3_length(origin);
}

bool water_frustum_is_behind(
  const double plane[4], const double bounds[6], double reach, double rounding)
{
  // The larger of two by a comparison and not by fmax, which is a call: NaN must do something else
  // there. Bounds have none, and a plane that has any makes sums that are not below anything.
  double highest = plane[3];
  for (int i = 0; i < 3; ++i)
  {
    const double low = plane[i] * bounds[2 * i];
    const double high = plane[i] * bounds[2 * i + 1];
    highest += low > high ? low : high;
  }
  if (!(highest < 0.0))
  {
    return false; // most boxes: no need to know how far it may be off
  }
  double size = fabs(plane[3]);
  for (int i = 0; i < 3; ++i)
  {
    const double low = fabs(bounds[2 * i]);
    const double high = fabs(bounds[2 * i + 1]);
    size += fabs(plane[i]) * (low > high ? low : high) + fabs(plane[i]) * reach;
  }
  return highest < -rounding * size;
}

bool water_frustum_meets(
  const water_frustum* frustum, int plane_count, const double bounds[6], double rounding)
{
  for (int i = 0; i < plane_count; ++i)
  {
    if (water_frustum_is_behind(frustum->planes[i], bounds, frustum->reach, rounding))
    {
      return false;
    }
  }
  return true;
}
