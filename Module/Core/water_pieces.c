// SPDX-License-Identifier: BSD-3-Clause
// water_pieces.c: step 4: the pieces of large meshes.
#include "water_pieces.h"

#include "water_math.h"
#include "water_target.h"

// The GPU transforms in single precision: a piece that is outside by less may have a pixel inside.
static const double piece_rounding = 16.0 * (double)FLT_EPSILON;

size_t water_pieces_count(size_t triangle_count)
{
  const size_t count = (triangle_count + WATER_PIECE_TRIANGLES - 1) / WATER_PIECE_TRIANGLES;
  return count < WATER_PIECES_MIN ? 0 : count;
}

static void take_in(const water_points* points, size_t number, double box[6])
{
  for (size_t axis = 0; axis < 3; ++axis)
  {
    const size_t at = 3 * number + axis;
    const double value = points->floats ? (double)points->floats[at] : points->doubles[at];
    box[2 * axis] = fmin(box[2 * axis], value); // NaN is passed by: such a triangle has no picture
    box[2 * axis + 1] = fmax(box[2 * axis + 1], value);
  }
}

bool water_pieces_bound(const water_points* points, size_t point_count, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6])
{
  for (size_t i = 0; i < 3 * triangle_count; ++i)
  {
    double* box = boxes[i / (3 * (size_t)WATER_PIECE_TRIANGLES)];
    if (indices[i] >= point_count)
    {
      return false;
    }
    if (i % (3 * (size_t)WATER_PIECE_TRIANGLES) == 0)
    {
      for (int j = 0; j < 6; ++j)
      {
        box[j] = j % 2 ? -DBL_MAX : DBL_MAX;
      }
    }
    take_in(points, indices[i], box);
  }
  return true;
}

void water_pieces_look(const water_plan* plan, const water_seen* seen,
  const double model_to_world[16], water_pieces_view* view)
{
  water_frustum* local = &view->frustum;
  double box[4];
  water_frustum world;
  water_target_box_of_rect(plan->texture_rect_px, plan->texture_px, box);
  water_frustum_make(&plan->mirrored, box, &world);
  // the far plane gives way to the clip at the water
  double clip_world[4];
  water_mat4_apply_row(plan->clip_plane_view, plan->mirrored.world_to_view, clip_world);
  memcpy(world.planes[5], clip_world, sizeof clip_world);
  for (int i = 0; i < 6; ++i)
  {
    water_mat4_apply_row(world.planes[i], model_to_world, local->planes[i]);
  }
  const double origin[3] = { model_to_world[3], model_to_world[7], model_to_world[11] };
  local->reach = world.reach + water_vec3_length(origin);
  water_frustum_prepare(local);
  double model_to_view[16];
  water_mat4_multiply(plan->mirrored.world_to_view, model_to_world, model_to_view);
  water_mat4_multiply(plan->mirrored.view_to_clip, model_to_view, view->to_clip);
  view->seen = seen;
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

static void add_to(water_trend* trend, const water_frustum* view, const double box[6])
{
  const double center[3] = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]),
    0.5 * (box[4] + box[5]) };
  const size_t column = cell_of(view->planes[0], view->planes[1], WATER_TREND_COLUMNS, center);
  const size_t row = cell_of(view->planes[2], view->planes[3], WATER_TREND_ROWS, center);
  const double distance = height_over(view->planes[4], center);
  double* last = &trend->last_distance[row][column];
  if (!(distance > 0.0))
  {
    return; // about the eye: nowhere in the picture
  }
  if (*last > 0.0)
  {
    trend->nearer_steps += distance < *last;
    trend->farther_steps += distance > *last;
  }
  *last = distance;
}

static bool is_seen(const water_pieces_view* view, const double box[6])
{
  return water_frustum_meets(&view->frustum, 6, box, piece_rounding) &&
    (!view->seen || water_seen_meets(view->seen, view->to_clip, box, 0.0));
}

size_t water_pieces_select(const water_pieces_view* view, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6], bool is_reversed, water_trend* trend, uint32_t* drawn)
{
  const size_t piece_count = (triangle_count + WATER_PIECE_TRIANGLES - 1) / WATER_PIECE_TRIANGLES;
  size_t drawn_count = 0;
  for (size_t i = 0; i < piece_count; ++i)
  {
    const size_t piece = is_reversed ? piece_count - 1 - i : i;
    const double* box = boxes[piece];
    const bool is_finite = water_all_finite(box, 6);
    if (is_finite && !is_seen(view, box))
    {
      continue;
    }
    if (is_finite)
    {
      add_to(trend, &view->frustum, box);
    }
    const size_t first = piece * WATER_PIECE_TRIANGLES;
    const size_t rest = triangle_count - first;
    const size_t size = rest < WATER_PIECE_TRIANGLES ? rest : WATER_PIECE_TRIANGLES;
    if (!is_reversed)
    {
      memcpy(drawn + drawn_count, indices + 3 * first, 3 * size * sizeof *indices);
    }
    for (size_t j = 0; is_reversed && j < size; ++j)
    {
      memcpy(
        drawn + drawn_count + 3 * j, indices + 3 * (first + size - 1 - j), 3 * sizeof *indices);
    }
    drawn_count += 3 * size;
  }
  return drawn_count;
}
