// SPDX-License-Identifier: BSD-3-Clause
// cases.c: the generated cases of the stress suite.
#include "cases.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

static const double degree = 0.017453292519943295;

static uint64_t bits(uint64_t* state) // splitmix64 (Steele, Lea and Flood 2014)
{
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double case_roll(stress_case* from, double low, double high)
{
  return low + (high - low) * (double)(bits(&from->dice) >> 11) / 9007199254740992.0; // 2^53
}

double case_roll_decades(stress_case* from, double low, double high)
{
  return pow(10.0, case_roll(from, low, high));
}

static int one_of(stress_case* from, int count)
{
  return (int)(bits(&from->dice) % (uint64_t)count);
}

static double sign_of(stress_case* from)
{
  return one_of(from, 2) ? 1.0 : -1.0;
}

static double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross_unit(const double a[3], const double b[3], double unit[3])
{
  const double c[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const double length = sqrt(dot(c, c));
  for (int i = 0; i < 3; ++i)
  {
    unit[i] = c[i] / length;
  }
}

static void roll_dir(stress_case* from, double dir[3])
{
  double length = 0.0;
  while (length < 0.1 || length > 1.0)
  {
    for (int i = 0; i < 3; ++i)
    {
      dir[i] = case_roll(from, -1.0, 1.0);
    }
    length = sqrt(dot(dir, dir));
  }
  for (int i = 0; i < 3; ++i)
  {
    dir[i] /= length;
  }
}

// Level, along an axis, nearly so, or any.
static void roll_normal(stress_case* from, double normal[3])
{
  const int kind = one_of(from, 4);
  if (kind == 0)
  {
    roll_dir(from, normal);
    return;
  }
  const int axis = kind == 1 ? one_of(from, 3) : 2;
  const double tilt = kind == 2 ? case_roll_decades(from, -16.0, 0.0) : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = i == axis ? 1.0 : tilt * case_roll(from, -1.0, 1.0);
  }
  const double length = sqrt(dot(normal, normal)) * (kind == 1 ? sign_of(from) : 1.0);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] /= length;
  }
}

static void roll_plane(stress_case* made, double unit[3])
{
  roll_normal(made, unit);
  const double offset = one_of(made, 4) ? case_roll_decades(made, -6.0, 7.0) : 0.0;
  roll_dir(made, made->center);
  quad sum = 0;
  const double length = one_of(made, 2) ? case_roll_decades(made, -6.0, 9.0) : 1.0;
  for (int i = 0; i < 3; ++i)
  {
    made->center[i] *= offset;
    made->scene.plane.normal[i] = length * unit[i];
    sum += (quad)made->scene.plane.normal[i] * (quad)made->center[i];
  }
  made->scene.plane.offset = (double)-sum;
}

// In the eye's height 0, 1e-12 and all powers of ten between; in its direction down to 1e-9 rad.
static void roll_view(stress_case* made, const double unit[3])
{
  double along[3];
  double across[3];
  double up[3];
  roll_dir(made, up);
  cross_unit(unit, up, along);
  cross_unit(unit, along, across);
  const double turn = case_roll(made, -3.2, 3.2);
  const int kind = one_of(made, 16);
  const double height = made->size * sign_of(made) *
    (kind == 0      ? 0.0
        : kind == 1 ? 1e-12
                    : case_roll_decades(made, -12.0, 0.0));
  const double side = height < 0.0 ? -1.0 : 1.0;
  const double sine = (one_of(made, 8) ? -side : side) * case_roll_decades(made, -9.0, 0.0);
  const double cosine = sqrt(fmax(1.0 - sine * sine, 0.0));
  const double foot[2] = { made->size * case_roll(made, -1.0, 1.0),
    made->size * case_roll(made, -1.0, 1.0) };
  double eye[3];
  double dir[3];
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = made->center[i] + foot[0] * along[i] + foot[1] * across[i] + height * unit[i];
    dir[i] = cosine * (cos(turn) * along[i] + sin(turn) * across[i]) + sine * unit[i];
  }
  do
  {
    roll_dir(made, up);
  } while (fabs(dot(up, dir)) > 0.99);
  double rows[3][3];
  cross_unit(dir, up, rows[0]);
  cross_unit(rows[0], dir, rows[1]);
  cross_unit(rows[0], rows[1], rows[2]);
  double* view = made->scene.eye.world_to_view;
  for (int i = 0; i < 3; ++i)
  {
    memcpy(view + 4 * i, rows[i], sizeof rows[i]);
    view[4 * i + 3] = -dot(rows[i], eye);
  }
  view[15] = 1.0;
}

