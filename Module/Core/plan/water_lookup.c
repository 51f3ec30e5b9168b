// SPDX-License-Identifier: BSD-3-Clause
// water_lookup.c: places on the plane and rays in the reflection texture's window, for the shader.
#include "water_lookup.h"

#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"
#include "water_prop.h"

// What a filter reads beside a place, and what is rounded.
static const double horizon_margin_px = 2.0;

static const double dome_height = 0.25; // over the plane, of a dome's widest side; land is lower

static const double above_top = 0.1; // of the top: texels are coarse where rays are low

static const int few_rays = 4; // as WATER_FEW_RAYS of vtkWaterRaysFS.glsl

static const double foam_pattern = 2048.0; // m, after which all of its cells repeat
static const double foam_period = 12.0;    // s

static const double ray_contrast = 0.25; // of white, over the number of rays

// Rows x, y and w of the clip coordinates of a world vector (w 0: a direction).
static void picture_of(
  const water_camera* camera, const double vector[3], double w, double picture[3])
{
  const double world[4] = { vector[0], vector[1], vector[2], w };
  double view[4];
  double clip[4];
  water_mat4_apply(camera->world_to_view, world, view);
  water_mat4_apply(camera->view_to_clip, view, clip);
  picture[0] = clip[0];
  picture[1] = clip[1];
  picture[2] = clip[3];
}

void water_lookup_axes(
  const water_plane* plane, water_side side, const double origin[3], water_axes* axes)
{
  const double sign = side == WATER_BELOW ? -1.0 : 1.0;
  water_plane_axes(plane->normal, axes->x_dir, axes->y_dir);
  for (int i = 0; i < 3; ++i)
  {
    axes->normal[i] = sign * plane->normal[i];
    axes->origin[i] = origin[i];
  }
}

water_status water_lookup_places(const water_camera* camera, const water_eye* eye,
  const water_plane* plane, const water_axes* axes, double origin_xy[2], double ndc_to_plane[9])
{
  const double eye_view[4] = { eye->has_center ? eye->center_view[0] : 0.0,
    eye->has_center ? eye->center_view[1] : 0.0, eye->has_center ? eye->center_view[2] : 0.0, 1.0 };
  double foot[4];
  water_mat4_apply(eye->view_to_world, eye_view, foot);
  water_plane_project(plane, foot, foot);

  // columns: the pictures of the two axes and of the foot; the inverse leads back
  double columns[3][3];
  picture_of(camera, axes->x_dir, 0.0, columns[0]);
  picture_of(camera, axes->y_dir, 0.0, columns[1]);
  picture_of(camera, foot, 1.0, columns[2]);
  double rows[3][3]; // of the inverse, up to the determinant, which cancels
  water_vec3_cross(columns[1], columns[2], rows[0]);
  water_vec3_cross(columns[2], columns[0], rows[1]);
  water_vec3_cross(columns[0], columns[1], rows[2]);
  double largest = 0.0;
  for (int i = 0; i < 9; ++i)
  {
    largest = fmax(largest, fabs(rows[i / 3][i % 3]));
  }
  if (!(largest > 0.0) || !isfinite(largest) || water_vec3_length(rows[2]) == 0.0)
  {
    return WATER_BAD_CAMERA;
  }
  for (int i = 0; i < 9; ++i)
  {
    ndc_to_plane[i] = rows[i / 3][i % 3] / largest;
  }
  const double from_origin[3] = { foot[0] - axes->origin[0], foot[1] - axes->origin[1],
    foot[2] - axes->origin[2] };
  origin_xy[0] = water_vec3_dot(from_origin, axes->x_dir);
  origin_xy[1] = water_vec3_dot(from_origin, axes->y_dir);
  return WATER_OK;
}

void water_lookup_pixel_depth(
  const double plane_clip[4], const double clip_w[4], double pixel_depth[4])
{
  const bool is_perspective = clip_w[2] != 0.0;
  const double* row = is_perspective ? clip_w : plane_clip; // row . (x, y, z, 1) = 1 / w, or 0
  pixel_depth[0] = -row[0] / row[2];
  pixel_depth[1] = -row[1] / row[2];
  pixel_depth[2] = -row[3] / row[2];
  pixel_depth[3] = is_perspective ? 1.0 / row[2] : 0.0;
}

void water_lookup_dirs(const water_camera* camera, const water_axes* axes, double dir_to_clip[12])
{
  const double* directions[3] = { axes->x_dir, axes->y_dir, axes->normal };
  for (int j = 0; j < 3; ++j)
  {
    double clip[4];
    water_mat4_apply_dir(camera->world_to_view, directions[j], clip);
    water_mat4_apply(camera->view_to_clip, clip, clip);
    for (int i = 0; i < 4; ++i)
    {
      dir_to_clip[3 * i + j] = clip[i];
    }
  }
}

// Slope of the view ray at a place in NDC, upwards from the plane.
static double rise_of(const double ndc_to_ray[9], const double ndc[2])
{
  return ndc_to_ray[6] * ndc[0] + ndc_to_ray[7] * ndc[1] + ndc_to_ray[8];
}

