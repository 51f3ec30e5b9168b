// SPDX-License-Identifier: BSD-3-Clause
// properties_plan.c: what must hold of a plan: side, picture, clip, props.
#include "properties.h"

#include "water_mirror.h"
#include "water_plane.h"
#include "water_select.h"

#include <math.h>

typedef struct place // a point on the water, in the eye's picture
{
  quad world[3];
  quad view[3];
  quad clip[4];
  double reach; // the length of the numbers that the mirrored view is summed from
} place;

static double absolute(quad value)
{
  return (double)fabsq(value);
}

static double view_offset(const stress_case* of)
{
  const double* view = of->scene.eye.world_to_view;
  return hypot(hypot(view[3], view[7]), view[11]);
}

static double reach_of(const stress_case* of, const quad point[3])
{
  return (double)quad_length(point) + absolute(of->offset) + view_offset(of);
}

bool stress_is_on_plane(const stress_case* of)
{
  water_plane unit;
  water_eye eye;
  water_side side;
  return water_plane_normalise(&of->scene.plane, &unit) == WATER_OK &&
    water_camera_decompose(&of->scene.eye, &eye) == WATER_OK &&
    water_select_side(&eye, &unit, &side) == WATER_CAMERA_ON_PLANE;
}

void stress_decision(
  const stress_case* of, const water_plan* plan, water_status status, stress_record* record)
{
  const bool is_on_plane = stress_is_on_plane(of);
  stress_keep(record, ACCEPTED, of->far_z / of->near_z, status == WATER_OK ? 0.0 : 1.0, 0.0);
  if (status != WATER_OK)
  {
    return;
  }
  const double height = absolute(of->eye_height);
  if (of->scene.eye.parallel)
  {
    // the sine that counts as edge-on (water_select.c), and the roundings of a rotated unit vector
    const bool is_edge_on = plan->side == WATER_EDGE_ON;
    const bool is_right = is_edge_on
      ? height < 1e-9 + 64.0 * stress_u
      : (plan->side == WATER_ABOVE) == (of->side > 0) && height > 1e-9 - 64.0 * stress_u;
    stress_keep(record, EYE_SIDE, 1.0 / height, is_right && !is_on_plane ? 0.0 : 1.0, 0.0);
    return;
  }
  // 48 u of the offsets may not be told from the plane; twice that must be
  const double bound = 96.0 * stress_u * (absolute(of->offset) + view_offset(of));
  const bool is_right =
    is_on_plane ? height <= bound : (plan->side == WATER_ABOVE) == (of->side > 0);
  stress_keep(
    record, EYE_SIDE, (absolute(of->offset) + view_offset(of)) / height, is_right ? 0.0 : 1.0, 0.0);
}

// Where a line of sight meets the water; false: it does not.
static bool place_roll(stress_case* of, place* made)
{
  const double* to_clip = of->scene.eye.view_to_clip;
  const bool is_parallel = of->scene.eye.parallel;
  quad base[3] = { 0, 0, 0 };
  quad dir[3] = { 0, 0, -1 };
  for (int i = 0; i < 2; ++i)
  {
    const quad ndc = (quad)case_roll(of, -1.0, 1.0);
    const double shift = is_parallel ? -to_clip[4 * i + 3] : to_clip[4 * i + 2];
    (is_parallel ? base : dir)[i] = (ndc + (quad)shift) / (quad)to_clip[5 * i];
  }
  const quad from = quad_dot(of->height_view, base) + of->height_view[3];
  const quad fall = -quad_dot(of->height_view, dir);
  const quad depth = fall == 0 ? -1 : from / fall;
  if (!(depth > 0) || !(depth < (quad)1e30))
  {
    return false;
  }
  const double* view = of->scene.eye.world_to_view;
  quad arm[3];
  for (int i = 0; i < 3; ++i)
  {
    made->view[i] = base[i] + depth * dir[i];
    arm[i] = made->view[i] - (quad)view[4 * i + 3];
  }
  for (int i = 0; i < 3; ++i)
  {
    made->world[i] = quad_dot(of->view_to_world + 3 * i, arm);
  }
  quad_apply(to_clip, 4, made->view, 1, made->clip);
  made->reach = reach_of(of, made->world);
  return true;
}

// Sum over a row of the projection times the sums over rows of the view, all without signs: what a
// product's roundings are shares of.
static double row_size(const water_camera* camera, int row, const quad point[3])
{
  double size = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const double* view = camera->world_to_view + 4 * k;
    const double sum = fabs(view[0]) * absolute(point[0]) + fabs(view[1]) * absolute(point[1]) +
      fabs(view[2]) * absolute(point[2]) + fabs(view[3]);
    size += fabs(camera->view_to_clip[4 * row + k]) * sum;
  }
  return size;
}

