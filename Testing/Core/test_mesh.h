// SPDX-License-Identifier: BSD-3-Clause
// test_mesh.h: a mesh for the tests of clusters.
#ifndef test_mesh_h
#define test_mesh_h

#include "test_scene.h"

#include <stdlib.h>

#include "water_clusters.h"

enum
{
  SIDE = 120, // quads of the mesh
  POINTS = (SIDE + 1) * (SIDE + 1),
  TRIANGLES = 2 * SIDE * SIDE,
  PIECES = (TRIANGLES + WATER_CLUSTER_TRIANGLES - 1) / WATER_CLUSTER_TRIANGLES
};

typedef struct mesh
{
  float points[3 * POINTS];
  uint32_t indices[3 * TRIANGLES];
  double boxes[PIECES][6];
  water_mesh described;
  water_cluster_work work[PIECES];
  uint32_t drawn[3 * TRIANGLES];
} mesh;

static const double at_zero[3] = { 0.0, 0.0, 0.0 };
static const water_clusters_target plain_map = { NULL, NULL, 0, 8 };

// A hilly square of 100 x 100 about a place.
static inline mesh* mesh_made(dice* from)
{
  mesh* made = malloc(sizeof *made);
  assert_non_null(made);
  for (int i = 0; i < POINTS; ++i)
  {
    made->points[3 * i] = (float)(100.0 * (i % (SIDE + 1)) / SIDE - 50.0);
    made->points[3 * i + 1] = (float)(100.0 * (i / (SIDE + 1)) / SIDE - 50.0);
    made->points[3 * i + 2] = (float)dice_roll(from, -3.0, 3.0);
  }
  uint32_t* index = made->indices;
  for (uint32_t i = 0; i < SIDE * SIDE; ++i)
  {
    const uint32_t corner = i / SIDE * (SIDE + 1) + i % SIDE;
    const uint32_t quad[6] = { corner, corner + 1, corner + SIDE + 2, corner, corner + SIDE + 2,
      corner + SIDE + 1 };
    for (int j = 0; j < 6; ++j)
    {
      *index++ = quad[j];
    }
  }
  made->described =
    (water_mesh){ { made->points, NULL }, POINTS, made->indices, TRIANGLES, made->boxes };
  return made;
}

// Marks what may be seen in one band, and copies it.
static inline size_t selected(const water_clusters_view* view, const water_mesh* described,
  bool is_reversed, water_trend* trend, water_cluster_work* work, uint32_t* drawn)
{
  water_clusters_mark(view, described, is_reversed, trend, work);
  return water_clusters_copy(described, is_reversed, work, 1, drawn);
}

// Is what was copied some of the mesh's triangles, in their order? is_drawn: room for one per
// triangle, or NULL.
static inline bool is_in_order(const mesh* of, size_t count, bool* is_drawn)
{
  size_t at = 0;
  for (size_t i = 0; i < TRIANGLES; ++i)
  {
    const uint32_t* triangle = of->indices + 3 * i;
    const bool is_next = at < count && memcmp(of->drawn + at, triangle, 3 * sizeof *triangle) == 0;
    at += is_next ? 3 : 0;
    if (is_drawn)
    {
      is_drawn[i] = is_next;
    }
  }
  return at == count;
}

#endif