static void add_place(const double ndc[2], double low[2], double high[2])
{
  for (int i = 0; i < 2; ++i)
  {
    low[i] = fmin(low[i], ndc[i]);
    high[i] = fmax(high[i], ndc[i]);
  }
}

static void under_horizon(const double ndc_to_ray[9], const int viewport_px[2], int rect_px[4])
{
  static const double corners[4][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 },
    { -1.0, 1.0 } };
  double low[2] = { 1.0, 1.0 };
  double high[2] = { -1.0, -1.0 };
  bool is_any = false;
  for (int i = 0; i < 4; ++i)
  {
    const double* next = corners[(i + 1) % 4];
    const double rise = rise_of(ndc_to_ray, corners[i]);
    const double rise_next = rise_of(ndc_to_ray, next);
    if (!(rise >= 0.0))
    {
      is_any = true;
      add_place(corners[i], low, high);
    }
    if ((rise < 0.0) != (rise_next < 0.0))
    {
      const double share = rise / (rise - rise_next);
      const double crossing[2] = { corners[i][0] + share * (next[0] - corners[i][0]),
        corners[i][1] + share * (next[1] - corners[i][1]) };
      add_place(crossing, low, high);
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    const double size = (double)viewport_px[i];
    const double first = fmax(floor(0.5 * (low[i] + 1.0) * size) - horizon_margin_px, 0.0);
    const double last = fmin(ceil(0.5 * (high[i] + 1.0) * size) + horizon_margin_px, size);
    rect_px[i] = is_any ? (int)first : 0;
    rect_px[2 + i] = is_any ? (int)(last - first) : 0;
  }
}

void water_lookup_pattern(const double origin_xy[2], double metres_per_unit, double pattern_xy[2])
{
  for (int i = 0; i < 2; ++i)
  {
    pattern_xy[i] = fmod(origin_xy[i] * metres_per_unit, foam_pattern);
  }
}

double water_lookup_pattern_turn(double time)
{
  const double turns = time / foam_period;
  return turns - floor(turns);
}

void water_lookup_under(
  const water_plan* plan, bool is_flat, const int viewport_px[2], int rect_px[4])
{
  if (is_flat && !plan->is_submerged && !plan->is_awash)
  {
    under_horizon(plan->ndc_to_ray, viewport_px, rect_px);
    return;
  }
  rect_px[0] = rect_px[1] = 0;
  rect_px[2] = viewport_px[0];
  rect_px[3] = viewport_px[1];
}

bool water_lookup_local(const water_axes* axes, const double dir[3], double local[3])
{
  const double length = water_vec3_length(dir);
  if (!(length > 0.0) || !isfinite(length))
  {
    return false;
  }
  local[0] = water_vec3_dot(dir, axes->x_dir) / length;
  local[1] = water_vec3_dot(dir, axes->y_dir) / length;
  local[2] = water_vec3_dot(dir, axes->normal) / length;
  return true;
}

void water_lookup_environment(
  const water_axes* axes, const double up[3], const double right[3], double dir_to_environment[9])
{
  double rows[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  double back[3];
  water_vec3_cross(right, up, back);
  const double back_length = water_vec3_length(back);
  const double up_length = water_vec3_length(up);
  if (back_length > 0.0 && isfinite(back_length) && isfinite(up_length))
  {
    for (int i = 0; i < 3; ++i)
    {
      rows[1][i] = up[i] / up_length;
      rows[2][i] = back[i] / back_length;
    }
    water_vec3_cross(rows[1], rows[2], rows[0]);
  }
  const double* local[3] = { axes->x_dir, axes->y_dir, axes->normal };
  for (int i = 0; i < 9; ++i)
  {
    dir_to_environment[i] = water_vec3_dot(rows[i / 3], local[i % 3]);
  }
}

bool water_lookup_is_at_surface(const water_camera* camera, const water_eye* eye,
  const water_plane* plane, const double surface_bounds[6])
{
  if (camera->parallel || !eye->has_center)
  {
    return false;
  }
  if (!surface_bounds)
  {
    return true;
  }
  const double center[4] = { eye->center_view[0], eye->center_view[1], eye->center_view[2], 1.0 };
  double foot[4];
  water_mat4_apply(eye->view_to_world, center, foot);
  water_plane_project(plane, foot, foot);
  for (int i = 0; i < 3; ++i)
  {
    // a flat box has no inside
    const double margin = 1e-6 * (1.0 + fabs(foot[i]));
    if (foot[i] < surface_bounds[2 * i] - margin || foot[i] > surface_bounds[2 * i + 1] + margin)
    {
      return false;
    }
  }
  return true;
}

bool water_lookup_cuts_surface(const water_eye* eye, const double plane_view[4])
{
  for (int corner = 0; corner < 4; ++corner)
  {
    const double clip[4] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0, -1.0, 1.0 };
    double view[4];
    water_mat4_apply(eye->clip_to_view, clip, view);
    // w is that of a point before the eye: positive
    if (water_vec3_dot(plane_view, view) + plane_view[3] * view[3] < 0.0)
    {
      return true;
    }
  }
  return false;
}

