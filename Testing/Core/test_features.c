// SPDX-License-Identifier: BSD-3-Clause
// test_features.c: what every look needs of a shader, by rules that are written out here once more.
#include "test_features.h"

#include "water_features.h"

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
  { WATER_FEATURE_FLAG(COLUMN), { ALL_SLOPES, ROUGH }, ENVIRONMENT | OFFSET },
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

// Only through clear water are translucent props seen below.
TEST(layer_below_is_of_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(water_features_with_below_layer(features),
      features + (is_clear ? WATER_FEATURE_BELOW_LAYER : 0));
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

// Only through clear water is ground seen, or that there is none.
TEST(ground_is_for_what_is_seen_through)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_clear = (features & WATER_FEATURE_MEDIUM) != 0;
    assert_int_equal(
      water_features_with_ground(features), features + (is_clear ? WATER_FEATURE_GROUND : 0));
    assert_int_equal(
      water_features_with_open(features), features + (is_clear ? WATER_FEATURE_OPEN : 0));
  }
}

// On hardware reads go out together, for what reads, and a pixel has one ray unless there is a
// peel: nothing else changes. All slopes of a pixel are no facets.
TEST(hardware_reads_in_batches)
{
  for (unsigned has = 0; has < LOOKS; ++has)
  {
    const water_feature_set features = expected_of(has);
    const bool is_traced = (has & RAYS) && !(has & (ENVIRONMENT | OFFSET));
    const water_feature_set batched = (is_traced ? WATER_FEATURE_HARDWARE_RAYS : 0) |
      (is_traced && (has & ROUGH) && !(has & ALL_SLOPES) ? WATER_FEATURE_HARDWARE_FACETS : 0) |
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
  assert_true((water_features_with_rank_region(last) & last) != 0);
  assert_true((water_features_with_flow(last) & last) != 0);
  assert_true((water_features_with_matter(last) & last) != 0);
  assert_true((water_features_with_foam_data(last) & last) != 0);
  assert_true((water_features_with_port(last) & last) != 0);
  assert_true((water_features_with_buffer(last) & last) != 0);
  assert_true((water_features_with_ground(last) & last) != 0);
  assert_true((water_features_with_open(last) & last) != 0);
  assert_true((water_features_with_samples(last) & last) != 0);
  assert_true((water_features_with_below_layer(last) & last) != 0);
  assert_true((water_features_on_hardware(last) & last) != 0);
  assert_true((water_sky_features(last, false, false, &sky) & last) != 0);
}

TESTS(features_of_every_look_follow_the_rules, layer_and_peel_are_for_traced_rays_alone,
  mesh_is_drawn_as_it_is_or_displaced, a_current_needs_waves_over_a_mesh,
  matter_is_in_what_is_seen_through, data_of_foam_need_foam, any_mesh_can_be_cut_at_the_shore,
  slopes_of_a_mesh_turn_rays, samples_are_of_what_is_seen_through,
  layer_below_is_of_what_is_seen_through, port_is_for_what_is_seen_through, buffers_are_for_meshes,
  ground_is_for_what_is_seen_through, hardware_reads_in_batches,
  water_in_a_mirrored_view_is_smooth_or_rough, sets_have_room_for_64_features)
