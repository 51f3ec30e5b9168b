// SPDX-License-Identifier: BSD-3-Clause
// water_clusters.c: the clusters of large meshes.
#include "water_clusters.h"

#include "water_math.h"

// The GPU transforms in single precision: a cluster that is outside by less may have a pixel
// inside.
static const double cluster_rounding = 16.0 * (double)FLT_EPSILON;

size_t water_clusters_count(size_t triangle_count)
{
  const size_t count = (triangle_count + WATER_CLUSTER_TRIANGLES - 1) / WATER_CLUSTER_TRIANGLES;
  return count < WATER_CLUSTERS_MIN ? 0 : count;
}

int water_clusters_bands(bool is_software, size_t triangle_count, unsigned core_count)
{
  const size_t worth = water_clusters_count(triangle_count) / WATER_BAND_CLUSTERS;
  size_t count = is_software ? core_count : 1;
  count = count < worth ? count : worth;
  count = count < WATER_CLUSTERS_BANDS_MAX ? count : WATER_CLUSTERS_BANDS_MAX;
  return count > 1 ? (int)count : 1;
}

bool water_clusters_bound(const water_mesh* mesh)
{
  for (size_t i = 0; i < 3 * mesh->triangle_count; ++i)
  {
    double* box = mesh->boxes[i / (3 * (size_t)WATER_CLUSTER_TRIANGLES)];
    if (mesh->indices[i] >= mesh->point_count)
    {
      return false;
    }
    if (i % (3 * (size_t)WATER_CLUSTER_TRIANGLES) == 0)
    {
      water_bounds_begin(box);
    }
    double place[3];
    water_points_get(&mesh->points, mesh->indices[i], place);
    water_bounds_add_point(box, place);
  }
  return true;
}

static double size_of_normal(const double plane[4])
{
  return fabs(plane[0]) + fabs(plane[1]) + fabs(plane[2]);
}

void water_clusters_view_make(const water_plan* plan, const water_clusters_target* target, int band,
  int band_count, bool is_solid, const double model_to_world[16], const double origin[3],
  water_clusters_view* view)
{
  // from coordinates relative to the origin
  double near_to_world[16];
  double origin_world[4];
  memcpy(near_to_world, model_to_world, sizeof near_to_world);
  water_mat4_apply_point(model_to_world, origin, origin_world);
  for (size_t i = 0; i < 3; ++i)
  {
    near_to_world[4 * i + 3] = origin_world[i];
  }
  double near_to_view[16];
  water_mat4_multiply(plan->mirrored.world_to_view, near_to_world, near_to_view);

  water_frustum* local = &view->frustum;
  double box[4];
  water_frustum world;
  const int* rect_px = plan->texture_rect_px;
  const int64_t width = rect_px[2];
  const int columns[2] = { (int)(width * band / band_count),
    (int)(width * (band + 1) / band_count) };
  const int band_px[4] = { rect_px[0] + columns[0], rect_px[1], columns[1] - columns[0],
    rect_px[3] };
  water_rect_to_ndc(band_px, plan->texture_px, box);
  water_frustum_make(&plan->mirrored, box, &world);
  // the far plane gives way to the clip at the water
  double clip_world[4];
  water_mat4_apply_row(plan->clip_plane_view, plan->mirrored.world_to_view, clip_world);
  memcpy(world.planes[5], clip_world, sizeof clip_world);
  double unit = 0.0; // at most so many of the mesh's are one of the world's
  for (int i = 0; i < 6; ++i)
  {
    water_mat4_apply_row(world.planes[i], near_to_world, local->planes[i]);
    unit = fmax(unit, size_of_normal(world.planes[i]) / size_of_normal(local->planes[i]));
  }
  // The GPU gets the product of all matrices, computed in double precision. Single precision rounds
  // only its own offset; the offsets that cancel in it have the rounding of doubles.
  const double eye[3] = { near_to_view[3], near_to_view[7], near_to_view[11] };
  const double from_model[3] = { model_to_world[3], model_to_world[7], model_to_world[11] };
  const double in_double =
    world.reach + water_vec3_length(origin_world) + water_vec3_length(from_model);
  local->reach = unit * (water_vec3_length(eye) + in_double * (DBL_EPSILON / (double)FLT_EPSILON));
  water_frustum_prepare(local);
  water_triangle_cull_view* triangles = &view->triangles;
  memcpy(triangles->origin, origin, sizeof triangles->origin);
  water_mat4_multiply(plan->mirrored.view_to_clip, near_to_view, triangles->to_clip);
  memcpy(triangles->kept, local->planes[5], sizeof triangles->kept);
  triangles->reach = local->reach;
  memcpy(triangles->texture_px, plan->texture_px, sizeof triangles->texture_px);
  memcpy(triangles->rect_px, rect_px, sizeof triangles->rect_px);
  memcpy(triangles->columns, columns, sizeof triangles->columns);
  triangles->has_samples = target->samples > 1;
  triangles->grid_px = ldexp(1.0, -target->subpixel_bits);
  triangles->seen = target->seen;
  triangles->depths = target->depths;
  triangles->is_solid = is_solid;
  view->is_fine = plan->is_software;
}

