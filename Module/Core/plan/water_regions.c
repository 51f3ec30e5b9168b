// SPDX-License-Identifier: BSD-3-Clause
#include "water_regions.h"

void water_regions_begin(int64_t* parents, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    parents[i] = (int64_t)i;
  }
}

int64_t water_regions_find(int64_t* parents, int64_t point)
{
  while (parents[point] != point)
  {
    parents[point] = parents[parents[point]];
    point = parents[point];
  }
  return point;
}

void water_regions_join(int64_t* parents, const int64_t* points, size_t count)
{
  int64_t region = count > 0 ? water_regions_find(parents, points[0]) : 0;
  for (size_t i = 1; i < count; ++i)
  {
    const int64_t other = water_regions_find(parents, points[i]);
    const int64_t lower = other < region ? other : region;
    parents[other] = lower;
    parents[region] = lower;
    region = lower;
  }
}
