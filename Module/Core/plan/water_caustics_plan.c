// SPDX-License-Identifier: BSD-3-Clause
#include "water_caustics_plan.h"

#include "water_caustics.h"
#include "water_math.h"

static const double least_left = 1.0 / 256.0; // light that comes back from deeper changes no colour
static const double deepest_heights =
  4.0; // of the eye: light that comes to its picture must come from places before it
static const double wide_depths =
  3.0; // pixels as wide as so many depths of the bed see the mean light
static const double reach_slopes =
  2.5; // light and sight come from so many root mean square slopes away
static const double point_density = 1.36; // points a pixel, along a side
static const double fineness = 2.0;       // texels a pixel, along a side
static const double most_texels = 5.2;    // a pixel of the picture
static const double sun_share =
  1.5; // largest distance of points, in standard deviations of the sun's disc
static const double farthest_ndc = 4.0; // of a place
static const double port_depths =
  10.0; // radii of a dome port: beds a quarter and four times as deep are still seen sharp
static const double behind = 1e-12; // w of such a place
static const double bed_texels =
  64.0; // along the longer side: an object narrower than a seventh of that is part of the bed
static const int side_steps = 4; // along a side of the picture
static const int largest_px = 4096;

static bool invert3(const double m[9], double inverse[9])
{
  double columns[3][3];
  for (int i = 0; i < 3; ++i)
  {
    water_vec3_cross(m + 3 * ((i + 1) % 3), m + 3 * ((i + 2) % 3), columns[i]);
  }
  const double determinant = water_vec3_dot(m, columns[0]);
  if (!isfinite(1.0 / determinant)) // nor is it where that is 0, or no number
  {
    return false;
  }
  for (int i = 0; i < 9; ++i)
  {
    inverse[i] = columns[i % 3][i / 3] / determinant;
  }
  return true;
}

// How places under a pixel change with the depth: place(0) (1 + depth per_depth) + depth aside.
typedef struct eye_rays
{
  double height; // of the eye; infinite when parallel
  double per_depth;
  double aside[2];
  double plane_to_ndc[9];
  double sign;  // of w of ndc_to_plane under the horizon
  double pixel; // rad; parallel: width
} eye_rays;

typedef struct view
{
  const water_plan* plan;
  const water_caustics* made; // as far as it is
  double index;
  bool is_straight; // through a dome port: sight is not refracted
  double slopes;    // light and sight are turned by that much at most
  double least_w;   // of ndc_to_plane: from there on pixels see the mean light
  eye_rays rays;
} view;

static bool find_rays(const water_plan* plan, const int viewport_px[2], eye_rays* rays)
{
  const double* m = plan->ndc_to_ray;
  const double middle[3] = { m[2], m[5], m[8] };
  const double up[3] = { m[1], m[4], m[7] };
  const bool is_parallel = plan->clip_w[2] == 0.0;
  rays->height = is_parallel ? (double)INFINITY : plan->plane_view[3];
  rays->per_depth = is_parallel ? 0.0 : 1.0 / plan->plane_view[3];
  rays->aside[0] = is_parallel ? -middle[0] / middle[2] : 0.0;
  rays->aside[1] = is_parallel ? -middle[1] / middle[2] : 0.0;
  // parallel rays are the same in all pixels: their distance is known from the way back
  rays->pixel = 2.0 / viewport_px[1] *
    (is_parallel ? 1.0 / water_vec3_length(plan->dir_to_eye + 3)
                 : water_vec3_length(up) / water_vec3_length(middle));
  // the steepest corner is under the horizon if anything is
  double steepest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double x = (i & 1) ? 1.0 : -1.0;
    const double y = (i & 2) ? 1.0 : -1.0;
    const double fall = -(m[6] * x + m[7] * y + m[8]);
    const double* w = plan->ndc_to_plane + 6;
    if (fall > steepest)
    {
      steepest = fall;
      rays->sign = w[0] * x + w[1] * y + w[2] > 0.0 ? 1.0 : -1.0;
    }
  }
  return steepest > 0.0 && (is_parallel || rays->height > 0.0) &&
    invert3(plan->ndc_to_plane, rays->plane_to_ndc);
}

