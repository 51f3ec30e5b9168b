// SPDX-License-Identifier: BSD-3-Clause
// test_features.c: what every look needs of a shader, by rules that are written out here once more,
// and that the files for it fit together.
#include "test_scene.h"

#include "water_features.h"
#include "water_sky.h"

#include <inttypes.h>
#include <stdlib.h>

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
  LOOKS = 1 << 15,
  MOVERS = SINES | SEA,
  WAVES = SINES | SEA | NORMAL_MAPS,
  ROUGH = WAVES | SLOPES,
  RAYS = ROUGH | OUTPUT
};

#define ONE_MORE(member, what) +1
_Static_assert(LOOKS == 1 << (1 WATER_FEATURE_LOOK_LIST(ONE_MORE)), "a bit for all of a look");

static water_feature_look look_of(unsigned has)
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
  return look;
}

// A feature is there when the look has any of each of these, and none of those.
static const struct
{
  water_feature_set feature;
  unsigned any_of[4]; // 0: no condition
  unsigned none_of;
} rules[] = {
  { WATER_FEATURE_FLAG(WAVES), { WAVES }, 0 },
  { WATER_FEATURE_FLAG(RAY_TRACED), { RAYS }, ENVIRONMENT | OFFSET },
  { WATER_FEATURE_FLAG(SEVERAL_RAYS), { RAYS }, ENVIRONMENT | OFFSET },
  { WATER_FEATURE_FLAG(OFFSET), { RAYS, OFFSET }, ENVIRONMENT },
  { WATER_FEATURE_FLAG(ENVIRONMENT), { ENVIRONMENT }, 0 },
  { WATER_FEATURE_FLAG(MEDIUM), { REFRACTION, OPAQUE }, 0 },
  { WATER_FEATURE_FLAG(CAUSTICS), { CAUSTICS, REFRACTION, OPAQUE, WAVES }, 0 },
  { WATER_FEATURE_FLAG(GLITTER), { GLITTER, ROUGH }, 0 },
  { WATER_FEATURE_FLAG(SEA), { SEA }, 0 },
  { WATER_FEATURE_FLAG(NORMAL_MAPS), { NORMAL_MAPS }, 0 },
  { WATER_FEATURE_FLAG(ROUGH), { ROUGH }, 0 },
  { WATER_FEATURE_FLAG(DISPLACED), { GEOMETRY, MOVERS }, 0 },
  { WATER_FEATURE_FLAG(SEA_MOVES), { GEOMETRY, SEA }, 0 },
  { WATER_FEATURE_FLAG(WHITECAPS), { WHITECAPS, SEA }, 0 },
  { WATER_FEATURE_FLAG(FOAM), { FOAM | SEA, FOAM | WHITECAPS }, 0 },
  { WATER_FEATURE_FLAG(SHADOWS),
    { SHADOWS, GLITTER | FOAM | SEA, GLITTER | FOAM | WHITECAPS, ROUGH | FOAM }, 0 },
  { WATER_FEATURE_FLAG(OUTPUT), { OUTPUT }, 0 },
};

static water_feature_set expected_of(unsigned has)
{
  water_feature_set features = 0;
  for (size_t i = 0; i < sizeof rules / sizeof rules[0]; ++i)
  {
    bool is_there = (has & rules[i].none_of) == 0;
    for (int j = 0; j < 4; ++j)
    {
      is_there = is_there && (rules[i].any_of[j] == 0 || (has & rules[i].any_of[j]) != 0);
    }
    features |= is_there ? rules[i].feature : 0;
  }
  return features;
}

// Every look has the features that the rules give it, and no others.
TEST(features_of_every_look_follow_the_rules)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    assert_int_equal(water_features_of(&look), expected_of(has));
    assert_int_equal(water_features_is_rough(&look), (has & ROUGH) != 0);
    assert_int_equal(water_features_needs_rays(&look), (has & RAYS) != 0);
    assert_int_equal(water_features_is_displaced(&look), (has & GEOMETRY) && (has & MOVERS));
    assert_int_equal(
      water_features_has_shadows(&look), (expected_of(has) & WATER_FEATURE_SHADOWS) != 0);
    assert_int_equal(
      water_features_is_of_sines(&look), !(has & (OFFSET | SEA | GEOMETRY | NORMAL_MAPS | SLOPES)));
  }
}