void water_lookup_depths(const water_camera* mirrored, double* z_infinity, double tolerance[2])
{
  const double* clip = mirrored->view_to_clip;
  const bool is_perspective = clip[14] != 0.0;
  *z_infinity = is_perspective ? 0.5 + 0.5 * clip[10] / clip[14] : 2.0;
  tolerance[0] = is_perspective ? 0.05 : 0.002;
  tolerance[1] = is_perspective ? 0.10 : 0.004;
}

water_status water_lookup_heights(const water_camera* mirrored, const double plane_view[4],
  double reflection_height[4], double reflection_w[4])
{
  double mirrored_view[4];
  water_mirror_clip_view(plane_view, 0.0, mirrored_view);
  const double w_view[4] = { 0.0, 0.0, 0.0, 1.0 };
  const water_status status =
    water_mirror_clip_clip(mirrored->view_to_clip, mirrored_view, reflection_height);
  return status == WATER_OK ? water_mirror_clip_clip(mirrored->view_to_clip, w_view, reflection_w)
                            : status;
}

double water_lookup_texel(const double dir_to_reflection[12], const int texture_px[2])
{
  const double x_px = 0.5 * dir_to_reflection[2] * texture_px[0];
  const double y_px = 0.5 * dir_to_reflection[5] * texture_px[1];
  return 1.0 / hypot(x_px, y_px);
}

void water_lookup_waterline(
  const double reflection_height[4], const int texture_px[2], double waterline[4])
{
  for (int i = 0; i < 2; ++i)
  {
    waterline[i] = 2.0 * reflection_height[i] / texture_px[i];
    waterline[2 + i] = texture_px[i];
  }
}

// Height over a plane of the highest corner of a prop's bounds: every product is the largest there,
// and so every rounded sum.
static double top_of(const water_plane* plane, const double bounds[6])
{
  double point[3];
  for (int j = 0; j < 3; ++j)
  {
    point[j] = bounds[2 * j + (plane->normal[j] > 0.0)];
  }
  return water_plane_height(plane, point);
}

double water_lookup_top(const water_plane* plane, const water_prop* props, size_t prop_count,
  const water_cull_reason* reasons)
{
  double top = 0.0;
  for (size_t i = 0; i < prop_count; ++i)
  {
    if (reasons[i] == WATER_CULL_NONE && water_prop_is_unbounded(props + i))
    {
      if ((props[i].flags & WATER_PROP_IS_SKY) == 0)
      {
        return (double)INFINITY;
      }
      continue;
    }
    const double height = top_of(plane, props[i].bounds);
    // the rarer first: half of the time is in the reasons
    if (height > top && reasons[i] == WATER_CULL_NONE)
    {
      top = height;
    }
  }
  return top;
}

double water_lookup_end(double top)
{
  return (1.0 + above_top) * top;
}

double water_lookup_bottom(const water_plane* plane, const water_prop* props, size_t prop_count)
{
  const water_plane down = { { -plane->normal[0], -plane->normal[1], -plane->normal[2] },
    -plane->offset };
  const uint32_t not_shown = WATER_PROP_IS_WATER | WATER_PROP_NO_BOUNDS | WATER_PROP_OVERLAY;
  double bottom = 0.0;
  for (size_t i = 0; i < prop_count; ++i)
  {
    const uint32_t flags = props[i].flags & (not_shown | WATER_PROP_VISIBLE);
    if (flags == WATER_PROP_VISIBLE && props[i].bounds[0] <= props[i].bounds[1])
    {
      bottom = fmax(bottom, top_of(&down, props[i].bounds)); // NaN says nothing
    }
  }
  return bottom;
}

double water_lookup_contrast(int rays)
{
  return ray_contrast / (rays > 1 ? rays : 1);
}

int water_lookup_calm_samples(int rays)
{
  return rays > few_rays ? 4 : 0;
}

bool water_lookup_is_enclosed(const water_plane* plane, const water_eye* eye,
  const water_prop* props, size_t prop_count, const water_cull_reason* reasons)
{
  const double* middle = eye->center_view;
  const double center[4] = { eye->has_center ? middle[0] : 0.0, eye->has_center ? middle[1] : 0.0,
    eye->has_center ? middle[2] : 0.0, 1.0 };
  double at[4];
  water_mat4_apply(eye->view_to_world, center, at);
  for (size_t i = 0; i < prop_count; ++i)
  {
    const double* bounds = props[i].bounds;
    // the rarest first
    if (at[0] > bounds[0] && at[0] < bounds[1] && at[1] > bounds[2] && at[1] < bounds[3] &&
      at[2] > bounds[4] && at[2] < bounds[5] && reasons[i] == WATER_CULL_NONE &&
      !water_prop_is_unbounded(props + i))
    {
      const double widest =
        fmax(bounds[1] - bounds[0], fmax(bounds[3] - bounds[2], bounds[5] - bounds[4]));
      if (top_of(plane, bounds) >= dome_height * widest)
      {
        return true;
      }
    }
  }
  return false;
}