// The plane in the eye's clip space: the inverse of ndc_to_plane, at the length that directions
// have.
static void find_clip(const water_plan* plan, const eye_rays* rays, water_caustics* made)
{
  static const int rows[3] = { 0, 1, 3 }; // x, y, w
  double product = 0.0;
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      const double entry = rays->plane_to_ndc[3 * i + j];
      product += entry * plan->dir_to_eye[3 * rows[i] + j];
      square += entry * entry;
    }
    made->rise_clip[i] = plan->dir_to_eye[3 * rows[i] + 2];
  }
  for (int i = 0; i < 9; ++i)
  {
    made->place_to_clip[i] = product / square * rays->plane_to_ndc[i];
  }
}

// From which NDC on pixels see the mean light: w of ndc_to_plane is less than this.
static double find_least_w(
  const water_plan* plan, const eye_rays* rays, double depth, bool is_straight)
{
  if (!isfinite(rays->height))
  {
    return 0.0;
  }
  double farthest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double ndc[3] = { (i & 1) ? 1.0 : -1.0, (i & 2) ? 1.0 : -1.0, 1.0 };
    farthest = fmax(farthest,
      hypot(water_vec3_dot(plan->ndc_to_plane, ndc), water_vec3_dot(plan->ndc_to_plane + 3, ndc)));
  }
  // through a port the bed is as many times farther away than the surface as it is deeper
  const double over = is_straight ? rays->height : depth;
  const double distance = sqrt(wide_depths * over * rays->height / rays->pixel);
  return farthest / distance;
}

static double widest(const double turn[3])
{
  return fmax(turn[0], turn[2]);
}

// Distance by which waves move the place that a ray of the eye reaches, per unit of depth. At a low
// angle it is limited to that of light, because a wider texture would be coarser.
//
// ray  to the eye
static double sight_reach(const double ray[3], const view* seen)
{
  double turn[3];
  water_caustics_turn(ray, seen->index, turn);
  return seen->slopes * fmin(widest(turn), widest(seen->made->turn));
}

// Takes a pixel's bed at a depth, as refraction shows it, into a part of NDC at the middle depth.
//
// reach  how far waves move the light that comes there, per depth
static void add_seen(
  const double ndc[3], double depth, double reach, const view* seen, double box[4])
{
  const eye_rays* rays = &seen->rays;
  const water_caustics* made = seen->made;
  double ray[3];
  double way[2] = { 0.0, 0.0 };
  const double flat[2] = { 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    ray[i] = -water_vec3_dot(seen->plan->ndc_to_ray + 3 * i, ndc);
  }
  const double length = water_vec3_length(ray);
  for (int i = 0; i < 3; ++i)
  {
    ray[i] /= length;
  }
  // a ray of the eye is refracted as light is that comes from there
  if (!water_caustics_way(ray, flat, seen->index, way))
  {
    return;
  }
  double sight = sight_reach(ray, seen);
  if (seen->is_straight)
  {
    way[0] = -ray[0] / ray[2];
    way[1] = -ray[1] / ray[2];
    sight = 0.0;
  }
  const double moves = hypot(reach, sight); // they do not depend on each other
  const double* to_plane = seen->plan->ndc_to_plane;
  for (int corner = 0; corner < 4; ++corner)
  {
    double source[3] = { 0.0, 0.0, 1.0 };
    for (int i = 0; i < 2; ++i)
    {
      const double place =
        water_vec3_dot(to_plane + 3 * i, ndc) / water_vec3_dot(to_plane + 6, ndc);
      const double moved = (corner >> i & 1) ? moves : -moves;
      const double from = place + depth * (way[i] - made->calm_way[i] + moved);
      source[i] = (from + made->middle * (made->calm_way[i] - rays->aside[i])) /
        (1.0 + made->middle * rays->per_depth);
    }
    // a place behind the eye is beyond all of the picture's border, on the side that it left by
    const double w = fmax(rays->sign * water_vec3_dot(rays->plane_to_ndc + 6, source), behind);
    for (int i = 0; i < 2; ++i)
    {
      const double at = rays->sign * water_vec3_dot(rays->plane_to_ndc + 3 * i, source) / w;
      if (isfinite(at))
      {
        box[i] = fmin(box[i], fmax(at, -farthest_ndc));
        box[2 + i] = fmax(box[2 + i], fmin(at, farthest_ndc));
      }
    }
  }
}

