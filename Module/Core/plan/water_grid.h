// SPDX-License-Identifier: BSD-3-Clause
// water_grid.h: points at rest over the part of a sheet that the eye sees, for waves that displace
// them: rows across the view, dense near the eye, each from one border of the view to the other.
//
// The part in view is a convex polygon: the sheet cut by the planes of the view, which are moved
// out by as far as waves can move a point. Rows run across the horizontal direction of view. The
// distance between rows grows with the square root of their distance from the eye: the straight
// line between two rows misses a wave by the square of their distance, so that this error is the
// same number of pixels everywhere. A row passes through every corner of the polygon, so that the
// grid covers all of it.
#ifndef water_grid_h
#define water_grid_h

#include "water_lookup.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// The eye and the plane; the shader that displaces points needs it, whether or not a plan was made.
typedef struct water_grid_view
{
  water_axes axes;         // normal: as the user turned it, which is where heights go
  double dir_to_clip[12];  // direction in these axes -> clip of the eye; 4 rows of 3
  double foot_clip[4];     // clip of the point under the eye
  double origin_xy[2];     // of that point, in the plane's own axes
  double clip_to_place[9]; // clip (x, y, w) of a point on the plane -> (x, y, w) from origin_xy on
  double height_clip[4];   // clip of any point -> height over the plane along the normal
  double eye_height;       // the eye's distance from the plane; infinite for a parallel view
  double far_depth;        // NDC z from which on an endless surface is held before the far plane
} water_grid_view;

// plane   of any scale
// origin  of the plane's own axes, in world
//
// Returns WATER_OK, WATER_BAD_PLANE or WATER_BAD_CAMERA (also: the plane is seen edge-on). On an
// error, *view is unchanged. An eye on the plane: water_select_level.
water_status water_grid_view_make(const water_camera* camera, const water_plane* plane,
  const double origin[3], water_grid_view* view);

// Lays size x size cells over the sheet, (size + 1)^2 points, row by row.
//
// sheet    xmin, xmax, ymin, ymax in the plane's own axes; NULL: it has no end. Then near and far
//          planes cut nothing: a row lies where each meets the plane. Beyond where waves are lower
//          than a thousandth of the picture there is one row more, a million times the eye's height
//          away
// height   how far waves move a point along the normal at most, up or down
// reach    and in the plane
// size     >= 16
// points   3 each, in world
// cells    2 each: distances of rows and of a row's points there, in the scene's unit
// row_dir  in the plane's own axes, unit length: from row to row
//
// Returns whether any of the sheet is in view; if not, the outputs are unchanged.
bool water_grid_lay(const water_grid_view* view, const double sheet[4], double height, double reach,
  int size, double* points, float* cells, double row_dir[2]);

// A corner of the smallest box about points that has the point under the eye in its middle.
//
// points  count of them, 3 each, in world
// sign    1: the corner of the greatest coordinates; -1: of the least
void water_grid_balance(
  const water_grid_view* view, const double* points, size_t count, double sign, double corner[3]);

#ifdef __cplusplus
}
#endif
#endif
