// SPDX-License-Identifier: BSD-3-Clause
// water_plan_draw.c: the mirrored view: mirror, target, select, clip.
#include "water_plan_draw.h"

#include "water_lookup.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_sky_view.h"
#include "water_target.h"

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

double water_plan_drop(const water_scene* scene, const water_plane* plane)
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

water_status water_plan_draw(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, const double box[4], water_plan* plan, water_cull_reason* reasons,
  size_t* bad_index)
{
  // an object in a trough must be visible in it
  const double margin = fmax(scene->settings.clip_margin, water_plan_drop(scene, plane));
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
