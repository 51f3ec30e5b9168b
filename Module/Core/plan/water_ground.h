// SPDX-License-Identifier: BSD-3-Clause
// water_ground.h: has a scene ground under all of its water, as a terrain or a basin has, or does
// it stand in open water, as a ship does?
//
// It has ground if an object under the water is nearly as wide as the scene, or if one surface runs
// along the border of the scene's bounds. Objects in open water touch this border only in places,
// or with high walls.
//
// The dry part of a ground is known. Water under it would be visible only from the side, as a slab
// under the land, and is left out. None of this depends on the level, which may therefore change.
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
  WATER_GROUND_PLACES = 16, // along the border, evenly
  WATER_GROUND_CELLS = 64   // of the scene along each axis
};

typedef struct water_ground
{
  double x_dir[3]; // the plane's axes, through the world's origin
  double y_dir[3];
  double up[3];
  double bounds[4];                 // of the scene in these axes: xmin, xmax, ymin, ymax
  double near;                      // how far from a place a point counts for it
  double low[WATER_GROUND_PLACES];  // heights are along the normal, from the world's origin
  double high[WATER_GROUND_PLACES]; // of the points there; low > high: none
  double bed_top;                   // of the lowest thing that is nearly as wide; infinite: none
  double cell_low[WATER_GROUND_CELLS][WATER_GROUND_CELLS]; // [y][x], lowest point; infinite: none
} water_ground;

// plane   of any scale; its offset does not count
// bounds  of the scene, in world
//
// Returns WATER_OK, WATER_BAD_PLANE_NORMAL, WATER_BAD_PLANE_OFFSET or, for bounds that are not
// finite or empty, WATER_BAD_SURFACE; then nothing may be added, and there is no ground.
water_status water_ground_begin(
  const water_plane* plane, const double bounds[6], water_ground* ground);

// Adds a thing's bounds, in world; empty ones count nothing.
void water_ground_add_bounds(const double bounds[6], water_ground* ground);

// Adds a point of a surface, in world. Points that are not finite are ignored.
void water_ground_add_point(const double point[3], water_ground* ground);

// Number of samples along each side of a face, so that every cell gets a point for a mesh with this
// number of faces.
int water_ground_across(double faces);

// level  height of the water along the normal, from the world's origin
bool water_ground_is_under(const water_ground* ground, double level);

// What of a cell is not known to be over the water, at the level: up to two convex parts, whose
// edges are those of the parts of the cells beside it. The edge against what is dry runs where a
// height between corners of cells reaches the level; a corner is as high as the lowest point in the
// two cells around it each way, for faces reach from cell to cell. Without a point in one of them
// it is wet.
//
// parts  corners in world, x, y, z of four each, counter-clockwise about the normal; two of them
// may
//        be the same
//
// Returns the number of parts.
int water_ground_wet(const water_ground* ground, double level, int x, int y, double parts[24]);

#ifdef __cplusplus
}
#endif
#endif
