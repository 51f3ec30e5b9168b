// SPDX-License-Identifier: BSD-3-Clause
// water_share.h: in addition to the plan: may two sheets of water share one mirrored view?
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
  const void* look;     // tells whether two sheets have the same look
  bool is_clear;        // the scene is seen through it
  bool is_displaced;    // waves move the surface itself
  bool is_opaque;       // drawn with the opaque geometry
  bool needs_rays;      // not calm
  bool has_environment; // reflects a static picture of the surroundings
  water_settings settings;
} water_share;

// Would both have the same mirrored view, and look the same with it? Never for two clear waters if
// the eye may be inside one of them: it would not be known which.
//
// eye_position  in world
bool water_share_can(
  const water_share* a, const water_share* b, const double eye_position[3], bool is_parallel);

#ifdef __cplusplus
}
#endif
#endif
