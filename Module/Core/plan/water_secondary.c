// SPDX-License-Identifier: BSD-3-Clause
// water_secondary.c: the plan of another water with the mirrored camera for an eye, and its mean
// slopes.
#include "water_secondary.h"

#include "water_glitter.h"
#include "water_math.h"
#include "water_phase.h"
#include "water_plan.h"

#include <limits.h>

water_status water_secondary_plan(
  const water_scene* scene, const water_plan* mirrored, water_plan* plan)
{
  water_scene seen;
  memset(&seen, 0, sizeof seen);
  seen.eye = mirrored->mirrored;
  seen.picture_eye = &scene->eye;
  memcpy(seen.viewport_px, mirrored->texture_px, sizeof seen.viewport_px);
  seen.plane = scene->plane;
  memcpy(seen.plane_origin, scene->plane_origin, sizeof seen.plane_origin);
  memcpy(seen.surface_bounds, scene->surface_bounds, sizeof seen.surface_bounds);
  seen.is_endless = scene->is_endless;
  seen.look = scene->look;
  seen.has_environment = true;
  memcpy(seen.environment_up, scene->environment_up, sizeof seen.environment_up);
  memcpy(seen.environment_right, scene->environment_right, sizeof seen.environment_right);
  seen.sky = mirrored->sky;
  memcpy(seen.light, scene->light, sizeof seen.light);
  seen.settings.texture_scale = 1.0;
  seen.settings.color_precision =
    mirrored->is_half_float ? WATER_COLOR_HALF_FLOAT : WATER_COLOR_EIGHT_BIT;
  seen.max_texture_px = INT_MAX;
  return water_plan_make(&seen, plan, NULL);
}

void water_secondary_view(
  const water_plan* mirrored, const water_camera* picture_eye, bool is_rough, water_scene* scene)
{
  scene->eye = mirrored->mirrored;
  scene->picture_eye = picture_eye;
  memcpy(scene->viewport_px, mirrored->texture_px, sizeof scene->viewport_px);
  scene->viewport_rect_px = mirrored->texture_rect_px;
  // the mean of all waves, on a surface at rest
  scene->has_waves = is_rough;
  scene->slope_max = is_rough ? (double)INFINITY : 0.0;
  scene->wave_height_max = 0.0;
  scene->surface_height = 0.0;
  scene->is_hidden = false;
  scene->has_scene_depth = false; // that of the picture
  scene->settings.texture_scale = 1.0;
  scene->settings.quality = WATER_QUALITY_FIXED;
  scene->settings.multi_samples = is_rough ? 0 : mirrored->samples;
  scene->settings.color_precision =
    mirrored->is_half_float ? WATER_COLOR_HALF_FLOAT : WATER_COLOR_EIGHT_BIT;
}

void water_secondary_slopes(const water_wave* waves, size_t count, const double sea[2],
  double sea_dir_rad, const double given[2], double dir_rad, double covariance[3])
{
  double sum[3];
  double of_sea[3];
  water_glitter_covariance(given, dir_rad, sum);
  water_glitter_covariance(sea, sea_dir_rad, of_sea);
  for (int j = 0; j < 3; ++j)
  {
    sum[j] += of_sea[j];
  }
  for (size_t i = 0; i < count; ++i)
  {
    const double steep = water_two_pi / waves[i].wavelength * waves[i].amplitude;
    const double variance[2] = { 0.5 * steep * steep, 0.0 };
    double wave[3];
    water_glitter_covariance(variance, waves[i].direction_rad, wave);
    for (int j = 0; j < 3; ++j)
    {
      sum[j] += wave[j];
    }
  }
  memcpy(covariance, sum, sizeof sum);
}
