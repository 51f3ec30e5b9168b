// SPDX-License-Identifier: BSD-3-Clause
// water_normals.c: built-in ripples, and the motion of normal maps.
#include "water_normals.h"

#include "water_phase.h"
#include "water_random.h"

enum
{
  RIPPLES = 40
};

static const double rms_slope = 0.1;

typedef struct ripple
{
  int waves[2]; // a side, along both axes
  double slope[2];
  double phase_rad;
} ripple;

water_status water_normals_check(const water_normal_map* map)
{
  if (!(map->size >= 1e-6 && map->size <= 1e9))
  {
    return WATER_BAD_NORMAL_MAP_SIZE;
  }
  if (!isfinite(map->speed) || !isfinite(map->direction_rad))
  {
    return WATER_BAD_NORMAL_MAP_MOTION;
  }
  return fabs(map->strength) <= 1e3 ? WATER_OK : WATER_BAD_NORMAL_MAP_STRENGTH;
}

void water_normals_place(
  const water_normal_map* map, double x, double y, double time, double place[2])
{
  const double way = map->speed * time;
  const double at[2] = { x - way * cos(map->direction_rad), y - way * sin(map->direction_rad) };
  for (int i = 0; i < 2; ++i)
  {
    const double maps = at[i] / map->size;
    const double rest = maps - floor(maps);
    place[i] = rest < 1.0 ? rest : 0.0; // just under a whole number it rounds up to 1
  }
}

void water_normals_texels(const unsigned char* pixels, size_t channels, size_t count, float* texels)
{
  for (size_t i = 0; i < count; ++i)
  {
    const unsigned char* pixel = pixels + channels * i;
    const double up = fmax(pixel[2] / 127.5 - 1.0, 0.05); // none that faces down
    for (size_t j = 0; j < 2; ++j)
    {
      const double slope = -(pixel[j] / 127.5 - 1.0) / up;
      texels[4 * i + j] = (float)slope;
      texels[4 * i + j + 2] = (float)(slope * slope);
    }
  }
}

// Each has the same variance of slope, which all of them share out.
static void roll_ripples(uint64_t seed, ripple ripples[RIPPLES])
{
  const double slope = rms_slope * sqrt(2.0 / (double)RIPPLES);
  for (int i = 0; i < RIPPLES; ++i)
  {
    const double length = 2.0 * pow(10.0, (i + 0.5) / (double)RIPPLES); // 2 to 20 waves a side
    const double angle = water_two_pi * water_random_uniform(seed, (uint64_t)(2 * i));
    ripples[i].waves[0] = (int)lround(length * cos(angle));
    ripples[i].waves[1] = (int)lround(length * sin(angle));
    const double whole = hypot(ripples[i].waves[0], ripples[i].waves[1]);
    ripples[i].slope[0] = slope * ripples[i].waves[0] / whole;
    ripples[i].slope[1] = slope * ripples[i].waves[1] / whole;
    ripples[i].phase_rad = water_two_pi * water_random_uniform(seed, (uint64_t)(2 * i + 1));
  }
}

void water_normals_fill(size_t size, uint64_t seed, unsigned char* pixels)
{
  ripple ripples[RIPPLES];
  roll_ripples(seed, ripples);
  for (size_t y = 0; y < size; ++y)
  {
    for (size_t x = 0; x < size; ++x)
    {
      double normal[3] = { 0.0, 0.0, 1.0 };
      for (int i = 0; i < RIPPLES; ++i)
      {
        const double turns =
          (ripples[i].waves[0] * (double)x + ripples[i].waves[1] * (double)y) / (double)size;
        const double part = cos(water_two_pi * turns + ripples[i].phase_rad);
        normal[0] -= ripples[i].slope[0] * part;
        normal[1] -= ripples[i].slope[1] * part;
      }
      const double length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + 1.0);
      for (int i = 0; i < 3; ++i)
      {
        const double level = 127.5 + 127.5 * normal[i] / length;
        pixels[3 * (y * size + x) + (size_t)i] = (unsigned char)lround(level);
      }
    }
  }
}