static void roll_perspective(stress_case* made, double* clip)
{
  made->near_z = made->size * case_roll_decades(made, -6.0, 0.0);
  made->far_z = made->near_z * case_roll_decades(made, 0.01, 8.0);
  const double half = 0.5 * degree *
    (one_of(made, 2) ? case_roll_decades(made, -3.0, 2.252) : case_roll(made, 1.0, 179.0));
  const double tall = 1.0 / tan(half);
  clip[0] = tall / case_roll_decades(made, -0.5, 0.5);
  clip[5] = tall;
  const bool is_off_axis = one_of(made, 2);
  clip[2] = is_off_axis ? sign_of(made) * case_roll_decades(made, -2.0, 3.0) : 0.0;
  clip[6] = is_off_axis ? sign_of(made) * case_roll_decades(made, -2.0, 3.0) : 0.0;
  const double depth = made->far_z - made->near_z;
  clip[10] = -(made->far_z + made->near_z) / depth;
  clip[11] = -2.0 * made->far_z / depth * made->near_z;
  clip[14] = -1.0;
}

static void roll_parallel(stress_case* made, double* clip)
{
  const double half = case_roll_decades(made, -9.0, 9.0);
  made->near_z = made->size * case_roll_decades(made, -6.0, 0.0);
  const double depth = made->size * case_roll_decades(made, -2.0, 3.0);
  made->far_z = made->near_z + depth;
  clip[0] = 1.0 / half / case_roll_decades(made, -0.5, 0.5);
  clip[5] = 1.0 / half;
  clip[3] = one_of(made, 2) ? sign_of(made) * case_roll_decades(made, -2.0, 3.0) : 0.0;
  clip[10] = -2.0 / depth;
  clip[11] = -(made->far_z + made->near_z) / depth;
  clip[15] = 1.0;
  made->scene.eye.parallel = true;
}

static void fill_truths(stress_case* made)
{
  const water_scene* scene = &made->scene;
  quad_of(scene->plane.normal, 3, made->normal);
  made->length = quad_length(made->normal);
  made->offset = (quad)scene->plane.offset / made->length;
  const double* view = scene->eye.world_to_view;
  quad_invert_rotation(view, made->view_to_world);
  const quad origin[3] = { (quad)view[3], (quad)view[7], (quad)view[11] };
  for (int i = 0; i < 3; ++i)
  {
    made->normal[i] /= made->length;
    made->eye[i] = -quad_dot(made->view_to_world + 3 * i, origin);
  }
  for (int j = 0; j < 3; ++j)
  {
    made->height_view[j] = made->normal[0] * made->view_to_world[j] +
      made->normal[1] * made->view_to_world[3 + j] + made->normal[2] * made->view_to_world[6 + j];
  }
  made->height_view[3] = case_height(made, made->eye);
  made->eye_height = scene->eye.parallel ? made->height_view[2] : made->height_view[3];
  made->side = made->eye_height > 0 ? 1 : made->eye_height < 0 ? -1 : 0;
}

quad case_height(const stress_case* of, const quad point[3])
{
  return quad_dot(of->normal, point) + of->offset;
}

void case_project_mirrored(const stress_case* of, const quad point[3], quad clip[4])
{
  const quad twice = 2 * case_height(of, point);
  quad image[3];
  quad view[3];
  for (int i = 0; i < 3; ++i)
  {
    image[i] = point[i] - twice * of->normal[i];
  }
  quad_apply(of->scene.eye.world_to_view, 3, image, 1, view);
  quad_apply(of->scene.eye.view_to_clip, 4, view, 1, clip);
}

