// SPDX-License-Identifier: BSD-3-Clause
// water_horizon.c: the picture cut at the horizon, and led back to the plane.
#include "water_horizon.h"

#include "water_lookup.h"
#include "water_math.h"
#include "water_plane.h"
#include "water_select.h"

// Distance from the end of the sheet to the horizon above it, in NDC: less than 0.02 pixels in a
// picture 16,384 pixels high, and just enough that floats can represent the remaining distance.
static const double horizon_gap = 2e-6;

// Of waves: NDC z for what is before the near plane, and the part of the far plane's distance from
// where on what is beyond it has its place.
static const double near_slice = 1e-3;
static const double far_slice = 0.02;

static const double beside_picture = 1.0 / 128.0; // in NDC: rounding must not uncover its sides

typedef struct outline // convex, in NDC, counter-clockwise
{
  double at[WATER_HORIZON_CORNERS][2];
  int count;
} outline;

static void outline_add(outline* shape, const double point[2])
{
  if (shape->count < WATER_HORIZON_CORNERS)
  {
    memcpy(shape->at[shape->count++], point, sizeof shape->at[0]);
  }
}

static double line_at(const double line[3], const double point[2])
{
  return line[0] * point[0] + line[1] * point[1] + line[2];
}

// Divides an outline at a line into the part on its side >= 0 and the rest. The two share the
// points of the cut to the last bit, so that no crack is between them.
static void outline_divide(
  const outline* shape, const double line[3], outline* inside, outline* outside)
{
  const outline whole = *shape;
  inside->count = 0;
  outside->count = 0;
  for (int i = 0; i < whole.count; ++i)
  {
    const double* here = whole.at[i];
    const double* next = whole.at[(i + 1) % whole.count];
    const double from = line_at(line, here);
    const double to = line_at(line, next);
    outline_add(from >= 0.0 ? inside : outside, here);
    if ((from >= 0.0) != (to >= 0.0))
    {
      const double part = from / (from - to);
      const double cut[2] = { here[0] + part * (next[0] - here[0]),
        here[1] + part * (next[1] - here[1]) };
      outline_add(inside, cut);
      outline_add(outside, cut);
    }
  }
  inside->count = inside->count < 3 ? 0 : inside->count;
  outside->count = outside->count < 3 ? 0 : outside->count;
}

static void outline_cut(outline* shape, const double line[3])
{
  outline left_out;
  outline_divide(shape, line, shape, &left_out);
}

// The picture, a little widened, as far as its view rays come down to the plane.
//
// plane  normalised, normal towards the eye
static outline outline_make(
  const water_eye* eye, const water_plane* plane, double beside, double gap)
{
  const double end = 1.0 + beside;
  outline shape = { { { -end, -end }, { end, -end }, { end, end }, { -end, end } }, 4 };
  if (eye->has_center)
  {
    double x_dir[3];
    double y_dir[3];
    double ray[9];
    water_plane_axes(plane->normal, x_dir, y_dir);
    water_camera_rays(eye, plane, x_dir, y_dir, ray);
    const double down[3] = { -ray[6], -ray[7], -ray[8] - gap * hypot(ray[6], ray[7]) };
    outline_cut(&shape, down);
  }
  return shape;
}

void water_horizon_depths(const double view_to_clip[16], bool is_displaced, double depths[3])
{
  depths[0] = is_displaced ? near_slice : 0.0;
  depths[1] = WATER_HORIZON_DEPTH;
  depths[2] = 0.0;
  // z / w of what is infinitely far away, less 1: 2 near / (far - near)
  const double beyond = -view_to_clip[10] - 1.0;
  const double slice = far_slice * beyond;
  if (is_displaced && view_to_clip[14] != 0.0 && slice > 1.0 - WATER_HORIZON_DEPTH)
  {
    depths[1] = 1.0 - slice;
    depths[2] = (WATER_HORIZON_DEPTH - depths[1]) / (beyond + slice);
  }
}

