// SPDX-License-Identifier: BSD-3-Clause
// water_polygon.h: the normal of a polygon.
#ifndef water_polygon_h
#define water_polygon_h

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

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

// Adds the unit normal of each polygon of a mesh, in floats, to the sums at all of its corners.
//
// points   of the mesh: rows of 3
// starts   count + 1: where each polygon's corners begin in the list, and where the last one's end
// corners  points
// sums     a row of 3 for each point
void water_polygon_add_normals(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, float* sums);

// The points that one thread adds to, if several threads add to one mesh at once.
typedef struct water_polygon_share
{
  const uint16_t* owners; // of each point
  uint16_t owner;
  bool is_owned; // the owner's points, else all but these
} water_polygon_share;

// As water_polygon_add_normals, for a share of the points alone.
void water_polygon_add_shared_normals(const double* points, const int64_t* starts,
  const int64_t* corners, size_t count, const water_polygon_share* share, float* sums);

// Gives sums of normals the length 1. (0, 0, 0) stays.
//
// normals  count rows of 3
void water_polygon_unit_normals(float* normals, size_t count);

#ifdef __cplusplus
}
#endif
#endif
