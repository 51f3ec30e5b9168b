// SPDX-License-Identifier: BSD-3-Clause
// water_sky_view.h: the sky view: meshes that may be the sky, such as a dome around the eye, in a
// wide view along the reflected rays. Waves turn rays out of the reflection texture, which is
// little wider than the picture; the sky view shows what they meet there.
//
// The point that a ray meets is found by a few spheres around the camera of the view, each as wide
// as the last point is far away (Szirmay-Kalos et al. 2005, "Approximate Ray-Tracing on the GPU
// with Distance Impostors").
#ifndef water_sky_view_h
#define water_sky_view_h

#include "water_camera.h"
#include "water_lookup.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// A camera that looks along a direction, 140 degrees wide. Rays that leave the water upwards are
// all that it serves, so the view begins a little under the horizon.
//
// at      in world
// ahead   in world, unit length; not under the plane
// normal  of the plane, upwards
// far     distance of all that is to be seen, > 0
void water_sky_view_camera(const double at[3], const double ahead[3], const double normal[3],
  double far, water_camera* camera);

// How far everything in a mirrored view reaches, except what may be the sky.
//
// plane    normalised, normal towards the eye
// reasons  of the props in the mirrored view
// top      height over the plane, >= 0; infinite with a prop without bounds
// depth    window depth of the mirrored view, in [0, 1]
void water_sky_view_rest(const water_camera* mirrored, const water_plane* plane,
  const water_eye* eye, const water_prop* props, size_t prop_count,
  const water_cull_reason* reasons, double* top, double* depth);

// Fills what a plan knows of the sky view: camera, size, clip, where its shader finds what, and the
// reason for every prop. Where no drawn prop may be the sky, or no rays are traced, the decision is
// WATER_NO_REFLECT_OUT_OF_VIEW.
//
// plane   normal towards the eye
// margin  how far the surface lies below it, >= 0
// box     of the picture that the water covers, NDC of the eye
// plan    the fields of the view are set
//
// Returns WATER_OK or the status of what cannot be planned.
water_status water_sky_view_plan(const water_scene* scene, const water_plane* plane,
  const water_axes* axes, double margin, const double box[4], water_plan* plan,
  water_cull_reason* reasons);

#ifdef __cplusplus
}
#endif
#endif
