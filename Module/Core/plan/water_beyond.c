// SPDX-License-Identifier: BSD-3-Clause
// water_beyond.c: size, looked-up part and clip of the own view, and the way into its picture.
#include "water_beyond.h"

#include "water_frustum.h"
#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_target.h"

// So many times as wide and high as the picture: of 50 random scenes, the pixels with a colour that
// is none of what is near by fell from 5.4 % (as wide as the picture) to 2.0 % (decision 006).
static const double band = 2.0;

// Height of the land that is kept at a shore: filtering and the first step of a ray come to the
// pixel beside.
static const double shore_px = 2.0;

// Sine of 30 degrees: PyVista's own camera looks down by 35.
static const double low_sine = 0.5;

bool water_beyond_is_low(const water_plane* plane, const double eye[3], const double ahead[3])
{
  water_plane unit;
  return water_plane_normalise(plane, &unit) == WATER_OK && water_plane_height(&unit, eye) > 0.0 &&
    -water_vec3_dot(unit.normal, ahead) < low_sine;
}

bool water_beyond_is_open(water_units_bed bed, bool is_endless, water_refraction_source source)
{
  return bed == WATER_UNITS_BED_NONE || (is_endless && source != WATER_FROM_PICTURE);
}

bool water_beyond_is_wanted(
  water_refraction_source source, bool is_open, bool is_low, const int tile_scale[2])
{
  const bool is_chosen = source == WATER_FROM_AUTOMATIC && is_open && is_low;
  return source == WATER_FROM_OWN_VIEW || is_chosen || tile_scale[0] > 1 || tile_scale[1] > 1;
}

water_status water_beyond_size(const int viewport_px[2], const int tile_scale[2],
  int max_texture_px, int texture_px[2], double picture_scale[2])
{
  const water_status status = water_target_size(viewport_px, 1.0, max_texture_px, texture_px);
  if (status == WATER_OK)
  {
    double bands[2];
    water_target_tile_bands(band, tile_scale, bands);
    water_target_widen(bands, max_texture_px, texture_px, picture_scale);
  }
  return status;
}

water_prop water_beyond_prop(const water_prop* prop)
{
  water_prop made = *prop;
  if (prop->flags & WATER_PROP_OWN_OTHER)
  {
    const uint32_t visible = prop->flags & WATER_PROP_OWN_VISIBLE ? WATER_PROP_VISIBLE : 0;
    made.flags &= ~(uint32_t)WATER_PROP_VISIBLE;
    made.flags |= visible | WATER_PROP_NO_BOUNDS;
  }
  if (prop->flags & WATER_PROP_RULER)
  {
    made.flags &= ~(uint32_t)WATER_PROP_LABEL;
    made.flags |= WATER_PROP_NO_BOUNDS; // those of labels are not read
  }
  return made;
}

bool water_beyond_keeps_layer(bool is_software, bool has_volumes, bool has_ranks)
{
  return !has_ranks && (is_software || !has_volumes);
}

void water_beyond_reach(const double dir_to_eye[12], double box[4])
{
  // the plumb line's direction, away from the eye, in clip space: from an image p all plumb lines
  // go on by v - p w
  const double v = -dir_to_eye[3 * 1 + 2];
  const double w = -dir_to_eye[3 * 3 + 2];
  const double ways[2] = { v - box[1] * w, v - box[3] * w };
  const double vanishing = w > 0.0 ? v / w : (double)INFINITY; // or it is not reached
  if (fmin(ways[0], ways[1]) < 0.0)
  {
    box[1] = w > 0.0 ? fmin(box[1], vanishing) : -(double)INFINITY;
  }
  if (fmax(ways[0], ways[1]) > 0.0)
  {
    box[3] = fmax(box[3], vanishing);
  }
  box[0] = -(double)INFINITY;
  box[2] = (double)INFINITY;
}

void water_beyond_clip_view(const water_camera* eye, const int viewport_px[2],
  const double plane_view[4], double margin, double clip_plane_view[4])
{
  // a length over its w that the picture shows so large
  const double slack = shore_px * 2.0 / (fabs(eye->view_to_clip[5]) * viewport_px[1]);
  const double* w = eye->view_to_clip + 12;
  for (int i = 0; i < 4; ++i)
  {
    clip_plane_view[i] = slack * w[i] - plane_view[i];
  }
  clip_plane_view[3] += margin;
  const double length = water_vec3_length(clip_plane_view);
  for (int i = 0; i < 4; ++i)
  {
    clip_plane_view[i] /= length;
  }
}

