// SPDX-License-Identifier: BSD-3-Clause
// water_runs.c: runs of large meshes' triangles.
#include "water_runs.h"

#include "water_math.h"

static size_t parts_of(size_t whole, size_t part)
{
  return (whole + part - 1) / part;
}

size_t water_runs_shape(size_t triangle_count, water_runs_mesh* mesh)
{
  const size_t least = parts_of(triangle_count, WATER_RUNS_LEAVES_MAX);
  mesh->triangle_count = triangle_count;
  mesh->leaf_triangles = least > WATER_RUNS_LEAF_MIN ? least : WATER_RUNS_LEAF_MIN;
  mesh->leaf_count = parts_of(triangle_count, mesh->leaf_triangles);
  mesh->group_count = parts_of(mesh->leaf_count, WATER_RUNS_GROUP);
  return triangle_count < WATER_RUNS_MESH_MIN ? 0 : mesh->leaf_count + mesh->group_count;
}

void water_runs_begin(const water_runs_mesh* mesh)
{
  for (size_t i = 0; i < mesh->leaf_count + mesh->group_count; ++i)
  {
    water_bounds_begin(mesh->boxes[i]);
  }
}

bool water_runs_add(const water_runs_mesh* mesh, size_t first, const uint32_t* indices,
  size_t count, const water_points* points, size_t point_count)
{
  for (size_t i = 0; i < count; ++i)
  {
    double* box = mesh->boxes[(first + i) / mesh->leaf_triangles];
    for (int corner = 0; corner < 3; ++corner)
    {
      const uint32_t number = indices[3 * i + (size_t)corner];
      if (number >= point_count)
      {
        return false;
      }
      double place[3];
      water_points_get(points, number, place);
      water_bounds_add_point(box, place);
    }
  }
  return true;
}

void water_runs_end(const water_runs_mesh* mesh)
{
  for (size_t group = 0; group < mesh->group_count; ++group)
  {
    double* box = mesh->boxes[mesh->leaf_count + group];
    water_bounds_begin(box);
    for (size_t i = group * WATER_RUNS_GROUP;
         i < mesh->leaf_count && i < (group + 1) * WATER_RUNS_GROUP; ++i)
    {
      water_bounds_add(box, mesh->boxes[i]);
    }
  }
}

// What is collected while leaves are looked at in their order.
typedef struct collection
{
  const water_runs_mesh* mesh;
  water_run* runs;
  size_t count;
} collection;

static void collect(collection* found, size_t leaf, size_t leaf_count)
{
  const size_t size = found->mesh->leaf_triangles;
  const size_t first = leaf * size;
  const size_t rest = found->mesh->triangle_count - first;
  const size_t count = leaf_count * size < rest ? leaf_count * size : rest;
  water_run* last = found->count > 0 ? &found->runs[found->count - 1] : NULL;
  if (last && first - (last->first + last->count) <= WATER_RUNS_GAP)
  {
    last->count = first + count - last->first;
    return;
  }
  found->runs[found->count].first = first;
  found->runs[found->count].count = count;
  ++found->count;
}

size_t water_runs_select(
  const water_clusters_view* view, const water_runs_mesh* mesh, water_run* runs)
{
  collection found = { mesh, runs, 0 };
  for (size_t group = 0; group < mesh->group_count; ++group)
  {
    const water_box_place place = water_clusters_place(view, mesh->boxes[mesh->leaf_count + group]);
    const size_t first = group * WATER_RUNS_GROUP;
    const size_t rest = mesh->leaf_count - first;
    const size_t count = rest < WATER_RUNS_GROUP ? rest : WATER_RUNS_GROUP;
    if (place == WATER_BOX_INSIDE)
    {
      collect(&found, first, count);
    }
    for (size_t i = 0; i < count && place == WATER_BOX_ACROSS; ++i)
    {
      if (water_clusters_place(view, mesh->boxes[first + i]) != WATER_BOX_OUTSIDE)
      {
        collect(&found, first + i, 1);
      }
    }
  }
  return found.count;
}