bool water_horizon_box(
  const water_eye* eye, const water_plane* plane, water_side side, double height, double box[4])
{
  static const double whole[4] = { -1.0, -1.0, 1.0, 1.0 };
  const water_plane facing = water_plane_turned(plane, side);
  double plane_view[4];
  water_camera_plane_view(eye, &facing, plane_view);
  // an eye that is over all waves sees none of them over the horizon
  const bool is_among =
    eye->has_center && water_vec3_dot(plane_view, eye->center_view) + plane_view[3] <= height;
  if (height > 0.0 && (is_among || !eye->has_center))
  {
    memcpy(box, whole, sizeof whole);
    return true;
  }
  const outline shape = outline_make(eye, &facing, 0.0, 0.0);
  for (int i = 0; i < shape.count; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      box[j] = i == 0 ? shape.at[i][j] : fmin(box[j], shape.at[i][j]);
      box[2 + j] = i == 0 ? shape.at[i][j] : fmax(box[2 + j], shape.at[i][j]);
    }
  }
  return shape.count > 0;
}

// What leads from the picture to the plane.
typedef struct way_back
{
  water_axes axes;      // from the foot
  double to_plane[9];   // (x, y, 1) in NDC -> (x, y, w) from the foot; w > 0 where the eye sees it
  double plane_clip[4]; // as in water_plan
  bool is_from_below;
} way_back;

static bool way_back_make(const water_camera* camera, const water_plane* plane, water_eye* eye,
  water_plane* facing, way_back* back)
{
  water_plane unit;
  water_plane level;
  water_side side;
  if (water_plane_normalise(plane, &unit) != WATER_OK ||
    water_camera_decompose(camera, eye) != WATER_OK)
  {
    return false;
  }
  water_select_level(eye, &unit, &level, &side);
  *facing = water_plane_turned(&level, side);
  back->is_from_below = side == WATER_BELOW;
  const double center[4] = { eye->has_center ? eye->center_view[0] : 0.0,
    eye->has_center ? eye->center_view[1] : 0.0, eye->has_center ? eye->center_view[2] : 0.0, 1.0 };
  double foot[4];
  water_mat4_apply(eye->view_to_world, center, foot);
  water_plane_project(facing, foot, foot);
  water_lookup_axes(&level, side, foot, &back->axes);
  double origin_xy[2];
  if (side == WATER_EDGE_ON ||
    water_lookup_places(camera, eye, facing, &back->axes, origin_xy, back->to_plane) != WATER_OK)
  {
    return false;
  }
  double plane_view[4];
  water_camera_plane_view(eye, facing, plane_view);
  water_mat4_apply_row(plane_view, eye->clip_to_view, back->plane_clip);
  return true;
}

static void place_of(const way_back* back, const double ndc[2], double place[3])
{
  for (int i = 0; i < 3; ++i)
  {
    place[i] = line_at(back->to_plane + 3 * i, ndc);
  }
}

static void lead_back(const way_back* back, const outline* shape, int part, water_horizon* horizon)
{
  horizon->counts[part] = shape->count;
  for (int i = 0; i < shape->count; ++i)
  {
    // the picture's turn is the normal's seen from above
    const int to = back->is_from_below ? shape->count - 1 - i : i;
    double place[3];
    place_of(back, shape->at[i], place);
    for (int k = 0; k < 3; ++k)
    {
      horizon->corners[part][to][k] =
        (place[0] * back->axes.x_dir[k] + place[1] * back->axes.y_dir[k]) / place[2];
      horizon->reach[k] = fmax(horizon->reach[k], fabs(horizon->corners[part][to][k]));
    }
  }
}

