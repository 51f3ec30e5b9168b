// SPDX-License-Identifier: BSD-3-Clause
// water_mirror.c: the mirrored camera, the clip at the plane, the way into its picture.
#include "water_mirror.h"

#include "water_math.h"
#include "water_plane.h"
#include "water_prop.h"

// Fx m Fx, Fx = diag(-1, 1, 1, 1): entries with one index of x change sign.
static void flip_x_both(const double matrix[16], double flipped[16])
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const bool is_flipped = (i == 0) != (j == 0);
      flipped[4 * i + j] = is_flipped ? -matrix[4 * i + j] : matrix[4 * i + j];
    }
  }
}

void water_mirror_camera(const water_camera* eye, const water_plane* plane, water_camera* mirrored)
{
  double world_to_mirrored[16];
  water_plane_mirror_matrix(plane, world_to_mirrored);
  double view[16];
  water_mat4_multiply(eye->world_to_view, world_to_mirrored, view);
  for (int j = 0; j < 4; ++j)
  {
    view[j] = -view[j];
  }
  memcpy(mirrored->world_to_view, view, sizeof view);
  double clip[16];
  flip_x_both(eye->view_to_clip, clip);
  memcpy(mirrored->view_to_clip, clip, sizeof clip);
  mirrored->parallel = eye->parallel;
}

void water_mirror_widen(const double reflection_scale[2], water_camera* mirrored)
{
  for (int j = 0; j < 4; ++j)
  {
    mirrored->view_to_clip[j] *= reflection_scale[0];
    mirrored->view_to_clip[4 + j] *= reflection_scale[1];
  }
}

// Distance of props from the far plane, in NDC: rounding must not move them behind it, or to the
// depth with which the reflection texture is cleared.
static const double far_margin = 2e-6;

// Divided by the distance of the far plane: the near plane is not moved nearer than this
// (vtkRenderer's NearClippingPlaneTolerance with 24 bits of depth).
static const double nearest_of_far = 1e-3;

// The far plane for depths that are scaled, z' - (1 - margin) w of water_mirror_reach: positive
// beyond it.
static void far_plane(const double world_to_clip[16], double scale, double beyond[4])
{
  for (int j = 0; j < 4; ++j)
  {
    beyond[j] = scale * (world_to_clip[8 + j] + world_to_clip[12 + j]) -
      (2.0 - far_margin) * world_to_clip[12 + j];
  }
}

void water_mirror_reach_begin(const water_camera* mirrored, water_reach* reach)
{
  double* world_to_clip = reach->world_to_clip;
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_clip);
  // z' = s (z + w) - w keeps the near plane z + w = 0 for every s; a point lies before the new far
  // plane, at z' = (1 - margin) w, for s = (2 - margin) w / (z + w), so the smallest s of all
  // corners takes them all in.
  reach->scale = 1.0;
  far_plane(world_to_clip, reach->scale, reach->beyond);
  for (int j = 0; j < 4; ++j)
  {
    reach->sizes[j] = fabs(world_to_clip[8 + j]) + 2.0 * fabs(world_to_clip[12 + j]);
  }
}

void water_mirror_reach_add(
  const water_prop* props, size_t prop_count, const water_cull_reason* reasons, water_reach* reach)
{
  for (size_t i = 0; i < prop_count; ++i)
  {
    const double* bounds = props[i].bounds;
    double farthest = reach->beyond[3]; // of all corners
    double size = reach->sizes[3];
    for (int j = 0; j < 3; ++j)
    {
      const double low = fabs(bounds[2 * j]);
      const double high = fabs(bounds[2 * j + 1]);
      farthest += reach->beyond[j] * bounds[2 * j + (reach->beyond[j] > 0.0)];
      size += reach->sizes[j] * (low > high ? low : high);
    }
    // Most props are before the far plane by more than rounding (water_select.c): none of their
    // corners would change the scale. Reasons are less foreseeable, to a processor, too.
    if (farthest < -32.0 * DBL_EPSILON * size || reasons[i] != WATER_CULL_NONE ||
      water_prop_is_unbounded(props + i))
    {
      continue;
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double point[3];
      water_bounds_corner(bounds, corner, point);
      double clip[4];
      water_mat4_apply_point(reach->world_to_clip, point, clip);
      if (clip[3] > 0.0 && clip[2] > -clip[3])
      {
        reach->scale = fmin(reach->scale, (2.0 - far_margin) * clip[3] / (clip[2] + clip[3]));
      }
    }
    far_plane(reach->world_to_clip, reach->scale, reach->beyond);
  }
}

void water_mirror_reach_apply(const water_reach* reach, water_camera* mirrored)
{
  double* clip = mirrored->view_to_clip;
  for (int j = 0; j < 4 && reach->scale < 1.0; ++j)
  {
    clip[8 + j] = reach->scale * (clip[8 + j] + clip[12 + j]) - clip[12 + j];
  }
}

