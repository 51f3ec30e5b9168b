// SPDX-License-Identifier: BSD-3-Clause
// water_relief.h: a lower bound of a surface's height at the corners of a grid's cells. Water that
// ends under land uses it to end at the waterline.
//
// A corner gets the height of the faces above it. Between corners, heights are interpolated; where
// the surface is lower than this, the corners are lowered. If these heights are above the water,
// the surface is too.
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

// The lowered height at a corner: in the cells around it, no part of the surface is below the
// heights interpolated between corners. Minus infinity: not known.
double water_relief_at(const water_relief* relief, int x, int y);

// Joins the reliefs of several parts of surfaces: first the heights that all parts have from their
// faces; then each part adds its points to the joined heights, and what they add to below is
// joined.
void water_relief_join_heights(const double* heights, water_relief* relief);
void water_relief_join_below(const double* below, water_relief* relief);

#ifdef __cplusplus
}
#endif
#endif
