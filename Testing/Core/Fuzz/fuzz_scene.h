// SPDX-License-Identifier: BSD-3-Clause
// fuzz_scene.h: scenes out of the fuzzer's bytes: any, or ones that are planned.
#ifndef fuzz_scene_h
#define fuzz_scene_h

#include "fuzz_input.h"
#include "water_plan.h"

enum
{
  FUZZ_PROPS = 8
};

// Looks down on the level z = 0 unless the bytes say otherwise.
static inline void fuzz_camera(fuzz_input* from, water_camera* camera)
{
  memset(camera, 0, sizeof *camera);
  camera->parallel = fuzz_bool(from);
  if (fuzz_byte(from) >= 224)
  {
    fuzz_doubles(from, camera->world_to_view, 16);
    fuzz_doubles(from, camera->view_to_clip, 16);
    return;
  }
  // a turn about two axes, and a place
  const double turn = fuzz_near(from, 0.0);
  const double tilt = fuzz_near(from, 0.5);
  const double c = cos(turn);
  const double s = sin(turn);
  const double d = cos(tilt);
  const double t = sin(tilt);
  const double view[12] = { c, s, 0.0, fuzz_near(from, 0.0), -s * t, c * t, d, fuzz_near(from, 0.0),
    s * d, -c * d, t, fuzz_near(from, -10.0) };
  memcpy(camera->world_to_view, view, sizeof view);
  camera->world_to_view[15] = 1.0;
  double* clip = camera->view_to_clip;
  clip[0] = fuzz_near(from, 1.0);
  clip[5] = fuzz_near(from, 1.3);
  clip[10] = fuzz_near(from, -1.01);
  clip[11] = fuzz_near(from, -2.01);
  const int shear = camera->parallel ? 3 : 2;
  clip[shear] = fuzz_near(from, 0.0);
  clip[4 + shear] = fuzz_near(from, 0.0);
  clip[14] = camera->parallel ? 0.0 : -1.0;
  clip[15] = camera->parallel ? 1.0 : 0.0;
}

static inline void fuzz_prop(fuzz_input* from, water_prop* prop)
{
  memset(prop, 0, sizeof *prop);
  for (int i = 0; i < 6; ++i)
  {
    prop->bounds[i] = fuzz_near(from, i % 2 ? 1.0 : -1.0);
  }
  const uint8_t flags = fuzz_byte(from);
  prop->flags = flags < 128 ? WATER_PROP_VISIBLE : flags;
  prop->width_px = (float)fuzz_byte(from);
}

// props: FUZZ_PROPS of them
static inline void fuzz_scene(fuzz_input* from, water_prop* props, water_scene* scene)
{
  memset(scene, 0, sizeof *scene);
  const uint8_t flags = fuzz_byte(from);
  scene->has_waves = flags & 1;
  scene->is_from_sun = flags & 2;
  scene->has_environment = flags & 4;
  scene->has_sun = flags & 8;
  scene->hides_above = flags & 16;
  scene->hides_below = flags & 32;
  scene->is_hidden = flags & 64;
  scene->is_flat = flags & 128;
  scene->settings.skips = fuzz_byte(from);
  scene->prop_count = fuzz_below(from, FUZZ_PROPS + 1);
  for (size_t i = 0; i < scene->prop_count; ++i)
  {
    fuzz_prop(from, &props[i]);
  }
  scene->props = props;
  fuzz_camera(from, &scene->eye);
  for (int i = 0; i < 2; ++i)
  {
    scene->viewport_px[i] = fuzz_bool(from) ? fuzz_int(from) : 300;
  }
  for (int i = 0; i < 3; ++i)
  {
    scene->plane.normal[i] = fuzz_near(from, i == 2 ? 1.0 : 0.0);
    scene->plane_origin[i] = fuzz_near(from, 0.0);
    scene->environment_up[i] = fuzz_near(from, 0.0);
    scene->environment_right[i] = fuzz_near(from, 1.0);
    scene->sun_dir[i] = fuzz_near(from, 1.0);
  }
  scene->plane.offset = fuzz_near(from, 0.0);
  for (int i = 0; i < 6; ++i)
  {
    scene->surface_bounds[i] = fuzz_near(from, i > 3 ? 0.0 : i % 2 ? 10.0 : -10.0);
  }
  scene->has_scene_depth = fuzz_bool(from);
  scene->is_software = fuzz_bool(from);
  scene->slope_rms = fuzz_near(from, 0.1);
  scene->slope_max = fuzz_near(from, 0.5);
  scene->wave_height_max = fuzz_near(from, 0.0);
  scene->settings.guard_band = fuzz_near(from, 0.0);
  scene->look.constant_reflectance = fuzz_bool(from);
  scene->look.index_of_refraction = fuzz_near(from, 1.333);
  scene->look.reflectance = fuzz_near(from, 1.0);
  scene->settings.texture_scale = fuzz_near(from, 1.0);
  scene->max_texture_px = fuzz_bool(from) ? fuzz_int(from) : 16384;
  scene->max_samples = 32;
  scene->settings.clip_margin = fuzz_near(from, 0.0);
  scene->settings.prop_px_min = fuzz_near(from, 0.0);
  scene->settings.reflectance_error = fuzz_near(from, 0.0);
  scene->surface_height = fuzz_near(from, 0.0);
}

#endif