// What a reflection texture has beside its colours is for who looks it up, and changes nothing
// else.
TEST(layer_and_peel_are_for_traced_rays_alone)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_traced = (has & RAYS) && !(has & (ENVIRONMENT | OFFSET));
    const bool is_offset = (has & RAYS) && (has & OFFSET) && !(has & ENVIRONMENT);
    const water_feature_texture layer = { .has_layer = true };
    const water_feature_texture peel = { .has_peel = true };
    const water_feature_texture dome = { .is_enclosed = true };
    assert_int_equal(water_features_with_texture(features, &layer),
      features + (is_traced ? WATER_FEATURE_TRANSLUCENT : 0));
    assert_int_equal(water_features_with_texture(features, &peel),
      features + (is_traced ? WATER_FEATURE_PEELED : 0));
    assert_int_equal(water_features_with_texture(features, &dome),
      features + (is_traced || is_offset ? WATER_FEATURE_ENCLOSED : 0));
    const water_feature_texture sky = { .is_enclosed = true, .has_sky_view = true };
    const water_feature_set seen = WATER_FEATURE_ENCLOSED | WATER_FEATURE_SKY_VIEW;
    assert_int_equal(water_features_with_texture(features, &sky),
      features +
        (is_traced      ? seen
            : is_offset ? WATER_FEATURE_ENCLOSED
                        : 0));
  }
}

// A mesh of the user's tells its heights unless waves displace it, and changes nothing else.
TEST(mesh_is_drawn_as_it_is_or_displaced)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_displaced = (has & GEOMETRY) && (has & MOVERS);
    assert_int_equal(
      water_features_with_mesh(features), features + (is_displaced ? 0 : WATER_FEATURE_MESH));
  }
}

// A current carries waves over a mesh: not where there are none, nor where they displace it.
TEST(a_current_needs_waves_over_a_mesh)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    const water_feature_set features = water_features_of(&look);
    const water_feature_set meshed = water_features_with_mesh(features);
    const bool is_carried =
      (features & WATER_FEATURE_WAVES) && !(features & WATER_FEATURE_DISPLACED);
    assert_int_equal(water_features_with_flow(features), features);
    assert_int_equal(
      water_features_with_flow(meshed), meshed | (is_carried ? WATER_FEATURE_FLOW : 0));
  }
}

// Matter takes light from what is seen through the water, whatever draws the surface.
TEST(matter_is_in_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(
      water_features_with_matter(features), features + (is_clear ? WATER_FEATURE_MATTER : 0));
  }
}

// Data say how much foam there is on water that has foam.
TEST(data_of_foam_need_foam)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool has_foam = (features & WATER_FEATURE_FOAM) != 0;
    assert_int_equal(
      water_features_with_foam_data(features), features + (has_foam ? WATER_FEATURE_FOAM_DATA : 0));
  }
}

// Any mesh can be cut at the shore, also one that waves displace: the cut is at its vertices.
TEST(any_mesh_can_be_cut_at_the_shore)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    assert_int_equal(water_features_with_shore(features), features + WATER_FEATURE_SHORE);
  }
}

// The slopes of a mesh turn rays, which are looked up as those of waves; not where waves move it.
TEST(slopes_of_a_mesh_turn_rays)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    const water_feature_set features = expected_of(has);
    const water_feature_set sloped = water_features_with_slopes(features, look.lookup);
    const water_feature_set traced = WATER_FEATURE_RAY_TRACED | WATER_FEATURE_SEVERAL_RAYS;
    const water_feature_set rays = (has & OFFSET) ? WATER_FEATURE_OFFSET : traced;
    const bool is_calm = !(has & (ENVIRONMENT | RAYS));
    const bool is_displaced = (has & GEOMETRY) && (has & MOVERS);
    const water_feature_set added =
      WATER_FEATURE_MESH | WATER_FEATURE_SLOPED | (is_calm ? rays : 0);
    assert_int_equal(sloped, is_displaced ? features : features + added);
    assert_int_equal(water_features_with_slopes(sloped, look.lookup), sloped);
  }
}

// Only what is seen through the surface has samples to look at.
TEST(samples_are_of_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(
      water_features_with_samples(features), features + (is_clear ? WATER_FEATURE_SAMPLES : 0));
  }
}

// Only through clear water is anything seen under a dome port's waterline.
TEST(port_is_for_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(
      water_features_with_port(features), features + (is_clear ? WATER_FEATURE_PORT : 0));
  }
}

// Only a mesh of the user's whose vertices tell their heights can be in a buffer.
TEST(buffers_are_for_meshes)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    const water_feature_set features = expected_of(has);
    const water_feature_set meshed = water_features_with_mesh(features);
    const bool is_mesh = (meshed & WATER_FEATURE_MESH) != 0;
    assert_int_equal(water_features_with_buffer(features), features);
    assert_int_equal(
      water_features_with_buffer(meshed), meshed | (is_mesh ? WATER_FEATURE_BUFFERED : 0));
    assert_int_equal(is_mesh, !water_features_is_displaced(&look));
  }
}

// Only through clear water is ground seen.
TEST(ground_is_for_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(
      water_features_with_ground(features), features + (is_clear ? WATER_FEATURE_GROUND : 0));
  }
}

