// SPDX-License-Identifier: BSD-3-Clause
// water_select.h: on which side the eye is, whether the water is seen, and what becomes of
// each prop in the mirrored view.
//
// Conservative throughout: rounding, and the slack of a box around its prop, may keep what nobody
// sees, but never lose what somebody does.
#ifndef water_select_h
#define water_select_h

#include "water_camera.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// The side of the plane the eye is on. Perspective: the side of its centre; parallel: the side from
// which it looks, wherever it is.
//
// Returns WATER_OK or WATER_CAMERA_ON_PLANE (the height is smaller than the rounding of the numbers
// it is made of). On an error, *side is unchanged. Never the wrong side: heights under 48 roundings
// (2^-53) of the lengths are rejected, those over 96 are accepted.
water_status water_select_side(const water_eye* eye, const water_plane* plane, water_side* side);

// An eye exactly on the plane does not see it. For such an eye the plane is lowered until the eye
// is above it by a ten thousandth of the distance to the eye's near plane, or by 1000 times the
// rounding error of the eye's height if that is more. For any other eye, level is the plane itself.
//
// plane  normalised
// level  the same, or moved along its normal
// side   of the eye, of that
void water_select_level(
  const water_eye* eye, const water_plane* plane, water_plane* level, water_side* side);

// Whether any point of a box may lie in the camera's frustum. Empty boxes must be sorted out
// before.
bool water_select_is_in_view(const water_camera* camera, const double bounds[6]);

typedef struct water_selection
{
  bool is_off;    // draw all that the flags and the bounds allow
  bool is_direct; // no reflection: what is marked as not reflected is drawn
  double box[4];  // part of the reflection texture that the water looks up, NDC: low x, low y, high
                  // x, high y
  double margin;  // how far behind the plane geometry is kept, >= 0
  double prop_px_min; // smaller props are left out, >= 0
  int texture_px[2];
} water_selection;

// Decides the reason for every prop. The far plane of the eye was set for the scene, not for its
// mirror image, which may reach further: it culls nothing here (water_mirror_reach moves it).
//
// plane  normalised, normal towards the eye
//
// Returns the index of the first prop that is drawn although its bounds are not finite; prop_count:
// there is none.
size_t water_select_props(const water_camera* mirrored, const water_plane* plane,
  const water_selection* selection, const water_prop* props, size_t prop_count,
  water_cull_reason* reasons);

#ifdef __cplusplus
}
#endif
#endif
