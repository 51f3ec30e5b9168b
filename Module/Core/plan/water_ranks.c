// SPDX-License-Identifier: BSD-3-Clause
// water_ranks.c: what ranks agree on: joined facts, one scene.
#include "water_ranks.h"

#include "water_lookup.h"
#include "water_math.h"

#include <string.h>

_Static_assert(sizeof(water_rank_frame) == 12 * sizeof(double), "it travels as doubles");
_Static_assert(sizeof(water_rank_view) == 22 * sizeof(double), "it travels as doubles");
_Static_assert(sizeof(water_prop) <= 64, "a prop takes at most 64 bytes");
_Static_assert(sizeof(water_rank_part) == 5 * sizeof(double), "it travels as doubles");
_Static_assert(sizeof(water_rank_drawn) == 10 * sizeof(double), "it travels as doubles");

static void begin_bounds(double bounds[6])
{
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] = i % 2 ? -1.0 : 1.0;
  }
}

// Empty boxes, and numbers that are not finite, add nothing.
static void add_bounds(const double more[6], double bounds[6])
{
  if (!water_bounds_are_finite(more) || water_bounds_is_empty(more))
  {
    return;
  }
  if (water_bounds_is_empty(bounds))
  {
    memcpy(bounds, more, 6 * sizeof *bounds);
    return;
  }
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] = i % 2 ? fmax(bounds[i], more[i]) : fmin(bounds[i], more[i]);
  }
}

water_status water_ranks_join_frames(
  const water_rank_frame* frames, size_t rank_count, double scene_bounds[6], size_t* bad_rank)
{
  begin_bounds(scene_bounds);
  for (size_t i = 0; i < rank_count; ++i)
  {
    // other versions first: what else they send is not what it seems
    if (frames[i].format != frames[0].format || frames[i].scene_size != frames[0].scene_size)
    {
      *bad_rank = i;
      return WATER_RANKS_DIFFERENT_VERSIONS;
    }
  }
  for (size_t i = 0; i < rank_count; ++i)
  {
    if (frames[i].has_error != 0.0)
    {
      *bad_rank = i;
      return WATER_RANKS_BAD_WATER;
    }
  }
  for (size_t i = 0; i < rank_count; ++i)
  {
    if (frames[i].water_count != frames[0].water_count ||
      frames[i].automatic != frames[0].automatic)
    {
      *bad_rank = i;
      return WATER_RANKS_DIFFERENT_WATERS;
    }
    add_bounds(frames[i].scene_bounds, scene_bounds);
  }
  return WATER_OK;
}

bool water_ranks_are_gone(const water_rank_frame* frames, size_t rank_count)
{
  for (size_t i = 0; i < rank_count; ++i)
  {
    if (frames[i].water_count != 0.0 || frames[i].is_gone == 0.0)
    {
      return false;
    }
  }
  return true;
}

// What the parts of a mesh add: each of them may be another.
static void join_surface(const water_rank_view* view, water_ranks_view* made)
{
  add_bounds(view->surface_bounds, made->surface_bounds);
  made->has_waves = made->has_waves || view->has_waves != 0.0;
  made->slope_rms = fmax(made->slope_rms, view->slope_rms);
  made->slope_max = fmax(made->slope_max, view->slope_max);
  made->wave_height_max = fmax(made->wave_height_max, view->wave_height_max);
  made->is_averaged = made->is_averaged || view->is_averaged != 0.0;
  made->has_marched_rays = made->has_marched_rays || view->has_marched_rays != 0.0;
  made->wants_peel = made->wants_peel || view->wants_peel != 0.0;
}

