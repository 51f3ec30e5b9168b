// SPDX-License-Identifier: BSD-3-Clause
#include "water_caustics.h"

#include "water_math.h"

static const double sun_radius_rad = 0.2665 * 3.14159265358979323846 / 180.0;
static const double slope_step = 1e-4; // of a derivative by differences

bool water_caustics_way(const double sun_dir[3], const double slope[2], double index, double way[2])
{
  const double length = sqrt(1.0 + slope[0] * slope[0] + slope[1] * slope[1]);
  const double normal[3] = { -slope[0] / length, -slope[1] / length, 1.0 / length };
  const double cosine = water_vec3_dot(normal, sun_dir);
  if (!(cosine > 0.0))
  {
    return false;
  }
  const double eta = 1.0 / index;
  const double under = sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
  double dir[3];
  for (int i = 0; i < 3; ++i)
  {
    dir[i] = -eta * sun_dir[i] + (eta * cosine - under) * normal[i];
  }
  if (!(dir[2] < 0.0))
  {
    return false;
  }
  way[0] = -dir[0] / dir[2];
  way[1] = -dir[1] / dir[2];
  return true;
}

void water_caustics_sun_spread(const double sun_dir[3], double index, double spread[3])
{
  const double cosine = sun_dir[2];
  const double sine = sqrt(fmax(1.0 - cosine * cosine, 0.0));
  const double under = sqrt(1.0 - sine * sine / (index * index));
  const double away = sun_radius_rad * cosine / (index * under * under * under);
  const double beside = sun_radius_rad / (index * under);
  const double dir[2] = { sine > 0.0 ? sun_dir[0] / sine : 1.0,
    sine > 0.0 ? sun_dir[1] / sine : 0.0 };
  const double first = 0.25 * away * away;
  const double second = 0.25 * beside * beside;
  spread[0] = first * dir[0] * dir[0] + second * dir[1] * dir[1];
  spread[1] = (first - second) * dir[0] * dir[1];
  spread[2] = first * dir[1] * dir[1] + second * dir[0] * dir[0];
}

void water_caustics_turn(const double sun_dir[3], double index, double turn[3])
{
  double rows[2][2] = { { 0.0, 0.0 }, { 0.0, 0.0 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    double slope[2] = { 0.0, 0.0 };
    double more[2] = { 0.0, 0.0 };
    double less[2] = { 0.0, 0.0 };
    slope[axis] = slope_step;
    const bool is_lit = water_caustics_way(sun_dir, slope, index, more);
    slope[axis] = -slope_step;
    if (is_lit && water_caustics_way(sun_dir, slope, index, less))
    {
      rows[0][axis] = 0.5 * (more[0] - less[0]) / slope_step;
      rows[1][axis] = 0.5 * (more[1] - less[1]) / slope_step;
    }
  }
  turn[0] = rows[0][0];
  turn[1] = 0.5 * (rows[0][1] + rows[1][0]);
  turn[2] = rows[1][1];
}

// The texels from a place minus to a place plus an extent, cut at the texture's border.
static void find_texels(float place, float extent, int size, int range[2])
{
  const float last = (float)size - 1.0f;
  range[0] = (int)fmaxf(fminf(ceilf(place - extent - 0.5f), (float)size), 0.0f);
  range[1] = (int)fmaxf(fminf(floorf(place + extent - 0.5f), last), -1.0f);
}

void water_caustics_add(
  const float* places, const float* shapes, size_t count, const int texture_px[2], float* light)
{
  for (size_t i = 0; i < count; ++i)
  {
    const float* place = places + 4 * i;
    const float* shape = shapes + 4 * i;
    const float determinant = shape[0] * shape[2] - shape[1] * shape[1];
    if (!(place[2] > 0.0f) || !(determinant > 0.0f))
    {
      continue;
    }
    int columns[2];
    int rows[2];
    find_texels(place[0], sqrtf(shape[2] / determinant), texture_px[0], columns);
    find_texels(place[1], sqrtf(shape[0] / determinant), texture_px[1], rows);
    for (int y = rows[0]; y <= rows[1]; ++y)
    {
      float* row = light + (size_t)y * (size_t)texture_px[0];
      const float dy = (float)y + 0.5f - place[1];
      const float of_row = 1.0f - shape[2] * dy * dy;
      const float across = 2.0f * shape[1] * dy;
      for (int x = columns[0]; x <= columns[1]; ++x)
      {
        const float dx = (float)x + 0.5f - place[0];
        const float within = of_row - dx * (shape[0] * dx + across);
        const float inside = within > 0.0f ? within : 0.0f;
        row[x] += place[2] * inside * inside * inside;
      }
    }
  }
}
