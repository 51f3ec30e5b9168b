// SPDX-License-Identifier: BSD-3-Clause
// water_plan_draw.h: the plan of the mirrored view; water_plan_make calls it.
#ifndef water_plan_draw_h
#define water_plan_draw_h

#include "water_camera.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// What the checks compute on their way, for the steps to use.
typedef struct water_plan_checked
{
  water_plane plane; // unit length, as the user turned it
  water_plane level; // the same, moved to the surface where the eye is
  water_eye eye;
  water_eye picture;  // the eye of the user's picture, if that is another one
  bool is_at_surface; // there is surface over the eye, or under it
  water_side side;
  int texture_px[2];
} water_plan_checked;

// How far the surface lies below the plane, away from the eye. This is less than the height of its
// crests if a splash rises from a shallow bed. Waves of an endless surface reach as far down as up.
// Geometry at the lowest point, such as the floor under a film of water, would hide everything from
// the mirrored eye.
double water_plan_drop(const water_scene* scene, const water_plane* plane);

// Plans the mirrored view: its camera, the reflection texture, the props in it, and its clip.
//
// plane      normal towards the eye
// box        of the picture that the water covers
// plan       plane_view is set
// bad_index  as water_select_props
//
// Returns as water_mirror_clip_clip.
water_status water_plan_draw(const water_scene* scene, const water_plan_checked* input,
  const water_plane* plane, const double box[4], water_plan* plan, water_cull_reason* reasons,
  size_t* bad_index);

#ifdef __cplusplus
}
#endif
#endif
