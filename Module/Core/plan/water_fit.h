// SPDX-License-Identifier: BSD-3-Clause
// water_fit.h: the plane that best fits a part of a surface, such as one lake of several, and which
// parts lie in one plane.
//
// The plane minimises the mean square of heights, weighted by the area projected along the up
// direction, because the error of the mirrored view grows with the surface's height above its
// plane. Integrals over triangles are exact, so the plane does not depend on the triangulation. The
// plane is level unless a tilt explains most of the heights.
#ifndef water_fit_h
#define water_fit_h

#include "water_status.h"
#include "water_types.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The state of the inspection of a part. Positions are relative to origin, to keep precision.
typedef struct water_fit
{
  double up[3]; // unit length; the other two are the plane's own axes (water_plane_axes)
  double x_dir[3];
  double y_dir[3];
  bool is_upright;  // up is z, and the axes are those of the world
  double origin[3]; // the first corner
  double area;      // seen along up
  double first[3];  // integrals of x, y and the height
  double second[6]; // of xx, xy, yy, x height, y height, height height
  double bounds[6]; // xmin, xmax, ymin, ymax, zmin, zmax in world
} water_fit;

typedef struct water_fit_plane
{
  double normal[3]; // unit length, up
  double origin[3]; // of a level plane over the world's origin, else in the middle of the part
  double middle[3]; // of the part, on the plane
  double reach;     // no point of the part is farther from there along the axes' diagonal
  double area;      // of the part, seen along up
  double rms;       // of heights over the plane
  bool is_level;
} water_fit_plane;

// up  unit length
void water_fit_begin(const double up[3], water_fit* fit);

// Adds a polygon, which may be concave.
//
// corners  in world, in order around it: count points of 3
//
// Returns whether it was added: it has three corners or more, and no coordinate is over 1e100 or is
// not finite.
bool water_fit_add_polygon(const double* corners, size_t count, water_fit* fit);

// Adds polygons of a mesh, up to the first one that cannot be added.
//
// points   of the mesh, in world: rows of 3
// starts   count + 1: where each polygon's corners begin in the list, and where the last one's end
// corners  points, all in [0, number of points)
//
// Returns the number of those that were added.
size_t water_fit_add_polygons(const double* points, const int64_t* starts, const int64_t* corners,
  size_t count, water_fit* fit);

// Adds a triangle: its corners in world. Triangles that are not finite are ignored.
void water_fit_add(const double a[3], const double b[3], const double c[3], water_fit* fit);

// Adds all that another fit with the same up direction has, so that blocks of a part may be added
// separately.
void water_fit_join(const water_fit* other, water_fit* fit);

// The plane of the triangles added so far. It is level in three cases: the best plane is tilted by
// less than 1e-4 rad, which moves a reflection by less than a fifth of a pixel in a picture with
// 1000 pixels per radian; the tilt explains less than half of the heights' mean square, as with
// waves; or the tilt is steeper than 30 degrees, which water never is.
//
// Returns WATER_OK or WATER_BAD_SURFACE (no area, or so large that squares overflow). On an error,
// *plane is unchanged.
water_status water_fit_judge(const water_fit* fit, water_fit_plane* plane);

// Largest distance at which the planes of two parts of a surface are treated as one plane.
//
// diagonal    of the surface's bounds
// coordinate  the largest of them, without its sign
// is_single   coordinates are floats
double water_fit_tolerance(double diagonal, double coordinate, bool is_single);

// Finds which parts lie in one plane. A part joins the first plane from which no point of it is
// farther than the tolerance. Otherwise it begins a new plane or, if their maximum number is
// reached, has none. The view that is mirrored at another plane does not show what such a part
// reflects: from the eye mirrored there, the ground between the plane and the part hides it.
//
// The first part begins a plane, whatever the tolerance.
//
// parts  the largest first
// most   planes, >= 1
// plane  of each part: the number of its plane, which are counted in order; of a part without one
//        the number of planes
// first  of each plane: the part that it is of; room for most
//
// Returns the number of planes.
size_t water_fit_share(const water_fit_plane* parts, size_t count, double tolerance, size_t most,
  size_t* plane, size_t* first);

// The plane of all parts that have none of their own, which decides only from which side they are
// seen: the level plane through the lowest of them. An eye above it sees each from above, or not at
// all.
//
// plane, planes  as water_fit_share has found them
// up             unit length
//
// Returns whether there are such parts. Otherwise *rest is unchanged.
bool water_fit_rest(const water_fit_plane* parts, size_t count, const size_t* plane, size_t planes,
  const double up[3], water_fit_plane* rest);

#ifdef __cplusplus
}
#endif
#endif
