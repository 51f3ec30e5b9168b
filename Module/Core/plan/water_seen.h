// SPDX-License-Identifier: BSD-3-Clause
// water_seen.h: how much of the picture a water may cover, and which of many waters have a mirrored
// view.
#ifndef water_seen_h
#define water_seen_h

#include "water_types.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The share of the picture that the box of a surface covers, in [0, 1]; 0: it is out of view.
// Objects that hide it are ignored.
//
// plane   of any scale
// bounds  of the surface: xmin, xmax, ymin, ymax, zmin, zmax in world; empty: out of view
double water_seen_share(const water_camera* eye, const water_plane* plane, const double bounds[6]);

// The same of a surface of several parts, each in a box of its own: the sum of their shares, or 1
// if that is less. A box of all of them would be large, however small and far apart the parts are.
// If only that box is in view, between the parts, a plan has a mirrored view for it: its share is
// nearly 0, so that it comes last.
//
// bounds         of the parts in the surface's own coordinates: rows of 6
// mesh_to_world  affine
double water_seen_share_of_parts(const water_camera* eye, const water_plane* plane,
  const double* bounds, size_t count, const double mesh_to_world[16]);

// Marks the waters that have a mirrored view: those that cover the largest parts of the picture,
// the first of equal ones. Waters out of view are marked too, which costs nothing, because nothing
// is drawn for them.
//
// shares  of water_seen_share
// most    of them in view
void water_seen_choose(const double* shares, size_t count, size_t most, bool* has_view);

// How far a water's plane is from an eye, in the scene's unit, >= 0: of two parallel clear waters
// on the same side of the eye, the farther is seen through the nearer and is drawn first. 0 for a
// plane without a normal.
double water_seen_distance(const water_plane* plane, const double eye[3]);

#ifdef __cplusplus
}
#endif
#endif