// The part of NDC at the middle depth that has the bed which the picture shows.
//
// reach  as above
static bool find_box(const view* seen, double reach, double box[4])
{
  static const double corners[5][2] = { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 },
    { -1.0, -1.0 } };
  const double* m = seen->plan->ndc_to_plane;
  box[0] = box[1] = (double)INFINITY;
  box[2] = box[3] = -(double)INFINITY;
  for (int i = 0; i < 4; ++i)
  {
    double w[2];
    for (int k = 0; k < 2; ++k)
    {
      const double* at = corners[i + k];
      w[k] = seen->rays.sign * (m[6] * at[0] + m[7] * at[1] + m[8]) - seen->least_w;
    }
    // the part of the side that is near enough
    const double crossing = w[0] / (w[0] - w[1]);
    const double ends[2] = { w[0] >= 0.0 ? 0.0 : crossing, w[1] >= 0.0 ? 1.0 : crossing };
    for (int k = 0; k <= side_steps && (w[0] >= 0.0 || w[1] >= 0.0); ++k)
    {
      const double share = ends[0] + (ends[1] - ends[0]) * k / side_steps;
      const double ndc[3] = { corners[i][0] + share * (corners[i + 1][0] - corners[i][0]),
        corners[i][1] + share * (corners[i + 1][1] - corners[i][1]), 1.0 };
      add_seen(ndc, 0.0, reach, seen, box);
      add_seen(ndc, seen->made->depth, reach, seen, box);
    }
  }
  return box[2] > box[0] && box[3] > box[1];
}

// Lays the texture of light over a part of NDC, with texels as large as pixels.
static void find_texture(
  const water_caustics_input* input, const double box[4], water_caustics* made)
{
  double sides[2];
  for (int i = 0; i < 2; ++i)
  {
    sides[i] = 0.5 * fineness * (box[2 + i] - box[i]) * input->viewport_px[i];
  }
  const double most = most_texels * input->viewport_px[0] * input->viewport_px[1];
  const double shrunk = fmin(1.0, sqrt(most / (sides[0] * sides[1])));
  const double longest = fmax(input->viewport_px[0], input->viewport_px[1]);
  for (int i = 0; i < 2; ++i)
  {
    const double limit = fmin(largest_px, input->max_texture_px);
    const double texels = fmin(fmax(ceil(sides[i] * shrunk), 2.0), limit);
    made->texture_px[i] = (int)texels;
    made->texel_of_ndc[i] = texels / (box[2 + i] - box[i]);
    made->texel_of_ndc[2 + i] = -box[i] * made->texel_of_ndc[i];
    made->bed_px[i] = (int)fmax(ceil(bed_texels * input->viewport_px[i] / longest), 2.0);
  }
}

// Counts the grid's points: one a texel along each side, fewer where the sun's disc is wide.
//
// blurred  depth at which it is that wide
static void find_counts(const water_caustics_input* input, const eye_rays* rays, double blurred,
  const double box[4], water_caustics* made)
{
  const double distance = isfinite(rays->height) ? rays->height + made->middle : 1.0;
  const double pixel = distance * rays->pixel;
  const double blur = blurred * sqrt(fmin(made->sun_spread[0], made->sun_spread[2]));
  const double apart = fmax(1.0, sun_share * blur / pixel);
  const double density = point_density / (fineness * apart);
  for (int i = 0; i < 2; ++i)
  {
    const double side = (box[2 + i] - box[i]) * made->texel_of_ndc[i] * density;
    made->count[i] = (int)fmin(fmax(ceil(side), 2.0), fmin(largest_px, input->max_texture_px));
  }
}