// On hardware reads go out together, for what reads, and a pixel has one ray unless there is a
// peel: nothing else changes.
TEST(hardware_reads_in_batches)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_traced = (has & RAYS) && !(has & (ENVIRONMENT | OFFSET));
    const water_feature_set batched = (is_traced ? WATER_FEATURE_HARDWARE_RAYS : 0) |
      (is_traced && (has & ROUGH) ? WATER_FEATURE_HARDWARE_FACETS : 0) |
      ((has & REFRACTION) && (has & OPAQUE) ? WATER_FEATURE_HARDWARE_MEDIUM : 0) |
      ((has & WAVES) ? WATER_FEATURE_HARDWARE_TILE : 0);
    const water_feature_set peeled = is_traced ? features | WATER_FEATURE_PEELED : features;
    assert_int_equal(
      water_features_on_hardware(features), (features & ~WATER_FEATURE_SEVERAL_RAYS) | batched);
    assert_int_equal(water_features_on_hardware(peeled),
      is_traced ? peeled | batched : batched | (features & ~WATER_FEATURE_SEVERAL_RAYS));
  }
}

// In the mirrored view of another water a water reflects the background, or the scene, smooth or
// rough.
TEST(water_in_a_mirrored_view_is_smooth_or_rough)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_look look = look_of(has);
    assert_int_equal(water_features_secondary(&look),
      (has & ROUGH) ? WATER_FEATURE_ENVIRONMENT | WATER_FEATURE_ROUGH : WATER_FEATURE_ENVIRONMENT);
    assert_int_equal(water_features_secondary_view(&look),
      (has & ROUGH) ? WATER_FEATURE_RAY_TRACED | WATER_FEATURE_SEVERAL_RAYS | WATER_FEATURE_ROUGH
                    : 0);
  }
}

// A feature beyond the 32nd counts as any other, and is kept by whatever adds to a set.
TEST(sets_have_room_for_64_features)
{
  const water_feature_set last = UINT64_C(1) << 63;
  const water_feature_texture texture = { true, true, true };
  water_sky sky;
  memset(&sky, 0, sizeof sky);
  assert_true(water_features_want(last, last, 0));
  assert_false(water_features_want(last, 0, last));
  assert_false(water_features_want(~last, last, 0));
  assert_true((water_features_with_texture(last, &texture) & last) != 0);
  assert_true((water_features_with_mesh(last) & last) != 0);
  assert_true((water_features_with_slopes(last, WATER_LOOKUP_RAY_TRACED) & last) != 0);
  assert_true((water_features_with_hulls(last) & last) != 0);
  assert_true((water_features_with_flow(last) & last) != 0);
  assert_true((water_features_with_matter(last) & last) != 0);
  assert_true((water_features_with_foam_data(last) & last) != 0);
  assert_true((water_features_with_port(last) & last) != 0);
  assert_true((water_features_with_buffer(last) & last) != 0);
  assert_true((water_features_with_ground(last) & last) != 0);
  assert_true((water_features_with_samples(last) & last) != 0);
  assert_true((water_features_on_hardware(last) & last) != 0);
  assert_true((water_sky_features(last, false, false, &sky) & last) != 0);
}

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
  // over ground, in a buffer, cut at the shore, and under one of 8 kinds of skies
  REACHABLE_MAX = (2 + 17 * 8) * LOOKS
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
      count += 17;
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
    strcmp(slot, "picture") == 0 || strcmp(slot, "ground") == 0 || strcmp(slot, "shafts") == 0 ||
    strcmp(slot, "others") == 0)
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
    return !(features & WATER_FEATURE_MATTER);
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
  if (strcmp(slot, "layer") == 0 || strcmp(slot, "behind") == 0 || strcmp(slot, "end") == 0)
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
  static const char* const surface[] = { "optics", "gradient", "attenuation", "mixture", "slopes",
    "highlights", "cover", "measure", "gain", "cell", "place", "under", "height", "clarity",
    "point", "pixel", "hulls", "sky", "floor", "tile", "slope", "sines", "tiles", "folds", "sea",
    "normal_maps", "flow", "waves", "output", "reflection", "dome", "end", "walk", "behind",
    "layer", "blur", "caustics", "picture", "medium", "shafts", "others", "refraction", "ground",
    "facet_slopes", "facets", "rays", "shadows", "glitter", "whitecaps", "foam_data", "foam", "sun",
    "port", "surface" };
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

TESTS(features_of_every_look_follow_the_rules, layer_and_peel_are_for_traced_rays_alone,
  mesh_is_drawn_as_it_is_or_displaced, a_current_needs_waves_over_a_mesh,
  matter_is_in_what_is_seen_through, data_of_foam_need_foam, any_mesh_can_be_cut_at_the_shore,
  slopes_of_a_mesh_turn_rays, samples_are_of_what_is_seen_through, port_is_for_what_is_seen_through,
  buffers_are_for_meshes, ground_is_for_what_is_seen_through, hardware_reads_in_batches,
  water_in_a_mirrored_view_is_smooth_or_rough, sets_have_room_for_64_features,
  each_slot_has_one_file, slots_stand_in_their_order, every_file_and_feature_is_used,
  vertices_move_where_the_surface_is_displaced)
