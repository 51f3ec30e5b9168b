// SPDX-License-Identifier: BSD-3-Clause
// water_sky.c: what is behind all props, by direction.
#include "water_sky.h"

#include "water_features.h"
#include "water_math.h"

void water_sky_map_none(water_sky_map* map)
{
  static const double same[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  memset(map, 0, sizeof *map);
  map->kind = WATER_SKY_SCREEN;
  memcpy(map->to_map, same, sizeof same);
  map->latitude[0] = 1.0;
  map->latitude[1] = 0.5;
  map->exponent = 1.0;
}

void water_sky_map_sphere(const double rotation[9], water_sky_map* map)
{
  water_sky_map_none(map);
  map->kind = WATER_SKY_MAP;
  memcpy(map->to_map, rotation, sizeof map->to_map);
}

void water_sky_map_stereo(const double rotation[9], bool is_left_eye, water_sky_map* map)
{
  water_sky_map_sphere(rotation, map);
  map->latitude[0] = 0.5;
  map->latitude[1] = is_left_eye ? 0.75 : 0.25;
}

void water_sky_map_cube(const double rotation[9], bool is_turned, water_sky_map* map)
{
  water_sky_map_sphere(rotation, map);
  map->kind = WATER_SKY_CUBE;
  for (int i = 6; i < 9 && is_turned; ++i)
  {
    map->to_map[i] = -map->to_map[i];
  }
}

void water_sky_rotation_on_floor(const double plane[4], const double right[3], double rotation[9])
{
  const double length = water_vec3_length(plane);
  const double scale = length > 0.0 ? 1.0 / length : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    rotation[3 + i] = scale * plane[i];
    rotation[6 + i] = right[i];
  }
  water_vec3_cross(rotation + 3, right, rotation);
}

void water_sky_floor_make(
  const double plane[4], const double right[3], const double scale[2], water_sky_floor* floor)
{
  const double length = water_vec3_length(plane);
  memset(floor, 0, sizeof *floor);
  floor->is_there = length > 0.0 && isfinite(length) && water_all_usable(plane, 4) &&
    water_all_usable(right, 3) && water_all_usable(scale, 2) && scale[0] != 0.0 && scale[1] != 0.0;
  if (!floor->is_there)
  {
    return;
  }
  double normal[3];
  double front[3];
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = plane[i] / length;
  }
  water_vec3_cross(normal, right, front);
  // texture places count from the foot of the world's origin
  for (int i = 0; i < 3; ++i)
  {
    floor->height[i] = normal[i];
    floor->u[i] = right[i] / scale[0];
    floor->v[i] = front[i] / scale[1];
  }
  floor->height[3] = plane[3] / length;
  floor->u[3] = floor->height[3] * water_vec3_dot(floor->u, normal);
  floor->v[3] = floor->height[3] * water_vec3_dot(floor->v, normal);
  floor->exponent = 1.0;
}

void water_sky_map_local(const water_sky_map* world, const water_axes* axes, water_sky_map* local)
{
  const double* dirs[3] = { axes->x_dir, axes->y_dir, axes->normal };
  *local = *world;
  for (int i = 0; i < 9; ++i)
  {
    local->to_map[i] = water_vec3_dot(world->to_map + 3 * (i / 3), dirs[i % 3]);
  }
}

void water_sky_environment(
  const double up[3], const double right[3], const water_axes* axes, water_sky_map* local)
{
  double rotation[9];
  water_lookup_environment(axes, up, right, rotation); // of directions in the axes already
  water_sky_map_sphere(rotation, local);
}

static void row_local(
  const double world[4], const water_axes* axes, const double origin_xy[2], double local[4])
{
  const double x = water_vec3_dot(world, axes->x_dir);
  const double y = water_vec3_dot(world, axes->y_dir);
  local[3] = water_vec3_dot(world, axes->origin) + origin_xy[0] * x + origin_xy[1] * y + world[3];
  local[0] = x;
  local[1] = y;
  local[2] = water_vec3_dot(world, axes->normal);
}

void water_sky_floor_local(const water_sky_floor* world, const water_axes* axes,
  const double origin_xy[2], water_sky_floor* local)
{
  *local = *world;
  if (world->is_there)
  {
    row_local(world->height, axes, origin_xy, local->height);
    row_local(world->u, axes, origin_xy, local->u);
    row_local(world->v, axes, origin_xy, local->v);
  }
}

const water_sky_map* water_sky_of(const water_plan* plan, bool has_environment)
{
  return has_environment ? &plan->environment_map : &plan->sky_map;
}

bool water_sky_is_one_color(const water_plan* plan, bool has_environment)
{
  return !has_environment && plan->sky_map.kind == WATER_SKY_SCREEN &&
    plan->sky.screen == WATER_SCREEN_COLOR && !plan->sky_floor.is_there;
}

water_feature_set water_sky_features(
  water_feature_set features, bool has_environment, bool is_below, const water_sky* sky)
{
  const bool is_looked_up =
    (features & (WATER_FEATURE_RAY_TRACED | WATER_FEATURE_ENVIRONMENT)) != 0 ||
    ((features & WATER_FEATURE_MEDIUM) != 0 && is_below);
  if (!is_looked_up || (features & WATER_FEATURE_SKY_VIEW) != 0)
  {
    return features;
  }
  if (has_environment)
  {
    return features | WATER_FEATURE_SKY_MAP;
  }
  const water_feature_set floor = sky->floor.is_there ? WATER_FEATURE_SKY_FLOOR : 0;
  switch (sky->map.kind)
  {
    case WATER_SKY_MAP:
      return features | floor | WATER_FEATURE_SKY_MAP;
    case WATER_SKY_CUBE:
      return features | floor | WATER_FEATURE_SKY_CUBE;
    default:
      return features | floor | (sky->screen != WATER_SCREEN_COLOR ? WATER_FEATURE_SKY_SCREEN : 0);
  }
}
