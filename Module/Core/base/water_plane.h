// SPDX-License-Identifier: BSD-3-Clause
// water_plane.h: the plane: normalise, height of a point, mirror matrix, own axes, sheet.
//
// Errors, in roundings u = 2^-53: the relative error of a unit normal and of its offset is at most
// 6 u. Mirroring twice is the identity within 48 u, and for the translation within 64 u of the
// offset. Testing/Core/Stability derives and checks these bounds; Documentation/stability.md has
// measurements.
#ifndef water_plane_h
#define water_plane_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Makes the normal unit length and scales the offset with it, so that heights are distances.
//
// Returns WATER_OK or WATER_BAD_PLANE (not finite, a zero normal, or over 1e100 from the origin).
// On an error, *unit is unchanged.
water_status water_plane_normalise(const water_plane* plane, water_plane* unit);

// Signed distance of a point from a normalised plane, positive above the water.
static inline double water_plane_height(const water_plane* unit, const double point[3])
{
  return unit->normal[0] * point[0] + unit->normal[1] * point[1] + unit->normal[2] * point[2] +
    unit->offset;
}

// Are two normalised planes the same within rounding, with equal or opposite normals? reach is the
// largest distance of their points from the world's origin.
bool water_plane_is_same(const water_plane* a, const water_plane* b, double reach);

// Are two planes of any scale the same, bit by bit, after normalisation? False if one of them
// cannot be normalised.
bool water_plane_is_identical(const water_plane* a, const water_plane* b);

// Are two planes of any scale the same within rounding, with equal or opposite normals? False if
// one of them cannot be normalised.
//
// origin_a, origin_b  of their own axes: the points, far from the world's origin, of the comparison
bool water_plane_is_shared(
  const water_plane* a, const double origin_a[3], const water_plane* b, const double origin_b[3]);

// The point of a normalised plane that is nearest to a point. projected may be point.
void water_plane_project(const water_plane* unit, const double point[3], double projected[3]);

// The mirror at a normalised plane as a matrix, I - 2 n n^T with its translation; determinant -1.
// Source: Householder 1958, "Unitary Triangularization of a Nonsymmetric Matrix".
void water_plane_mirror_matrix(const water_plane* unit, double world_to_mirrored[16]);

// The plane's own axes, both unit length: x_dir is the world's x projected onto the plane (the
// world's y when the normal is within 45 degrees of x), y_dir = normal x x_dir. For a level plane
// they are the world's x and y.
void water_plane_axes(const double unit_normal[3], double x_dir[3], double y_dir[3]);

// Unit vector to a direction in the sky: azimuth in radians from the plane's second axis over the
// first (north over east for a level plane), elevation in radians over the plane.
void water_plane_sky_direction(
  const double unit_normal[3], double azimuth_rad, double elevation_rad, double direction[3]);

// The rectangle over the plane that covers a box: xmin, xmax, ymin, ymax in the plane's own axes
// about origin.
//
// bounds  xmin, xmax, ymin, ymax, zmin, zmax in world
//
// Returns WATER_OK or WATER_BAD_SURFACE (bounds empty or not finite). On an error, sheet is
// unchanged.
water_status water_sheet_bounds(const double origin[3], const double x_dir[3],
  const double y_dir[3], const double bounds[6], double sheet[4]);

// Bounds, in world coordinates, of a surface that waves displace.
//
// unit    normalised
// bounds  at rest: xmin, xmax, ymin, ymax, zmin, zmax in world
// height  how far a point moves along the normal at most, up or down
// reach   and in the plane
void water_plane_displaced_bounds(const water_plane* unit, const double bounds[6], double height,
  double reach, double displaced[6]);

// As water_sheet_bounds, for a plane of any scale, in its own axes about origin.
//
// Returns as water_plane_normalise, or WATER_BAD_SURFACE. On an error, sheet is unchanged.
water_status water_sheet_around(
  const water_plane* plane, const double origin[3], const double bounds[6], double sheet[4]);

// The plane with its normal towards an eye on a side of it.
water_plane water_plane_turned(const water_plane* plane, water_side side);

// The sheet's corners in world, counter-clockwise about the normal: 4 points of 3.
void water_sheet_corners(const double origin[3], const double x_dir[3], const double y_dir[3],
  const double sheet[4], double corners[12]);

#ifdef __cplusplus
}
#endif
#endif
