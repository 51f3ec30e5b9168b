// SPDX-License-Identifier: BSD-3-Clause
// water_sun_view.c: the projection along the sun's rays, and what casts shadows in it.
#include "water_sun_view.h"

#include "water_camera.h"
#include "water_lookup.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"
#include "water_prop.h"
#include "water_select.h"
#include "water_target.h"

// A lower sun lays things down farther away than any picture shows: 0.06 degrees.
static const double lowest_sine = 1e-3;

// So many times as far away as the highest thing is high: mappers that draw spheres and tubes on
// squares look along rays from the camera, which are the sun's then.
static const double far_away = 100.0;

// Of the nearest water's w: waves may come nearer than the plane.
static const double nearer = 0.5;

// A camera that looks along the sun's rays at a point.
static void look_down(const double at[3], const double to_sun[3], double way, double view[16])
{
  double axis[3] = { 0.0, 0.0, 0.0 };
  axis[fabs(to_sun[0]) < 0.6 ? 0 : 1] = 1.0; // any that is not along the rays
  double right[3];
  double up[3];
  water_vec3_cross(axis, to_sun, right);
  const double length = water_vec3_length(right);
  for (int i = 0; i < 3; ++i)
  {
    right[i] /= length;
  }
  water_vec3_cross(to_sun, right, up);
  memcpy(view, right, sizeof right);
  memcpy(view + 4, up, sizeof up);
  memcpy(view + 8, to_sun, 3 * sizeof *to_sun);
  view[3] = -water_vec3_dot(right, at);
  view[7] = -water_vec3_dot(up, at);
  view[11] = -water_vec3_dot(to_sun, at) - way;
  memset(view + 12, 0, 3 * sizeof *view);
  view[15] = 1.0;
}

void water_sun_view_camera(const water_camera* eye, const double view_to_world[16],
  const water_plane* plane, const double to_sun[3], double bottom, double top, double nearest_w,
  water_camera* camera, double* depth)
{
  const double* n = plane->normal;
  const double sine = fmax(water_vec3_dot(n, to_sun), lowest_sine);
  const double height[4] = { n[0], n[1], n[2], plane->offset };
  double lay_down[16]; // a point, minus its height over the sine, along the way to the sun
  for (int i = 0; i < 16; ++i)
  {
    const double down = i < 12 ? to_sun[i / 4] * height[i % 4] / sine : 0.0;
    lay_down[i] = (i % 5 == 0 ? 1.0 : 0.0) - down;
  }
  double world_to_clip[16];
  double laid[16];
  water_mat4_multiply(eye->view_to_clip, eye->world_to_view, world_to_clip);
  water_mat4_multiply(world_to_clip, lay_down, laid);
  const double scale = nearer * nearest_w / (bottom + top);
  for (int i = 0; i < 4; ++i)
  {
    laid[8 + i] = laid[12 + i] - 2.0 * scale * (height[i] + (i == 3 ? bottom : 0.0));
  }
  const double at[3] = { view_to_world[3], view_to_world[7], view_to_world[11] };
  const double way = far_away * (fabs(water_plane_height(plane, at)) + bottom + top);
  water_camera made = *eye;
  double from_sun[16] = { 0.0 };
  look_down(at, to_sun, way, made.world_to_view);
  (void)water_mat4_invert_affine(made.world_to_view, from_sun); // it is rigid
  water_mat4_multiply(laid, from_sun, made.view_to_clip);
  *camera = made;
  *depth = scale;
}

// Chooses the props, and leaves out the sky and what may be it: things without bounds, and around
// the eye. Returns how high over the plane they reach; 0: there are none.
static double select_casters(const water_scene* scene, const water_eye* eye,
  const water_plane* plane, const water_camera* camera, const water_selection* selection,
  water_cull_reason* reasons)
{
  double top = 0.0;
  (void)water_select_props(camera, plane, selection, scene->props, scene->prop_count, reasons);
  for (size_t i = 0; i < scene->prop_count; ++i)
  {
    const water_prop* prop = scene->props + i;
    if (reasons[i] == WATER_CULL_NONE &&
      (water_prop_is_unbounded(prop) || water_lookup_is_enclosed(plane, eye, prop, 1, reasons + i)))
    {
      reasons[i] = WATER_CULL_OUT_OF_WATER;
    }
    top = fmax(top, water_lookup_top(plane, prop, 1, reasons + i));
  }
  return top;
}

