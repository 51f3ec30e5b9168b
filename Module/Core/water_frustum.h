// SPDX-License-Identifier: BSD-3-Clause
// water_frustum.h: boxes against half-spaces and frusta; conservative: rounding may keep a box, but
// never lose it.
#ifndef water_frustum_h
#define water_frustum_h

#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Half-spaces of a frustum, dot(plane, (x, 1)) >= 0 inside: left, right, bottom, top, near, far.
typedef struct water_frustum
{
  double planes[6][4];
  double reach; // the length of the numbers that were summed and cancelled to the planes' offsets
} water_frustum;

// The part of a camera's frustum, in world, behind a part of its picture.
//
// box  NDC: low x, low y, high x, high y
void water_frustum_make(const water_camera* camera, const double box[4], water_frustum* made);

// Whether a box lies wholly on the negative side of a plane, and by more than rounding. A sum that
// overflows is not below anything.
//
// reach     of the frustum, or 0
// rounding  of the arithmetic, relative to the numbers summed
bool water_frustum_is_behind(
  const double plane[4], const double bounds[6], double reach, double rounding);

// Whether any point of a box may lie within the first plane_count planes: 6, or 5 without the far
// one.
bool water_frustum_meets(
  const water_frustum* frustum, int plane_count, const double bounds[6], double rounding);

#ifdef __cplusplus
}
#endif
#endif
