// SPDX-License-Identifier: BSD-3-Clause
// water_shore.h: where a solver's water is, and where it ends between the places that the solver
// knows.
//
// Level, bed and depth are heights in one unit; level = bed + depth. A solver clamps depths at 0,
// so they do not show where the water ends between a wet and a dry place. The level does: it is
// extended beyond the shore, and the shore is where the bed reaches it.
#ifndef water_shore_h
#define water_shore_h

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_column
{
  double level; // of the surface; NaN: not known
  double bed;   // minus infinity: not known, far below
  double depth; // infinity: not known
  bool is_wet;
} water_column;

// Heights and depths farther than that from 0 are fill values of files, in any unit of length.
#define water_shore_highest 1e9

// A height or depth as it is given; NaN if it is such a fill value.
double water_shore_known(double height);

// A value of an array that a solver gives: NaN marks a place without a value, as a fill value does,
// and becomes one.
double water_shore_given(double height);

// Completes the heights that a solver gives for a place; pass NaN for those that it does not give.
// With a depth, that determines whether the place is wet. With the level alone it is wet.
//
// dry_depth  a place with no more water than that is dry, >= 0
//
// A place with a value that is not finite, that lies beyond water_shore_highest, or with a depth
// below 0, is dry.
water_column water_shore_column(double level, double bed, double depth, double dry_depth);

// Depth of the water, negative where the bed is above it. The shore is where this depth is 0 on the
// straight line between two places.
//
// is_wet  as the solver says; a dry place is never under water, even if its bed is below the level:
//         a dyke may keep it dry
// level   of a dry place: that of the wet ones beside it; NaN: there are none, or it is a divide
double water_shore_depth(bool is_wet, double level, double bed);

// What a solver gives of points, and what is found of them: rows of the same length.
typedef struct water_shore_rows
{
  const double* given_levels; // NULL: not given; NaN is a fill value
  const double* given_beds;
  const double* given_depths;
  double* levels; // as of water_shore_level; that of land is its bed's
  double* depths; // as of water_shore_depth
  double* beds;   // of water_column
  char* are_wet;
} water_shore_rows;

// water_shore_column, water_shore_depth and water_shore_level of many points; land has no level.
//
// Returns whether a wet point has no water by its level and bed.
bool water_shore_columns(const water_shore_rows* rows, size_t count, double dry_depth);

// Is a cell that the solver calls dry kept dry by a dyke? It is unless the height of its bed
// reaches the mean level of its corners, or lacks no more than a film of water. Then all of it is
// dry, not only what rises above the water.
//
// bed     of the cell; NaN: the mean of its corners
// levels  of the corners, as in water_shore_depth; those that are not finite do not count
// beds    of the corners, likewise; without any bed, nothing shows that it is high enough
bool water_shore_is_dyke(
  double bed, const double* levels, const double* beds, size_t count, double dry_depth);

// Do the levels of two wet places differ by more than a film of water, and more than floats round
// them?
bool water_shore_are_apart(double level, double other, double dry_depth);

// Are two places beside a dry one of two lakes, if the waters are lakes? Around the dry place there
// are up to four neighbours from one to the other, each of which may be higher by a film.
bool water_shore_are_of_lakes(double level, double other, double dry_depth);

// Are waters lakes? They are if more than two of three wet neighbours at the shore have one level,
// or if no neighbours have different levels. A dry place beside two lakes at different levels is a
// divide, and each lake ends before it at its own level. The mean of both levels would tilt both of
// them there, and join them. The level of other water, such as a river, changes from place to
// place, and its mean is extended beyond the shore.
//
// Neighbours are both ends of a side of a cell. Wet places of a cell with dry ones between them on
// both sides may be of two lakes. Of a river along the rows of a grid, half of the sides lead
// across it and are level: a simple majority would change with every step.
//
// level   wet neighbours in cells at the shore that have one level
// uneven  those that are apart
bool water_shore_are_lakes(size_t level, size_t uneven);

// The shore between a wet place and a divide: the share of the way, in (0, 1], at which the bed
// reaches the level of the wet place.
//
// depth, level  of the wet place
// bed           of the divide
double water_shore_before_divide(double depth, double level, double bed);

// The level of a point as a surface has it: where there is none, that of its bed, otherwise 0.
double water_shore_level(double level, double bed);

// A corner of what is wet of a polygon: a corner of the polygon (from == to, share 0), or the shore
// on one of its edges.
typedef struct water_shore_corner
{
  size_t from; // the polygon's corner; of an edge the wet one, so that both of its polygons agree
  size_t to;
  double share; // of the way from there, in (0, 1)
} water_shore_corner;

// The part of a convex polygon that is under water, in the polygon's order. The depth is linear
// along the edges; a corner of depth 0 is on the shore.
//
// depths   count of them, finite
// corners  room for 2 count
//
// Returns the number of corners: 0, or 3 and more.
size_t water_shore_cut(const double* depths, size_t count, water_shore_corner* corners);

// The place of such a corner on an edge: the surface continues in a straight line from the wet end.
//
// from   x, y and level of the edge's wet end
// to     the same of its dry end
// share  as of water_shore_corner
// point  x, y and level
void water_shore_point(const double from[3], const double to[3], double share, double point[3]);

// A triangle of a convex polygon with n corners: those that meet in its first corner, as VTK draws
// quads.
//
// number   0 to n - 3
// corners  of the polygon, in its order
void water_shore_triangle(size_t number, size_t corners[3]);

// Does water meet land more than once along a polygon's border? Then its triangles are cut instead.
bool water_shore_is_split(const double* depths, size_t count);

#ifdef __cplusplus
}
#endif
#endif
