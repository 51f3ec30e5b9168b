// SPDX-License-Identifier: BSD-3-Clause
// water_plan.c: the order of the steps, and nothing else: check, decide, view, mirror, target,
// select, clip, shade. Revised in water_plan_revise.c.
#include "water_plan.h"

#include "water_beyond.h"
#include "water_camera.h"
#include "water_daylight.h"
#include "water_horizon.h"
#include "water_lookup.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_optics.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_sky.h"
#include "water_sky_view.h"
#include "water_sun_view.h"
#include "water_target.h"
#include "water_visibility.h"

// To find out what of the reflection texture is seen costs a look at every pixel of the rectangle,
// and the mirrored view must wait for the main one: worth it if a part of it is left out, and if
// the processor draws. A GPU would have nothing to do while its answer is waited for, and takes
// longer to find out than to draw. Measured (decision 009).
static const double visible_share = 0.9;

// The props go through all steps some at a time, while they are in the processor's nearest cache.
static const size_t props_at_once = 256;

// For reflection textures coarser than this, the looked-up cells are not determined: one of their
// cells covers too much of the picture to be searched.
static const double visibility_texture_scale = 0.25;

static const int default_samples_max = 8; // more is slow and not seen in a reflection

// What the checks compute on their way, for the steps to use.
typedef struct checked
{
  water_plane plane; // unit length, as the user turned it
  water_plane level; // the same, moved to the surface where the eye is
  water_eye eye;
  water_eye picture;  // the eye of the user's picture, if that is another one
  bool is_at_surface; // there is surface over the eye, or under it
  water_side side;
  int texture_px[2];
} checked;

// The eye's side of the surface itself, where there is one over or under the eye, and of the plane
// elsewhere.
static void select_side(const water_scene* scene, checked* result)
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
static water_status check(const water_scene* scene, checked* result)
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
static bool is_in_view(const water_scene* scene, const checked* input)
{
  double box[4];
  return scene->is_endless
    ? water_horizon_box(&input->eye, &input->plane, input->side, scene->wave_height_max, box)
    : water_select_is_in_view(&scene->eye, scene->surface_bounds);
}

static water_decision decide(const water_scene* scene, const checked* input)
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
static bool cover(
  const water_scene* scene, const checked* input, const water_plane* plane, double box[4])
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
static bool is_faint(
  const water_scene* scene, const checked* input, const water_plan* plan, const double box[4])
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
static water_decision decide_by_cover(const water_scene* scene, const checked* input,
  const water_plane* plane, const water_plan* plan, double box[4])
{
  if (!cover(scene, input, plane, box) && (scene->settings.skips & WATER_MAY_SKIP_UNSEEN))
  {
    return WATER_NO_REFLECT_OUT_OF_VIEW;
  }
  return is_faint(scene, input, plan, box) ? WATER_NO_REFLECT_FAINT : WATER_REFLECT;
}

// Calm and flat water looks up its own pixels.
static void fill_visibility(const water_scene* scene, water_plan* plan)
{
  const bool saves_draws =
    (scene->settings.skips & (WATER_MAY_SKIP_PROPS | WATER_MAY_SKIP_CLUSTERS)) != 0;
  const bool can_see = (scene->settings.skips & WATER_MAY_SKIP_PIXELS) && scene->is_software &&
    scene->is_flat && !scene->has_waves &&
    scene->settings.texture_scale >= visibility_texture_scale && saves_draws;
  plan->has_visibility = can_see && scene->has_scene_depth;
  plan->is_software = scene->is_software;
  if (can_see)
  {
    double area = visible_share;
    for (int i = 0; i < 2; ++i)
    {
      area *= (double)plan->texture_rect_px[2 + i] * scene->viewport_px[i] / plan->texture_px[i];
    }
    plan->visible_px_max = area;
  }
}

