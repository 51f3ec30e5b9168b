// SPDX-License-Identifier: BSD-3-Clause
#include "water_seen.h"

#include "water_camera.h"
#include "water_math.h"
#include "water_plane.h"
#include "water_select.h"
#include "water_target.h"

static const double between_parts = 1e-9; // less than any part

double water_seen_share(const water_camera* eye, const water_plane* plane, const double bounds[6])
{
  water_plane unit;
  double box[4];
  if (!water_bounds_are_finite(bounds) || water_bounds_is_empty(bounds) ||
    water_plane_normalise(plane, &unit) != WATER_OK || !water_select_is_in_view(eye, bounds))
  {
    return 0.0;
  }
  water_target_box(eye, &unit, bounds, box);
  return 0.25 * fmax(box[2] - box[0], 0.0) * fmax(box[3] - box[1], 0.0);
}

double water_seen_share_of_parts(const water_camera* eye, const water_plane* plane,
  const double* bounds, size_t count, const double mesh_to_world[16])
{
  double sum = 0.0;
  double all[6];
  water_bounds_begin(all);
  for (size_t i = 0; i < count && sum < 1.0; ++i)
  {
    double moved[6];
    water_bounds_begin(moved);
    for (int number = 0; number < 8; ++number)
    {
      double corner[3];
      double world[4];
      water_bounds_corner(bounds + 6 * i, number, corner);
      water_mat4_apply_point(mesh_to_world, corner, world);
      water_bounds_add_point(moved, world);
    }
    sum += water_seen_share(eye, plane, moved);
    water_bounds_add(all, moved);
  }
  return sum > 0.0 ? fmin(sum, 1.0) : between_parts * water_seen_share(eye, plane, all);
}

double water_seen_distance(const water_plane* plane, const double eye[3])
{
  water_plane unit;
  return water_plane_normalise(plane, &unit) == WATER_OK ? fabs(water_plane_height(&unit, eye))
                                                         : 0.0;
}

void water_seen_choose(const double* shares, size_t count, size_t most, bool* has_view)
{
  for (size_t i = 0; i < count; ++i)
  {
    size_t larger = 0;
    for (size_t j = 0; j < count; ++j)
    {
      larger += shares[j] > shares[i] || (j < i && shares[j] == shares[i]) ? 1 : 0;
    }
    has_view[i] = larger < most || !(shares[i] > 0.0);
  }
}