water_status water_ranks_join_views(const water_rank_view* views, size_t rank_count, size_t rank,
  water_ranks_view* joined, size_t* bad_rank)
{
  water_ranks_view made;
  memset(&made, 0, sizeof made);
  begin_bounds(made.surface_bounds);
  double max_texture_px = views[0].max_texture_px;
  double max_samples = views[0].max_samples;
  for (size_t i = 0; i < rank_count; ++i)
  {
    // errors first: what else such a rank sends is not to be compared
    if (views[i].has_error != 0.0)
    {
      *bad_rank = i;
      return WATER_RANKS_BAD_WATER;
    }
  }
  for (size_t i = 0; i < rank_count; ++i)
  {
    const water_rank_view* view = views + i;
    if (view->sheet_count != views[0].sheet_count || view->digest != views[0].digest)
    {
      *bad_rank = i;
      return view->sheet_count != views[0].sheet_count ? WATER_RANKS_DIFFERENT_WATERS
                                                       : WATER_RANKS_DIFFERENT_LOOKS;
    }
    made.first_prop += i < rank ? (size_t)view->prop_count : 0;
    made.prop_count += (size_t)view->prop_count;
    max_texture_px = fmin(max_texture_px, view->max_texture_px);
    max_samples = fmin(max_samples, view->max_samples);
    made.is_software = made.is_software || view->is_software != 0.0;
    made.measured_ms = fmax(made.measured_ms, view->measured_ms);
    join_surface(view, &made);
  }
  if (!(views[0].farthest_rank < (double)rank_count)) // NaN neither
  {
    *bad_rank = 0;
    return WATER_RANKS_NO_SUCH_RANK;
  }
  made.farthest_rank = (int)fmax(views[0].farthest_rank, -1.0);
  made.max_texture_px = (int)max_texture_px;
  made.max_samples = (int)max_samples;
  *joined = made;
  return WATER_OK;
}

water_scene water_ranks_scene(
  const water_scene* root, const water_ranks_view* joined, const water_prop* props)
{
  water_scene scene = *root;
  scene.props = props;
  scene.prop_count = joined->prop_count;
  scene.max_texture_px = joined->max_texture_px;
  scene.max_samples = joined->max_samples;
  scene.is_software = joined->is_software;
  memcpy(scene.surface_bounds, joined->surface_bounds, sizeof scene.surface_bounds);
  scene.has_waves = joined->has_waves;
  scene.slope_rms = joined->slope_rms;
  scene.slope_max = joined->slope_max;
  scene.wave_height_max = joined->wave_height_max;
  scene.is_hidden = false;
  scene.has_scene_depth = false;
  return scene;
}

uint64_t water_ranks_digest(uint64_t digest, const double* numbers, size_t count)
{
  static const uint64_t prime = UINT64_C(1099511628211);
  for (size_t i = 0; i < count; ++i)
  {
    unsigned char bytes[sizeof *numbers];
    memcpy(bytes, numbers + i, sizeof bytes);
    for (size_t j = 0; j < sizeof bytes; ++j)
    {
      digest = (digest ^ bytes[j]) * prime;
    }
  }
  return digest;
}

uint64_t water_ranks_digest_settings(uint64_t digest, const water_settings* settings)
{
  const double numbers[] = { settings->texture_scale, settings->guard_band, settings->clip_margin,
    settings->prop_px_min, settings->reflectance_error, (double)settings->skips,
    (double)settings->multi_samples, (double)settings->color_precision, (double)settings->quality,
    settings->target_error_px, settings->time_budget_ms };
  return water_ranks_digest(digest, numbers, sizeof numbers / sizeof numbers[0]);
}

uint64_t water_ranks_digest_waves(uint64_t digest, const water_wave_term* terms, size_t term_count)
{
  const double count = (double)term_count;
  digest = water_ranks_digest(digest, &count, 1);
  for (size_t i = 0; i < term_count; ++i)
  {
    const water_wave_term* term = terms + i;
    const double numbers[] = { term->dir[0], term->dir[1], term->turns_per_m[0],
      term->turns_per_m[1], term->k, term->amplitude, term->steepness, term->turns };
    digest = water_ranks_digest(digest, numbers, sizeof numbers / sizeof numbers[0]);
  }
  return digest;
}

double water_ranks_digest_number(uint64_t digest)
{
  return (double)(digest >> 11);
}

bool water_rank_shows_water(int farthest_rank, size_t rank)
{
  return farthest_rank < 0 || (size_t)farthest_rank == rank;
}

