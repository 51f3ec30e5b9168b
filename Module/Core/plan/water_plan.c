// SPDX-License-Identifier: BSD-3-Clause
// water_plan.c: the order of the steps, and nothing else: check, decide, view, mirror, target,
// select, clip, shade. The mirrored view in water_plan_draw.c; revised in water_plan_revise.c.
#include "water_plan.h"

#include "water_beyond.h"
#include "water_camera.h"
#include "water_daylight.h"
#include "water_horizon.h"
#include "water_lookup.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_optics.h"
#include "water_plan_draw.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_sky.h"
#include "water_sky_view.h"
#include "water_sun_view.h"
#include "water_target.h"

// The eye's side of the surface itself, where there is one over or under the eye, and of the plane
// elsewhere.
static void select_side(const water_scene* scene, water_plan_checked* result)
{
  const water_plane given = result->plane;
  water_select_level(&result->eye, &given, &result->plane, &result->side);
  result->level = result->plane;
  result->is_at_surface = water_lookup_is_at_surface(
    &scene->eye, &result->eye, &result->plane, scene->is_endless ? NULL : scene->surface_bounds);
  if (result->is_at_surface && scene->surface_height != 0.0)
  {
    result->level.offset -= scene->surface_height;
    result->side = WATER_ABOVE;
    // an eye on the very surface is on both sides, and stays over it
    (void)water_select_side(&result->eye, &result->level, &result->side);
  }
}

// Is it the mirrored view that is planned?
static bool is_mirrored(const water_scene* scene)
{
  return !scene->is_beyond && !scene->is_from_sun && !scene->is_of_sky;
}

// All checks but that of the props, in the order of water_status.h.
static water_status check(const water_scene* scene, water_plan_checked* result)
{
  water_status status = water_plane_normalise(&scene->plane, &result->plane);
  if (status != WATER_OK)
  {
    return status;
  }
  if (!scene->is_endless &&
    (!water_all_usable(scene->surface_bounds, 6) || water_bounds_is_empty(scene->surface_bounds)))
  {
    return WATER_BAD_SURFACE;
  }
  const double texture_scale = is_mirrored(scene) ? scene->settings.texture_scale : 1.0;
  status =
    water_target_size(scene->viewport_px, texture_scale, scene->max_texture_px, result->texture_px);
  if (status != WATER_OK)
  {
    return status;
  }
  if (!(scene->settings.clip_margin >= 0.0 && scene->settings.clip_margin <= water_largest &&
        scene->wave_height_max >= 0.0 && scene->wave_height_max <= water_largest &&
        fabs(scene->surface_height) <= water_largest))
  {
    return WATER_BAD_CLIP_MARGIN;
  }
  if (!(scene->settings.prop_px_min >= 0.0))
  {
    return WATER_BAD_PROP_SIZE;
  }
  if (!(scene->settings.reflectance_error >= 0.0 && scene->settings.reflectance_error <= 1.0))
  {
    return WATER_BAD_REFLECTANCE_ERROR;
  }
  status = water_optics_check(&scene->look);
  if (status != WATER_OK)
  {
    return status;
  }
  status = water_camera_decompose(&scene->eye, &result->eye);
  if (status == WATER_OK && scene->picture_eye)
  {
    status = water_camera_decompose(scene->picture_eye, &result->picture);
  }
  if (status != WATER_OK)
  {
    return status;
  }
  select_side(scene, result);
  return WATER_OK;
}

// May any of the surface be in the picture? Nothing of an endless one is over the eye.
static bool is_in_view(const water_scene* scene, const water_plan_checked* input)
{
  double box[4];
  return scene->is_endless
    ? water_horizon_box(&input->eye, &input->plane, input->side, scene->wave_height_max, box)
    : water_select_is_in_view(&scene->eye, scene->surface_bounds);
}

static water_decision decide(const water_scene* scene, const water_plan_checked* input)
{
  const water_side side = input->side;
  if (side == WATER_EDGE_ON)
  {
    return WATER_NO_REFLECT_EDGE_ON;
  }
  if (scene->look.constant_reflectance && scene->look.reflectance == 0.0 && is_mirrored(scene))
  {
    return WATER_NO_REFLECT_NO_REFLECTANCE;
  }
  if (scene->settings.skips & WATER_MAY_SKIP_UNSEEN)
  {
    if (side == WATER_BELOW ? scene->hides_below : scene->hides_above)
    {
      return WATER_NO_REFLECT_FACING_AWAY;
    }
    if (!is_in_view(scene, input))
    {
      return WATER_NO_REFLECT_OUT_OF_VIEW;
    }
  }
  if (scene->is_hidden && (scene->settings.skips & WATER_MAY_SKIP_HIDDEN))
  {
    return WATER_NO_REFLECT_HIDDEN;
  }
  return scene->has_environment && is_mirrored(scene) ? WATER_NO_REFLECT_ENVIRONMENT
                                                      : WATER_REFLECT;
}

