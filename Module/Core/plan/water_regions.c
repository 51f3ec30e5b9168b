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

void water_regions_join(int64_t* parents, int64_t a, int64_t b)
{
  const int64_t of_a = water_regions_find(parents, a);
  const int64_t of_b = water_regions_find(parents, b);
  if (of_a < of_b)
  {
    parents[of_b] = of_a;
  }
  else
  {
    parents[of_a] = of_b;
  }
}