// The scale of depths that moves the near plane to a point before it: z' = s z + (1 - s) w keeps
// the far plane z = w, and gives the point the depth -(1 - margin) w.
static double near_scale(const double clip[4])
{
  return (2.0 - far_margin) * clip[3] / (clip[3] - clip[2]);
}

// The least scale: the near plane is a part of the far plane's distance away.
static double near_scale_min(const double view_to_clip[16])
{
  const double slope = view_to_clip[10];
  const double start = view_to_clip[11];
  if (view_to_clip[14] == 0.0)
  {
    return nearest_of_far;
  }
  const double far_w = start / (1.0 + slope);
  const double near_w = nearest_of_far * far_w;
  const double clip[4] = { 0.0, 0.0, start - slope * near_w, near_w };
  return far_w > 0.0 && isfinite(far_w) ? fmin(near_scale(clip), 1.0) : 1.0;
}

double water_mirror_near(
  const water_plane* plane, const water_prop* props, size_t prop_count, water_camera* mirrored)
{
  double world_to_clip[16];
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_clip);
  const double least = near_scale_min(mirrored->view_to_clip);
  double scale = 1.0;
  for (size_t i = 0; i < prop_count && scale > least; ++i)
  {
    const double* bounds = props[i].bounds;
    if (props[i].flags != WATER_PROP_VISIBLE || water_prop_is_unbounded(props + i) ||
      water_bounds_is_empty(bounds))
    {
      continue;
    }
    bool is_over = false;
    bool is_in_front = false;
    double own = 1.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      double point[3];
      double clip[4];
      water_bounds_corner(bounds, corner, point);
      water_mat4_apply_point(world_to_clip, point, clip);
      is_over = is_over || water_plane_height(plane, point) > 0.0;
      is_in_front = is_in_front || clip[3] > 0.0;
      own = clip[3] <= 0.0 ? least : clip[2] < -clip[3] ? fmin(own, near_scale(clip)) : own;
    }
    scale = is_over && is_in_front ? fmin(scale, own) : scale;
  }
  scale = fmax(scale, least);
  double* clip = mirrored->view_to_clip;
  for (int j = 0; j < 4; ++j)
  {
    clip[8 + j] = scale * clip[8 + j] + (1.0 - scale) * clip[12 + j];
  }
  return scale;
}

void water_mirror_pose(
  const water_camera* mirrored, double position[3], double focal_point[3], double view_up[3])
{
  const double* view = mirrored->world_to_view;
  const double origin[3] = { view[3], view[7], view[11] };
  for (int i = 0; i < 3; ++i)
  {
    // the rows of a rigid view are its axes in world, and its inverse is its transpose
    const double column[3] = { view[i], view[4 + i], view[8 + i] };
    position[i] = -water_vec3_dot(column, origin);
    focal_point[i] = position[i] - view[8 + i];
    view_up[i] = view[4 + i];
  }
}

void water_mirror_clip_view(const double plane_view[4], double margin, double clip_plane_view[4])
{
  // V'^-1 = R V^-1 Fx, and the mirror turns a plane into its negative: -(plane_view Fx).
  clip_plane_view[0] = plane_view[0];
  clip_plane_view[1] = -plane_view[1];
  clip_plane_view[2] = -plane_view[2];
  clip_plane_view[3] = margin - plane_view[3];
}

water_status water_mirror_clip_clip(
  const double view_to_clip[16], const double clip_plane_view[4], double clip_plane_clip[4])
{
  double clip_to_view[16];
  if (!water_mat4_invert(view_to_clip, clip_to_view))
  {
    return WATER_BAD_CAMERA;
  }
  water_mat4_apply_row(clip_plane_view, clip_to_view, clip_plane_clip); // a plane is a row vector
  return WATER_OK;
}

static const double in_plane = 5e-7; // of the distance: four roundings of a float

void water_mirror_clip_position(const double view_to_clip[16], const double clip_plane_clip[4],
  double position[4], double* constant)
{
  memcpy(position, clip_plane_clip, 4 * sizeof position[0]);
  *constant = 0.0;
  const double* z = &view_to_clip[8];
  const double* w = &view_to_clip[12];
  if (z[0] == 0.0 && z[1] == 0.0 && w[0] == 0.0 && w[1] == 0.0 && w[2] != 0.0 && w[3] == 0.0)
  {
    // z = z[2] w / w[2] + z[3]
    position[2] = 0.0;
    position[3] += clip_plane_clip[2] * z[2] / w[2] + in_plane;
    *constant = clip_plane_clip[2] * z[3];
  }
}

void water_mirror_clip_window(
  const double clip_plane_clip[4], const int texture_px[2], double clip_plane_window[4])
{
  // Clip w is positive in front of the camera, so the division by it leaves the sign alone.
  double plane[4];
  memcpy(plane, clip_plane_clip, sizeof plane);
  plane[3] -= plane[0] + plane[1] + plane[2]; // NDC = 2 * window / size - 1
  plane[0] *= 2.0 / texture_px[0];
  plane[1] *= 2.0 / texture_px[1];
  plane[2] *= 2.0;
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    largest = fmax(largest, fabs(plane[i]));
  }
  for (int i = 0; i < 4; ++i)
  {
    clip_plane_window[i] = plane[i] / largest;
  }
}

