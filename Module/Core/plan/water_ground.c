// SPDX-License-Identifier: BSD-3-Clause
// water_ground.c: has a scene ground under all of its water?
#include "water_ground.h"

#include "water_math.h"

static const double wide = 0.75;  // share of the scene's area that a bed covers
static const double near = 0.04;  // of the scene's diagonal
static const double steep = 0.15; // of the same: so far apart the points of one surface may lie
static const int enough = 13;     // places that have a surface

water_status water_ground_begin(
  const water_plane* plane, const double origin[3], const double bounds[6], water_ground* ground)
{
  memset(ground, 0, sizeof *ground);
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    ground->low[i] = (double)INFINITY;
    ground->high[i] = -(double)INFINITY;
  }
  water_plane unit;
  water_status status = water_plane_normalise(plane, &unit);
  if (status == WATER_OK)
  {
    memcpy(ground->origin, origin, sizeof ground->origin);
    memcpy(ground->up, unit.normal, sizeof ground->up);
    water_plane_axes(unit.normal, ground->x_dir, ground->y_dir);
    status = water_sheet_bounds(origin, ground->x_dir, ground->y_dir, bounds, ground->bounds);
  }
  const double* scene = ground->bounds;
  ground->near = near * hypot(scene[1] - scene[0], scene[3] - scene[2]);
  return status;
}

static void to_axes(const water_ground* ground, const double point[3], double place[3])
{
  const double* origin = ground->origin;
  const double from[3] = { point[0] - origin[0], point[1] - origin[1], point[2] - origin[2] };
  place[0] = water_vec3_dot(from, ground->x_dir);
  place[1] = water_vec3_dot(from, ground->y_dir);
  place[2] = water_vec3_dot(from, ground->up);
}

void water_ground_add_bounds(const double bounds[6], water_ground* ground)
{
  double box[4]; // along the plane's axes
  if (water_sheet_bounds(ground->origin, ground->x_dir, ground->y_dir, bounds, box) != WATER_OK)
  {
    return;
  }
  double top[3]; // the highest corner
  double place[3];
  for (int i = 0; i < 3; ++i)
  {
    top[i] = bounds[2 * i + (ground->up[i] > 0.0)];
  }
  to_axes(ground, top, place);
  const double* scene = ground->bounds;
  const double area = (scene[1] - scene[0]) * (scene[3] - scene[2]);
  const double covered = (fmin(box[1], scene[1]) - fmax(box[0], scene[0])) *
    (fmin(box[3], scene[3]) - fmax(box[2], scene[2]));
  ground->has_bed = ground->has_bed || (place[2] <= 0.0 && area > 0.0 && covered >= wide * area);
}

// Place i of the border: four along each side, each beginning with a corner.
static void place_of(const water_ground* ground, int i, double place[2])
{
  const double* scene = ground->bounds;
  const double along = 0.25 * (i % 4);
  const int side = i / 4;
  const int axis = side % 2;
  const bool is_back = side >= 2;
  const double share[2] = { axis == 0 ? along : 1.0, axis == 0 ? 0.0 : along };
  for (int j = 0; j < 2; ++j)
  {
    const double part = is_back ? 1.0 - share[j] : share[j];
    place[j] = scene[2 * j] + part * (scene[2 * j + 1] - scene[2 * j]);
  }
}

void water_ground_add_point(const double point[3], water_ground* ground)
{
  double at[3];
  to_axes(ground, point, at);
  const double* scene = ground->bounds;
  const double inside =
    fmin(fmin(at[0] - scene[0], scene[1] - at[0]), fmin(at[1] - scene[2], scene[3] - at[1]));
  if (!(inside <= ground->near) || !isfinite(at[0] + at[1] + at[2]))
  {
    return; // most points are far from the border
  }
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    double place[2];
    place_of(ground, i, place);
    if (fabs(at[0] - place[0]) <= ground->near && fabs(at[1] - place[1]) <= ground->near)
    {
      ground->low[i] = fmin(ground->low[i], at[2]);
      ground->high[i] = fmax(ground->high[i], at[2]);
    }
  }
}

bool water_ground_is_under(const water_ground* ground)
{
  const double most = steep / near * ground->near;
  int count = 0;
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    const double spread = ground->high[i] - ground->low[i];
    count += spread >= 0.0 && spread <= most ? 1 : 0;
  }
  return ground->has_bed || count >= enough;
}
