// SPDX-License-Identifier: BSD-3-Clause
// water_share.h: in addition to the plan: may two waters share one mirrored view?
#ifndef water_share_h
#define water_share_h

#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_share
{
  water_plane plane;
  double origin[3];     // of the plane's own axes, where waves count from
  const void* look;     // tells whether two waters have the same look
  bool is_clear;        // the scene is seen through it
  bool is_displaced;    // waves move the surface itself
  bool is_opaque;       // drawn with the opaque geometry
  bool needs_rays;      // not calm
  bool has_environment; // reflects a static picture of the surroundings
  water_settings settings;
} water_share;

// Can both use one mirrored view without a change of the picture? Not if one of them is clear and
// the eye may be under water: it would be unknown in which of the two waters the eye is.
//
// eye_position  in world
bool water_share_can(
  const water_share* a, const water_share* b, const double eye_position[3], bool is_parallel);

#ifdef __cplusplus
}
#endif
#endif