// Which part of the picture the water covers. false: none of what counts of the picture.
static bool cover(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, double box[4])
{
  static const double whole[4] = { -1.0, -1.0, 1.0, 1.0 };
  double counted[4];
  if (!scene->is_endless)
  {
    water_target_box(&scene->eye, plane, scene->surface_bounds, box);
  }
  else if (!water_horizon_box(&input->eye, &input->plane, input->side, scene->wave_height_max, box))
  {
    memcpy(box, whole, sizeof whole); // it is drawn although nothing of it is seen
  }
  if (!scene->viewport_rect_px)
  {
    return true;
  }
  water_rect_to_ndc(scene->viewport_rect_px, scene->viewport_px, counted);
  for (int i = 0; i < 2; ++i)
  {
    box[i] = fmax(box[i], counted[i]);
    box[2 + i] = fmin(box[2 + i], counted[2 + i]);
  }
  return box[0] < box[2] && box[1] < box[3];
}

// box: of the picture that the water covers
static bool is_faint(const water_scene* scene, const water_plan_checked* input,
  const water_plan* plan, const double box[4])
{
  return (scene->settings.skips & WATER_MAY_SKIP_FAINT) && is_mirrored(scene) &&
    scene->settings.reflectance_error > 0.0 &&
    water_optics_reflectance_max(&scene->look, plan->eta, plan->ndc_to_ray, box,
      scene->has_waves ? scene->slope_max : 0.0) <= scene->settings.reflectance_error &&
    input->side == WATER_ABOVE;
}

// Whether the part of the picture that the water covers is worth a mirrored view.
//
// box  that part
static water_decision decide_by_cover(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, const water_plan* plan, double box[4])
{
  if (!cover(scene, input, plane, box) && (scene->settings.skips & WATER_MAY_SKIP_UNSEEN))
  {
    return WATER_NO_REFLECT_OUT_OF_VIEW;
  }
  return is_faint(scene, input, plan, box) ? WATER_NO_REFLECT_FAINT : WATER_REFLECT;
}

// plane: normal towards the eye.
static water_status fill_view(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, const water_axes* axes, water_plan* plan)
{
  water_camera_plane_view(&input->eye, plane, plan->plane_view);
  water_mat4_apply_dir(scene->eye.world_to_view, plane->normal, plan->normal_clip);
  water_mat4_apply(scene->eye.view_to_clip, plan->normal_clip, plan->normal_clip);
  water_mat4_apply_row(plan->plane_view, input->eye.clip_to_view, plan->plane_clip);
  memcpy(plan->clip_w, input->eye.clip_to_view + 12, sizeof plan->clip_w);
  water_lookup_pixel_depth(plan->plane_clip, plan->clip_w, plan->pixel_depth);
  water_camera_rays(&input->eye, plane, axes->x_dir, axes->y_dir, plan->ndc_to_ray);
  water_lookup_dirs(scene->picture_eye ? scene->picture_eye : &scene->eye, axes, plan->dir_to_eye);
  water_sky_environment(
    scene->environment_up, scene->environment_right, axes, &plan->environment_map);
  water_sky_map_local(&scene->sky.map, axes, &plan->sky_map);
  const water_plane level = water_plane_turned(&input->level, input->side);
  double level_view[4];
  water_camera_plane_view(&input->eye, &level, level_view);
  water_mat4_apply_row(level_view, input->eye.clip_to_view, plan->surface_clip);
  plan->is_submerged = input->side == WATER_BELOW && input->is_at_surface;
  plan->is_endless = scene->is_endless;
  // no near plane cuts an endless surface
  plan->is_awash = input->side == WATER_ABOVE && input->is_at_surface && !scene->is_endless &&
    water_lookup_cuts_surface(&input->eye, level_view);
  plan->bed_depth = water_lookup_bottom(plane, scene->props, scene->prop_count);
  plan->has_sun = scene->has_sun && water_lookup_local(axes, scene->sun_dir, plan->sun_dir);
  for (int i = 0; i < 3 && plan->has_sun; ++i)
  {
    plan->sun_color[i] = scene->sun_diffuse[i] * scene->sun_intensity;
  }
  plan->sky = scene->sky;
  memcpy(plan->daylight, scene->light, sizeof plan->daylight);
  water_daylight_add_sky(&scene->sky, plan->daylight);
  plan->is_half_float = scene->settings.color_precision == WATER_COLOR_HALF_FLOAT ||
    (scene->settings.color_precision == WATER_COLOR_AUTOMATIC && scene->may_tone_map);
  plan->eta = water_optics_eta(&scene->look, input->side);
  const water_status status =
    water_lookup_places(&scene->eye, &input->eye, plane, axes, plan->origin_xy, plan->ndc_to_plane);
  water_sky_floor_local(&scene->sky.floor, axes, plan->origin_xy, &plan->sky_floor);
  return status;
}

