// SPDX-License-Identifier: BSD-3-Clause
// water_shafts.c: the square around an eye under water whose light is gathered.
#include "water_shafts.h"

#include "water_caustics.h"
#include "water_math.h"

static const double farthest_left = 0.1; // of the light: what comes from beyond shows no shafts
static const double farthest_depths =
  10.0;                                   // of the eye: so wide is the square to each side, at most
static const double reach_slopes = 2.5;   // as for caustics
static const int texture_px = 512;        // along a side
static const int largest_count = 1024;    // points along a side
static const double point_density = 0.68; // points a texel, along a side, as for caustics
static const int step_count = 24;
static const double fade_from = 0.38; // distance from the middle, in uv: inside, light is as it is
static const double fade_to = 0.49;

bool water_shafts_plan(
  const water_plan* plan, const water_caustics_input* input, water_shafts* shafts)
{
  const double flat[2] = { 0.0, 0.0 };
  // the third axis of an eye under the plane points down
  const double sun_dir[3] = { plan->sun_dir[0], plan->sun_dir[1], -plan->sun_dir[2] };
  const double depth = plan->plane_view[3];
  water_shafts made = { .eye_depth = depth, .steps = step_count };
  water_caustics* light = &made.light;
  if (!plan->has_view || !plan->has_sun || !plan->is_submerged || plan->clip_w[2] == 0.0 ||
    !(depth > 0.0) || !isfinite(depth) || !(input->extinction > 0.0) || !(sun_dir[2] > 0.0) ||
    !water_caustics_way(sun_dir, flat, input->index, light->calm_way))
  {
    return false;
  }
  memcpy(light->sun_dir, sun_dir, sizeof sun_dir);
  light->index = input->index;
  water_caustics_turn(sun_dir, input->index, light->turn);
  water_caustics_sun_spread(sun_dir, input->index, light->sun_spread);
  light->depth = light->middle = light->search[0] = depth;
  light->is_level = true;
  light->is_added = input->is_software;
  light->bed_px[0] = light->bed_px[1] = 1;
  light->place_to_clip[8] = 1.0; // every place is over the same bed
  const double far = fmin(-log(farthest_left) / input->extinction, farthest_depths * depth);
  const double turned = fmax(light->turn[0], light->turn[2]);
  const double margin = depth * reach_slopes * input->slope_rms * turned;
  const double px = fmin(texture_px, input->max_texture_px);
  const double count = ceil(px * point_density * (far + margin) / far);
  if (!(count <= fmin(largest_count, input->max_texture_px)))
  {
    return false; // light comes from so far around that no shafts are left
  }
  for (int i = 0; i < 2; ++i)
  {
    const double middle = -depth * light->calm_way[i]; // lights the eye
    const double half = far + margin;
    light->texture_px[i] = (int)px;
    light->count[i] = (int)count;
    light->grid_to_source[4 * i] = 2.0 * half;
    light->grid_to_source[3 * i + 2] = middle - half;
    light->place_to_light[4 * i] = px / (2.0 * far);
    light->place_to_light[3 * i + 2] = 0.5 * px - middle * px / (2.0 * far);
    made.place_to_uv[1 + i] = 0.5 - middle / (2.0 * far);
  }
  light->grid_to_source[8] = light->place_to_light[8] = 1.0;
  made.place_to_uv[0] = 1.0 / (2.0 * far);
  made.fade[0] = fade_from * fade_from;
  made.fade[1] = fade_to * fade_to;
  *shafts = made;
  return true;
}
