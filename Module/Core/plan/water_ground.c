// SPDX-License-Identifier: BSD-3-Clause
// water_ground.c: has a scene ground under all of its water?
#include "water_ground.h"

#include <math.h>

static const double wide = 0.75;  // share of the scene's area that a bed covers
static const double near = 0.04;  // of the scene's diagonal
static const double steep = 0.15; // of the same: so far apart the points of one surface may lie
static const int enough = 13;     // places that have a surface

void water_ground_begin(const double bounds[4], water_ground* ground)
{
  for (int i = 0; i < 4; ++i)
  {
    ground->bounds[i] = bounds[i];
  }
  ground->near = near * hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    ground->low[i] = (double)INFINITY;
    ground->high[i] = -(double)INFINITY;
  }
  ground->has_bed = false;
}

void water_ground_add_bounds(const double bounds[6], water_ground* ground)
{
  const double* scene = ground->bounds;
  const double area = (scene[1] - scene[0]) * (scene[3] - scene[2]);
  const double covered = (fmin(bounds[1], scene[1]) - fmax(bounds[0], scene[0])) *
    (fmin(bounds[3], scene[3]) - fmax(bounds[2], scene[2]));
  ground->has_bed = ground->has_bed ||
    (bounds[0] <= bounds[1] && bounds[2] <= bounds[3] && bounds[5] <= 0.0 && area > 0.0 &&
      covered >= wide * area);
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

void water_ground_add_point(double x, double y, double height, water_ground* ground)
{
  const double* scene = ground->bounds;
  const double inside = fmin(fmin(x - scene[0], scene[1] - x), fmin(y - scene[2], scene[3] - y));
  if (!(inside <= ground->near) || !isfinite(height))
  {
    return; // most points are far from the border
  }
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    double place[2];
    place_of(ground, i, place);
    if (fabs(x - place[0]) <= ground->near && fabs(y - place[1]) <= ground->near)
    {
      ground->low[i] = fmin(ground->low[i], height);
      ground->high[i] = fmax(ground->high[i], height);
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