// Chooses the props that the reflection texture shows, and what depends on them all: their reach,
// their top, and whether one may be the sky. margin: of the clip
static void fill_props(const water_scene* scene, const water_eye* eye, const water_plane* plane,
  double margin, water_plan* plan, water_cull_reason* reasons, size_t* bad_index)
{
  water_selection selection;
  selection.is_off = false;
  selection.is_direct = false;
  selection.margin = margin;
  selection.prop_px_min = scene->settings.prop_px_min;
  memcpy(selection.texture_px, plan->texture_px, sizeof selection.texture_px);
  water_rect_to_ndc(plan->texture_rect_px, plan->texture_px, selection.box);
  // the near plane of an eye is set for what it sees, which need not be the endless surface
  const double nearer = scene->is_endless
    ? water_mirror_near(plane, scene->props, scene->prop_count, &plan->mirrored)
    : 1.0;
  water_reach reach;
  water_mirror_reach_begin(&plan->mirrored, &reach);
  *bad_index = scene->prop_count;
  for (size_t first = 0; first < scene->prop_count; first += props_at_once)
  {
    const size_t rest = scene->prop_count - first;
    const size_t count = rest < props_at_once ? rest : props_at_once;
    const water_prop* props = scene->props + first;
    const size_t found =
      water_select_props(&plan->mirrored, plane, &selection, props, count, reasons + first);
    if (found < count && *bad_index == scene->prop_count)
    {
      *bad_index = first + found;
    }
    water_mirror_reach_add(props, count, reasons + first, &reach);
    plan->reflection_top =
      fmax(plan->reflection_top, water_lookup_top(plane, props, count, reasons + first));
    plan->is_enclosed =
      plan->is_enclosed || water_lookup_is_enclosed(plane, eye, props, count, reasons + first);
    if (!(scene->settings.skips & WATER_MAY_SKIP_PROPS))
    {
      // after the reach and the top: rays are to take the same steps with all props and without
      // some
      selection.is_off = true;
      (void)water_select_props(&plan->mirrored, plane, &selection, props, count, reasons + first);
      selection.is_off = false;
    }
  }
  water_mirror_reach_apply(&reach, &plan->mirrored);
  plan->depth_scale = reach.scale * nearer;
  plan->depth_offset = reach.scale * (1.0 - nearer);
  plan->reflection_top += scene->wave_height_max; // a ray may start in a trough
  if (plan->is_enclosed && scene->has_waves)
  {
    water_sky_view_rest(&plan->mirrored, plane, eye, scene->props, scene->prop_count, reasons,
      &plan->rest_top, &plan->rest_depth);
    plan->rest_top += scene->wave_height_max;
  }
}

// Samples per pixel of the mirrored view. Rays need texels that show one object: a mixed texel at
// an edge belongs to neither side. Rays sample edges themselves. Source: measured,
// Documentation/decisions/006-lookup.md.
static int samples_of(const water_scene* scene)
{
  const int most = default_samples_max;
  const int calm = scene->window_samples > scene->calm_samples_min ? scene->window_samples
                                                                   : scene->calm_samples_min;
  const int own = scene->has_waves ? 0 : calm < most ? calm : most;
  const int wanted = scene->settings.multi_samples >= 0 ? scene->settings.multi_samples : own;
  const int given = wanted < scene->max_samples ? wanted : scene->max_samples;
  return given > 1 ? given : 0;
}

// How far the surface lies below the plane, away from the eye. This is less than the height of its
// crests if a splash rises from a shallow bed. Waves of an endless surface reach as far down as up.
// Geometry at the lowest point, such as the floor under a film of water, would hide everything from
// the mirrored eye.
static double drop_of(const water_scene* scene, const water_plane* plane)
{
  static const double film = 1e-3; // of the way down
  double lowest = 0.0;
  for (int i = 0; i < 8 && !scene->is_endless; ++i)
  {
    double corner[3];
    water_bounds_corner(scene->surface_bounds, i, corner);
    lowest = fmin(lowest, water_plane_height(plane, corner));
  }
  return scene->is_endless ? scene->wave_height_max
                           : fmin(scene->wave_height_max, (1.0 - film) * -lowest);
}

