// SPDX-License-Identifier: BSD-3-Clause
// water_frustum.h: boxes against half-spaces and frusta; conservative: rounding may keep a box, but
// never lose it.
#ifndef water_frustum_h
#define water_frustum_h

#include "water_types.h"

#include <math.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Half-spaces of a frustum, dot(plane, (x, 1)) >= 0 inside: left, right, bottom, top, near, far.
typedef struct water_frustum
{
  double planes[6][4];
  double reach; // the length of the numbers that were summed and cancelled to the planes' offsets
  int corners[6][3]; // of a box, as indices of its bounds: the furthest on a plane's positive side
} water_frustum;

// Finds the corners for the planes.
void water_frustum_prepare(water_frustum* frustum);

// The part of a camera's frustum, in world, behind a part of its picture.
//
// box  NDC: low x, low y, high x, high y
void water_frustum_make(const water_camera* camera, const double box[4], water_frustum* made);

// Whether a box lies wholly on the negative side of a plane, and by more than rounding. A sum that
// overflows does not count as below.
//
// reach     of the frustum, or 0
// rounding  of the arithmetic, relative to the numbers summed
static inline bool water_frustum_is_behind(
  const double plane[4], const double bounds[6], double reach, double rounding)
{
  // the corner that lies furthest on the positive side: every product is the largest there
  double highest = plane[3];
  for (int i = 0; i < 3; ++i)
  {
    highest += plane[i] * bounds[2 * i + (plane[i] > 0.0)];
  }
  if (!(highest < 0.0))
  {
    return false; // most boxes: no need to know how far it may be off
  }
  double size = fabs(plane[3]);
  for (int i = 0; i < 3; ++i)
  {
    const double low = fabs(bounds[2 * i]);
    const double high = fabs(bounds[2 * i + 1]);
    size += fabs(plane[i]) * (low > high ? low : high) + fabs(plane[i]) * reach;
  }
  return highest < -rounding * size;
}

// The first of plane_count planes (6, or 5 without the far one) that has a box wholly behind it;
// -1: there is none, and any point of the box may lie within.
static inline int water_frustum_divides(
  const water_frustum* frustum, int plane_count, const double bounds[6], double rounding)
{
  for (int i = 0; i < plane_count; ++i)
  {
    const double* plane = frustum->planes[i];
    const int* corner = frustum->corners[i];
    const double highest = plane[3] + plane[0] * bounds[corner[0]] + plane[1] * bounds[corner[1]] +
      plane[2] * bounds[corner[2]];
    if (highest < 0.0 && water_frustum_is_behind(plane, bounds, frustum->reach, rounding))
    {
      return i;
    }
  }
  return -1;
}

static inline bool water_frustum_meets(
  const water_frustum* frustum, int plane_count, const double bounds[6], double rounding)
{
  return water_frustum_divides(frustum, plane_count, bounds, rounding) < 0;
}

// Whether a box lies entirely in front of all planes, except for rounding.
static inline bool water_frustum_holds(const water_frustum* frustum, const double bounds[6])
{
  for (int i = 0; i < 6; ++i)
  {
    const double* plane = frustum->planes[i];
    const int* corner = frustum->corners[i]; // of the opposite one: xmin is 0, xmax 1, ymin 2...
    const double lowest = plane[3] + plane[0] * bounds[corner[0] ^ 1] +
      plane[1] * bounds[corner[1] ^ 1] + plane[2] * bounds[corner[2] ^ 1];
    if (!(lowest >= 0.0))
    {
      return false;
    }
  }
  return true;
}

#ifdef __cplusplus
}
#endif
#endif
