// SPDX-License-Identifier: BSD-3-Clause
// shader_combinations.h: all sets of features that a surface's shader can be asked for, from all
// looks.
#ifndef shader_combinations_h
#define shader_combinations_h

#include "water_features.h"

#include <stddef.h>

enum
{
  SHADER_LOOK_COUNT = 1 << 14, // looks: a bit for each of their members
  SHADER_SET_COUNT = 1 << WATER_FEATURE_COUNT
};

static inline water_feature_look shader_look(unsigned number)
{
  unsigned bit = 0;
  water_feature_look look;
#define SHADER_NEXT_BIT ((number >> bit++ & 1u) != 0)
  look.has_sines = SHADER_NEXT_BIT;
  look.has_sea = SHADER_NEXT_BIT;
  look.has_normal_maps = SHADER_NEXT_BIT;
  look.has_slope_variance = SHADER_NEXT_BIT;
  look.has_wave_geometry = SHADER_NEXT_BIT;
  look.has_environment = SHADER_NEXT_BIT;
  look.lookup = SHADER_NEXT_BIT ? WATER_LOOKUP_OFFSET : WATER_LOOKUP_RAY_TRACED;
  look.has_refraction = SHADER_NEXT_BIT;
  look.is_opaque = SHADER_NEXT_BIT;
  look.has_caustics = SHADER_NEXT_BIT;
  look.has_glitter = SHADER_NEXT_BIT;
  look.has_foam = SHADER_NEXT_BIT;
  look.has_shadows = SHADER_NEXT_BIT;
  look.has_output = SHADER_NEXT_BIT;
#undef SHADER_NEXT_BIT
  return look;
}

// The distinct ones in ascending order; returns how many.
//
// sets  room for SHADER_SET_COUNT
static inline size_t shader_combinations(unsigned* sets)
{
  for (size_t i = 0; i < SHADER_SET_COUNT; ++i)
  {
    sets[i] = 0; // first: is it reached?
  }
  for (unsigned number = 0; number < SHADER_LOOK_COUNT; ++number)
  {
    const water_feature_look look = shader_look(number);
    const unsigned asked[3] = { water_features_of(&look),
      water_features_with_layer(water_features_of(&look)), water_features_secondary(&look) };
    for (int i = 0; i < 3; ++i)
    {
      sets[asked[i]] = 1;
      // a mesh whose vertices VTK does not let us move
      sets[asked[i] & ~(unsigned)WATER_FEATURE_DISPLACED] = 1;
    }
  }
  size_t count = 0;
  for (unsigned set = 0; set < SHADER_SET_COUNT; ++set)
  {
    if (sets[set])
    {
      sets[count++] = set;
    }
  }
  return count;
}

#endif
