// SPDX-License-Identifier: BSD-3-Clause
// water_sun_view.h: the sun view: what is between the sun and the water, laid down along the
// sun's rays on the water's plane, in the eye's own picture. A pixel of it tells whether anything
// blocks the sun's light on the water that the eye sees there.
//
// Source: Blinn 1988, "Me and My (Fake) Shadow". The depth is the height over the plane, of the
// highest prop on a ray: waves compare their own with it.
#ifndef water_sun_view_h
#define water_sun_view_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Points of the world, laid down on the plane, in clip space of the eye.
//
// view_to_world  of the eye (water_eye)
// plane          normalised, normal towards the eye
// to_sun         in world, unit length; over the plane
// bottom         what is less than so far below the plane is in the view, too, >= 0
// top            height over the plane of the highest thing, > 0
// nearest_w      of the water in clip space of the eye, > 0
// camera         looks from far away along the sun's rays; its projection does the rest
// depth          window depth of a point: 1 - depth * (its height + bottom) / w, w of where it is
//                laid down
void water_sun_view_camera(const water_camera* eye, const double view_to_world[16],
  const water_plane* plane, const double to_sun[3], double bottom, double top, double nearest_w,
  water_camera* camera, double* depth);

// Fills what a plan knows of the sun view: camera, size, clip, and the reason for every prop. Props
// without bounds cast no shadow. Neither do props that surround the eye and may be the sky. If no
// prop casts a shadow, the decision is WATER_NO_REFLECT_OUT_OF_VIEW.
//
// plane   normal towards the eye, which is over the water
// margin  how far the surface lies below it, >= 0
// box     of the picture that the water covers, NDC of the eye
// plan    the fields of the view are set
//
// Returns WATER_OK or the status of what cannot be planned.
water_status water_sun_view_plan(const water_scene* scene, const water_plane* plane, double margin,
  const double box[4], water_plan* plan, water_cull_reason* reasons);

#ifdef __cplusplus
}
#endif
#endif