// The view and the mirrored camera of the plan are set.
static water_status fill_shade(const water_scene* scene, const water_plan_checked* input,
  const water_axes* axes, water_plan* plan)
{
  if (scene->picture_eye)
  {
    // the mirrored camera is as rigid as the eye, and water_lookup_heights says what is wrong with
    // its projection
    (void)water_mirror_reflection_to(
      scene->picture_eye, &plan->mirrored, plan->reflection_ndc_to_eye);
  }
  else
  {
    water_mirror_reflection_to_eye(&scene->eye, &input->eye, plan->plane_view,
      plan->reflection_scale, plan->reflection_ndc_to_eye);
  }
  water_lookup_depths(&plan->mirrored, &plan->reflection_z_infinity, plan->reflection_tolerance);
  water_lookup_dirs(&plan->mirrored, axes, plan->dir_to_reflection);
  plan->reflection_texel = water_lookup_texel(plan->dir_to_reflection, plan->texture_px);
  const water_status status = water_lookup_heights(
    &plan->mirrored, plan->plane_view, plan->reflection_height, plan->reflection_w);
  water_lookup_waterline(plan->reflection_height, plan->texture_px, plan->reflection_waterline);
  return status;
}

// The mirrored view, the own view, the sun view, or the sky view.
static water_status fill_drawn_view(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, const water_axes* axes, const double box[4], water_plan* plan,
  water_cull_reason* reasons, size_t* bad_index)
{
  if (scene->is_beyond)
  {
    return water_beyond_plan(scene, box, plan, reasons, bad_index);
  }
  if (scene->is_from_sun)
  {
    *bad_index = scene->prop_count; // the mirrored view's plan tells of it
    return water_sun_view_plan(scene, plane, water_plan_drop(scene, plane), box, plan, reasons);
  }
  if (scene->is_of_sky)
  {
    *bad_index = scene->prop_count;
    return water_sky_view_plan(
      scene, plane, axes, water_plan_drop(scene, plane), box, plan, reasons);
  }
  const water_status status = water_plan_draw(scene, input, plane, box, plan, reasons, bad_index);
  return status == WATER_OK ? fill_shade(scene, input, axes, plan) : status;
}

// Are the matrices of a drawn view numbers? They are not if its range of depths has no inverse.
static bool is_drawable(const water_plan* plan)
{
  double world_to_texture[16];
  water_mirror_texture_matrix(&plan->mirrored, world_to_texture);
  return water_all_finite(world_to_texture, 16) && water_all_finite(plan->clip_plane_window, 4);
}

water_status water_plan_make(const water_scene* scene, water_plan* plan, water_cull_reason* reasons)
{
  water_plan made;
  water_plan_checked input;
  memset(&made, 0, sizeof made); // same scene, same plan: also in what is not set
  memset(&input, 0, sizeof input);
  made.decision = WATER_NO_REFLECT_FAILED;

  water_status status = check(scene, &input);
  water_status props_status = WATER_OK;
  if (status == WATER_OK)
  {
    made.decision = decide(scene, &input);
    made.side = input.side;
  }
  made.has_view = made.decision == WATER_REFLECT ||
    made.decision == WATER_NO_REFLECT_NO_REFLECTANCE ||
    made.decision == WATER_NO_REFLECT_ENVIRONMENT || water_decision_is_unseen(made.decision);
  if (made.has_view)
  {
    const water_plane plane = water_plane_turned(&input.plane, input.side);
    water_axes axes;
    water_lookup_axes(&input.plane, input.side, scene->plane_origin, &axes);
    status = fill_view(scene, &input, &plane, &axes, &made);
    double box[4];
    if (status == WATER_OK && made.decision == WATER_REFLECT)
    {
      made.decision = decide_by_cover(scene, &input, &plane, &made, box);
    }
    if (status == WATER_OK && made.decision == WATER_REFLECT)
    {
      size_t bad_index = 0;
      status = fill_drawn_view(scene, &input, &plane, &axes, box, &made, reasons, &bad_index);
      if (bad_index < scene->prop_count)
      {
        made.bad_index = bad_index;
        props_status = WATER_BAD_PROP_BOUNDS;
      }
      status = status == WATER_OK && !is_drawable(&made) ? WATER_BAD_CAMERA : status;
    }
    if (water_decision_is_unseen(made.decision))
    {
      // an eye in it sees the water wherever it looks
      made.has_view = made.is_submerged || made.is_awash;
    }
    if (status != WATER_OK)
    {
      made.decision = WATER_NO_REFLECT_FAILED;
      made.has_view = false;
    }
  }
  made.rolls_off = !scene->may_tone_map;
  made.is_sky_known = isfinite(made.reflection_top) && !made.is_enclosed;
  *plan = made;
  return status != WATER_OK ? status : props_status;
}

bool water_decision_is_unseen(water_decision decision)
{
  return decision == WATER_NO_REFLECT_OUT_OF_VIEW || decision == WATER_NO_REFLECT_HIDDEN ||
    decision == WATER_NO_REFLECT_FACING_AWAY;
}

bool water_plan_has_reflection(const water_plan* plan)
{
  return plan->decision == WATER_REFLECT || plan->decision == WATER_REUSE;
}
