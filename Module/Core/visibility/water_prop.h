// SPDX-License-Identifier: BSD-3-Clause
// water_prop.h: questions about one prop that are asked of every prop; private to the core.
#ifndef water_prop_h
#define water_prop_h

#include "water_math.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Is a prop drawn wherever it may be: it fills the view, or its bounds are not finite?
static inline bool water_prop_is_unbounded(const water_prop* prop)
{
  return (prop->flags & WATER_PROP_NO_BOUNDS) || !water_bounds_are_finite(prop->bounds);
}

#ifdef __cplusplus
}
#endif
#endif
