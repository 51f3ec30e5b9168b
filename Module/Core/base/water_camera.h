// SPDX-License-Identifier: BSD-3-Clause
// water_camera.h: decomposes the eye's camera once for all steps: inverses, projection centre, view
// rays.
//
// view_to_clip determines whether the eye is perspective or parallel (parallel: clip w is
// constant), so every matrix that a host can draw with is supported; water_camera.parallel is only
// passed on. In front of the eye clip w is positive, as OpenGL's clipping demands.
#ifndef water_camera_h
#define water_camera_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_eye
{
  double view_to_world[16];
  double clip_to_view[16];
  bool has_center;       // perspective: all view rays meet in center_view
  double center_view[3]; // the eye point in view space; the origin unless the projection is sheared
  double ndc_to_dir[9];  // (x, y, 1) in NDC -> direction of the view ray in view space, away from
                         // the eye; perspective: of clip w 1; parallel: unit length, for all pixels
} water_eye;

// Decomposes a camera.
//
// Returns WATER_OK or WATER_BAD_CAMERA (a matrix or its inverse is not finite or has an entry over
// 1e100, the view is further than 1e-6 from a proper rotation with translation, or the projection
// has no inverse). On an error, *eye is unchanged.
water_status water_camera_decompose(const water_camera* camera, water_eye* eye);

// The view ray of a pixel in the plane's own axes, for the third one towards the eye.
//
// plane       normalised, normal towards the eye
// x_dir       with y_dir the plane's own axes (water_plane_axes of the plane as the user gave it)
// ndc_to_ray  (x, y, 1) in NDC -> direction in (x_dir, y_dir, plane->normal), away from the eye
void water_camera_rays(const water_eye* eye, const water_plane* plane, const double x_dir[3],
  const double y_dir[3], double ndc_to_ray[9]);

// A plane given in world, for points in view space: dot(plane_view, (x, y, z, 1)) is the height.
void water_camera_plane_view(const water_eye* eye, const water_plane* plane, double plane_view[4]);

#ifdef __cplusplus
}
#endif
#endif
