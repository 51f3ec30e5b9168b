// SPDX-License-Identifier: BSD-3-Clause
// water_grid.c: points at rest over the part of a sheet that the eye sees.
#include "water_grid.h"

#include "water_horizon.h"
#include "water_math.h"
#include "water_plane.h"
#include "water_select.h"

// Corners of the part in view: four, and each of the six planes can add one. Rows through them, and
// of an endless sheet through three more places.
enum
{
  WATER_GRID_CORNERS = 10,
  WATER_GRID_ROWS = WATER_GRID_CORNERS + 3
};

// How far an endless sheet reaches: times the eye's height, or the width of a parallel view.
static const double endless_reach = 1e6;

static const double lowest_wave = 1e-3; // that is seen, over half of the picture

typedef struct polygon // convex; from the point under the eye on
{
  double at[WATER_GRID_CORNERS][2];
  int count;
} polygon;

water_status water_grid_view_make(const water_camera* camera, const water_plane* plane,
  const double origin[3], water_grid_view* view)
{
  water_grid_view made;
  water_plane unit;
  water_eye eye;
  water_status status = water_plane_normalise(plane, &unit);
  if (status == WATER_OK)
  {
    status = water_camera_decompose(camera, &eye);
  }
  if (status != WATER_OK)
  {
    return status;
  }
  const water_plane given = unit;
  water_side side;
  water_select_level(&eye, &given, &unit, &side);
  water_plane_axes(unit.normal, made.axes.x_dir, made.axes.y_dir);
  memcpy(made.axes.normal, unit.normal, sizeof made.axes.normal);
  memcpy(made.axes.origin, origin, sizeof made.axes.origin);
  if (side == WATER_EDGE_ON)
  {
    return WATER_BAD_CAMERA;
  }
  status = water_lookup_places(camera, &eye, &unit, &made.axes, made.origin_xy, made.clip_to_place);
  if (status != WATER_OK)
  {
    return status;
  }
  water_lookup_dirs(camera, &made.axes, made.dir_to_clip);
  double foot[3];
  for (int i = 0; i < 3; ++i)
  {
    foot[i] =
      origin[i] + made.origin_xy[0] * made.axes.x_dir[i] + made.origin_xy[1] * made.axes.y_dir[i];
  }
  water_mat4_apply_point(camera->world_to_view, foot, made.foot_clip);
  water_mat4_apply(camera->view_to_clip, made.foot_clip, made.foot_clip);
  double plane_view[4];
  water_camera_plane_view(&eye, &unit, plane_view);
  water_mat4_apply_row(plane_view, eye.clip_to_view, made.height_clip);
  double depths[3];
  water_horizon_depths(camera->view_to_clip, true, depths);
  made.far_depth = depths[1];
  made.eye_height = eye.has_center
    ? fabs(water_vec3_dot(plane_view, eye.center_view) + plane_view[3])
    : (double)INFINITY;
  *view = made;
  return WATER_OK;
}

// Keeps what lies on the side line >= 0 (Sutherland and Hodgman 1974, "Reentrant Polygon
// Clipping").
static void polygon_cut(polygon* shape, const double line[3])
{
  polygon kept;
  kept.count = 0;
  for (int i = 0; i < shape->count; ++i)
  {
    const double* here = shape->at[i];
    const double* next = shape->at[(i + 1) % shape->count];
    const double in = line[0] * here[0] + line[1] * here[1] + line[2];
    const double out = line[0] * next[0] + line[1] * next[1] + line[2];
    if (in >= 0.0 && kept.count < WATER_GRID_CORNERS)
    {
      memcpy(kept.at[kept.count++], here, sizeof kept.at[0]);
    }
    if ((in >= 0.0) != (out >= 0.0) && kept.count < WATER_GRID_CORNERS)
    {
      const double part = in / (in - out);
      for (int j = 0; j < 2; ++j)
      {
        kept.at[kept.count][j] = here[j] + part * (next[j] - here[j]);
      }
      ++kept.count;
    }
  }
  *shape = kept;
}

// Half of the side of the square around the point under the eye that represents an endless sheet.
static double endless_side(const water_grid_view* view, double height, double reach)
{
  double wide = view->eye_height;
  if (isinf(view->eye_height))
  {
    // to the middle of its picture, and from there to a corner at most; w is the same everywhere
    const double* place = view->clip_to_place;
    const double across = hypot(place[0], place[3]) + hypot(place[1], place[4]);
    wide = (hypot(place[2], place[5]) + across) / fabs(place[8]);
  }
  return endless_reach * fmax(fmax(wide, height), reach);
}

