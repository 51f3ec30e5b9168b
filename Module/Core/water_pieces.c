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

void water_pieces_view(const water_plan* plan, const double model_to_world[16], water_frustum* view)
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
    water_mat4_apply_row(world.planes[i], model_to_world, view->planes[i]);
  }
  const double origin[3] = { model_to_world[3], model_to_world[7], model_to_world[11] };
  view->reach = world.reach + water_vec3_length(origin);
  water_frustum_prepare(view);
}

size_t water_pieces_select(const water_frustum* view, const uint32_t* indices,
  size_t triangle_count, double (*boxes)[6], uint32_t* drawn)
{
  const size_t per_piece = 3 * (size_t)WATER_PIECE_TRIANGLES;
  const size_t index_count = 3 * triangle_count;
  size_t drawn_count = 0;
  for (size_t first = 0; first < index_count; first += per_piece)
  {
    const double* box = boxes[first / per_piece];
    const size_t rest = index_count - first;
    const size_t size = rest < per_piece ? rest : per_piece;
    if (!water_all_finite(box, 6) || water_frustum_meets(view, 6, box, piece_rounding))
    {
      memcpy(drawn + drawn_count, indices + first, size * sizeof *indices);
      drawn_count += size;
    }
  }
  return drawn_count;
}
