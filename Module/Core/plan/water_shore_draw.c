// SPDX-License-Identifier: BSD-3-Clause
#include "water_shore_draw.h"

#include "water_math.h"

#include <float.h>
#include <math.h>

// A difference of two of these is finite in floats.
static const double largest = 1e37;

bool water_shore_draw_is_wanted(const water_shore_renderer* renderer)
{
  const bool can = renderer->clips_well && renderer->is_plain_draw && renderer->is_of_the_mesh;
  if (renderer->setting == WATER_SHORE_CUT_AUTOMATIC)
  {
    return can && !renderer->is_software;
  }
  return can && renderer->setting == WATER_SHORE_CUT_WHILE_DRAWN;
}

bool water_shore_draw_is_exact(const water_shore_facts* facts)
{
  return facts->has_depths && facts->dykes == 0 && facts->crossed == 0 && facts->shared == 0 &&
    facts->unplaced == 0 && facts->unknown == 0;
}

bool water_shore_draw_is_whole(size_t own_cells, size_t wet_cells)
{
  return own_cells > wet_cells - own_cells;
}

WATER_WIDE static void find_places(const double* points, const double* levels, const double* depths,
  size_t count, double scale, const double still[3], double* places, double bounds[6])
{
  double own[6]; // in the caller's memory, each point would wait for the one before
  memcpy(own, bounds, sizeof own);
  for (size_t i = 0; i < count; ++i)
  {
    const bool is_wet = depths[i] > 0.0;
    const double place[3] = { is_wet ? points[3 * i] : still[0],
      is_wet ? points[3 * i + 1] : still[1], is_wet ? scale * levels[i] : still[2] };
    places[3 * i] = place[0]; // a copy of all three would wait for the row to be stored
    places[3 * i + 1] = place[1];
    places[3 * i + 2] = place[2];
    water_bounds_add_point(own, place);
  }
  memcpy(bounds, own, sizeof own);
}

void water_shore_places(const double* points, const double* levels, const double* depths,
  size_t count, double scale, const double still[3], double* places, double bounds[6])
{
  find_places(points, levels, depths, count, scale, still, places, bounds);
}

WATER_WIDE static void find_distances(const double* depths, size_t count, float* distances)
{
  const double least = (double)FLT_MIN;
  for (size_t i = 0; i < count; ++i)
  {
    const double size = fabs(depths[i]);
    const double kept = size < largest ? size : largest;
    const double seen = kept > least ? kept : least;
    distances[i] = (float)(depths[i] > 0.0 ? seen : -seen);
  }
}

void water_shore_distances(const double* depths, size_t count, float* distances)
{
  find_distances(depths, count, distances);
}
