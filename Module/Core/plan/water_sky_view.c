// SPDX-License-Identifier: BSD-3-Clause
// water_sky_view.c: the wide camera, what may be the sky in it, and how its shader finds a point.
#include "water_sky_view.h"

#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"
#include "water_prop.h"
#include "water_select.h"
#include "water_target.h"

static const double widest = 2.75;        // tangent of half of its angle
static const double under_horizon = 0.05; // tangent
static const double near_part = 1e-3;     // of the far plane's distance
static const double rim_part = 0.01; // of that distance: the view shows so much under the plane
static const double beyond = 1.01;   // the far plane, over the distance of all props

void water_sky_view_camera(const double at[3], const double ahead[3], const double normal[3],
  double far, water_camera* camera)
{
  double right[3];
  water_vec3_cross(ahead, normal, right);
  const double flat = water_vec3_length(right);
  if (flat < 1e-6) // straight up: any direction is to the right
  {
    const int least = fabs(normal[0]) < 0.6 ? 0 : 1;
    double axis[3] = { 0.0, 0.0, 0.0 };
    axis[least] = 1.0;
    water_vec3_cross(ahead, axis, right);
  }
  const double length = water_vec3_length(right);
  double* view = camera->world_to_view;
  for (int i = 0; i < 3; ++i)
  {
    view[i] = right[i] / length;
    view[8 + i] = -ahead[i];
  }
  water_vec3_cross(view + 8, view, view + 4);
  for (int i = 0; i < 3; ++i)
  {
    view[4 * i + 3] = -water_vec3_dot(view + 4 * i, at);
    view[12 + i] = 0.0;
  }
  view[15] = 1.0;
  const double rise = fmax(water_vec3_dot(ahead, normal), 0.0);
  const double bottom = fmin(rise / fmax(flat, 1e-6) + under_horizon, widest);
  const double z_near = near_part * far;
  double* clip = camera->view_to_clip;
  memset(clip, 0, 16 * sizeof *clip);
  clip[0] = 1.0 / widest;
  clip[5] = 2.0 / (widest + bottom);
  clip[6] = (widest - bottom) / (widest + bottom);
  clip[10] = -(far + z_near) / (far - z_near);
  clip[11] = -2.0 * far * z_near / (far - z_near);
  clip[14] = -1.0;
}

static bool may_be_sky(const water_plane* plane, const water_eye* eye, const water_prop* prop,
  const water_cull_reason* reason)
{
  return water_lookup_is_enclosed(plane, eye, prop, 1, reason);
}

// Window depth of the farthest corner in front of the camera.
static double farthest_depth(const double world_to_clip[16], const double bounds[6])
{
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double point[3];
    double clip[4];
    water_bounds_corner(bounds, corner, point);
    water_mat4_apply_point(world_to_clip, point, clip);
    farthest = clip[3] > 0.0 ? fmax(farthest, 0.5 + 0.5 * clip[2] / clip[3]) : farthest;
  }
  return fmin(farthest, 1.0);
}

void water_sky_view_rest(const water_camera* mirrored, const water_plane* plane,
  const water_eye* eye, const water_prop* props, size_t prop_count,
  const water_cull_reason* reasons, double* top, double* depth)
{
  double world_to_clip[16];
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_clip);
  *top = *depth = 0.0;
  for (size_t i = 0; i < prop_count; ++i)
  {
    if (reasons[i] == WATER_CULL_NONE && !may_be_sky(plane, eye, props + i, reasons + i))
    {
      *top = fmax(*top, water_lookup_top(plane, props + i, 1, reasons + i));
      *depth = water_prop_is_unbounded(props + i)
        ? 1.0
        : fmax(*depth, farthest_depth(world_to_clip, props[i].bounds));
    }
  }
}

// Chooses what may be the sky. Returns the distance of the farthest corner from a point; 0: there
// is nothing.
static double select_sky(const water_scene* scene, const water_eye* eye, const water_plane* plane,
  const double at[3], water_cull_reason* reasons)
{
  water_selection selection;
  memset(&selection, 0, sizeof selection);
  selection.is_off = true;
  double farthest = 0.0;
  (void)water_select_props(
    &scene->eye, plane, &selection, scene->props, scene->prop_count, reasons);
  for (size_t i = 0; i < scene->prop_count; ++i)
  {
    if (reasons[i] != WATER_CULL_NONE)
    {
      continue;
    }
    if (!may_be_sky(plane, eye, scene->props + i, reasons + i))
    {
      reasons[i] = WATER_CULL_OUT_OF_WATER;
      continue;
    }
    double away[3];
    for (int j = 0; j < 3; ++j)
    {
      const double* bounds = scene->props[i].bounds + 2 * j;
      away[j] = fmax(fabs(bounds[0] - at[j]), fabs(bounds[1] - at[j]));
    }
    farthest = fmax(farthest, water_vec3_length(away));
  }
  return farthest;
}

