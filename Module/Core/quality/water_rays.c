// SPDX-License-Identifier: BSD-3-Clause
// water_rays.c: the part of water_quality.h that is about rays: qualities by name, and where the
// frames of an average look.
#include "water_quality.h"

#include "water_math.h"

#include <string.h>

static const struct
{
  const char* name;
  water_ray_quality quality;
} qualities[] = {
  { "fast", { 8, 3, 1, 1, 1.0 } },
  { "default", { 16, 6, 4, 1, 1.0 } },
  { "high", { 24, 12, 8, 2, 1.0 } },
  { "reference", { 256, 64, 1, 2, 0.0 } },
};

water_status water_quality_of_name(const char* name, water_ray_quality* quality)
{
  for (size_t i = 0; i < sizeof qualities / sizeof qualities[0]; ++i)
  {
    if (strcmp(name, qualities[i].name) == 0)
    {
      *quality = qualities[i].quality;
      return WATER_OK;
    }
  }
  return WATER_BAD_QUALITY_NAME;
}

enum
{
  few_rays = 4 // as WATER_FEW_RAYS of vtkWaterRaysFS.glsl
};

bool water_rays_take_all_slopes(int rays)
{
  return rays > few_rays;
}

void water_quality_jitter(unsigned i, double place_px[2])
{
  static const double step[2] = { 0.75487766624669276, 0.56984029099805327 };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place = 0.5 + step[axis] * i;
    place_px[axis] = place - floor(place) - 0.5;
  }
}
