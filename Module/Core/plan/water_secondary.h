// SPDX-License-Identifier: BSD-3-Clause
// water_secondary.h: other water as the mirrored view of a water shows it.
//
// It is a surface with its own colour that reflects the background with its own Fresnel
// reflectance. It needs no reflection texture, which ends the recursion of mirrors. Its waves are
// shown as roughness, their mean over time, so that a reflection texture does not depend on the
// time of another water's waves.
//
// With secondary reflections it reflects the scene instead: it looks up a secondary view, that of
// the mirrored camera, mirrored again in its own plane. In that view other waters reflect the
// background.
#ifndef water_secondary_h
#define water_secondary_h

#include "water_status.h"
#include "water_types.h"
#include "water_waves.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Plans another water for the mirrored view of a plan.
//
// scene     of the other water: its plane, plane_origin, surface_bounds and look, the environment,
//           the sky and the eye of the picture; nothing else counts
// mirrored  the plan in whose view it is drawn
// plan      has the view of the mirrored camera, except for dir_to_eye: the background is fixed to
//           the screen of the picture, so dir_to_eye is that of scene->eye
//
// Returns WATER_OK or the status of water_plan_make; then the plan has no view, and the plain
// colour is shown.
water_status water_secondary_plan(
  const water_scene* scene, const water_plan* mirrored, water_plan* plan);

// Makes the scene of a secondary view from the scene of another water in the picture.
//
// mirrored     the plan in whose view the other water is drawn; it must outlive the scene
// picture_eye  the eye of the picture; the same
// is_rough     the other water has waves
// scene        with all props, and the settings of the pass whose plan this is
void water_secondary_view(
  const water_plan* mirrored, const water_camera* picture_eye, bool is_rough, water_scene* scene);

// Variances xx, yy and xy of all slopes along the plane's axes: of checked waves by the sums of
// (k A)^2 / 2, of a wind sea, and those given for what is too small for either.
//
// sea    of all waves of a wind sea, along and across sea_dir_rad; 0 without one
// given  along and across dir_rad, as water_glitter_covariance has it
void water_secondary_slopes(const water_wave* waves, size_t count, const double sea[2],
  double sea_dir_rad, const double given[2], double dir_rad, double covariance[3]);

#ifdef __cplusplus
}
#endif
#endif
