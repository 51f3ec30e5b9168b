// SPDX-License-Identifier: BSD-3-Clause
// water_mirror.h: the camera mirrored at the plane, the clip at the plane, and the transformations
// from the scene to the mirrored view.
//
// R is the mirror matrix of the plane (determinant -1), Fx = diag(-1, 1, 1, 1). The mirrored camera
// is V' = Fx V R, P' = Fx P Fx: V' is a proper rigid view, so triangles keep their winding, and P'
// covers frusta that are not symmetric. Its picture is flipped in x against the eye's.
// Every plane handed in here has its normal towards the eye; the eye's side of it is kept.
//
// Errors, in roundings u = 2^-53, where the reach is the sum of the lengths of a point, of the
// plane's offset and of the view's: the mirrored view has determinant 1 within 64 u of the eye's
// own; mirrored twice it is the eye's within 64 u (translation: 128 u of the reach). A point of the
// water is displaced in it by at most 32 u of the reach, and its pixel by this length divided by
// the distance from the eye, times the projection's scale. Errors of heights above the clip are at
// most 128 u of the reach in view space; in clip space, the inverse of the projection adds 64 u of
// its own size. Testing/Core/Stability derives and checks these bounds; Documentation/stability.md
// has measurements.
#ifndef water_mirror_h
#define water_mirror_h

#include "water_camera.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Mirrors a camera at a normalised plane. The sign of the normal does not matter.
void water_mirror_camera(const water_camera* eye, const water_plane* plane, water_camera* mirrored);

// How far the far plane of a camera must move so that the drawn props lie in front of it, by more
// than rounding. The near plane and the picture do not change.
typedef struct water_reach
{
  double world_to_clip[16];
  double beyond[4]; // the far plane so far, in world: positive beyond it
  double sizes[4];  // of the numbers that it is made of
  double scale;     // of the depths: a window depth z becomes scale * z
} water_reach;

// Until props are added, the far plane stays.
void water_mirror_reach_begin(const water_camera* mirrored, water_reach* reach);

// Adds props, some at a time.
//
// reasons  of water_select_props; only WATER_CULL_NONE counts
void water_mirror_reach_add(
  const water_prop* props, size_t prop_count, const water_cull_reason* reasons, water_reach* reach);

// Moves the far plane.
void water_mirror_reach_apply(const water_reach* reach, water_camera* mirrored);

// Moves the near plane of a mirrored camera closer to the camera, so that it does not cut props
// above the water whose mirror images are nearer to the eye than the props. The far plane and the
// picture do not change. As in VTK, the near plane keeps at least a thousandth of the far plane's
// distance, unless it was nearer before. Call this before water_select_props and
// water_mirror_reach_begin.
//
// plane  normalised, normal towards the eye
//
// Returns the scale s of the depths: a window depth z becomes s z + 1 - s.
double water_mirror_near(
  const water_plane* plane, const water_prop* props, size_t prop_count, water_camera* mirrored);

// Widens the frustum of a mirrored camera: its present picture becomes the part reflection_scale of
// the new one, per axis, about the middle.
void water_mirror_widen(const double reflection_scale[2], water_camera* mirrored);

// A rigid camera in vtkCamera's terms, in world.
//
// focal_point  at distance 1 of position
// view_up      unit length, at right angles to the view direction
void water_mirror_pose(
  const water_camera* mirrored, double position[3], double focal_point[3], double view_up[3]);

// The clip at the plane in mirrored view space: kept side >= 0, unit normal.
//
// plane_view  the plane in the eye's view space (water_camera_plane_view)
// margin      how far behind the plane geometry is kept, >= 0
void water_mirror_clip_view(const double plane_view[4], double margin, double clip_plane_view[4]);

// The clip of water_mirror_clip_view in clip space: dot(clip_plane_clip, clip) is the height over
// the clip.
//
// Returns WATER_OK or WATER_BAD_CAMERA (view_to_clip has no inverse).
water_status water_mirror_clip_clip(
  const double view_to_clip[16], const double clip_plane_view[4], double clip_plane_clip[4]);

// The same for single precision: the height over the clip is dot(position, clip) + constant. A
// perspective's z and w differ by little more than their rounding where the near plane is close,
// and the clip would be found from that: z is left out there. What lies in the plane is kept: a
// perspective's clip is lower by as much of the distance as floats round.
void water_mirror_clip_position(const double view_to_clip[16], const double clip_plane_clip[4],
  double position[4], double* constant);

// The clip of water_mirror_clip_clip in the reflection texture's window space:
// dot(clip_plane_window, (x_px, y_px, depth, 1)) has the sign of the clip for every point in front
// of the camera; depth in [0, 1]. The largest entry is 1 or -1.
void water_mirror_clip_window(
  const double clip_plane_clip[4], const int texture_px[2], double clip_plane_window[4]);

// The clip at a plane, and a margin under it, in all spaces of a plan's own camera, wherever that
// is.
//
// plane  normalised; the side of its normal is kept
//
// Returns WATER_OK or WATER_BAD_CAMERA (the camera's projection has no inverse).
water_status water_mirror_clip_plan(const water_plane* plane, double margin, water_plan* plan);

// World to the reflection texture: divide by w: u, v, depth in [0, 1]. Not used by the module: for
// tests, and for programs that use the core alone.
void water_mirror_texture_matrix(const water_camera* mirrored, double world_to_texture[16]);

// The eye's view direction (unit length) and position, in mirrored view space: lights attached to
// the camera must stay at the user's camera, not at the mirrored one.
void water_mirror_headlight(
  const double plane_view[4], double headlight_dir[3], double headlight_position[3]);

// As water_mirror_headlight, for any eye and any mirrored camera, such as one that is mirrored at
// two planes.
void water_mirror_headlight_of(const water_eye* eye, const water_camera* mirrored,
  double headlight_dir[3], double headlight_position[3]);

// (x, y, 1) in NDC of the reflection texture -> (x, y, w) in clip of the eye, of the direction that
// the reflection texture sees there. For a parallel eye that is one and the same direction, and w
// is 0.
//
// reflection_scale  part of the reflection texture that is the eye's own picture, per axis
void water_mirror_reflection_to_eye(const water_camera* camera, const water_eye* eye,
  const double plane_view[4], const double reflection_scale[2], double reflection_ndc_to_eye[9]);

// As water_mirror_reflection_to_eye, for any eye and any mirrored camera.
//
// Returns WATER_OK or WATER_BAD_CAMERA (of the mirrored camera). On an error, the matrix is
// unchanged.
water_status water_mirror_reflection_to(
  const water_camera* camera, const water_camera* mirrored, double reflection_ndc_to_eye[9]);

#ifdef __cplusplus
}
#endif
#endif