static polygon part_in_view(
  const water_grid_view* view, const double sheet[4], double height, double reach)
{
  const double* origin = view->origin_xy;
  const double side = sheet ? 0.0 : endless_side(view, height, reach);
  const double x[2] = { sheet ? sheet[0] - origin[0] : -side, sheet ? sheet[1] - origin[0] : side };
  const double y[2] = { sheet ? sheet[2] - origin[1] : -side, sheet ? sheet[3] - origin[1] : side };
  polygon shape = { { { x[0], y[0] }, { x[1], y[0] }, { x[1], y[1] }, { x[0], y[1] } }, 4 };
  const double* w = view->dir_to_clip + 9;
  for (int axis = 0; axis < (sheet ? 3 : 2); ++axis)
  {
    const double* row = view->dir_to_clip + 3 * axis;
    for (double sign = -1.0; sign <= 1.0; sign += 2.0)
    {
      double line[3] = { w[0] + sign * row[0], w[1] + sign * row[1],
        view->foot_clip[3] + sign * view->foot_clip[axis] };
      line[2] += height * fabs(w[2] + sign * row[2]) + reach * hypot(line[0], line[1]);
      polygon_cut(&shape, line);
    }
  }
  return shape;
}

// The direction in the plane in which w grows, away from the eye. Straight down, or in a parallel
// view, there is no such direction, and the rows are those of the picture.
static void away(const water_grid_view* view, double dir[2])
{
  const int rows[3] = { 3, 1, 0 };
  dir[0] = 1.0;
  dir[1] = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double* row = view->dir_to_clip + 3 * rows[i];
    const double along = hypot(row[0], row[1]);
    if (along > 1e-3 * water_vec3_length(row))
    {
      dir[0] = row[0] / along;
      dir[1] = row[1] / along;
      return;
    }
  }
}

// A measure of ways in which rows are even: its slope is (eye_height + |way|)^(-1/2).
static double evened(double way, double eye_height)
{
  if (isinf(eye_height))
  {
    return way;
  }
  return copysign(2.0 * fabs(way) / (sqrt(eye_height + fabs(way)) + sqrt(eye_height)), way);
}

static double evened_inverse(double measure, double eye_height)
{
  if (isinf(eye_height))
  {
    return measure;
  }
  const double half = 0.5 * fabs(measure);
  return copysign(half * (half + 2.0 * sqrt(eye_height)), measure);
}

// Where a row cuts the polygon, across the view.
static void slice(const polygon* shape, const double dir[2], double way, double range[2])
{
  range[0] = DBL_MAX;
  range[1] = -DBL_MAX;
  for (int i = 0; i < shape->count; ++i)
  {
    const double* here = shape->at[i];
    const double* next = shape->at[(i + 1) % shape->count];
    const double from = dir[0] * here[0] + dir[1] * here[1] - way;
    const double to = dir[0] * next[0] + dir[1] * next[1] - way;
    const double side = dir[0] * here[1] - dir[1] * here[0];
    if (from == 0.0)
    {
      range[0] = fmin(range[0], side);
      range[1] = fmax(range[1], side);
    }
    if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0))
    {
      const double other = dir[0] * next[1] - dir[1] * next[0];
      const double cut = side + from / (from - to) * (other - side);
      range[0] = fmin(range[0], cut);
      range[1] = fmax(range[1], cut);
    }
  }
}

typedef struct row_places // of even rows, and of those through the corners among them
{
  double first; // evened
  double step;
  double eye_height;
  int even_count;
  double corners[WATER_GRID_ROWS]; // ascending
  int corner_count;
} row_places;

static void rows_add(row_places* rows, double way)
{
  int place = rows->corner_count++;
  for (; place > 0 && rows->corners[place - 1] > way; --place)
  {
    rows->corners[place] = rows->corners[place - 1];
  }
  rows->corners[place] = way;
}