// A box relative to the view's origin. Returns false where it is infinite.
static bool bring_near(const water_clusters_view* view, const double given[6], double box[6])
{
  for (int i = 0; i < 6; ++i)
  {
    box[i] = given[i] - view->triangles.origin[i / 2];
  }
  return water_all_finite(box, 6);
}

// The same of a cluster.
static bool box_of(
  const water_clusters_view* view, const water_mesh* mesh, size_t cluster, double box[6])
{
  return bring_near(view, mesh->boxes[cluster], box);
}

static double height_over(const double plane[4], const double point[3])
{
  return water_vec3_dot(plane, point) + plane[3];
}

// Where between two planes of the view a place lies, as one of the cells; outside: the next one.
static size_t cell_of(const double low[4], const double high[4], int count, const double place[3])
{
  const double from_low = height_over(low, place);
  const double share = from_low / (from_low + height_over(high, place));
  return share > 0.0 ? (size_t)fmin(count * share, count - 1) : 0;
}

// Returns how far the box is from the eye, along its view; not above 0: it is about the eye.
static double add_to(water_trend* trend, const water_frustum* view, const double box[6])
{
  const double center[3] = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]),
    0.5 * (box[4] + box[5]) };
  const size_t column = cell_of(view->planes[0], view->planes[1], WATER_TREND_COLUMNS, center);
  const size_t row = cell_of(view->planes[2], view->planes[3], WATER_TREND_ROWS, center);
  const double distance = height_over(view->planes[4], center);
  double* last = &trend->last_distance[row][column];
  if (distance > 0.0)
  {
    trend->nearer_steps += *last > 0.0 && distance < *last;
    trend->farther_steps += *last > 0.0 && distance > *last;
    *last = distance;
  }
  return distance;
}

static bool is_seen(const water_clusters_view* view, const double box[6])
{
  const water_visibility* seen = view->triangles.seen;
  return water_frustum_meets(&view->frustum, 6, box, cluster_rounding) &&
    (!seen || water_visibility_meets(seen, view->triangles.to_clip, box, 0.0));
}

water_box_place water_clusters_place(const water_clusters_view* view, const double given[6])
{
  double box[6];
  if (water_bounds_is_empty(given))
  {
    return WATER_BOX_OUTSIDE; // NaN alone: it has no picture
  }
  if (!bring_near(view, given, box))
  {
    return WATER_BOX_ACROSS;
  }
  if (!is_seen(view, box))
  {
    return WATER_BOX_OUTSIDE;
  }
  return !view->triangles.seen && water_frustum_holds(&view->frustum, box) ? WATER_BOX_INSIDE
                                                                           : WATER_BOX_ACROSS;
}

bool water_clusters_is_kept(const water_clusters_view* view, const double given[6])
{
  const double* kept = view->frustum.planes[5];
  const double turned[4] = { -kept[0], -kept[1], -kept[2], -kept[3] };
  double box[6];
  return bring_near(view, given, box) &&
    water_frustum_is_behind(turned, box, view->frustum.reach, cluster_rounding);
}

// Corners that were projected last; neighbours share them.
enum
{
  CORNERS = 256
};

typedef struct corner_cache
{
  water_corner corners[CORNERS];
  uint64_t numbers[CORNERS]; // of their points, + 1
} corner_cache;

static const water_corner* corner_of(
  const water_clusters_view* view, const water_mesh* mesh, uint32_t number, corner_cache* cache)
{
  const size_t at = number % CORNERS;
  if (cache->numbers[at] != (uint64_t)number + 1)
  {
    cache->numbers[at] = (uint64_t)number + 1;
    water_triangle_cull_project(&view->triangles, &mesh->points, number, &cache->corners[at]);
  }
  return &cache->corners[at];
}

static size_t size_of(const water_mesh* mesh, size_t cluster)
{
  const size_t rest = mesh->triangle_count - cluster * WATER_CLUSTER_TRIANGLES;
  return rest < WATER_CLUSTER_TRIANGLES ? rest : WATER_CLUSTER_TRIANGLES;
}

