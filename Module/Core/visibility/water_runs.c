// SPDX-License-Identifier: BSD-3-Clause
// water_runs.c: runs of large meshes' triangles.
#include "water_runs.h"

#include "water_math.h"

#include <string.h>

static size_t parts_of(size_t whole, size_t part)
{
  return (whole + part - 1) / part;
}

bool water_runs_are_worth(size_t triangle_count)
{
  return triangle_count >= WATER_RUNS_MESH_MIN;
}

size_t water_runs_shape(size_t triangle_count, water_runs_mesh* mesh)
{
  const size_t least = parts_of(triangle_count, WATER_RUNS_LEAVES_MAX);
  mesh->triangle_count = triangle_count;
  mesh->leaf_triangles = least > WATER_RUNS_LEAF_MIN ? least : WATER_RUNS_LEAF_MIN;
  mesh->leaf_count = parts_of(triangle_count, mesh->leaf_triangles);
  mesh->group_count = parts_of(mesh->leaf_count, WATER_RUNS_GROUP);
  return water_runs_are_worth(triangle_count) ? mesh->leaf_count + mesh->group_count : 0;
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

// Where a leaf lies.
enum
{
  IN_AIR,  // outside of the view, on the kept side of the clip
  OUTSIDE, // of the view
  KEPT,    // may change a pixel, wholly on the kept side
  CUT      // may change a pixel, and the clip may cut it
};

static uint8_t place_of(water_box_place place, bool is_kept)
{
  if (place == WATER_BOX_OUTSIDE)
  {
    return is_kept ? IN_AIR : OUTSIDE;
  }
  return is_kept ? KEPT : CUT;
}

static void find_places(
  const water_clusters_view* view, const water_runs_mesh* mesh, uint8_t* places)
{
  for (size_t group = 0; group < mesh->group_count; ++group)
  {
    const double* box = mesh->boxes[mesh->leaf_count + group];
    const water_box_place place = water_clusters_place(view, box);
    const bool is_kept = water_clusters_is_kept(view, box);
    const size_t first = group * WATER_RUNS_GROUP;
    const size_t rest = mesh->leaf_count - first;
    const size_t count = rest < WATER_RUNS_GROUP ? rest : WATER_RUNS_GROUP;
    const bool is_placed = place == WATER_BOX_OUTSIDE || place == WATER_BOX_INSIDE;
    if (place == WATER_BOX_OUTSIDE || (is_placed && is_kept))
    {
      memset(places + first, place_of(place, is_kept), count);
      continue;
    }
    for (size_t i = first; i < first + count; ++i)
    {
      // what holds for the group holds for its leaves
      places[i] = place_of(is_placed ? place : water_clusters_place(view, mesh->boxes[i]),
        is_kept || water_clusters_is_kept(view, mesh->boxes[i]));
    }
  }
}

// What is collected while leaves are looked at in their order.
typedef struct collection
{
  const water_runs_mesh* mesh;
  water_run* runs;
  size_t count;
  bool may_join; // there is a run, and all leaves since may be drawn with it
} collection;

// Leaves that no run draws may be drawn besides: those in the air where the clip is off, any where
// it is on.
static void pass_by(collection* found, uint8_t place)
{
  found->may_join = found->may_join && (found->runs[found->count - 1].is_cut || place == IN_AIR);
}

static void collect(collection* found, size_t leaf, bool is_cut)
{
  const size_t size = found->mesh->leaf_triangles;
  const size_t first = leaf * size;
  const size_t rest = found->mesh->triangle_count - first;
  const size_t count = size < rest ? size : rest;
  water_run* last = found->may_join ? &found->runs[found->count - 1] : NULL;
  if (last && last->is_cut == is_cut && first - (last->first + last->count) <= WATER_RUNS_GAP)
  {
    last->count = first + count - last->first;
  }
  else
  {
    found->runs[found->count].first = first;
    found->runs[found->count].count = count;
    found->runs[found->count].is_cut = is_cut;
    ++found->count;
  }
  found->may_join = true;
}

// To turn the clip off and on takes as long as to draw many triangles with it: short stretches
// between runs that are cut are drawn with it.
static void keep_long_stretches(const water_runs_mesh* mesh, water_run* runs, size_t count)
{
  for (size_t begin = 0; begin < count;)
  {
    size_t end = begin;
    size_t triangles = 0;
    while (end < count && !runs[end].is_cut)
    {
      triangles += runs[end++].count;
    }
    for (size_t i = begin; i < end && triangles < mesh->triangle_count / WATER_RUNS_STRETCHES; ++i)
    {
      runs[i].is_cut = true;
    }
    begin = end > begin ? end : begin + 1;
  }
}

size_t water_runs_select(
  const water_clusters_view* view, const water_runs_mesh* mesh, uint8_t* places, water_run* runs)
{
  find_places(view, mesh, places);
  collection found = { mesh, runs, 0, false };
  for (size_t leaf = 0; leaf < mesh->leaf_count; ++leaf)
  {
    if (places[leaf] == KEPT || places[leaf] == CUT)
    {
      collect(&found, leaf, places[leaf] == CUT);
    }
    else
    {
      pass_by(&found, places[leaf]);
    }
  }
  keep_long_stretches(mesh, runs, found.count);
  return found.count;
}