int case_may_be_shown(const stress_case* of, const double point[3])
{
  const double normal[3] = { (double)of->normal[0], (double)of->normal[1], (double)of->normal[2] };
  const double height = dot(normal, point) + (double)of->offset;
  const double* view = of->scene.eye.world_to_view;
  const double* to_clip = of->scene.eye.view_to_clip;
  double size = fabs((double)of->offset); // of what the roundings are shares of
  double image[3];
  double seen[3];
  for (int i = 0; i < 3; ++i)
  {
    image[i] = point[i] - 2.0 * height * normal[i];
    size += fabs(point[i]) + fabs(view[4 * i + 3]);
  }
  for (int i = 0; i < 3; ++i)
  {
    seen[i] = dot(view + 4 * i, image) + view[4 * i + 3];
  }
  const double off = 1e-12 * size;
  const double w = dot(to_clip + 12, seen) + to_clip[15];
  const double x = dot(to_clip, seen) + to_clip[3];
  const double y = dot(to_clip + 4, seen) + to_clip[7];
  const double shear = fabs(to_clip[2]) + fabs(to_clip[6]) + 1.0;
  return (double)of->side * height > -off && w > -off && fabs(x) < w + off * (to_clip[0] + shear) &&
    fabs(y) < w + off * (to_clip[5] + shear);
}

int case_is_shown(const stress_case* of, const quad point[3])
{
  const quad height = case_height(of, point) * of->side;
  if (!(height > 0))
  {
    return 0;
  }
  quad clip[4];
  case_project_mirrored(of, point, clip);
  if (!(clip[3] > 0 && fabsq(clip[0]) <= clip[3] && fabsq(clip[1]) <= clip[3] &&
        clip[2] >= -clip[3]))
  {
    return 0;
  }
  // from the image back along the line of sight: parallel ones all have the same direction
  quad way[3];
  const quad down = -height;
  quad rise;
  for (int i = 0; i < 3; ++i)
  {
    const quad image = point[i] - 2 * height * of->side * of->normal[i];
    way[i] = of->scene.eye.parallel ? of->view_to_world[3 * i + 2] : of->eye[i] - image;
  }
  rise = quad_dot(of->normal, way) * of->side;
  if (!(rise > 0))
  {
    return 0;
  }
  quad crossing[3];
  for (int i = 0; i < 3; ++i)
  {
    const quad image = point[i] - 2 * height * of->side * of->normal[i];
    crossing[i] = image - down / rise * way[i];
    if (crossing[i] < (quad)of->scene.surface_bounds[2 * i] ||
      crossing[i] > (quad)of->scene.surface_bounds[2 * i + 1])
    {
      return 0;
    }
  }
  quad view[3];
  quad_apply(of->scene.eye.world_to_view, 3, crossing, 1, view);
  quad_apply(of->scene.eye.view_to_clip, 4, view, 1, clip);
  return clip[2] >= -clip[3]; // the near plane does not cut the water away there
}

// A point that is shown near the border of the picture, or anywhere in it.
static int roll_shown(stress_case* made, quad point[3])
{
  const double* to_clip = made->scene.eye.view_to_clip;
  double ndc[2];
  for (int i = 0; i < 2; ++i)
  {
    ndc[i] = one_of(made, 2) ? sign_of(made) * (1.0 - case_roll_decades(made, -16.0, 0.0))
                             : case_roll(made, -1.0, 1.0);
  }
  // the line of sight in view space: base + depth * dir
  const bool is_parallel = made->scene.eye.parallel;
  const quad x = ((quad)ndc[0] + (quad)(is_parallel ? -to_clip[3] : to_clip[2])) / (quad)to_clip[0];
  const quad y = ((quad)ndc[1] + (quad)(is_parallel ? -to_clip[7] : to_clip[6])) / (quad)to_clip[5];
  const quad base[3] = { is_parallel ? x : 0, is_parallel ? y : 0, 0 };
  const quad dir[3] = { is_parallel ? 0 : x, is_parallel ? 0 : y, -1 };
  const quad from = (quad_dot(made->height_view, base) + made->height_view[3]) * made->side;
  const quad fall = -quad_dot(made->height_view, dir) * made->side;
  if (!(fall > 0) || made->side == 0)
  {
    return 0;
  }
  const quad water = from / fall; // depth where the line of sight meets the plane
  if (!(water >= (quad)made->near_z))
  {
    return 0;
  }
  const quad depth =
    water + (quad)(case_roll_decades(made, -6.0, 4.0)) * (is_parallel ? (quad)made->size : water);
  quad view[3];
  for (int i = 0; i < 3; ++i)
  {
    view[i] = base[i] + depth * dir[i] - (quad)made->scene.eye.world_to_view[4 * i + 3];
  }
  quad image[3];
  for (int i = 0; i < 3; ++i)
  {
    image[i] = quad_dot(made->view_to_world + 3 * i, view);
  }
  const quad twice = 2 * case_height(made, image);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = (quad)(double)(image[i] - twice * made->normal[i]);
  }
  return case_is_shown(made, point);
}

