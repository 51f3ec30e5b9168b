// SPDX-License-Identifier: BSD-3-Clause
// water_volume_planes.h: in addition to the plan: the position of a volume in the reflection
// texture, for traced rays.
#ifndef water_volume_planes_h
#define water_volume_planes_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_VOLUME_PLANES_COUNT = 7
};

// The half-spaces whose intersection is the part of a box that the reflection texture shows: those
// of the box's six sides, and the kept side of the water. A point of NDC (x, y, z, 1) lies in one
// when its dot product is >= 0.
//
// bounds        of the box, in its own space
// box_to_world  affine, any scale and shear
// sides         largest coefficient 1
//
// Returns WATER_OK, WATER_BAD_PROP_BOUNDS when bounds are not finite or are empty, or
// WATER_BAD_CAMERA when the way from the box to the mirrored camera's clip space has no inverse.
water_status water_volume_planes_make(const water_plan* plan, const double bounds[6],
  const double box_to_world[16], double sides[WATER_VOLUME_PLANES_COUNT][4]);

#ifdef __cplusplus
}
#endif
#endif