// Where the view is from, in the plane's axes from the point under the eye, and its direction
// there: from that point, or, of a parallel eye, from the water in the middle of the picture. A
// place in the plane sees a floor there from its side only.
static void place_camera(
  const water_eye* eye, const double box[4], const water_plan* plan, double at[3], double ahead[3])
{
  double middle[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 2; ++i)
  {
    middle[i] = 0.5 * (fmax(box[i], -1.0) + fmin(box[2 + i], 1.0));
  }
  double place[3];
  for (int i = 0; i < 3; ++i)
  {
    ahead[i] = water_vec3_dot(plan->ndc_to_ray + 3 * i, middle);
    place[i] = water_vec3_dot(plan->ndc_to_plane + 3 * i, middle);
  }
  ahead[2] = fabs(ahead[2]);
  const double length = water_vec3_length(ahead);
  for (int i = 0; i < 3; ++i)
  {
    ahead[i] /= length;
  }
  at[0] = at[1] = at[2] = 0.0;
  if (!eye->has_center && place[2] != 0.0)
  {
    at[0] = place[0] / place[2];
    at[1] = place[1] / place[2];
  }
}

static void to_world(
  const water_axes* axes, const double origin_xy[2], const double local[3], double world[3])
{
  for (int i = 0; i < 3; ++i)
  {
    world[i] = axes->origin[i] + (origin_xy[0] + local[0]) * axes->x_dir[i] +
      (origin_xy[1] + local[1]) * axes->y_dir[i] + local[2] * axes->normal[i];
  }
}

// What its shader needs; the camera is set.
static void fill_lookup(const water_axes* axes, water_plan* plan)
{
  double dir_to_clip[12];
  const double* clip = plan->mirrored.view_to_clip;
  water_lookup_dirs(&plan->mirrored, axes, dir_to_clip);
  memcpy(plan->sky_view_dirs, dir_to_clip, 6 * sizeof *dir_to_clip);
  memcpy(plan->sky_view_dirs + 6, dir_to_clip + 9, 3 * sizeof *dir_to_clip);
  plan->sky_view_near[0] = 2.0 / clip[11];
  plan->sky_view_near[1] = (clip[10] - 1.0) / clip[11];
}

water_status water_sky_view_plan(const water_scene* scene, const water_plane* plane,
  const water_axes* axes, double margin, const double box[4], water_plan* plan,
  water_cull_reason* reasons)
{
  water_eye eye;
  water_status status = water_camera_decompose(&scene->eye, &eye);
  if (status != WATER_OK)
  {
    return status;
  }
  double ahead[3];
  double at[3];
  static const double none[2] = { 0.0, 0.0 };
  place_camera(&eye, box, plan, plan->sky_view_at, ahead);
  to_world(axes, plan->origin_xy, plan->sky_view_at, at);
  water_axes turned = *axes;
  memset(turned.origin, 0, sizeof turned.origin);
  double ahead_world[3];
  to_world(&turned, none, ahead, ahead_world);
  const double far = beyond * select_sky(scene, &eye, plane, at, reasons);
  const bool is_wanted = scene->has_waves && plan->side == WATER_ABOVE && far > 0.0;
  plan->decision = is_wanted ? WATER_REFLECT : WATER_NO_REFLECT_OUT_OF_VIEW;
  if (!is_wanted)
  {
    return WATER_OK;
  }
  water_sky_view_camera(at, ahead_world, axes->normal, far, &plan->mirrored);
  const int longest = scene->viewport_px[scene->viewport_px[0] < scene->viewport_px[1] ? 1 : 0];
  const int square[2] = { longest, longest };
  status = water_target_size(
    square, scene->settings.texture_scale, scene->max_texture_px, plan->texture_px);
  const int whole[4] = { 0, 0, plan->texture_px[0], plan->texture_px[1] };
  memcpy(plan->texture_rect_px, whole, sizeof whole);
  plan->reflection_scale[0] = plan->reflection_scale[1] = plan->depth_scale = 1.0;
  plan->is_software = scene->is_software;
  plan->is_enclosed = true;
  fill_lookup(axes, plan);
  water_mirror_pose(
    &plan->mirrored, plan->mirrored_position, plan->mirrored_focal_point, plan->mirrored_view_up);
  water_eye picture = eye;
  if (status == WATER_OK && scene->picture_eye)
  {
    status = water_camera_decompose(scene->picture_eye, &picture);
  }
  water_mirror_headlight_of(
    &picture, &plan->mirrored, plan->headlight_dir, plan->headlight_position);
  if (status == WATER_OK)
  {
    status = water_mirror_reflection_to(scene->picture_eye ? scene->picture_eye : &scene->eye,
      &plan->mirrored, plan->reflection_ndc_to_eye);
  }
  return status == WATER_OK ? water_mirror_clip_plan(plane, margin + rim_part * far, plan) : status;
}
