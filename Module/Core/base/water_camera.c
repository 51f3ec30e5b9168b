// SPDX-License-Identifier: BSD-3-Clause
// water_camera.c: takes the eye apart: inverses, projection centre, view rays.
#include "water_camera.h"

#include "water_math.h"

// How far a view may be from rigid, relative: hosts build it from float directions at worst.
static const double rigid_tolerance = 1e-6;
// The same for the last row, 0 0 0 1: roundings of an inverted matrix only.
static const double affine_tolerance = 1e-12;

static bool is_rigid(const double world_to_view[16])
{
  const double origin[3] = { world_to_view[3], world_to_view[7], world_to_view[11] };
  const double reach = 1.0 + water_vec3_length(origin);
  for (int i = 0; i < 3; ++i)
  {
    // a slanted last row is multiplied by the world's coordinates, so by about reach
    if (!(fabs(world_to_view[12 + i]) * reach <= affine_tolerance))
    {
      return false;
    }
    for (int j = i; j < 3; ++j)
    {
      const double product = water_vec3_dot(world_to_view + 4 * i, world_to_view + 4 * j);
      if (!(fabs(product - (i == j ? 1.0 : 0.0)) <= rigid_tolerance))
      {
        return false;
      }
    }
  }
  double right_handed[3];
  water_vec3_cross(world_to_view, world_to_view + 4, right_handed);
  return fabs(world_to_view[15] - 1.0) <= affine_tolerance &&
    water_vec3_dot(right_handed, world_to_view + 8) > 0.0;
}

water_status water_camera_decompose(const water_camera* camera, water_eye* eye)
{
  water_eye parts = { { 0.0 }, { 0.0 }, false, { 0.0 }, { 0.0 } };
  if (!water_all_usable(camera->world_to_view, 16) || !water_all_usable(camera->view_to_clip, 16) ||
    !is_rigid(camera->world_to_view) ||
    !water_mat4_invert_affine(camera->world_to_view, parts.view_to_world) ||
    !water_mat4_invert(camera->view_to_clip, parts.clip_to_view))
  {
    return WATER_BAD_CAMERA;
  }
  const double* to_clip = camera->view_to_clip;
  const double* to_view = parts.clip_to_view;

  // The third column of the inverse, clip (0,0,1,0), is where all view rays meet: x, y and w of
  // clip vanish there. It is a point for a perspective projection, a direction for a parallel one.
  const double center[4] = { to_view[2], to_view[6], to_view[10], to_view[14] };
  parts.has_center = to_clip[12] != 0.0 || to_clip[13] != 0.0 || to_clip[14] != 0.0;
  if (parts.has_center)
  {
    for (int i = 0; i < 3; ++i)
    {
      parts.center_view[i] = center[i] / center[3];
    }
    // Of a point q of the ray, given by clip (x, y, any, 1), q - q.w * center is a direction; it is
    // linear in (x, y), and its clip w is 1, so it leads away from the eye.
    const int columns[3] = { 0, 1, 3 };
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        parts.ndc_to_dir[3 * i + j] =
          to_view[4 * i + columns[j]] - parts.center_view[i] * to_view[12 + columns[j]];
      }
    }
  }
  else
  {
    const double length = water_vec3_length(center);
    const double sign = center[2] > 0.0 ? -1.0 : 1.0; // the camera looks along -z
    for (int i = 0; i < 3; ++i)
    {
      parts.ndc_to_dir[3 * i + 2] = sign * center[i] / length;
    }
  }
  if (!water_all_usable(parts.clip_to_view, 16) || !water_all_usable(parts.ndc_to_dir, 9))
  {
    return WATER_BAD_CAMERA;
  }
  *eye = parts;
  return WATER_OK;
}

void water_camera_rays(const water_eye* eye, const water_plane* plane, const double x_dir[3],
  const double y_dir[3], double ndc_to_ray[9])
{
  const double* axes[3] = { x_dir, y_dir, plane->normal };
  const double* rotation = eye->view_to_world;
  for (int i = 0; i < 3; ++i)
  {
    double axis_view[3]; // the axis seen in view space: only the rotation, no world coordinates
    for (int k = 0; k < 3; ++k)
    {
      axis_view[k] =
        axes[i][0] * rotation[k] + axes[i][1] * rotation[4 + k] + axes[i][2] * rotation[8 + k];
    }
    for (int j = 0; j < 3; ++j)
    {
      ndc_to_ray[3 * i + j] = axis_view[0] * eye->ndc_to_dir[j] +
        axis_view[1] * eye->ndc_to_dir[3 + j] + axis_view[2] * eye->ndc_to_dir[6 + j];
    }
  }
}

void water_camera_plane_view(const water_eye* eye, const water_plane* plane, double plane_view[4])
{
  const double plane_world[4] = { plane->normal[0], plane->normal[1], plane->normal[2],
    plane->offset };
  water_mat4_apply_row(plane_world, eye->view_to_world, plane_view);
}
