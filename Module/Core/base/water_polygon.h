// SPDX-License-Identifier: BSD-3-Clause
// water_polygon.h: the normal of a polygon.
#ifndef water_polygon_h
#define water_polygon_h

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The unit normal of a polygon, which may be concave or not quite flat: the direction of its area
// vector, the sum of the cross products of a fan's edges. Seen from where it points, the corners
// turn counter-clockwise.
//
// corners  count points of 3, in order
// normal   (0, 0, 0) if there is none
//
// Returns whether there is one: the polygon has three corners or more and an area that is finite.
bool water_polygon_normal(const double* corners, size_t count, double normal[3]);

#ifdef __cplusplus
}
#endif
#endif