// plane: normal towards the eye; plane_view of the plan is set.
// box: of the picture that the water covers
static water_status fill_draw(const water_scene* scene, const checked* input,
  const water_plane* plane, const double box[4], water_plan* plan, water_cull_reason* reasons,
  size_t* bad_index)
{
  // an object in a trough must be visible in it
  const double margin = fmax(scene->settings.clip_margin, drop_of(scene, plane));
  water_mirror_camera(&scene->eye, plane, &plan->mirrored);
  memcpy(plan->texture_px, input->texture_px, sizeof plan->texture_px);
  plan->samples = samples_of(scene);
  plan->reflection_scale[0] = plan->reflection_scale[1] = 1.0;
  if (scene->has_waves)
  {
    const water_camera whole = water_target_whole(&scene->eye, scene->tile_scale);
    const double band = scene->settings.guard_band > 0.0
      ? scene->settings.guard_band
      : water_target_guard_band(&whole, scene->slope_rms);
    double bands[2];
    water_target_tile_bands(band, scene->tile_scale, bands);
    water_target_widen(bands, scene->max_texture_px, plan->texture_px, plan->reflection_scale);
    water_mirror_widen(plan->reflection_scale, &plan->mirrored);
  }
  double looked_up[4];
  memcpy(looked_up, box, sizeof looked_up);
  if (scene->has_waves)
  {
    water_target_reach(&scene->eye, scene->slope_max, looked_up);
  }
  water_target_rect(looked_up, plan->reflection_scale, plan->texture_px, plan->texture_rect_px);
  fill_props(scene, &input->eye, plane, margin, plan, reasons, bad_index);
  if (!(scene->settings.skips & WATER_MAY_SKIP_PIXELS))
  {
    const int whole[4] = { 0, 0, plan->texture_px[0], plan->texture_px[1] };
    memcpy(plan->texture_rect_px, whole, sizeof whole);
  }
  for (int i = 0; i < 4; ++i)
  {
    plan->height_rounding += 16.0 * (double)FLT_EPSILON * fabs(plan->plane_clip[i]);
  }
  fill_visibility(scene, plan);
  water_mirror_pose(
    &plan->mirrored, plan->mirrored_position, plan->mirrored_focal_point, plan->mirrored_view_up);
  if (scene->picture_eye)
  {
    water_mirror_headlight_of(
      &input->picture, &plan->mirrored, plan->headlight_dir, plan->headlight_position);
  }
  else
  {
    water_mirror_headlight(plan->plane_view, plan->headlight_dir, plan->headlight_position);
  }
  water_mirror_clip_view(plan->plane_view, margin, plan->clip_plane_view);
  water_mat4_apply_row(plan->clip_plane_view, plan->mirrored.world_to_view, plan->clip_plane_world);
  const water_status status = water_mirror_clip_clip(
    plan->mirrored.view_to_clip, plan->clip_plane_view, plan->clip_plane_clip);
  if (status == WATER_OK)
  {
    water_mirror_clip_window(plan->clip_plane_clip, plan->texture_px, plan->clip_plane_window);
  }
  return status;
}

// plane: normal towards the eye.
static water_status fill_view(const water_scene* scene, const checked* input,
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
static water_status fill_shade(
  const water_scene* scene, const checked* input, const water_axes* axes, water_plan* plan)
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
static water_status fill_drawn_view(const water_scene* scene, const checked* input,
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
    return water_sun_view_plan(scene, plane, drop_of(scene, plane), box, plan, reasons);
  }
  if (scene->is_of_sky)
  {
    *bad_index = scene->prop_count;
    return water_sky_view_plan(scene, plane, axes, drop_of(scene, plane), box, plan, reasons);
  }
  const water_status status = fill_draw(scene, input, plane, box, plan, reasons, bad_index);
  return status == WATER_OK ? fill_shade(scene, input, axes, plan) : status;
}

water_status water_plan_make(const water_scene* scene, water_plan* plan, water_cull_reason* reasons)
{
  water_plan made;
  checked input;
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
