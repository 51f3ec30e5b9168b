// SPDX-License-Identifier: BSD-3-Clause
// water_pieces.h: step 4: large meshes in pieces, so that the mirrored view draws only those that
// the water can show. A piece is a run of a mesh's triangles in the order they are drawn in: what
// is left is drawn in that order, too, and covers every pixel as before. So it does from the last
// triangle to the first, if of equally far ones the first drawn stays: a mesh that runs towards the
// eye is drawn that way, and what is near hides what is far before that is shaded.
#ifndef water_pieces_h
#define water_pieces_h

#include "water_frustum.h"
#include "water_seen.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_PIECE_TRIANGLES = 32, // of a piece; the last has what is left
  WATER_PIECES_MIN = 128,     // a smaller mesh is drawn as a whole
  WATER_TREND_COLUMNS = 64,   // cells of the picture: what lies one behind the other is in a column
  WATER_TREND_ROWS = 4
};

typedef struct water_points // xyz, one of the two
{
  const float* floats;
  const double* doubles;
} water_points;

// Number of pieces of a mesh; 0: it is drawn as a whole.
size_t water_pieces_count(size_t triangle_count);

// The boxes around the pieces.
//
// indices  3 per triangle, of points
// boxes    one per piece: xmin, xmax, ymin, ymax, zmin, zmax; infinite where the points are
//
// Returns false when an index is not below point_count.
bool water_pieces_bound(const water_points* points, size_t point_count, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6]);

// What the pieces must meet to be drawn, in the mesh's own coordinates.
typedef struct water_pieces_view
{
  water_frustum frustum; // the part of the mirrored one behind the drawn part of the map; in place
                         // of its far plane the kept side of the clip
  double to_clip[16];
  const water_seen* seen; // NULL: all of the drawn part of the map is
} water_pieces_view;

// model_to_world  affine
void water_pieces_look(const water_plan* plan, const water_seen* seen,
  const double model_to_world[16], water_pieces_view* view);

// Whether pieces come nearer in the order they are drawn in, where one lies behind the other; all
// 0: none is drawn yet.
typedef struct water_trend
{
  double last_distance[WATER_TREND_ROWS][WATER_TREND_COLUMNS]; // by place in the picture; 0: none
  int nearer_steps;                                            // from piece to piece in a cell
  int farther_steps;
} water_trend;

// Copies the indices of the pieces that may be seen, in their order or from the last triangle to
// the first.
//
// trend  of all pieces drawn so far in a view; these are added
// drawn  room for 3 * triangle_count
//
// Returns how many indices were copied.
size_t water_pieces_select(const water_pieces_view* view, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6], bool is_reversed, water_trend* trend, uint32_t* drawn);

#ifdef __cplusplus
}
#endif
#endif
