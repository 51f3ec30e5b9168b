// SPDX-License-Identifier: BSD-3-Clause
// test_features_files.c: the files of the shaders fit together, for all features that a look may
// need.
#include "test_features.h"

#include "water_features.h"

#include <inttypes.h>
#include <stdlib.h>

typedef struct file
{
  const char* slot;
  const char* name;
  water_feature_set any_of;
  water_feature_set none_of;
} file;

#define FILE_ENTRY(slot, name, any_of, none_of, what) { #slot, #name, any_of, none_of },
static const file surface_files[] = { WATER_SURFACE_FILE_LIST(FILE_ENTRY) };
static const file photon_files[] = { WATER_PHOTON_FILE_LIST(FILE_ENTRY) };
static const file vertex_files[] = { WATER_VERTEX_FILE_LIST(FILE_ENTRY) };
enum
{
  SURFACE_FILES = sizeof surface_files / sizeof surface_files[0],
  PHOTON_FILES = sizeof photon_files / sizeof photon_files[0],
  VERTEX_FILES = sizeof vertex_files / sizeof vertex_files[0],
  // looked up in 8 kinds of reflection textures, on 2 of machines, with a mesh, with one that is
  // not flat, or without, with samples, with hulls, with a current, with matter, with foam of data,
  // over ground or none, with a layer below, in a buffer, cut at the shore, in a rank's part of
  // the space, and under one of 8 kinds of skies
  REACHABLE_MAX = (2 + 20 * 8) * LOOKS
};

// Features with a sky: one colour, a screen, a map or a cube; from 4 on with a floor.
static water_feature_set under_sky(water_feature_set features, unsigned kind)
{
  const water_sky_kind kinds[4] = { WATER_SKY_SCREEN, WATER_SKY_SCREEN, WATER_SKY_MAP,
    WATER_SKY_CUBE };
  water_sky sky;
  memset(&sky, 0, sizeof sky);
  sky.screen = kind % 4 == 1 ? WATER_SCREEN_VERTICAL : WATER_SCREEN_COLOR;
  sky.map.kind = kinds[kind % 4];
  sky.floor.is_there = kind >= 4;
  return water_sky_features(features, false, true, &sky);
}

static int compare_sets(const void* a, const void* b)
{
  const water_feature_set first = *(const water_feature_set*)a;
  const water_feature_set second = *(const water_feature_set*)b;
  return (first > second) - (first < second);
}

// All sets of features that a shader may be asked for, each once. They are found for the first
// test.
static size_t reach_all(const water_feature_set** all)
{
  static water_feature_set features[REACHABLE_MAX];
  static size_t distinct = 0;
  size_t count = 0;
  *all = features;
  if (distinct > 0)
  {
    return distinct;
  }
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    features[count] = water_features_secondary(&look);
    features[count + 1] = water_features_with_mesh(features[count]);
    count += 2;
    for (unsigned kind = 0; kind < 8; ++kind)
    {
      const water_feature_texture texture = { kind & 1, kind >> 1 & 1, kind >> 2 & 1,
        (kind ^ kind >> 1) & 1 };
      features[count] = water_features_with_texture(water_features_of(&look), &texture);
      features[count + 1] = water_features_on_hardware(features[count]);
      features[count + 2] = water_features_with_mesh(features[count]);
      features[count + 3] = water_features_with_mesh(features[count + 1]);
      features[count + 4] = water_features_with_samples(features[count]);
      features[count + 5] = water_features_with_samples(features[count + 1]);
      features[count + 6] = water_features_with_texture(
        water_features_with_slopes(water_features_of(&look), look.lookup), &texture);
      features[count + 7] = water_features_on_hardware(features[count + 6]);
      features[count + 8] = under_sky(features[count + has % 8], kind);
      features[count + 9] = water_features_with_hulls(features[count + has % 8]);
      features[count + 10] = water_features_with_port(features[count + has % 8]);
      features[count + 11] = water_features_with_flow(features[count + has % 8]);
      features[count + 12] = water_features_with_ground(features[count + has % 8]);
      features[count + 13] = water_features_with_buffer(features[count + has % 8]);
      features[count + 14] = water_features_with_matter(features[count + has % 8]);
      features[count + 15] = water_features_with_foam_data(features[count + has % 8]);
      features[count + 16] = water_features_with_shore(features[count + has % 8]);
      features[count + 17] = water_features_with_open(features[count + has % 8]);
      features[count + 18] = water_features_with_below_layer(features[count + has % 8]);
      features[count + 19] = water_features_with_rank_region(features[count + has % 8]);
      count += 20;
    }
  }
  qsort(features, count, sizeof features[0], compare_sets);
  for (size_t i = 0; i < count; ++i)
  {
    if (i == 0 || features[i] != features[distinct - 1])
    {
      features[distinct++] = features[i];
    }
  }
  return distinct;
}