bool water_horizon_make(const water_camera* camera, const water_plane* plane, const double kept[4],
  water_horizon* horizon)
{
  water_horizon made;
  memset(&made, 0, sizeof made);
  *horizon = made;
  water_eye eye;
  water_plane facing;
  way_back back;
  if (!way_back_make(camera, plane, &eye, &facing, &back))
  {
    return false;
  }
  outline shape = outline_make(&eye, &facing, beside_picture, horizon_gap);
  if (shape.count == 0)
  {
    return false;
  }
  memcpy(made.foot, back.axes.origin, sizeof made.foot);
  double middle[3];
  place_of(&back, shape.at[0], middle);
  for (int i = 0; i < 9 && middle[2] < 0.0; ++i)
  {
    back.to_plane[i] = -back.to_plane[i];
  }
  if (kept)
  {
    double line[3];
    const double along[3] = { water_vec3_dot(kept, back.axes.x_dir),
      water_vec3_dot(kept, back.axes.y_dir), water_vec3_dot(kept, made.foot) + kept[3] };
    for (int j = 0; j < 3; ++j)
    {
      line[j] = along[0] * back.to_plane[j] + along[1] * back.to_plane[3 + j] +
        along[2] * back.to_plane[6 + j];
    }
    outline_cut(&shape, line);
  }
  // NDC z of the plane is -(x, y, 1) . (clip x, y, w of the plane) / (its z)
  const double* clip = back.plane_clip;
  const double ends[2] = { -1.0, WATER_HORIZON_DEPTH };
  for (int part = 0; part < 2; ++part)
  {
    const double beyond[3] = { -clip[0] / clip[2], -clip[1] / clip[2],
      -clip[3] / clip[2] - ends[part] };
    outline before;
    outline_divide(&shape, beyond, &shape, &before);
    lead_back(&back, &before, part, &made);
  }
  lead_back(&back, &shape, WATER_HORIZON_PARTS - 1, &made);
  *horizon = made;
  return made.counts[0] + made.counts[1] + made.counts[2] > 0;
}

// Adds the point of the near plane that covers a place in front of it.
static void add_on_near_plane(
  const water_camera* camera, const water_eye* eye, const double place[3], double bounds[6])
{
  double view[4];
  double clip[4];
  double world[4];
  water_mat4_apply_point(camera->world_to_view, place, view);
  water_mat4_apply(camera->view_to_clip, view, clip);
  const double on_plane[4] = { clip[0] / clip[3], clip[1] / clip[3], -1.0, 1.0 };
  water_mat4_apply(eye->clip_to_view, on_plane, view);
  water_mat4_apply(eye->view_to_world, view, world);
  for (int k = 0; k < 3; ++k)
  {
    world[k] /= world[3];
  }
  water_bounds_add_point(bounds, world);
}

// Adds the corners of what a camera sees between its near and its far plane.
static void add_view(const water_eye* eye, double bounds[6])
{
  static const double whole[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
  for (int i = 0; i < 8; ++i)
  {
    double corner[4] = { 0.0, 0.0, 0.0, 1.0 };
    double view[4];
    double world[4];
    water_bounds_corner(whole, i, corner);
    water_mat4_apply(eye->clip_to_view, corner, view);
    water_mat4_apply(eye->view_to_world, view, world);
    for (int k = 0; k < 3; ++k)
    {
      world[k] /= world[3];
    }
    water_bounds_add_point(bounds, world);
  }
}

bool water_horizon_bounds(const water_camera* camera, const water_plane* plane, double height,
  double reach, double bounds[6])
{
  water_eye eye;
  water_plane unit;
  if (water_plane_normalise(plane, &unit) != WATER_OK ||
    water_camera_decompose(camera, &eye) != WATER_OK)
  {
    return false;
  }
  double made[6];
  water_bounds_begin(made);
  water_horizon horizon;
  bool is_seen = water_horizon_make(camera, plane, NULL, &horizon);
  for (int part = 0; part < WATER_HORIZON_PARTS; ++part)
  {
    for (int i = 0; i < horizon.counts[part]; ++i)
    {
      double corner[3];
      for (int k = 0; k < 3; ++k)
      {
        corner[k] = horizon.foot[k] + horizon.corners[part][i][k];
      }
      water_bounds_add_point(made, corner);
      if (part == 0)
      {
        add_on_near_plane(camera, &eye, corner, made);
      }
    }
  }
  double plane_view[4];
  water_camera_plane_view(&eye, &unit, plane_view);
  if (height > 0.0 &&
    (!eye.has_center ||
      fabs(water_vec3_dot(plane_view, eye.center_view) + plane_view[3]) <= height))
  {
    is_seen = true;
    add_view(&eye, made);
  }
  if (is_seen)
  {
    water_plane_displaced_bounds(&unit, made, height, reach, bounds);
  }
  return is_seen;
}
