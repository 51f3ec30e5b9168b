// SPDX-License-Identifier: BSD-3-Clause
// shader_combinations.h: all sets of features that a surface's shader can be asked for, from all
// looks; with a mesh of the user's, its data, hulls, a peel or a dome of some; with each sky of
// some of those that see one.
#ifndef shader_combinations_h
#define shader_combinations_h

#include "water_features.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>

#define SHADER_ONE_MORE(member, what) +1
enum
{
  SHADER_LOOK_BITS = 1 WATER_FEATURE_LOOK_LIST(SHADER_ONE_MORE), // and the kind of lookup
  SHADER_LOOK_COUNT = 1 << SHADER_LOOK_BITS,
  SHADER_TEXTURE_COUNT = 1 << 4, // what a reflection texture may have
  SHADER_SKY_COUNT = 7, // skies beside the one-coloured one: three, a floor, and they with a floor
  // each as often as it is asked for, and with skies
  SHADER_SET_COUNT = SHADER_LOOK_COUNT * (1 + 20 * SHADER_TEXTURE_COUNT)
};
#undef SHADER_ONE_MORE

static inline water_feature_look shader_look(unsigned number)
{
  unsigned bit = 0;
  water_feature_look look;
  look.lookup = (number >> bit++ & 1u) != 0 ? WATER_LOOKUP_OFFSET : WATER_LOOKUP_RAY_TRACED;
#define SHADER_NEXT_BIT(member, what) look.member = (number >> bit++ & 1u) != 0;
  WATER_FEATURE_LOOK_LIST(SHADER_NEXT_BIT)
#undef SHADER_NEXT_BIT
  return look;
}

// Has a look next to nothing of what it may have, or next to all? Those are enough to see each file
// beside those for a mesh, a peel and a dome, which the others know next to nothing of.
static inline bool shader_has_little_or_much(unsigned number)
{
  unsigned has = 0;
  for (unsigned bit = 0; bit < SHADER_LOOK_BITS; ++bit)
  {
    has += number >> bit & 1u;
  }
  return has <= 2 || has + 2 >= SHADER_LOOK_BITS;
}

static inline water_feature_texture shader_texture(unsigned number)
{
  const water_feature_texture texture = { (number & 1u) != 0, (number & 2u) != 0,
    (number & 4u) != 0, (number & 8u) != 0 };
  return texture;
}

static inline water_feature_set shader_sky(unsigned number)
{
  const water_feature_set kinds[4] = { 0, WATER_FEATURE_SKY_SCREEN, WATER_FEATURE_SKY_MAP,
    WATER_FEATURE_SKY_CUBE };
  const unsigned one = number + 1; // 1 to 7
  return kinds[one & 3u] | ((one & 4u) != 0 ? WATER_FEATURE_SKY_FLOOR : 0);
}

// Looks that see a sky, each with all that the sky's files call or are called by.
static inline size_t shader_add_skies(water_feature_set* sets, size_t count)
{
  const water_feature_set sees =
    WATER_FEATURE_RAY_TRACED | WATER_FEATURE_ENVIRONMENT | WATER_FEATURE_MEDIUM;
  const water_feature_set other = WATER_FEATURE_OUTPUT | WATER_FEATURE_SHADOWS |
    WATER_FEATURE_FOAM | WATER_FEATURE_CAUSTICS | WATER_FEATURE_NORMAL_MAPS | WATER_FEATURE_MESH |
    WATER_FEATURE_SAMPLES | WATER_FEATURE_DISPLACED | WATER_FEATURE_GLITTER |
    WATER_FEATURE_SKY_VIEW;
  const size_t bare = count;
  for (size_t i = 0; i < bare; ++i)
  {
    for (unsigned sky = 0; sky < SHADER_SKY_COUNT && (sets[i] & sees) && !(sets[i] & other); ++sky)
    {
      sets[count++] = sets[i] | shader_sky(sky);
    }
  }
  return count;
}

static inline int shader_compare(const void* a, const void* b)
{
  const water_feature_set* one = (const water_feature_set*)a;
  const water_feature_set* other = (const water_feature_set*)b;
  return *one < *other ? -1 : *one > *other ? 1 : 0;
}

// The distinct ones, those without a sky first; returns how many.
//
// sets  room for SHADER_SET_COUNT
static inline size_t shader_combinations(water_feature_set* sets)
{
  const water_feature_set still = ~(WATER_FEATURE_DISPLACED | WATER_FEATURE_SEA_MOVES);
  size_t count = 0;
  for (unsigned number = 0; number < SHADER_LOOK_COUNT; ++number)
  {
    const water_feature_look look = shader_look(number);
    sets[count++] = water_features_secondary(&look);
    const bool is_any = shader_has_little_or_much(number);
    const unsigned textures = is_any ? SHADER_TEXTURE_COUNT : 2; // without a layer, and with one
    for (unsigned has = 0; has < textures; ++has)
    {
      const water_feature_texture texture = shader_texture(has);
      const water_feature_set asked =
        water_features_with_texture(water_features_of(&look), &texture);
      const water_feature_set hardware = water_features_on_hardware(asked);
      sets[count++] = asked;
      sets[count++] = hardware;
      if (is_any)
      {
        sets[count++] = water_features_with_mesh(asked);
        sets[count++] = water_features_with_mesh(hardware);
        sets[count++] = water_features_with_samples(asked);
        sets[count++] = water_features_with_samples(hardware);
        const water_feature_set sloped = water_features_with_texture(
          water_features_with_slopes(water_features_of(&look), look.lookup), &texture);
        sets[count++] = sloped;
        sets[count++] = water_features_on_hardware(sloped);
        sets[count++] = water_features_with_flow(sloped);
        sets[count++] = water_features_with_buffer(sloped);
        sets[count++] = water_features_with_buffer(water_features_with_mesh(asked));
        sets[count++] = water_features_with_buffer(
          water_features_with_samples(water_features_with_ground(sloped)));
        sets[count++] = water_features_with_flow(water_features_with_mesh(hardware));
        sets[count++] = water_features_with_matter(water_features_with_mesh(asked));
        sets[count++] = water_features_with_matter(water_features_with_samples(hardware));
        sets[count++] = water_features_with_foam_data(water_features_with_mesh(asked));
        sets[count++] = water_features_with_foam_data(water_features_with_matter(sloped));
        sets[count++] = water_features_with_shore(water_features_with_mesh(hardware));
        sets[count++] = water_features_with_hulls(asked);
        sets[count++] = water_features_with_rank_region(hardware);
        sets[count++] = water_features_with_port(hardware);
        sets[count++] = water_features_with_ground(asked);
        sets[count++] = water_features_with_ground(hardware);
        sets[count++] = water_features_with_open(asked);
        sets[count++] = water_features_with_open(hardware);
        sets[count++] = water_features_with_below_layer(water_features_with_samples(asked));
        sets[count++] = water_features_with_below_layer(water_features_with_open(hardware));
      }
      // a mesh whose vertices VTK does not let us move
      sets[count++] = asked & still;
      sets[count++] = hardware & still;
    }
  }
  qsort(sets, count, sizeof sets[0], shader_compare);
  size_t distinct = 0;
  for (size_t i = 0; i < count; ++i)
  {
    if (distinct == 0 || sets[i] != sets[distinct - 1])
    {
      sets[distinct++] = sets[i];
    }
  }
  return shader_add_skies(sets, distinct);
}

#endif
