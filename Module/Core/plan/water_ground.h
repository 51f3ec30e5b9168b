// SPDX-License-Identifier: BSD-3-Clause
// water_ground.h: has a scene ground under all of its water, as a terrain or a basin has, or does
// it stand in open water, as a ship does?
//
// It has if a thing that lies under the water is nearly as wide as the scene; or if there is one
// surface along the border of the scene's bounds. Things that stand in open water touch these only
// here and there, or are as high as their walls where they do.
#ifndef water_ground_h
#define water_ground_h

#include "water_plane.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_GROUND_PLACES = 16 // along the border, evenly
};

typedef struct water_ground
{
  double origin[3]; // of the plane's axes
  double x_dir[3];
  double y_dir[3];
  double up[3];
  double bounds[4]; // of the scene in the plane's axes: xmin, xmax, ymin, ymax
  double near;      // how far from a place a point counts for it
  double low[WATER_GROUND_PLACES];
  double high[WATER_GROUND_PLACES]; // of the points there, over the plane; low > high: none
  bool has_bed;
} water_ground;

// plane   of any scale
// origin  of its axes, in world
// bounds  of the scene, in world
//
// Returns WATER_OK, WATER_BAD_PLANE_NORMAL, WATER_BAD_PLANE_OFFSET or, for bounds that are not
// finite or empty, WATER_BAD_SURFACE; then nothing may be added, and there is no ground.
water_status water_ground_begin(
  const water_plane* plane, const double origin[3], const double bounds[6], water_ground* ground);

// Adds a thing's bounds, in world; empty ones count nothing.
void water_ground_add_bounds(const double bounds[6], water_ground* ground);

// Adds a point of a surface, in world. Numbers that are not finite count nothing.
void water_ground_add_point(const double point[3], water_ground* ground);

bool water_ground_is_under(const water_ground* ground);

#ifdef __cplusplus
}
#endif
#endif
