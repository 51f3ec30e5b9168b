// SPDX-License-Identifier: BSD-3-Clause
// water_footprint.h: an object seen from above: its lowest and highest points over a grid of cells.
// They distinguish a surface, such as a terrain, from a solid.
//
// A surface has its lowest and its highest points close together in each cell. A solid has a gap
// between them. A solid with walls along its rim is a block: a box, or a terrain with a skirt and a
// base. If its top meets its base there, it is an object: a cone, a dome, a hull.
#ifndef water_footprint_h
#define water_footprint_h

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_FOOTPRINT_CELLS = 64 // along each axis
};

typedef enum water_footprint_shape
{
  WATER_FOOTPRINT_SURFACE = 0,
  WATER_FOOTPRINT_BLOCK = 1,
  WATER_FOOTPRINT_OBJECT = 2
} water_footprint_shape;

typedef struct water_footprint
{
  double low[WATER_FOOTPRINT_CELLS][WATER_FOOTPRINT_CELLS];  // [y][x], heights
  double high[WATER_FOOTPRINT_CELLS][WATER_FOOTPRINT_CELLS]; // low > high: no point
  int first[2]; // the cells in use along x and y; first > last: none
  int last[2];
} water_footprint;

void water_footprint_begin(water_footprint* footprint);

// Adds a point; x, y: its cell, in [0, WATER_FOOTPRINT_CELLS).
void water_footprint_add(int x, int y, double height, water_footprint* footprint);

bool water_footprint_has(const water_footprint* footprint, int x, int y);

// The kind of the object. With fewer than 16 cells it is treated as a surface.
water_footprint_shape water_footprint_shape_of(const water_footprint* footprint);

// The lowest level with water over the object: a fiftieth of the object's top lies below it.
// Infinite for an object without points.
double water_footprint_wet_from(const water_footprint* footprint);

#ifdef __cplusplus
}
#endif
#endif