void water_beyond_row(const double row[4], const double picture_scale[2], double of_own_view[4])
{
  for (int i = 0; i < 4; ++i)
  {
    of_own_view[i] = i < 2 ? row[i] / picture_scale[i] : row[i];
  }
}

void water_beyond_dirs(
  const double dir_to_eye[12], const double picture_scale[2], double dir_to_own_view[12])
{
  for (int i = 0; i < 12; ++i)
  {
    dir_to_own_view[i] = i < 6 ? picture_scale[i / 3] * dir_to_eye[i] : dir_to_eye[i];
  }
}

// Where the own view sees the background: as the eye sees it, in NDC of its own.
static void fill_background(const double picture_scale[2], double own_ndc_to_eye[9])
{
  memset(own_ndc_to_eye, 0, 9 * sizeof *own_ndc_to_eye);
  own_ndc_to_eye[0] = 1.0 / picture_scale[0];
  own_ndc_to_eye[4] = 1.0 / picture_scale[1];
  own_ndc_to_eye[8] = 1.0;
}

static void select_props(
  const water_scene* scene, water_plan* plan, water_cull_reason* reasons, size_t* bad_index)
{
  const double* clip = plan->clip_plane_world;
  const water_plane kept = { { clip[0], clip[1], clip[2] }, clip[3] };
  water_selection selection;
  memset(&selection, 0, sizeof selection);
  selection.is_direct = true;
  memcpy(selection.texture_px, plan->texture_px, sizeof selection.texture_px);
  water_rect_to_ndc(plan->texture_rect_px, plan->texture_px, selection.box);
  selection.is_off = !(scene->settings.skips & WATER_MAY_SKIP_PROPS);
  *bad_index = water_select_props(
    &plan->mirrored, &kept, &selection, scene->props, scene->prop_count, reasons);
}

water_status water_beyond_plan(const water_scene* scene, const double box[4], water_plan* plan,
  water_cull_reason* reasons, size_t* bad_index)
{
  water_status status = water_beyond_size(scene->viewport_px, scene->tile_scale,
    scene->max_texture_px, plan->texture_px, plan->reflection_scale);
  if (status != WATER_OK)
  {
    return status;
  }
  plan->mirrored = scene->eye;
  water_mirror_widen(plan->reflection_scale, &plan->mirrored);
  const bool is_level = scene->is_flat && !scene->has_waves && plan->side == WATER_ABOVE;
  double looked_up[4] = { -(double)INFINITY, -(double)INFINITY, (double)INFINITY,
    (double)INFINITY };
  if (is_level && (scene->settings.skips & WATER_MAY_SKIP_PIXELS))
  {
    memcpy(looked_up, box, sizeof looked_up);
    water_beyond_reach(plan->dir_to_eye, looked_up);
  }
  water_target_rect_of_eye(
    looked_up, plan->reflection_scale, plan->texture_px, plan->texture_rect_px);
  plan->is_software = scene->is_software;
  plan->depth_scale = 1.0;
  fill_background(plan->reflection_scale, plan->reflection_ndc_to_eye);
  water_mirror_pose(
    &plan->mirrored, plan->mirrored_position, plan->mirrored_focal_point, plan->mirrored_view_up);
  plan->headlight_dir[2] = -1.0; // it is where the eye is
  water_beyond_clip_view(&scene->eye, scene->viewport_px, plan->plane_view, scene->wave_height_max,
    plan->clip_plane_view);
  water_mat4_apply_row(plan->clip_plane_view, plan->mirrored.world_to_view, plan->clip_plane_world);
  select_props(scene, plan, reasons, bad_index);
  status = water_mirror_clip_clip(
    plan->mirrored.view_to_clip, plan->clip_plane_view, plan->clip_plane_clip);
  if (status == WATER_OK)
  {
    water_mirror_clip_window(plan->clip_plane_clip, plan->texture_px, plan->clip_plane_window);
  }
  return status;
}
