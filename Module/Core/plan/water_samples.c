// SPDX-License-Identifier: BSD-3-Clause
// water_samples.c: how fine a picture of samples is, and which sample each of its pixels has.
#include "water_samples.h"

#include <float.h>

int water_samples_side(int samples, const int size_px[2], int max_texture_px)
{
  const int longer = size_px[0] > size_px[1] ? size_px[0] : size_px[1];
  int side = 1;
  while (
    side < WATER_SAMPLES_SIDE_MAX && side * side < samples && longer <= max_texture_px / (side + 1))
  {
    ++side;
  }
  return side;
}

void water_samples_nearest(const float places[][2], int samples, int side, int numbers[])
{
  for (int fine = 0; fine < side * side; ++fine)
  {
    const double x = (fine % side + 0.5) / side - 0.5;
    const double y = (fine / side + 0.5) / side - 0.5;
    double nearest = DBL_MAX;
    numbers[fine] = 0;
    for (int i = 0; i < samples; ++i)
    {
      const double across = (double)places[i][0] - x;
      const double up = (double)places[i][1] - y;
      const double away = across * across + up * up;
      numbers[fine] = away < nearest ? i : numbers[fine];
      nearest = away < nearest ? away : nearest;
    }
  }
}
