// SPDX-License-Identifier: BSD-3-Clause
// water_runs.h: large meshes on a GPU: runs of their triangles, so that the mirrored view draws
// only those that the water can show. A GPU draws a triangle sooner than the CPU looks at it. So
// the clusters are large, lie in groups, and what is left of them is a few long runs, drawn in the
// mesh's order from the index buffer that is there: nothing is copied, and every pixel is as
// before. With software rendering, water_clusters.h is used in its place.
#ifndef water_runs_h
#define water_runs_h

#include "water_clusters.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_RUNS_MESH_MIN = 32768, // triangles of a mesh, at least
  WATER_RUNS_LEAF_MIN = 64,    // triangles of a leaf, at least
  WATER_RUNS_LEAVES_MAX = 65536,
  WATER_RUNS_GROUP = 16,    // leaves of a group; the last has what is left
  WATER_RUNS_GAP = 256,     // triangles that are drawn sooner than another run begins
  WATER_RUNS_STRETCHES = 64 // of a mesh, at most, that are drawn without the clip
};

typedef struct water_runs_mesh
{
  size_t triangle_count;
  size_t leaf_triangles; // of a leaf; the last has what is left
  size_t leaf_count;
  size_t group_count;
  double (*boxes)[6]; // of the leaves, then of the groups; min > max: nothing is in it
} water_runs_mesh;

typedef struct water_run
{
  size_t first; // triangle
  size_t count; // > 0
  bool is_cut;  // the clip plane may cut it, or it is short: else the clip may be off
} water_run;

// Should a mesh be drawn as runs? Drawing a smaller mesh takes less time than testing it.
bool water_runs_are_worth(size_t triangle_count);

// Chooses the leaves of a mesh, and sets all but its boxes.
//
// Returns how many boxes it needs; 0: it is drawn as a whole.
size_t water_runs_shape(size_t triangle_count, water_runs_mesh* mesh);

// Empties the boxes.
void water_runs_begin(const water_runs_mesh* mesh);

// Extends the boxes of the leaves by triangles. A mesh may be added in parts, in any order.
//
// first    triangle
// indices  3 for each of count triangles
//
// Returns false when an index is not below point_count.
bool water_runs_add(const water_runs_mesh* mesh, size_t first, const uint32_t* indices,
  size_t count, const water_points* points, size_t point_count);

// Fills the boxes of the groups from those of the leaves.
void water_runs_end(const water_runs_mesh* mesh);

// The runs that may change a pixel, in the mesh's order. Gaps of up to WATER_RUNS_GAP triangles
// between them are drawn, too, where that changes nothing.
//
// view    of the whole drawn part of the reflection texture (water_clusters_view_make)
// places  room for leaf_count
// runs    room for leaf_count
//
// Returns how many there are.
size_t water_runs_select(
  const water_clusters_view* view, const water_runs_mesh* mesh, uint8_t* places, water_run* runs);

#ifdef __cplusplus
}
#endif
#endif
