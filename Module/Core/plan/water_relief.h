// SPDX-License-Identifier: BSD-3-Clause
// water_relief.h: how high a surface is at the corners of a grid's cells, at least: the border of
// water that ends under a land's edge is to follow the waterline.
//
// A corner has the height of the faces over it. Between corners, heights are interpolated, and a
// surface that is lower there lowers the corners: what is over the water by these heights is so.
#ifndef water_relief_h
#define water_relief_h

#include "water_footprint.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_RELIEF_CORNERS = WATER_FOOTPRINT_CELLS + 1 // along each axis
};

typedef struct water_relief
{
  double height[WATER_RELIEF_CORNERS][WATER_RELIEF_CORNERS]; // [y][x]; infinite: no face
  // [y][x], how far the surface reaches under what is interpolated; infinite: no point
  double below[WATER_FOOTPRINT_CELLS][WATER_FOOTPRINT_CELLS];
} water_relief;

void water_relief_begin(water_relief* relief);

// Adds a face.
//
// corners  x and y in cells of the grid, from its border, and a height
void water_relief_add_triangle(double corners[3][3], water_relief* relief);

// Adds a point of the surface, once it has all of its faces; as a corner of a face.
void water_relief_add_point(const double point[3], water_relief* relief);

// The least height at a corner of cells, so that nothing of the surface in the cells around it is
// lower than what is interpolated between corners. Minus infinity: not known.
double water_relief_at(const water_relief* relief, int x, int y);

#ifdef __cplusplus
}
#endif
#endif