// A slot that stays empty, and when.
static bool is_empty(const char* slot, water_feature_set features)
{
  static const char* const of_waves[6] = { "tile", "slope", "sines", "sea", "normal_maps", "flow" };
  const water_feature_set lookups =
    WATER_FEATURE_ENVIRONMENT | WATER_FEATURE_RAY_TRACED | WATER_FEATURE_OFFSET;
  for (int i = 0; i < 6; ++i)
  {
    if (strcmp(slot, of_waves[i]) == 0)
    {
      return !(features & WATER_FEATURE_WAVES);
    }
  }
  if (strcmp(slot, "walk") == 0)
  {
    return !(features & WATER_FEATURE_RAY_TRACED);
  }
  if (strcmp(slot, "facet_slopes") == 0)
  {
    return !(features & WATER_FEATURE_ROUGH);
  }
  if (strcmp(slot, "attenuation") == 0 || strcmp(slot, "refraction") == 0 ||
    strcmp(slot, "picture") == 0 || strcmp(slot, "haze") == 0 || strcmp(slot, "scattered") == 0 ||
    strcmp(slot, "ground") == 0 || strcmp(slot, "shafts") == 0 || strcmp(slot, "others") == 0 ||
    strcmp(slot, "below") == 0)
  {
    return !(features & WATER_FEATURE_MEDIUM);
  }
  if (strcmp(slot, "cover") == 0)
  {
    return !(features & WATER_FEATURE_FOAM);
  }
  if (strcmp(slot, "foam_data") == 0)
  {
    return !(features & WATER_FEATURE_FOAM);
  }
  if (strcmp(slot, "mixture") == 0)
  {
    return !(features & (WATER_FEATURE_MATTER | WATER_FEATURE_MEDIUM));
  }
  if (strcmp(slot, "measure") == 0)
  {
    return !(features & WATER_FEATURE_FOAM_DATA);
  }
  if (strcmp(slot, "gain") == 0)
  {
    return !(features & WATER_FEATURE_FLOW);
  }
  if (strcmp(slot, "slopes") == 0 || strcmp(slot, "highlights") == 0)
  {
    return !(features & WATER_FEATURE_GLITTER);
  }
  if (strcmp(slot, "cell") == 0)
  {
    return !(features & WATER_FEATURE_DISPLACED);
  }
  if (strcmp(slot, "tiles") == 0)
  {
    return !(features & WATER_FEATURE_SEA);
  }
  if (strcmp(slot, "folds") == 0)
  {
    return !(features & WATER_FEATURE_WAVES);
  }
  if (strcmp(slot, "whitecaps") == 0)
  {
    return !(features & WATER_FEATURE_FOAM);
  }
  if (strcmp(slot, "layer") == 0 || strcmp(slot, "behind") == 0 || strcmp(slot, "edges") == 0 ||
    strcmp(slot, "end") == 0)
  {
    return !(features & lookups);
  }
  // the layer's file blurs, too
  return strcmp(slot, "blur") == 0 &&
    (!(features & lookups) || (features & WATER_FEATURE_TRANSLUCENT));
}

// One file fills each slot of every shader, or none where nothing asks for the slot.
TEST(each_slot_has_one_file)
{
  const water_feature_set* reachable = NULL;
  const size_t count = reach_all(&reachable);
  for (size_t i = 0; i < count; ++i)
  {
    for (int first = 0; first < SURFACE_FILES;)
    {
      const char* slot = surface_files[first].slot;
      int filled = 0;
      int next = first;
      for (; next < SURFACE_FILES && strcmp(surface_files[next].slot, slot) == 0; ++next)
      {
        filled += water_features_want(
          reachable[i], surface_files[next].any_of, surface_files[next].none_of);
      }
      if (filled != !is_empty(slot, reachable[i]))
      {
        print_error("%d files for %s with features 0x%" PRIx64 "\n", filled, slot, reachable[i]);
        fail();
      }
      first = next;
    }
  }
}

static void assert_order(
  const file* files, int file_count, const char* const* slots, int slot_count)
{
  int slot = 0;
  for (int i = 0; i < file_count; ++i)
  {
    slot += i > 0 && strcmp(files[i].slot, files[i - 1].slot) != 0;
    assert_true(slot < slot_count);
    assert_string_equal(files[i].slot, slots[slot]);
    for (int j = 0; j < i; ++j)
    {
      assert_string_not_equal(files[i].name, files[j].name);
    }
  }
  assert_int_equal(slot, slot_count - 1);
}