// The mirrored view: R's entries are off by 7 u (Frobenius), its translation by 4 u of the plane's
// offset, the product by 12 u, 14 u and 4 u of the three lengths, the unit plane by 12 u: at most
// 32 u of their sum, the reach.
static void check_place(
  const water_plan* plan, const place* at, double condition, stress_record* record)
{
  quad seen[3];
  quad_apply(plan->mirrored.world_to_view, 3, at->world, 1, seen);
  seen[0] = -seen[0];
  quad off[3];
  for (int i = 0; i < 3; ++i)
  {
    off[i] = seen[i] - at->view[i];
  }
  stress_keep(record, OWN_PLACE, condition, (double)quad_length(off) / at->reach, 32.0 * stress_u);
}

void stress_picture(stress_case* of, const water_plan* plan, stress_record* record)
{
  place at;
  if (!place_roll(of, &at))
  {
    return;
  }
  const double depth = of->scene.eye.parallel ? of->size : absolute(at.view[2]);
  const double condition = at.reach / depth;
  check_place(plan, &at, condition, record);

  quad view[3];
  quad clip[4];
  quad texture[4];
  quad_apply(plan->mirrored.world_to_view, 3, at.world, 1, view);
  quad_apply(plan->mirrored.view_to_clip, 4, view, 1, clip);
  double world_to_texture[16];
  water_mirror_texture_matrix(&plan->mirrored, world_to_texture);
  quad_apply(world_to_texture, 4, at.world, 1, texture);
  const double* to_clip = of->scene.eye.view_to_clip;
  // a place that is off by so much, seen by the rows of the projection
  const double off = 32.0 * stress_u * at.reach;
  const double off_w = off * (fabs(to_clip[12]) + fabs(to_clip[13]) + fabs(to_clip[14]));
  const double w = absolute(at.clip[3]);
  if (w < 4.0 * off_w)
  {
    return; // nothing is left of the distance from the eye
  }
  bool is_in_rect = at.clip[2] >= -at.clip[3];
  for (int i = 0; i < 2; ++i)
  {
    const quad ndc = (i == 0 ? -1 : 1) * at.clip[i] / at.clip[3] * (quad)plan->reflection_scale[i];
    const double* row = to_clip + 4 * i;
    // how many halves of the picture, there where the point is, the reach is long
    const double pictures = at.reach *
      (fabs(row[0]) + fabs(row[1]) + fabs(row[2]) + absolute(ndc) * off_w / off) / (w - off_w);
    const double bound = 2.0 * stress_u + 32.0 * stress_u * pictures;
    stress_keep(record, OWN_PIXEL, pictures, absolute(clip[i] / clip[3] - ndc), bound);
    // the matrix: a product of 4 terms, a sum and a half: 6 u of what it is summed from
    const quad share = (1 + ndc) / 2;
    const double size =
      (row_size(&plan->mirrored, i, at.world) + row_size(&plan->mirrored, 3, at.world)) / w;
    stress_keep(record, MAP_PIXEL, pictures, absolute(texture[i] / texture[3] - share),
      0.5 * bound + 8.0 * stress_u * size * (1.0 + absolute(share)));
    const double low = plan->texture_rect_px[i];
    const double px = (double)(share * plan->texture_px[i]);
    is_in_rect = is_in_rect && px >= low && px <= low + plan->texture_rect_px[2 + i];
  }
  for (int i = 0; i < 3; ++i)
  {
    const double* bounds = of->scene.surface_bounds + 2 * i;
    if (at.world[i] < (quad)bounds[0] || at.world[i] > (quad)bounds[1])
    {
      return; // no water there
    }
  }
  if (at.clip[2] >= -at.clip[3])
  {
    stress_keep(record, IN_RECT, condition, is_in_rect ? 0.0 : 1.0, 0.0);
  }
}

// What the roundings of the inverse of a projection are shares of: the equilibrated inverse has
// entries near 1 (water_math.h), so that entry (i, j) of the inverse is off by as many roundings of
// what scales it, 1 / (largest of row j), over the largest of column i after that.
static double inverse_size(const double* p, const double plane[4], const quad clip[4])
{
  double rows[4] = { 0.0, 0.0, 0.0, 0.0 };
  double scaled = 0.0;
  for (int i = 0; i < 16; ++i)
  {
    rows[i / 4] = fmax(rows[i / 4], fabs(p[i]));
  }
  for (int j = 0; j < 4; ++j)
  {
    scaled += absolute(clip[j]) / rows[j];
  }
  double size = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    double column = 0.0;
    for (int j = 0; j < 4; ++j)
    {
      column = fmax(column, fabs(p[4 * j + i]) / rows[j]);
    }
    size += fabs(plane[i]) / column * scaled;
  }
  return size;
}

