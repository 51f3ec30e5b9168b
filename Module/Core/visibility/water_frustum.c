// SPDX-License-Identifier: BSD-3-Clause
// water_frustum.c: the half-spaces of a frustum.
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
  water_frustum_prepare(made);
}

void water_frustum_prepare(water_frustum* frustum)
{
  for (int i = 0; i < 6; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      frustum->corners[i][axis] = 2 * axis + (frustum->planes[i][axis] > 0.0);
    }
  }
}
