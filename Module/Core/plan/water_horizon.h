// SPDX-License-Identifier: BSD-3-Clause
// water_horizon.h: the part of an infinite plane that an eye sees, up to the horizon: its area in
// the picture, and a sheet of a few triangles.
//
// The part is a convex polygon: the picture, cut at the horizon. Its corners are found in the
// picture and projected onto the plane, so no corner is behind the eye, and none is farther away
// than necessary. Perspective: the sheet ends under the horizon by a millionth of the picture's
// height, at about a million times the eye's height over the plane. Every plane has a horizon,
// whatever its orientation; a parallel view does not show it.
#ifndef water_horizon_h
#define water_horizon_h

#include "water_camera.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Of the sheet by depth: nearer than the eye's near plane, between the two, beyond the far plane
// (or WATER_HORIZON_DEPTH). A depth that is held there (water_horizon_depths) is the same in all of
// a part.
#define WATER_HORIZON_PARTS 3

// The picture's four corners, and one more for each cut: horizon, kept side, near, far.
#define WATER_HORIZON_CORNERS 8

// The greatest depth of an endless surface, z in NDC: all that is beyond it is drawn there. Nearer
// than 1, the depth of the background, by two steps of a depth buffer of 24 bits: VTK's passes
// leave out what is as deep as the background.
#define WATER_HORIZON_DEPTH (1.0 - 1.0 / 4194304.0)

typedef struct water_horizon
{
  double foot[3]; // the point of the plane under the eye, in world
  // of convex polygons, from the foot on; counter-clockwise as seen from the normal's side
  double corners[WATER_HORIZON_PARTS][WATER_HORIZON_CORNERS][3];
  int counts[WATER_HORIZON_PARTS]; // 0: there is no such part
  double reach[3];                 // of their coordinates, without signs, the greatest
} water_horizon;

// The sheet for an eye; it reaches over the picture's sides by a 128th.
//
// plane  of any scale
// kept   (x, 1) in world -> >= 0 where the sheet is wanted; NULL: everywhere
//
// Returns whether there is any. There is none if the eye does not see the plane (it looks away, or
// along it in parallel), or if plane or camera are not usable; then *horizon has no parts. An eye
// on the plane: water_select_level.
bool water_horizon_make(const water_camera* camera, const water_plane* plane, const double kept[4],
  water_horizon* horizon);

// How depths of an endless surface are held between those of the near and the far plane
// (vtkWaterDepthVS.glsl), which would cut it. With t = z / w of a vertex: t < -1 becomes
// -1 + depths[0] / -t, and t > depths[1] becomes depths[1] + depths[2] (t - depths[1]).
//
// Parts of a displaced surface hide each other and need different depths. What is nearer than the
// near plane gets depths in the first 2,000th of the depth range; what is beyond the far plane gets
// depths in a small range that ends at WATER_HORIZON_DEPTH and begins in front of the far plane, by
// a 50th of the range of z / w from the far plane to infinity. No part of flat water hides another:
// nearer than the near plane it has the near plane's depth, beyond the far plane
// WATER_HORIZON_DEPTH.
void water_horizon_depths(const double view_to_clip[16], bool is_displaced, double depths[3]);

// A box around all that an eye sees of an endless surface, for engines that composite the ranks'
// pictures only where there are props' bounds. Such an engine cuts the box at the near plane, but
// what is nearer is drawn there (water_horizon_depths). The box therefore holds the part of the
// near plane that this covers.
//
// plane   of any scale
// height  how far waves move the surface up or down, >= 0: an eye among them sees it everywhere
// reach   and in the plane
// bounds  xmin, xmax, ymin, ymax, zmin, zmax in world
//
// Returns whether it sees any of it; if not, bounds are unchanged.
bool water_horizon_bounds(const water_camera* camera, const water_plane* plane, double height,
  double reach, double bounds[6]);

// The part of the picture that an endless surface covers.
//
// plane   normalised, as the user turned it
// height  how far waves move the surface up or down, >= 0: to an eye among them it is everywhere
// box     NDC: low x, low y, high x, high y
//
// Returns whether there is any; if not, box is unchanged.
bool water_horizon_box(
  const water_eye* eye, const water_plane* plane, water_side side, double height, double box[4]);

#ifdef __cplusplus
}
#endif
#endif