// Rows of an endless sheet beside those through the corners: where the near and the far plane meet
// it, and where waves become too low to be visible; rows are even up to there.
//
// Returns the last.
static double rows_add_endless(
  const water_grid_view* view, const double dir[2], double height, row_places* rows)
{
  const double first = rows->corners[0];
  const double last = rows->corners[rows->corner_count - 1];
  const double* to_clip = view->dir_to_clip;
  const double ends[2] = { -1.0, view->far_depth };
  for (int i = 0; i < 2; ++i)
  {
    const double end = ends[i];
    // z = end w on the way from under the eye, straight away from it
    const double slope =
      dir[0] * (to_clip[6] - end * to_clip[9]) + dir[1] * (to_clip[7] - end * to_clip[10]);
    const double way = -(view->foot_clip[2] - end * view->foot_clip[3]) / slope;
    if (way > first && way < last)
    {
      rows_add(rows, way);
    }
  }
  const double tallest = height * hypot(to_clip[2], to_clip[5]) / lowest_wave;
  const double grown = dir[0] * to_clip[9] + dir[1] * to_clip[10];
  const double even_last = grown > 0.0 ? (tallest - view->foot_clip[3]) / grown : last;
  if (isinf(view->eye_height) || !(even_last < last))
  {
    return last;
  }
  const double nearest = fmax(first, 0.0) + view->eye_height; // some of it is always even
  rows_add(rows, fmin(fmax(even_last, nearest), last));
  return fmin(fmax(even_last, nearest), last);
}

static row_places rows_of(const water_grid_view* view, const polygon* shape, const double dir[2],
  double height, bool is_endless, int row_count)
{
  row_places rows;
  // an eye among the waves is near those that it sees, too
  rows.eye_height = fmax(view->eye_height, height);
  rows.corner_count = 0;
  for (int i = 0; i < shape->count; ++i)
  {
    rows_add(&rows, dir[0] * shape->at[i][0] + dir[1] * shape->at[i][1]);
  }
  const double even_last =
    is_endless ? rows_add_endless(view, dir, height, &rows) : rows.corners[rows.corner_count - 1];
  // between the corners; the nearest and the farthest are the first row and the last
  rows.even_count = row_count - rows.corner_count;
  rows.first = evened(rows.corners[0], rows.eye_height);
  rows.step = (evened(even_last, rows.eye_height) - rows.first) / (rows.even_count + 1);
  return rows;
}

// The next row, ascending: the nearer of the next corner and the next even row.
static double row_next(const row_places* rows, int* corner, int* even)
{
  const double way = *even < rows->even_count
    ? evened_inverse(rows->first + rows->step * (*even + 1), rows->eye_height)
    : DBL_MAX;
  if (*corner < rows->corner_count && (rows->corners[*corner] <= way || *even >= rows->even_count))
  {
    return rows->corners[(*corner)++];
  }
  ++*even;
  // rounding must not lead it past the corners
  return fmax(fmin(way, rows->corners[rows->corner_count - 1]), rows->corners[0]);
}

bool water_grid_lay(const water_grid_view* view, const double sheet[4], double height, double reach,
  int size, double* points, float* cells, double row_dir[2])
{
  const polygon shape = part_in_view(view, sheet, height, reach);
  if (shape.count < 3)
  {
    return false;
  }
  const water_axes* axes = &view->axes;
  double dir[2];
  away(view, dir);
  const row_places rows = rows_of(view, &shape, dir, height, !sheet, size + 1);
  int corner = 0;
  int even = 0;
  for (int i = 0; i <= size; ++i)
  {
    double range[2];
    const double way = row_next(&rows, &corner, &even);
    slice(&shape, dir, way, range);
    const double apart =
      rows.step * (isinf(rows.eye_height) ? 1.0 : sqrt(rows.eye_height + fabs(way)));
    for (int j = 0; j <= size; ++j)
    {
      const double side = range[0] + (range[1] - range[0]) * j / size;
      const double x = view->origin_xy[0] + way * dir[0] - side * dir[1];
      const double y = view->origin_xy[1] + way * dir[1] + side * dir[0];
      for (int k = 0; k < 3; ++k)
      {
        points[k] = axes->origin[k] + x * axes->x_dir[k] + y * axes->y_dir[k];
      }
      points += 3;
      cells[0] = (float)apart;
      cells[1] = (float)((range[1] - range[0]) / size);
      cells += 2;
    }
  }
  memcpy(row_dir, dir, sizeof dir);
  return true;
}

void water_grid_balance(
  const water_grid_view* view, const double* points, size_t count, double sign, double corner[3])
{
  const water_axes* axes = &view->axes;
  for (int k = 0; k < 3; ++k)
  {
    const double foot =
      axes->origin[k] + view->origin_xy[0] * axes->x_dir[k] + view->origin_xy[1] * axes->y_dir[k];
    double reach = 0.0;
    for (size_t i = 0; i < count; ++i)
    {
      reach = fmax(reach, fabs(points[3 * i + (size_t)k] - foot));
    }
    corner[k] = foot + sign * reach;
  }
}