// A point anywhere in the mirrored picture, on either side of the water.
static void roll_point(stress_case* of, quad point[3])
{
  const double* to_clip = of->scene.eye.view_to_clip;
  const double depth = of->near_z * pow(of->far_z / of->near_z, case_roll(of, 0.0, 1.0));
  quad arm[3] = { 0, 0, (quad)-depth };
  for (int i = 0; i < 3; ++i)
  {
    if (i < 2)
    {
      const quad ndc = (quad)case_roll(of, -1.0, 1.0);
      arm[i] = of->scene.eye.parallel
        ? (ndc - (quad)to_clip[4 * i + 3]) / (quad)to_clip[5 * i]
        : (ndc + (quad)to_clip[4 * i + 2]) / (quad)to_clip[5 * i] * (quad)depth;
    }
    arm[i] -= (quad)of->scene.eye.world_to_view[4 * i + 3];
  }
  quad image[3];
  for (int i = 0; i < 3; ++i)
  {
    image[i] = quad_dot(of->view_to_world + 3 * i, arm);
  }
  const quad twice = 2 * case_height(of, image);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = image[i] - twice * of->normal[i];
  }
}

// The plane's normal goes through the inverse of the view (24 u an entry, 42 u in all) and meets a
// point that the mirrored view put off by 32 u; the offset by 30 u: 128 u of the reach. The inverse
// of the projection adds 64 u of its own size.
void stress_clip(stress_case* of, const water_plan* plan, stress_record* record)
{
  quad point[3];
  roll_point(of, point);
  const quad height = case_height(of, point) * of->side + (quad)of->scene.settings.clip_margin;
  const double reach = reach_of(of, point) + of->scene.settings.clip_margin;
  const double condition = reach / absolute(height);
  quad view[3];
  quad clip[4];
  quad_apply(plan->mirrored.world_to_view, 3, point, 1, view);
  quad_apply(plan->mirrored.view_to_clip, 4, view, 1, clip);
  quad found;
  quad_apply(plan->clip_plane_view, 1, view, 1, &found);
  const double bound = 128.0 * stress_u;
  stress_keep(record, CLIP_HEIGHT, condition, absolute(found - height) / reach, bound);
  found = 0;
  for (int i = 0; i < 4; ++i)
  {
    found += (quad)plan->clip_plane_clip[i] * clip[i];
  }
  const double size = inverse_size(plan->mirrored.view_to_clip, plan->clip_plane_view, clip);
  const double most = bound * reach + 64.0 * stress_u * size;
  stress_keep(record, CLIP_SIDE, most / absolute(height), absolute(found - height) / most, 1.0);
}

// Points of a prop that was left out: none is shown.
static void check_skipped(stress_case* of, const water_prop* prop, stress_record* record)
{
  for (int round = 0; round < 4; ++round)
  {
    double at[3];
    quad point[3];
    for (int i = 0; i < 3; ++i)
    {
      const double low = prop->bounds[2 * i];
      const double high = prop->bounds[2 * i + 1];
      // corners, and points of faces and edges
      at[i] = fmin(fmax(low + (high - low) * case_roll(of, -0.5, 1.5), low), high);
    }
    quad_of(at, 3, point);
    if (case_may_be_shown(of, at) && case_is_shown(of, point))
    {
      stress_keep(record, CULLING, reach_of(of, point) / of->size, 1.0, 0.0);
    }
  }
}

// z' <= w up to the roundings of the product.
static void check_far(
  stress_case* of, const water_plan* plan, const water_prop* prop, stress_record* record)
{
  quad point[3];
  for (int i = 0; i < 3; ++i)
  {
    point[i] = (quad)prop->bounds[2 * i + (case_roll(of, 0.0, 1.0) < 0.5)];
  }
  quad view[3];
  quad clip[4];
  quad_apply(plan->mirrored.world_to_view, 3, point, 1, view);
  quad_apply(plan->mirrored.view_to_clip, 4, view, 1, clip);
  if (clip[3] > 0)
  {
    const double size = row_size(&plan->mirrored, 2, point) + row_size(&plan->mirrored, 3, point);
    const double beyond = (double)((clip[2] - clip[3]) / clip[3]);
    stress_keep(record, FAR_PLANE, of->far_z / of->near_z, fmax(beyond, 0.0),
      64.0 * stress_u * size / (double)clip[3]);
  }
}

void stress_props(
  stress_case* of, const water_plan* plan, const water_cull_reason* reasons, stress_record* record)
{
  for (int number = 0; number < CASE_PROPS; ++number)
  {
    const water_prop* prop = &of->props[number];
    if (number < CASE_SHOWN && of->is_shown[number])
    {
      stress_keep(record, CULLING, reach_of(of, of->shown[number]) / of->size,
        reasons[number] == WATER_CULL_NONE ? 0.0 : 1.0, 0.0);
    }
    if (reasons[number] == WATER_CULL_NONE)
    {
      check_far(of, plan, prop, record);
    }
    else
    {
      check_skipped(of, prop, record);
    }
  }
}