// From the grid to places on the plane, and from there to texels.
static void find_maps(const view* seen, const double box[4], water_caustics* made)
{
  const double* m = seen->plan->ndc_to_plane;
  const eye_rays* rays = &seen->rays;
  const double scale = 1.0 + made->middle * rays->per_depth;
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double aside = made->middle * (rays->aside[i] - made->calm_way[i]);
      made->grid_to_source[3 * i + j] = rays->sign * (scale * m[3 * i + j] + aside * m[6 + j]);
    }
    made->grid_to_source[6 + j] = rays->sign * m[6 + j];
    const double far_w = seen->least_w;
    made->near[j] = far_w > 0.0 ? rays->sign * m[6 + j] / far_w : (j == 2 ? 2.0 : 0.0);
  }
  for (int i = 0; i < 3; ++i) // from [0, 1] to NDC of the box
  {
    double* row = made->grid_to_source + 3 * i;
    row[2] += row[0] * box[0] + row[1] * box[1];
    row[0] *= box[2] - box[0];
    row[1] *= box[3] - box[1];
  }
  double clip[9];
  for (int i = 0; i < 3; ++i)
  {
    const double* row = made->place_to_clip + 3 * i;
    clip[3 * i] = row[0];
    clip[3 * i + 1] = row[1];
    clip[3 * i + 2] = row[2] +
      made->middle * (row[0] * made->calm_way[0] + row[1] * made->calm_way[1] - made->rise_clip[i]);
  }
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      made->place_to_light[3 * i + j] =
        made->texel_of_ndc[i] * clip[3 * i + j] + made->texel_of_ndc[2 + i] * clip[6 + j];
    }
    made->place_to_light[6 + j] = clip[6 + j];
  }
}

bool water_caustics_plan(
  const water_plan* plan, const water_caustics_input* input, water_caustics* caustics)
{
  water_caustics made = { 0 };
  view seen = { .plan = plan, .made = &made, .index = input->index };
  const double flat[2] = { 0.0, 0.0 };
  if (!plan->has_view || !plan->has_sun || plan->side == WATER_BELOW || plan->is_submerged ||
    !(plan->bed_depth > 0.0) || input->viewport_px[0] < 1 || input->viewport_px[1] < 1 ||
    !water_caustics_way(plan->sun_dir, flat, input->index, made.calm_way) ||
    !find_rays(plan, input->viewport_px, &seen.rays))
  {
    return false;
  }
  const eye_rays* rays = &seen.rays;
  // beyond that the water hides the bed
  made.depth = fmin(plan->bed_depth, -0.5 * log(least_left) / input->extinction);
  seen.is_straight = rays->height < input->port_radius;
  if (!seen.is_straight)
  {
    made.depth = fmin(made.depth, deepest_heights * rays->height);
  }
  if (!isfinite(made.depth))
  {
    return false;
  }
  memcpy(made.sun_dir, plan->sun_dir, sizeof made.sun_dir);
  made.index = input->index;
  water_caustics_turn(plan->sun_dir, input->index, made.turn);
  water_caustics_sun_spread(plan->sun_dir, input->index, made.sun_spread);
  find_clip(plan, rays, &made);
  // a depth whose pixels are as far from those of the surface as from those of the deepest bed
  made.middle = isfinite(rays->height)
    ? sqrt(rays->height * (rays->height + made.depth)) - rays->height
    : 0.5 * made.depth;
  if (seen.is_straight)
  {
    made.middle = fmin(port_depths * input->port_radius, made.depth);
  }
  made.search[0] = seen.is_straight ? made.middle : made.depth;
  made.search[1] = seen.is_straight ? made.middle : 0.0;
  seen.slopes = reach_slopes * input->slope_rms;
  seen.least_w = find_least_w(plan, rays, made.depth, seen.is_straight);
  double light[4];
  double box[4];
  if (!find_box(&seen, 0.0, light) || !find_box(&seen, seen.slopes * widest(made.turn), box))
  {
    return false;
  }
  find_texture(input, light, &made);
  find_counts(input, rays, seen.is_straight ? made.middle : made.depth, box, &made);
  made.is_added = input->is_software;
  find_maps(&seen, box, &made);
  *caustics = made;
  return true;
}
