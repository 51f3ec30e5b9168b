// SPDX-License-Identifier: BSD-3-Clause
// water_clusters.h: splits large meshes into clusters, so that the mirrored view draws only those
// that the water can show. A cluster is a run of consecutive triangles. The remaining clusters are
// drawn in the mesh's order, so every pixel is as before. It is also as before if they are drawn
// from the last triangle to the first and, of equally distant triangles, the first drawn one stays.
// A mesh that runs towards the eye is drawn in this way: near triangles then hide far ones before
// those are shaded. Where triangles are expensive, those of the remaining clusters are tested
// individually (water_triangle_cull.h).
#ifndef water_clusters_h
#define water_clusters_h

#include "water_frustum.h"
#include "water_triangle_cull.h"
#include "water_types.h"
#include "water_visibility.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_CLUSTER_TRIANGLES = 32, // of a cluster; the last has what is left
  WATER_CLUSTERS_MIN = 128,     // a smaller mesh is drawn as a whole
  WATER_CLUSTERS_BANDS_MAX = 4,
  WATER_BAND_CLUSTERS = 200, // for fewer, a thread takes longer to begin than it saves
  WATER_TREND_COLUMNS = 64,  // cells of the picture: what lies one behind the other is in a column
  WATER_TREND_ROWS = 4
};

// How many bands are worth a thread each.
//
// core_count  of the machine; 0: not known
int water_clusters_bands(bool is_software, size_t triangle_count, unsigned core_count);

// Number of clusters of a mesh; 0: it is drawn as a whole.
size_t water_clusters_count(size_t triangle_count);

typedef struct water_mesh
{
  water_points points;
  size_t point_count;
  const uint32_t* indices; // 3 per triangle, of points
  size_t triangle_count;
  double (*boxes)[6]; // one per cluster: xmin, xmax, ymin, ymax, zmin, zmax; infinite where the
                      // points are
} water_mesh;

// Fills the boxes around the clusters.
//
// Returns false when an index is not below point_count.
bool water_clusters_bound(const water_mesh* mesh);

// What the clusters must meet to be drawn.
typedef struct water_clusters_view
{
  water_frustum frustum; // the part of the mirrored one behind the drawn part of the reflection
                         // texture; in place of its far plane the kept side of the clip; relative
                         // to the origin of triangles
  water_triangle_cull_view triangles;
  bool is_fine; // triangles are tested individually
} water_clusters_view;

// What the clusters are drawn into.
typedef struct water_clusters_target
{
  const water_visibility* seen; // NULL: all of its drawn part is looked up
  float* depths;                // water_triangle_cull.h; NULL: none
  int samples;                  // of a pixel; 0 and 1: its middle
  int subpixel_bits;            // of the GPU: it puts corners at multiples of 2^-bits pixels
} water_clusters_target;

// band            of band_count bands of columns of the drawn part, of which each has its own view:
//                 what may change a pixel is marked in one of them, at least
// is_solid        every pixel that a triangle of the mesh covers gets its colour and depth
// model_to_world  affine
// origin          what the GPU's coordinates of the mesh are relative to: they are in single
//                 precision
void water_clusters_view_make(const water_plan* plan, const water_clusters_target* target, int band,
  int band_count, bool is_solid, const double model_to_world[16], const double origin[3],
  water_clusters_view* view);

typedef enum water_box_place
{
  WATER_BOX_OUTSIDE, // no pixel of it changes
  WATER_BOX_ACROSS,  // some may, others not; or nothing is known
  WATER_BOX_INSIDE   // all of it lies in the view: so do all boxes in it
} water_box_place;

// Where a box of the mesh's own coordinates lies in a view. min > max: it is empty, outside.
water_box_place water_clusters_place(const water_clusters_view* view, const double box[6]);

// Does a box of the mesh's own coordinates lie wholly on the kept side of the clip, by more than
// rounding?
bool water_clusters_is_kept(const water_clusters_view* view, const double box[6]);

// Whether clusters that hide each other become nearer in the order in which they are drawn; all 0:
// none is drawn yet.
typedef struct water_trend
{
  double last_distance[WATER_TREND_ROWS][WATER_TREND_COLUMNS]; // by place in the picture; 0: none
  int nearer_steps;                                            // from cluster to cluster in a cell
  int farther_steps;
} water_trend;

// What is noted of a cluster.
typedef struct water_cluster_work
{
  uint32_t triangles; // that are drawn, a bit each
  int32_t next;       // of those that are about as far
  float distance;
} water_cluster_work;

// Marks what may be seen. Bands of one reflection texture may be done at the same time, by one
// thread each.
//
// is_reversed  they are drawn from the last triangle to the first
// trend        of all clusters drawn so far in the band; these are added
// work         room for one per cluster
void water_clusters_mark(const water_clusters_view* view, const water_mesh* mesh, bool is_reversed,
  water_trend* trend, water_cluster_work* work);

// Copies the indices of what is marked, in their order or from the last triangle to the first.
//
// works  of all bands, one after the other
// drawn  room for 3 * triangle_count
//
// Returns how many indices were copied.
size_t water_clusters_copy(const water_mesh* mesh, bool is_reversed,
  const water_cluster_work* works, int band_count, uint32_t* drawn);

#ifdef __cplusplus
}
#endif
#endif