static void roll_props(stress_case* made)
{
  for (int number = 0; number < CASE_PROPS; ++number)
  {
    water_prop* prop = &made->props[number];
    prop->flags = WATER_PROP_VISIBLE;
    prop->width_px = one_of(made, 8) ? 0.0f : 4.0f;
    const double reach = made->size * case_roll_decades(made, -6.0, 1.0);
    quad point[3] = { 0, 0, 0 };
    const int is_shown = number < CASE_SHOWN && roll_shown(made, point);
    for (int i = 0; i < 3; ++i)
    {
      const double low =
        is_shown ? (double)point[i] : made->center[i] + made->size * case_roll(made, -2.0, 2.0);
      const double other = one_of(made, 8) ? low + reach * case_roll(made, -1.0, 1.0) : low;
      prop->bounds[2 * i] = fmin(low, other);
      prop->bounds[2 * i + 1] = fmax(low, other);
    }
    if (number < CASE_SHOWN)
    {
      made->is_shown[number] = is_shown;
      memcpy(made->shown[number], point, sizeof point);
    }
  }
}

void case_make(uint64_t seed, uint64_t number, stress_case* made)
{
  memset(made, 0, sizeof *made); // padding, too: scenes are compared as bytes
  made->dice = seed ^ (number * 0xd1342543de82ef95u);
  (void)bits(&made->dice);
  made->size = case_roll_decades(made, -6.0, 9.0);
  water_scene* scene = &made->scene;
  double unit[3];
  roll_plane(made, unit);
  roll_view(made, unit);
  if (one_of(made, 3))
  {
    roll_perspective(made, scene->eye.view_to_clip);
  }
  else
  {
    roll_parallel(made, scene->eye.view_to_clip);
  }
  fill_truths(made);
  const double half = made->size * case_roll_decades(made, -1.0, 3.0);
  for (int i = 0; i < 3; ++i)
  {
    scene->surface_bounds[2 * i] = made->center[i] - half;
    scene->surface_bounds[2 * i + 1] = made->center[i] + half;
  }
  memcpy(scene->plane_origin, made->center, sizeof made->center);
  scene->viewport_px[0] = 1 + one_of(made, 4096);
  scene->viewport_px[1] = 1 + one_of(made, 4096);
  scene->settings.texture_scale = case_roll(made, 0.25, 2.0);
  scene->max_texture_px = 16384;
  scene->max_samples = 32;
  scene->look.index_of_refraction = 1.333;
  scene->has_waves = one_of(made, 4) == 0;
  scene->slope_rms = 0.1;
  scene->slope_max = case_roll_decades(made, -3.0, 0.0);
  scene->is_flat = one_of(made, 2);
  scene->has_scene_depth = one_of(made, 2);
  scene->settings.clip_margin = one_of(made, 2) ? 0.0 : made->size * 1e-3;
  scene->settings.skips = WATER_MAY_SKIP_ALL;
  roll_props(made);
  scene->props = made->props;
  scene->prop_count = CASE_PROPS;
}
