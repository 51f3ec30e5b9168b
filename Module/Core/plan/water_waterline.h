// SPDX-License-Identifier: BSD-3-Clause
// water_waterline.h: in addition to the plan: where hulls cut the water's surface, and a table by
// which a pixel finds out whether it is inside a hull's waterline.
//
// A hull consists of triangles. The lines in which they cut the water form closed loops, whatever
// the shape of the hull above and below: only its sides must be closed at the water. All loops get
// the same orientation, and a place is inside if they wind around it at least once. This also holds
// in a hold between thick walls, and where two hulls overlap. Source: Hormann and Agathos 2001,
// "The point in polygon problem for arbitrary polygons" (winding numbers by crossings).
//
// Places are in the plane's own axes about its origin (water_plane_axes); heights are over the
// water's surface.
#ifndef water_waterline_h
#define water_waterline_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_WATERLINE_REACH                                                                      \
  1e12 // of places about the origin: a table of all has no room for more

enum
{
  WATER_WATERLINE_LONGEST = 16384 // texels of a row: what textures have at least on today's GPUs
};

// A piece of a waterline, across one triangle.
typedef struct water_waterline_piece
{
  double ends[2][2];  // x, y of its first and its second end
  size_t edges[2][2]; // the edge of the mesh that each end lies on: its points, the lower one first
  size_t next[2];     // once it is closed: 2 piece + end of what each end meets
  bool is_seen;       // while loops are turned
} water_waterline_piece;

// An end of a piece, to find the other one on the same edge.
typedef struct water_waterline_end
{
  size_t edge[2];
  size_t which; // 2 piece + end
} water_waterline_end;

// Transforms the points of a mesh into the plane's own axes.
//
// points_to_world  of the mesh
// unit             the plane, normalised
// origin           of the plane's own axes
// points           count of 3
// places           count of 3: x, y and height over the plane. May be points
void water_waterline_places(const double points_to_world[16], const water_plane* unit,
  const double origin[3], const double* points, size_t count, double* places);

// The first of places with a number that is not finite, or beyond WATER_WATERLINE_REACH; count:
// there is none.
size_t water_waterline_find_wrong(const double* places, size_t count);

// Finds the places that waves may reach; all others are above or below all waves.
//
// reach  of the waves over and under the plane, >= 0
// near   room for count: the numbers of the places, ascending
//
// Returns how many there are.
size_t water_waterline_near(const double* places, size_t count, double reach, size_t* near);

// Cuts a triangle at the height 0; a corner on it counts as over it.
//
// corners  numbers of its corners in places, x, y and height of each
//
// Returns false when the water does not cut it. Then the piece is unchanged.
bool water_waterline_cut(
  const size_t corners[3], const double* places, water_waterline_piece* piece);

// Closes the pieces of a hull to loops, and turns each counter-clockwise.
//
// ends       room for 2 count
// open_piece  when they do not close, one at whose end the hull is open; of several at one edge of
//             the mesh the last
//
// Returns whether they close; else the pieces are of no use.
bool water_waterline_close(
  water_waterline_piece* pieces, size_t count, water_waterline_end* ends, size_t* open_piece);

// Rows across the longer side of all that is inside. In the table, all rows have as many texels as
// the longest one. The first channel of a row's first texel is the number of edges that cross the
// row. Each of the next texels has one such edge: x and y of its start, then of its end, relative
// to the middle.
typedef struct water_waterline_rows
{
  double middle[2]; // of all
  double half[2];   // from there to the border
  int axis;         // rows lie one after another along that: 0, 1
  int count;        // of rows
  size_t longest;   // texels
} water_waterline_rows;

// Determines the rows for the closed pieces of all hulls. Returns false if there are none.
bool water_waterline_lay(
  const water_waterline_piece* pieces, size_t count, water_waterline_rows* rows);

// Fills the table.
//
// texels  rows->count * rows->longest * 4
void water_waterline_fill(const water_waterline_piece* pieces, size_t count,
  const water_waterline_rows* rows, float* texels);

#ifdef __cplusplus
}
#endif
#endif
