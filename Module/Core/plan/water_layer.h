// SPDX-License-Identifier: BSD-3-Clause
// water_layer.h: beside the plan: where the map shows a volume, for rays that are followed.
#ifndef water_layer_h
#define water_layer_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_LAYER_SIDES = 7
};

// The half-spaces that have all that the map shows of a box in common: its six sides, and the side
// of the water that is kept. A point of NDC (x, y, z, 1) lies in one when its dot product is >= 0.
//
// bounds  in world
// sides   largest coefficient 1
//
// Returns WATER_OK, WATER_BAD_PROP_BOUNDS when bounds are not finite or are empty, or
// WATER_BAD_CAMERA when the mirrored camera has no inverse.
water_status water_layer_sides(
  const water_plan* plan, const double bounds[6], double sides[WATER_LAYER_SIDES][4]);

#ifdef __cplusplus
}
#endif
#endif
