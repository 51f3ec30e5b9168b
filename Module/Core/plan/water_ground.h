// SPDX-License-Identifier: BSD-3-Clause
// water_ground.h: has a scene ground under all of its water, as a terrain or a basin has, or does
// it stand in open water, as a ship does?
//
// It has if a thing that lies under the water is nearly as wide as the scene; or if there is one
// surface along the border of the scene's bounds. Things that stand in open water touch these only
// here and there, or are as high as their walls where they do.
#ifndef water_ground_h
#define water_ground_h

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
  double bounds[4]; // of the scene in the plane's axes: xmin, xmax, ymin, ymax
  double near;      // how far from a place a point counts for it
  double low[WATER_GROUND_PLACES];
  double high[WATER_GROUND_PLACES]; // of the points there, over the plane; low > high: none
  bool has_bed;
} water_ground;

// bounds  finite, min <= max
void water_ground_begin(const double bounds[4], water_ground* ground);

// Adds a thing's bounds: x and y in the plane's axes, then the heights over the plane.
void water_ground_add_bounds(const double bounds[6], water_ground* ground);

// Adds a point of a surface; height over the plane. Numbers that are not finite count nothing.
void water_ground_add_point(double x, double y, double height, water_ground* ground);

bool water_ground_is_under(const water_ground* ground);

#ifdef __cplusplus
}
#endif
#endif