water_status water_mirror_clip_plan(const water_plane* plane, double margin, water_plan* plan)
{
  double to_world[16] = { 0.0 };
  const double clip[4] = { plane->normal[0], plane->normal[1], plane->normal[2],
    plane->offset + margin };
  memcpy(plan->clip_plane_world, clip, sizeof clip);
  (void)water_mat4_invert_affine(plan->mirrored.world_to_view, to_world); // it is rigid
  water_mat4_apply_row(clip, to_world, plan->clip_plane_view);
  const water_status status = water_mirror_clip_clip(
    plan->mirrored.view_to_clip, plan->clip_plane_view, plan->clip_plane_clip);
  if (status == WATER_OK)
  {
    water_mirror_clip_window(plan->clip_plane_clip, plan->texture_px, plan->clip_plane_window);
  }
  return status;
}

void water_mirror_texture_matrix(const water_camera* mirrored, double world_to_texture[16])
{
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_texture);
  for (int j = 0; j < 12; ++j)
  {
    world_to_texture[j] = 0.5 * (world_to_texture[j] + world_to_texture[12 + j % 4]);
  }
}

void water_mirror_headlight(
  const double plane_view[4], double headlight_dir[3], double headlight_position[3])
{
  // V' V^-1 = Fx (I - 2 n n^T) for directions, n the normal in view space, applied to (0, 0, -1).
  const double twice = 2.0 * plane_view[2];
  const double dir[3] = { -twice * plane_view[0], twice * plane_view[1],
    twice * plane_view[2] - 1.0 };
  const double length = water_vec3_length(dir);
  for (int i = 0; i < 3; ++i)
  {
    headlight_dir[i] = dir[i] / length;
    // and for points Fx (x - 2 h(x) n), applied to the eye, (0, 0, 0), at height plane_view[3]
    headlight_position[i] = (i == 0 ? 2.0 : -2.0) * plane_view[3] * plane_view[i];
  }
}

void water_mirror_headlight_of(const water_eye* eye, const water_camera* mirrored,
  double headlight_dir[3], double headlight_position[3])
{
  const double* world = eye->view_to_world;
  const double ahead[3] = { -world[2], -world[6], -world[10] };
  const double position[3] = { world[3], world[7], world[11] };
  double dir[4];
  double place[4];
  water_mat4_apply_dir(mirrored->world_to_view, ahead, dir);
  water_mat4_apply_point(mirrored->world_to_view, position, place);
  const double length = water_vec3_length(dir);
  for (int i = 0; i < 3; ++i)
  {
    headlight_dir[i] = dir[i] / length;
    headlight_position[i] = place[i];
  }
}

void water_mirror_reflection_to_eye(const water_camera* camera, const water_eye* eye,
  const double plane_view[4], const double reflection_scale[2], double reflection_ndc_to_eye[9])
{
  const double* to_clip = camera->view_to_clip;
  const int rows[3] = { 0, 1, 3 };
  for (int j = 0; j < 3; ++j)
  {
    // what the reflection texture sees at (x, y) is what the eye sees at (-x, y), reflected at the
    // plane
    double dir[3];
    for (int k = 0; k < 3; ++k)
    {
      dir[k] = j == 0 ? -eye->ndc_to_dir[3 * k] : eye->ndc_to_dir[3 * k + j];
      dir[k] /= j < 2 ? reflection_scale[j] : 1.0;
    }
    const double twice = 2.0 * water_vec3_dot(plane_view, dir);
    for (int k = 0; k < 3; ++k)
    {
      dir[k] -= twice * plane_view[k];
    }
    for (int i = 0; i < 3; ++i)
    {
      reflection_ndc_to_eye[3 * i + j] = water_vec3_dot(to_clip + 4 * rows[i], dir);
    }
  }
}

water_status water_mirror_reflection_to(
  const water_camera* camera, const water_camera* mirrored, double reflection_ndc_to_eye[9])
{
  water_eye eye;
  const water_status status = water_camera_decompose(mirrored, &eye);
  for (int j = 0; j < 3 && status == WATER_OK; ++j)
  {
    const double dir[3] = { eye.ndc_to_dir[j], eye.ndc_to_dir[3 + j], eye.ndc_to_dir[6 + j] };
    double world[4];
    double clip[4];
    water_mat4_apply_dir(eye.view_to_world, dir, world);
    water_mat4_apply_dir(camera->world_to_view, world, clip);
    water_mat4_apply(camera->view_to_clip, clip, clip);
    reflection_ndc_to_eye[j] = clip[0];
    reflection_ndc_to_eye[3 + j] = clip[1];
    reflection_ndc_to_eye[6 + j] = clip[3];
  }
  return status;
}
