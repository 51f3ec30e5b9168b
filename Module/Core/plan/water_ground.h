// SPDX-License-Identifier: BSD-3-Clause
// water_ground.h: does a scene have ground under all of its water, such as a terrain or a basin, or
// does it stand in open water, such as a ship?
//
// It has ground if an object under the water is nearly as wide as the scene, or if one surface runs
// along the border of the scene's bounds. Objects in open water touch this border only in places.
// A solid (water_footprint.h) is ground only as a block with water over it, such as a terrain with
// a skirt and a base. A cone, a dome and a barge stand or float in open water.
//
// The dry part of a ground is known. Water under it would be visible only from the side, as a slab
// under the land, and is left out. The stored data about the ground are valid for all water levels.
#ifndef water_ground_h
#define water_ground_h

#include "water_blocks.h"
#include "water_footprint.h"
#include "water_plane.h"
#include "water_relief.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_GROUND_PLACES = 16,                   // along the border, evenly
  WATER_GROUND_CELLS = WATER_FOOTPRINT_CELLS, // of the scene along each axis
  // what processes send: of a ground and the heights of a relief; of what is below these
  WATER_GROUND_NUMBERS = 2 * WATER_GROUND_PLACES + 2 + 2 * WATER_GROUND_CELLS * WATER_GROUND_CELLS +
    WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS,
  WATER_GROUND_BELOW_NUMBERS = WATER_GROUND_CELLS * WATER_GROUND_CELLS
};

typedef struct water_ground
{
  double x_dir[3]; // the plane's axes, through the world's origin
  double y_dir[3];
  double up[3];
  double bounds[4];                    // of the scene in these axes: xmin, xmax, ymin, ymax
  double near;                         // how far from a place a cell counts for it
  double spread[WATER_GROUND_PLACES];  // of a surface's heights in a cell there; infinite: none
  bool has_block[WATER_GROUND_PLACES]; // a block is there
  double block_from;                   // the lowest level with water over a block; infinite: none
  double bed_top;                      // of the lowest thing that is nearly as wide; infinite: none
  double cell_low[WATER_GROUND_CELLS][WATER_GROUND_CELLS]; // [y][x], lowest point; infinite: none
  bool cell_has_block[WATER_GROUND_CELLS][WATER_GROUND_CELLS];
  // [y][x], of all surfaces, as of water_relief_at; infinite: none
  double corner_low[WATER_RELIEF_CORNERS][WATER_RELIEF_CORNERS];
} water_ground;

// plane   of any scale; its offset does not count
// bounds  of the scene, in world
//
// Returns WATER_OK, WATER_BAD_PLANE or, for bounds that are not finite or empty, WATER_BAD_SURFACE.
// On an error, nothing may be added, and there is no ground.
water_status water_ground_begin(
  const water_plane* plane, const double bounds[6], water_ground* ground);

// Adds the bounds, in world coordinates, of an object that may be a bed. Empty bounds are ignored.
void water_ground_add_bounds(const double bounds[6], water_ground* ground);

// Adds a point of an object, in world coordinates, to the object's footprint. Points that are not
// finite are ignored.
void water_ground_see_point(
  const water_ground* ground, const double point[3], water_footprint* footprint);

// Adds a face of an object that is a surface, in world coordinates, to its relief; after all faces,
// adds a point of it. Coordinates that are not finite are ignored.
void water_ground_see_face(const water_ground* ground, double corners[3][3], water_relief* relief);
void water_ground_see_relief(
  const water_ground* ground, const double point[3], water_relief* relief);

// Adds an object after all of its points were added. Objects that stand in the water are not
// ground, nor are columns, which are high blocks with a flat top.
//
// relief  of a surface; NULL: not known
//
// Returns whether it may be a bed. A cone or a column is not, even if it is wholly under water.
bool water_ground_add_thing(
  const water_footprint* footprint, const water_relief* relief, water_ground* ground);

// A ground of several processes, of which each adds the objects that it has: begin; add objects;
// add the faces of all surfaces to one relief; water_ground_write. The numbers of all processes are
// then joined to a ground that was begun with the same plane and bounds, and to a new relief. To
// that, each process adds the points of its surfaces, and the processes join what is below
// (water_relief_join_below). water_ground_take_relief ends it. The order of the processes makes no
// difference. An object that is divided counts as several objects.
void water_ground_write(
  const water_ground* ground, const water_relief* relief, double numbers[WATER_GROUND_NUMBERS]);
void water_ground_join(
  const double numbers[WATER_GROUND_NUMBERS], water_ground* ground, water_relief* relief);
void water_ground_take_relief(const water_relief* relief, water_ground* ground);

// Number of samples along two sides of a triangle, in world coordinates, so that no cell that it
// covers is missed.
int water_ground_across(const water_ground* ground, double corners[3][3]);

// level  height of the water along the normal, from the world's origin
bool water_ground_is_under(const water_ground* ground, double level);

// Is the bed under water flat, like that of a tank or a pool? Then most of it is about as deep as
// its deepest place.
bool water_ground_is_flat(const water_ground* ground, double level);

// The part of a cell that is not known to be above the water, at the level: up to two convex parts,
// whose edges coincide with those of the adjacent cells. The edge towards dry land is where a
// height interpolated between corners of cells reaches the level. A corner has the height given by
// the reliefs of all surfaces. Where these are not known, it has the height of the lowest point
// within two cells in each direction, because faces reach from cell to cell. If one of these cells
// has no point, the corner is wet.
//
// parts  corners in world, x, y, z of four each, counter-clockwise about the normal; two of them
//        may be the same
//
// Returns the number of parts.
int water_ground_wet(const water_ground* ground, double level, int x, int y, double parts[24]);

// Finds the cells that are wet at the level, as blocks.
//
// Returns whether one of them is not.
bool water_ground_find_blocks(const water_ground* ground, double level, water_blocks* blocks);

// The parts of a block that begins at a cell: one, or triangles about its middle, with the vertices
// of its neighbours. As water_ground_wet's.
int water_ground_block(const water_ground* ground, double level, const water_blocks* blocks, int x,
  int y, double parts[96]);

#ifdef __cplusplus
}
#endif
#endif
