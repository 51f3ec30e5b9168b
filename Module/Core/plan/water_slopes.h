// SPDX-License-Identifier: BSD-3-Clause
// water_slopes.h: in addition to water_flatness.h: how steep a user's surface is relative to the
// water's plane, and what its vertices need to carry their positions and slopes.
#ifndef water_slopes_h
#define water_slopes_h

#include "water_lookup.h"
#include "water_types.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The state of the inspection of a surface.
typedef struct water_slopes
{
  double normal[3];
  double area;    // twice, of the projection onto the plane
  double squares; // of slopes, times that
} water_slopes;

// unit  normalised plane of the water
void water_slopes_begin(const water_plane* unit, water_slopes* slopes);

// Looks at the triangles of a polygon's fan about its first corner.
//
// points         of the mesh, in its own coordinates: rows of 3
// corners        count points
// mesh_to_world  affine; NULL: the mesh's coordinates are those of the world
void water_slopes_add_polygon(const double* points, const int64_t* corners, size_t count,
  const double mesh_to_world[16], water_slopes* slopes);

// Adds what another inspection with the same plane has seen.
void water_slopes_join(const water_slopes* other, water_slopes* slopes);

// Looks at a triangle: its corners in world. What is not finite is left out, and walls count as
// slopes of 10.
void water_slopes_add(
  const double a[3], const double b[3], const double c[3], water_slopes* slopes);

// The root of the mean square of slopes, by area; 0 without area.
double water_slopes_rms(const water_slopes* slopes);

// Do such slopes turn rays visibly? Yes from 1e-4 on, which moves a reflection by a fifth of a
// pixel in a picture with 1000 pixels per radian.
bool water_slopes_are_seen(double rms);

// The root of the mean square of the slopes of two surfaces, one on the other, such as waves on a
// swell.
double water_slopes_together(double rms_a, double rms_b);

// Places along the plane's axes of points in a mesh's own coordinates, from the point under the
// eye.
//
// origin_xy  of that, as water_lookup_places has it
// across     (point, 1) -> along the first axis
// down       along the second
void water_slopes_places(const water_axes* axes, const double origin_xy[2],
  const double mesh_to_world[16], double across[4], double down[4]);

// The mesh's normals, of any length, in the plane's axes, the third towards the eye. 3 rows of 3;
// 0: the matrix has no inverse.
void water_slopes_normals(
  const water_axes* axes, const double mesh_to_world[16], double normal_to_plane[9]);

#ifdef __cplusplus
}
#endif
#endif