bool water_rank_region_is_there(const double region[6])
{
  return region[0] < region[1] && region[2] < region[3] && region[4] < region[5];
}

void water_rank_region_sides(const water_plane* plane, const double plane_origin[3],
  const water_plan* plan, const double region[6], double sides[6][4])
{
  water_axes axes;
  water_lookup_axes(plane, plan->side, plane_origin, &axes);
  for (int i = 0; i < 6; ++i)
  {
    const int k = i / 2;
    const double foot =
      axes.origin[k] + plan->origin_xy[0] * axes.x_dir[k] + plan->origin_xy[1] * axes.y_dir[k];
    const double sign = i % 2 ? -1.0 : 1.0;
    const bool is_open = isinf(region[i]);
    sides[i][0] = is_open ? 0.0 : sign * axes.x_dir[k];
    sides[i][1] = is_open ? 0.0 : sign * axes.y_dir[k];
    sides[i][2] = is_open ? 0.0 : sign * axes.normal[k];
    sides[i][3] = is_open ? 1.0 : sign * (foot - region[i]);
  }
}

bool water_ranks_take_numbers(double* numbers, size_t count, size_t rank_count)
{
  for (size_t i = 0; i < rank_count; ++i)
  {
    const double* sent = numbers + i * (count + 1);
    if (sent[count] != WATER_RANKS_IS_HERE)
    {
      return false;
    }
    memmove(numbers + i * count, sent, count * sizeof *numbers);
  }
  return true;
}

int water_ranks_join_parts(const water_rank_part* parts, size_t rank_count, int rect_px[4])
{
  double first[2] = { 0.0, 0.0 };
  double end[2] = { 0.0, 0.0 };
  bool is_empty = true;
  bool is_equal = true;
  for (size_t i = 0; i < rank_count; ++i)
  {
    const double* rect = parts[i].rect_px;
    is_equal = is_equal && parts[i].samples == parts[0].samples;
    if (rect[2] <= 0.0 || rect[3] <= 0.0)
    {
      continue;
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      const double last = rect[axis] + rect[2 + axis];
      first[axis] = is_empty ? rect[axis] : fmin(first[axis], rect[axis]);
      end[axis] = is_empty ? last : fmax(end[axis], last);
    }
    is_empty = false;
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    rect_px[axis] = (int)first[axis];
    rect_px[2 + axis] = (int)(end[axis] - first[axis]);
  }
  return is_equal ? (int)parts[0].samples : 0;
}

water_rank_drawn water_rank_drawn_begin(void)
{
  water_rank_drawn drawn;
  memset(&drawn, 0, sizeof drawn);
  begin_bounds(drawn.blended_bounds);
  return drawn;
}

void water_rank_drawn_add(const double bounds[6], water_rank_drawn* drawn)
{
  add_bounds(bounds, drawn->blended_bounds);
}

water_ranks_drawing water_ranks_join_drawn(const water_rank_drawn* drawn, size_t rank_count,
  double (*bounds)[6], bool* has_blended, size_t* bad_rank)
{
  bool is_aborted = false;
  bool wants_again = false;
  size_t failed = rank_count;
  *has_blended = false;
  for (size_t i = 0; i < rank_count; ++i)
  {
    const bool has_own = drawn[i].has_blended != 0.0;
    begin_bounds(bounds[i]);
    if (has_own)
    {
      add_bounds(drawn[i].blended_bounds, bounds[i]);
    }
    *has_blended = *has_blended || has_own;
    is_aborted = is_aborted || drawn[i].is_aborted != 0.0;
    wants_again = wants_again || drawn[i].wants_again != 0.0;
    failed = drawn[i].has_failed != 0.0 && i < failed ? i : failed;
  }
  if (wants_again || is_aborted)
  {
    return wants_again ? WATER_RANKS_DRAW_AGAIN : WATER_RANKS_ABORTED;
  }
  *bad_rank = failed < rank_count ? failed : *bad_rank;
  return failed < rank_count ? WATER_RANKS_FAILED : WATER_RANKS_DRAWN;
}
