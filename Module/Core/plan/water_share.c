// SPDX-License-Identifier: BSD-3-Clause
// water_share.c: may two sheets of water share one mirrored view?
#include "water_share.h"

#include "water_math.h"
#include "water_plane.h"

static bool is_same_settings(const water_settings* a, const water_settings* b)
{
  return a->texture_scale == b->texture_scale && a->guard_band == b->guard_band &&
    a->clip_margin == b->clip_margin && a->prop_px_min == b->prop_px_min &&
    a->reflectance_error == b->reflectance_error && a->skips == b->skips &&
    a->multi_samples == b->multi_samples && a->color_precision == b->color_precision &&
    a->quality == b->quality && a->target_error_px == b->target_error_px &&
    a->time_budget_ms == b->time_budget_ms && a->secondary_reflections == b->secondary_reflections;
}

bool water_share_can(
  const water_share* a, const water_share* b, const double eye_position[3], bool is_parallel)
{
  if ((a->is_clear || b->is_clear) && !is_parallel &&
    (a->is_displaced || water_plane_height(&a->plane, eye_position) < 0.0))
  {
    return false;
  }
  const bool is_calm = !a->needs_rays && !b->needs_rays;
  const bool has_same_waves =
    a->look == b->look && memcmp(a->origin, b->origin, sizeof a->origin) == 0;
  return water_plane_is_identical(&a->plane, &b->plane) &&
    is_same_settings(&a->settings, &b->settings) && a->has_environment == b->has_environment &&
    a->is_opaque == b->is_opaque && a->is_displaced == b->is_displaced &&
    (is_calm || has_same_waves);
}
