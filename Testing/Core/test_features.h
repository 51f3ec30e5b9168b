// SPDX-License-Identifier: BSD-3-Clause
// test_features.h: all looks, for the tests of what they need of a shader.
#ifndef test_features_h
#define test_features_h

#include "test_scene.h"

#include "water_features.h"
#include "water_sky.h"

// What a look may have, a bit each.
enum
{
  SINES = 1 << 0,
  SEA = 1 << 1,
  NORMAL_MAPS = 1 << 2,
  SLOPES = 1 << 3,
  GEOMETRY = 1 << 4,
  ENVIRONMENT = 1 << 5,
  REFRACTION = 1 << 6,
  OPAQUE = 1 << 7,
  CAUSTICS = 1 << 8,
  GLITTER = 1 << 9,
  FOAM = 1 << 10,
  SHADOWS = 1 << 11,
  OUTPUT = 1 << 12,
  OFFSET = 1 << 13, // how it looks up, not ray traced
  WHITECAPS = 1 << 14,
  ALL_SLOPES = 1 << 15,
  LOOKS = 1 << 16,
  MOVERS = SINES | SEA,
  WAVES = SINES | SEA | NORMAL_MAPS,
  ROUGH = WAVES | SLOPES,
  RAYS = ROUGH | OUTPUT
};

#define ONE_MORE(member, what) +1
_Static_assert(LOOKS == 1 << (1 WATER_FEATURE_LOOK_LIST(ONE_MORE)), "a bit for all of a look");

static inline water_feature_look look_of(unsigned has)
{
  water_feature_look look;
  memset(&look, 0, sizeof look);
  look.has_sines = (has & SINES) != 0;
  look.has_sea = (has & SEA) != 0;
  look.has_normal_maps = (has & NORMAL_MAPS) != 0;
  look.has_slope_variance = (has & SLOPES) != 0;
  look.has_wave_geometry = (has & GEOMETRY) != 0;
  look.has_environment = (has & ENVIRONMENT) != 0;
  look.lookup = (has & OFFSET) ? WATER_LOOKUP_OFFSET : WATER_LOOKUP_RAY_TRACED;
  look.has_refraction = (has & REFRACTION) != 0;
  look.is_opaque = (has & OPAQUE) != 0;
  look.has_caustics = (has & CAUSTICS) != 0;
  look.has_glitter = (has & GLITTER) != 0;
  look.has_foam = (has & FOAM) != 0;
  look.has_shadows = (has & SHADOWS) != 0;
  look.has_output = (has & OUTPUT) != 0;
  look.has_whitecaps = (has & WHITECAPS) != 0;
  look.has_all_slopes = (has & ALL_SLOPES) != 0;
  return look;
}

#endif