// GLSL knows only what stands before: no slot is missing, each stands after those it calls, its
// files stand together, and no file stands twice.
TEST(slots_stand_in_their_order)
{
  static const char* const surface[] = { "optics", "gradient", "attenuation", "mixture",
    "scattered", "slopes", "highlights", "cover", "measure", "gain", "cell", "place", "under",
    "height", "clarity", "point", "pixel", "hulls", "region", "sky", "floor", "tile", "slope",
    "sines", "tiles", "folds", "sea", "normal_maps", "flow", "waves", "output", "reflection",
    "dome", "end", "walk", "edges", "behind", "layer", "blur", "caustics", "picture", "haze",
    "medium", "below", "shafts", "others", "refraction", "ground", "facet_slopes", "facets", "rays",
    "shadows", "glitter", "whitecaps", "foam_data", "foam", "sun", "port", "surface" };
  static const char* const vertex[] = { "cell", "tiles", "sea", "displacement", "heights", "slopes",
    "flow", "matter", "foam", "shore", "depth" };
  static const char* const photon[] = { "gradient", "place", "height", "point", "pixel", "tile",
    "sines", "tiles", "folds", "sea", "normal_maps", "flow", "waves", "photon" };
  assert_order(photon_files, PHOTON_FILES, photon, sizeof photon / sizeof photon[0]);
  assert_order(surface_files, SURFACE_FILES, surface, sizeof surface / sizeof surface[0]);
  assert_order(vertex_files, VERTEX_FILES, vertex, sizeof vertex / sizeof vertex[0]);
}

// No file and no feature is there for nothing: some shader has it, and all but the files of every
// shader are missing in another.
TEST(every_file_and_feature_is_used)
{
  const water_feature_set* reachable = NULL;
  const size_t count = reach_all(&reachable);
  water_feature_set used = 0;
  for (size_t i = 0; i < count; ++i)
  {
    used |= reachable[i];
  }
  assert_int_equal(used, (UINT64_C(1) << WATER_FEATURE_COUNT) - 1);
  for (int i = 0; i < SURFACE_FILES; ++i)
  {
    const file* at = &surface_files[i];
    bool is_wanted = false;
    bool is_missing = false;
    for (size_t j = 0; j < count; ++j)
    {
      const bool is_in = water_features_want(reachable[j], at->any_of, at->none_of);
      is_wanted = is_wanted || is_in;
      is_missing = is_missing || !is_in;
    }
    assert_true(is_wanted);
    assert_int_equal(is_missing, at->any_of != 0 || at->none_of != 0);
  }
}

// Vertices are moved by a shader exactly where the surface is displaced, and tell their heights
// exactly where a mesh of the user's is drawn as it is, and data where it has some. All can be kept
// from being cut.
TEST(vertices_move_where_the_surface_is_displaced)
{
  static const struct
  {
    const char* slot;
    water_feature_set feature;
  } still[] = { { "heights", WATER_FEATURE_FLAG(MESH) }, { "slopes", WATER_FEATURE_FLAG(SLOPED) },
    { "flow", WATER_FEATURE_FLAG(FLOW) }, { "matter", WATER_FEATURE_FLAG(MATTER) },
    { "foam", WATER_FEATURE_FLAG(FOAM_DATA) }, { "shore", WATER_FEATURE_FLAG(SHORE) } };
  const water_feature_set* reachable = NULL;
  const size_t count = reach_all(&reachable);
  for (size_t i = 0; i < count; ++i)
  {
    for (int j = 0; j < VERTEX_FILES; ++j)
    {
      const file* at = &vertex_files[j];
      water_feature_set feature = WATER_FEATURE_DISPLACED;
      for (size_t k = 0; k < sizeof still / sizeof still[0]; ++k)
      {
        feature = strcmp(at->slot, still[k].slot) == 0 ? still[k].feature : feature;
      }
      const bool is_for_all = strcmp(at->slot, "depth") == 0;
      const bool has_sea = (reachable[i] & WATER_FEATURE_SEA_MOVES) != 0;
      const bool is_of_sea =
        strcmp(at->slot, "tiles") == 0 || strcmp(at->name, "vtkWaterSeaVS") == 0;
      const bool is_else = strcmp(at->name, "vtkWaterNoSeaVS") == 0;
      assert_int_equal(water_features_want(reachable[i], at->any_of, at->none_of),
        is_for_all ||
          ((reachable[i] & feature) != 0 && (!is_of_sea || has_sea) && (!is_else || !has_sea)));
    }
  }
}

TESTS(each_slot_has_one_file, slots_stand_in_their_order, every_file_and_feature_is_used,
  vertices_move_where_the_surface_is_displaced)