// Marks the triangles of a cluster that are drawn.
static uint32_t look_at(
  const water_clusters_view* view, const water_mesh* mesh, size_t cluster, corner_cache* cache)
{
  const size_t size = size_of(mesh, cluster);
  const uint32_t* triangle = mesh->indices + 3 * cluster * WATER_CLUSTER_TRIANGLES;
  double box[6];
  water_triangle_cull_slack slack;
  box_of(view, mesh, cluster, box);
  water_triangle_cull_allow(&view->triangles, box, &slack);
  uint32_t marks = 0;
  for (size_t i = 0; i < size; ++i, triangle += 3)
  {
    const water_corner* corners[3];
    for (int j = 0; j < 3; ++j)
    {
      corners[j] = corner_of(view, mesh, triangle[j], cache);
    }
    // a corner may have taken the place of another of the three: then there is nothing to look at
    const bool is_known =
      corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0];
    const bool is_drawn = !is_known || water_triangle_cull_add(&view->triangles, &slack, corners);
    marks |= (uint32_t)is_drawn << i;
  }
  return marks;
}

// Looks at the triangles of clusters, the nearest clusters first: these hide others. distances: the
// least and the largest of them.
static void look_at_all(const water_clusters_view* view, const water_mesh* mesh,
  size_t cluster_count, const double distances[2], water_cluster_work* work)
{
  enum
  {
    STEPS = 256, // of distance, by equal factors
    NONE = -1
  };
  int32_t first[STEPS]; // lists of clusters that are about as far
  for (int i = 0; i < STEPS; ++i)
  {
    first[i] = NONE;
  }
  const double steps =
    distances[1] > distances[0] ? (double)STEPS / log2(distances[1] / distances[0]) : 0.0;
  for (size_t i = 0; i < cluster_count; ++i)
  {
    if (work[i].triangles && water_all_finite(mesh->boxes[i], 6))
    {
      const double step = steps * log2(fmax((double)work[i].distance / distances[0], 1.0));
      const size_t at = (size_t)fmin(step, STEPS - 1);
      work[i].next = first[at];
      first[at] = (int32_t)i;
    }
  }
  corner_cache cache;
  memset(cache.numbers, 0, sizeof cache.numbers);
  for (int i = 0; i < STEPS; ++i)
  {
    for (int32_t cluster = first[i]; cluster != NONE; cluster = work[cluster].next)
    {
      work[cluster].triangles = look_at(view, mesh, (size_t)cluster, &cache);
    }
  }
}

// Copies the marked triangles of a cluster. Returns how many indices.
static size_t copy_marked(
  const water_mesh* mesh, size_t cluster, uint32_t marks, bool is_reversed, uint32_t* drawn)
{
  const size_t size = size_of(mesh, cluster);
  const uint32_t* triangles = mesh->indices + 3 * cluster * WATER_CLUSTER_TRIANGLES;
  size_t count = 0;
  for (size_t i = 0; i < size; ++i)
  {
    const size_t at = is_reversed ? size - 1 - i : i;
    if (marks >> at & 1)
    {
      memcpy(drawn + count, triangles + 3 * at, 3 * sizeof *triangles);
      count += 3;
    }
  }
  return count;
}

static size_t count_of(const water_mesh* mesh)
{
  return (mesh->triangle_count + WATER_CLUSTER_TRIANGLES - 1) / WATER_CLUSTER_TRIANGLES;
}

void water_clusters_mark(const water_clusters_view* view, const water_mesh* mesh, bool is_reversed,
  water_trend* trend, water_cluster_work* work)
{
  const size_t count = count_of(mesh);
  double distances[2] = { DBL_MAX, 0.0 };
  for (size_t i = 0; i < count; ++i)
  {
    const size_t cluster = is_reversed ? count - 1 - i : i;
    double box[6];
    const bool is_finite = box_of(view, mesh, cluster, box);
    work[cluster].triangles = !is_finite || is_seen(view, box) ? UINT32_MAX : 0;
    work[cluster].distance = 0.0F;
    if (is_finite && work[cluster].triangles)
    {
      const double distance = add_to(trend, &view->frustum, box);
      work[cluster].distance = (float)distance;
      distances[0] = distance > 0.0 ? fmin(distances[0], distance) : distances[0];
      distances[1] = fmax(distances[1], distance);
    }
  }
  if (view->is_fine)
  {
    look_at_all(view, mesh, count, distances, work);
  }
}

size_t water_clusters_copy(const water_mesh* mesh, bool is_reversed,
  const water_cluster_work* works, int band_count, uint32_t* drawn)
{
  const size_t count = count_of(mesh);
  size_t drawn_count = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const size_t cluster = is_reversed ? count - 1 - i : i;
    uint32_t marks = 0;
    for (size_t band = 0; band < (size_t)band_count; ++band)
    {
      marks |= works[band * count + cluster].triangles;
    }
    drawn_count += copy_marked(mesh, cluster, marks, is_reversed, drawn + drawn_count);
  }
  return drawn_count;
}
