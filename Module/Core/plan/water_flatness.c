// SPDX-License-Identifier: BSD-3-Clause
#include "water_flatness.h"

#include "water_math.h"
#include "water_plane.h"

#include <float.h>
#include <math.h>

// Of a mesh's diagonal. The search for heights ends here: an eye that is too far away to see a
// greater height sees the mesh some 20 pixels wide.
static const double height_share = 1e-4;
// Between two texels that are black and white, a colour changes by 1 of 255.
static const double shift_px = 1.0 / 256.0;
// Of a double's heights: products and sums of four terms, and of the matrix that they come from.
static const double roundings = 16.0;

bool water_flatness_heights(
  const water_plane* unit, const double mesh_to_world[16], double height[4])
{
  const double plane[4] = { unit->normal[0], unit->normal[1], unit->normal[2], unit->offset };
  const double* last = mesh_to_world + 12;
  double row[4];
  water_mat4_apply_row(plane, mesh_to_world, row);
  if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0 ||
    !water_all_usable(row, 4))
  {
    return false;
  }
  memcpy(height, row, sizeof row);
  return true;
}

bool water_flatness_begin(const water_plane* unit, const double mesh_to_world[16],
  const double bounds[6], bool is_single, water_flatness* flatness)
{
  water_flatness made = { { 0.0 }, 0.0, 0.0, 0.0, 0.0 };
  if (!water_bounds_are_finite(bounds) || water_bounds_is_empty(bounds) ||
    !water_flatness_heights(unit, mesh_to_world, made.height))
  {
    return false;
  }
  double size = 0.0; // of the terms of a height that depend on the point
  double sides[3];   // of the bounds in world
  for (int i = 0; i < 3; ++i)
  {
    const double low = bounds[2 * i];
    const double high = bounds[2 * i + 1];
    const double axis[3] = { mesh_to_world[i], mesh_to_world[4 + i], mesh_to_world[8 + i] };
    size += fabs(made.height[i]) * fmax(fabs(low), fabs(high));
    sides[i] = (high - low) * water_vec3_length(axis);
  }
  made.limit = height_share * water_vec3_length(sides);
  // A float has a relative error of half of FLT_EPSILON, and twice that if it was computed from
  // floats.
  made.rounding = roundings * DBL_EPSILON * (size + fabs(unit->offset) + fabs(made.height[3])) +
    (is_single ? (double)FLT_EPSILON * size : 0.0);
  *flatness = made;
  return true;
}

static bool add_height(double height, water_flatness* flatness)
{
  flatness->reach = isfinite(height) ? fmax(flatness->reach, height) : flatness->reach;
  if (!isfinite(height) || height <= flatness->height_max)
  {
    return true;
  }
  const bool is_high = height > flatness->limit && height > flatness->rounding;
  flatness->height_max = is_high ? (double)INFINITY : height;
  return !is_high;
}

bool water_flatness_add(const double point[3], water_flatness* flatness)
{
  const double* row = flatness->height;
  return add_height(fabs(water_vec3_dot(row, point) + row[3]), flatness);
}

// The largest height is added as a point's would be: only it matters, because if any is too high,
// so is it.
WATER_WIDE static void add_points(const double* points, size_t count, water_flatness* flatness)
{
  enum
  {
    LANES = 8 // each with a maximum of its own: compilers use wide instructions then
  };
  const double row[4] = { flatness->height[0], flatness->height[1], flatness->height[2],
    flatness->height[3] };
  double most[LANES] = { 0.0 };
  for (size_t i = 0; i < count; ++i)
  {
    const double height = fabs(water_vec3_dot(row, points + 3 * i) + row[3]);
    double* lane = most + i % LANES;
    *lane = height > *lane && height <= DBL_MAX ? height : *lane;
  }
  double highest = 0.0;
  for (int lane = 0; lane < LANES; ++lane)
  {
    highest = most[lane] > highest ? most[lane] : highest;
  }
  add_height(highest, flatness);
}

void water_flatness_add_points(const double* points, size_t count, water_flatness* flatness)
{
  add_points(points, count, flatness);
}

void water_flatness_join(const water_flatness* other, water_flatness* flatness)
{
  flatness->height_max = fmax(flatness->height_max, other->height_max);
  flatness->reach = fmax(flatness->reach, other->reach);
}

double water_flatness_judge(const water_flatness* flatness)
{
  return flatness->height_max > flatness->rounding ? flatness->height_max : 0.0;
}

bool water_flatness_is_unseen(const water_plan* plan, double height_max, const int viewport_px[2])
{
  if (!(height_max > 0.0))
  {
    return true;
  }
  // No visible point of the surface is nearer than the near plane, or than a plane that much
  // higher: 1 / w of both is linear in the picture.
  double raised[4];
  for (int i = 0; i < 4; ++i)
  {
    raised[i] = plan->plane_clip[i] - height_max * plan->clip_w[i];
  }
  const bool is_under_eye = raised[2] * plan->plane_clip[2] > 0.0;
  double near_per_w = 0.0;
  double plane_per_w = is_under_eye ? 0.0 : (double)INFINITY;
  for (int i = 0; i < 4; ++i)
  {
    const double ndc[4] = { i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, -1.0, 1.0 };
    near_per_w = fmax(near_per_w, water_vec4_dot(plan->clip_w, ndc));
    if (is_under_eye)
    {
      const double z = -(raised[0] * ndc[0] + raised[1] * ndc[1] + raised[3]) / raised[2];
      const double on_plane[4] = { ndc[0], ndc[1], z, 1.0 };
      plane_per_w = fmax(plane_per_w, water_vec4_dot(plan->clip_w, on_plane));
    }
  }
  // The mirror image of a point is 2 height_max away along the normal, which moves its clip
  // coordinates by so much, and w with them.
  const double* up = plan->normal_clip;
  const double along = fmax(fabs(up[0]) * viewport_px[0], fabs(up[1]) * viewport_px[1]) +
    fabs(up[3]) * fmax(viewport_px[0], viewport_px[1]);
  const double turn = 2.0 * height_max * fmin(near_per_w, plane_per_w);
  const double rest = 1.0 - turn * fabs(up[3]); // of w
  return rest > 0.0 && 0.5 * turn * along < shift_px * rest;
}

void water_flatness_row(const double row[4], const double shift[3], const double scale[3],
  const double origin[3], double of[4])
{
  double sum = row[3];
  for (int i = 0; i < 3; ++i)
  {
    sum += row[i] * (origin[i] / scale[i] + shift[i]);
  }
  for (int i = 0; i < 3; ++i)
  {
    of[i] = row[i] / scale[i];
  }
  of[3] = sum;
}

void water_flatness_vertices(const double height[4], water_side side, const double bounds[6],
  const double shift[3], const double scale[3], double origin[3], double rise[4])
{
  const double sign = side == WATER_BELOW ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    const double middle = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    origin[i] = (double)(float)((middle - shift[i]) * scale[i]);
  }
  water_flatness_row(height, shift, scale, origin, rise);
  for (int i = 0; i < 4; ++i)
  {
    rise[i] *= sign;
  }
}