// w of the nearest water in the picture: 1 / w changes evenly over it.
static double nearest_of(const water_plan* plan, const double box[4])
{
  const double* plane = plan->plane_clip;
  double most = 0.0; // 1 / w
  for (int i = 0; i < 4; ++i)
  {
    const double x = fmin(fmax(box[i & 1 ? 2 : 0], -1.0), 1.0);
    const double y = fmin(fmax(box[i & 2 ? 3 : 1], -1.0), 1.0);
    const double ndc[4] = { x, y, -(plane[0] * x + plane[1] * y + plane[3]) / plane[2], 1.0 };
    most = fmax(most, water_vec4_dot(plan->clip_w, ndc)); // NaN says nothing
  }
  return most > 0.0 ? 1.0 / most : 1.0;
}

static water_status fill_camera(const water_scene* scene, const water_eye* eye,
  const water_plane* plane, double margin, const double box[4], double top, water_plan* plan)
{
  double to_sun[3];
  const double length = water_vec3_length(scene->sun_dir);
  for (int i = 0; i < 3; ++i)
  {
    to_sun[i] = scene->sun_dir[i] / length;
  }
  water_sun_view_camera(&scene->eye, eye->view_to_world, plane, to_sun, margin, top,
    nearest_of(plan, box), &plan->mirrored, &plan->sun_view_depth);
  plan->sun_view_bottom = margin;
  water_mirror_pose(
    &plan->mirrored, plan->mirrored_position, plan->mirrored_focal_point, plan->mirrored_view_up);
  return water_mirror_clip_plan(plane, margin, plan);
}

water_status water_sun_view_plan(const water_scene* scene, const water_plane* plane, double margin,
  const double box[4], water_plan* plan, water_cull_reason* reasons)
{
  static const double whole[4] = { -1.0, -1.0, 1.0, 1.0 };
  water_eye eye;
  water_status status = water_camera_decompose(&scene->eye, &eye);
  if (status == WATER_OK)
  {
    status = water_target_size(scene->viewport_px, 1.0, scene->max_texture_px, plan->texture_px);
  }
  if (status != WATER_OK)
  {
    return status;
  }
  plan->reflection_scale[0] = plan->reflection_scale[1] = plan->depth_scale = 1.0;
  plan->is_software = scene->is_software;
  memset(&plan->sky, 0, sizeof plan->sky); // only depths are drawn
  plan->headlight_dir[2] = -1.0;
  // waves are looked up where the plane is below or above them, which may be elsewhere
  const bool is_level = scene->is_flat && (scene->settings.skips & WATER_MAY_SKIP_PIXELS);
  water_target_rect_of_eye(
    is_level ? box : whole, plan->reflection_scale, plan->texture_px, plan->texture_rect_px);
  water_selection selection;
  memset(&selection, 0, sizeof selection);
  selection.is_off = true;
  const double top = select_casters(scene, &eye, plane, &scene->eye, &selection, reasons);
  const bool has_sun = plan->has_sun && plan->side == WATER_ABOVE;
  plan->decision = has_sun && top > 0.0 ? WATER_REFLECT : WATER_NO_REFLECT_OUT_OF_VIEW;
  if (plan->decision != WATER_REFLECT)
  {
    return WATER_OK;
  }
  status = fill_camera(scene, &eye, plane, margin, box, top, plan);
  selection.is_off = !(scene->settings.skips & WATER_MAY_SKIP_PROPS);
  selection.margin = margin;
  memcpy(selection.texture_px, plan->texture_px, sizeof selection.texture_px);
  water_rect_to_ndc(plan->texture_rect_px, plan->texture_px, selection.box);
  if (status == WATER_OK &&
    select_casters(scene, &eye, plane, &plan->mirrored, &selection, reasons) <= 0.0)
  {
    plan->decision = WATER_NO_REFLECT_OUT_OF_VIEW; // what casts any casts it elsewhere
  }
  return status;
}
