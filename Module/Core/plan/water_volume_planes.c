// SPDX-License-Identifier: BSD-3-Clause
#include "water_volume_planes.h"

#include "water_math.h"

#include <math.h>

static void normalise(const double side[4], double normalised[4])
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    largest = fmax(largest, fabs(side[i]));
  }
  for (int i = 0; i < 4; ++i)
  {
    normalised[i] = largest > 0.0 ? side[i] / largest : 0.0;
  }
}

water_status water_volume_planes_make(const water_plan* plan, const double bounds[6],
  const double box_to_world[16], double sides[WATER_VOLUME_PLANES_COUNT][4])
{
  if (!water_bounds_are_finite(bounds) || water_bounds_is_empty(bounds))
  {
    return WATER_BAD_PROP_BOUNDS;
  }
  double world_to_clip[16];
  double box_to_clip[16];
  double clip_to_box[16];
  water_mat4_multiply(plan->mirrored.view_to_clip, plan->mirrored.world_to_view, world_to_clip);
  water_mat4_multiply(world_to_clip, box_to_world, box_to_clip);
  if (!water_mat4_invert(box_to_clip, clip_to_box))
  {
    return WATER_BAD_CAMERA;
  }
  for (int i = 0; i < 6; ++i)
  {
    double side[4] = { 0.0, 0.0, 0.0, 0.0 };
    const double inward = i % 2 == 0 ? 1.0 : -1.0;
    side[i / 2] = inward;
    side[3] = -inward * bounds[i];
    double clip[4];
    water_mat4_apply_row(side, clip_to_box, clip); // a plane is a row vector
    normalise(clip, sides[i]);
  }
  normalise(plan->clip_plane_clip, sides[6]);
  return WATER_OK;
}
