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

void water_pieces_look(
  const water_plan* plan, const double model_to_world[16], water_pieces_view* view)
{
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
    water_mat4_apply_row(world.planes[i], model_to_world, view->frustum.planes[i]);
  }
  const double origin[3] = { model_to_world[3], model_to_world[7], model_to_world[11] };
  view->frustum.reach = world.reach + water_vec3_length(origin);
  water_frustum_prepare(&view->frustum);
  double back[4] = { plan->mirrored.world_to_view[8], plan->mirrored.world_to_view[9],
    plan->mirrored.world_to_view[10], 0.0 };
  water_mat4_apply_row(back, model_to_world, back);
  for (int i = 0; i < 3; ++i)
  {
    view->away[i] = -back[i];
  }
}

enum
{
  NOT_SEEN = UINT16_MAX,
  LAST_STEP = 255
};

static double distance_of(const water_pieces_view* view, const double box[6])
{
  const double middle[3] = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]),
    0.5 * (box[4] + box[5]) };
  return water_vec3_dot(view->away, middle);
}

size_t water_pieces_select(const water_pieces_view* view, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6], uint16_t* steps, uint32_t* drawn)
{
  const size_t per_piece = 3 * (size_t)WATER_PIECE_TRIANGLES;
  const size_t index_count = 3 * triangle_count;
  const size_t piece_count = (index_count + per_piece - 1) / per_piece;
  double nearest = DBL_MAX;
  double farthest = -DBL_MAX;
  for (size_t i = 0; i < piece_count; ++i)
  {
    const bool is_endless = !water_all_finite(boxes[i], 6);
    steps[i] = NOT_SEEN;
    if (is_endless || water_frustum_meets(&view->frustum, 6, boxes[i], piece_rounding))
    {
      steps[i] = 0;
      nearest = is_endless ? nearest : fmin(nearest, distance_of(view, boxes[i]));
      farthest = is_endless ? farthest : fmax(farthest, distance_of(view, boxes[i]));
    }
  }
  // sorted by counting: how many indices lie before each step
  size_t before[LAST_STEP + 2] = { 0 };
  const double per_step = farthest > nearest ? (farthest - nearest) / LAST_STEP : 1.0;
  for (size_t i = 0; i < piece_count; ++i)
  {
    if (steps[i] != NOT_SEEN)
    {
      const double step = (distance_of(view, boxes[i]) - nearest) / per_step;
      steps[i] = step > 0.0 ? (uint16_t)fmin(step, LAST_STEP) : 0; // NaN: 0
      before[steps[i] + 1] += i + 1 < piece_count ? per_piece : index_count - i * per_piece;
    }
  }
  for (int step = 0; step <= LAST_STEP; ++step)
  {
    before[step + 1] += before[step];
  }
  const size_t drawn_count = before[LAST_STEP + 1];
  for (size_t i = 0; i < piece_count; ++i)
  {
    if (steps[i] != NOT_SEEN)
    {
      const size_t size = i + 1 < piece_count ? per_piece : index_count - i * per_piece;
      memcpy(drawn + before[steps[i]], indices + i * per_piece, size * sizeof *indices);
      before[steps[i]] += size;
    }
  }
  return drawn_count;
}
