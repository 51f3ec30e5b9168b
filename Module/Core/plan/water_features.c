// SPDX-License-Identifier: BSD-3-Clause
// water_features.c: what a water's shader must do.
#include "water_features.h"

static bool has_waves(const water_feature_look* look)
{
  return look->has_sines || look->has_sea || look->has_normal_maps;
}

bool water_features_is_rough(const water_feature_look* look)
{
  return has_waves(look) || look->has_slope_variance;
}

bool water_features_needs_rays(const water_feature_look* look)
{
  return water_features_is_rough(look) || look->has_output;
}

bool water_features_is_displaced(const water_feature_look* look)
{
  return look->has_wave_geometry && (look->has_sines || look->has_sea);
}

static bool has_whitecaps(const water_feature_look* look)
{
  return look->has_sea && look->has_whitecaps;
}

static bool has_foam(const water_feature_look* look)
{
  return look->has_foam || has_whitecaps(look);
}

static bool is_sunlit(const water_feature_look* look)
{
  return (look->has_glitter && water_features_is_rough(look)) || has_foam(look);
}

bool water_features_has_shadows(const water_feature_look* look)
{
  return look->has_shadows && is_sunlit(look);
}

bool water_features_is_of_sines(const water_feature_look* look)
{
  return look->lookup == WATER_LOOKUP_RAY_TRACED && !look->has_sea && !look->has_wave_geometry &&
    !look->has_normal_maps && !look->has_slope_variance;
}

static water_feature_set reflection_of(const water_feature_look* look)
{
  if (look->has_environment)
  {
    return WATER_FEATURE_ENVIRONMENT;
  }
  if (!water_features_needs_rays(look))
  {
    return 0;
  }
  return look->lookup == WATER_LOOKUP_RAY_TRACED
    ? WATER_FEATURE_RAY_TRACED | WATER_FEATURE_SEVERAL_RAYS
    : WATER_FEATURE_OFFSET;
}

static water_feature_set if_has(bool has, water_feature_set feature)
{
  return has ? feature : 0;
}

water_feature_set water_features_of(const water_feature_look* look)
{
  const bool is_rough = water_features_is_rough(look);
  const bool is_clear = look->has_refraction && look->is_opaque;
  const water_feature_set reflection = reflection_of(look);
  const bool is_traced = (reflection & WATER_FEATURE_RAY_TRACED) != 0;
  return reflection | if_has(has_waves(look), WATER_FEATURE_WAVES) |
    if_has(look->has_sea, WATER_FEATURE_SEA) |
    if_has(look->has_normal_maps, WATER_FEATURE_NORMAL_MAPS) |
    if_has(is_rough, WATER_FEATURE_ROUGH) |
    if_has(is_traced && is_rough && look->has_all_slopes, WATER_FEATURE_COLUMN) |
    if_has(water_features_is_displaced(look), WATER_FEATURE_DISPLACED) |
    if_has(look->has_sea && look->has_wave_geometry, WATER_FEATURE_SEA_MOVES) |
    if_has(has_whitecaps(look), WATER_FEATURE_WHITECAPS) | if_has(is_clear, WATER_FEATURE_MEDIUM) |
    if_has(is_clear && has_waves(look) && look->has_caustics, WATER_FEATURE_CAUSTICS) |
    if_has(look->has_glitter && is_rough, WATER_FEATURE_GLITTER) |
    if_has(has_foam(look), WATER_FEATURE_FOAM) |
    if_has(water_features_has_shadows(look), WATER_FEATURE_SHADOWS) |
    if_has(look->has_output, WATER_FEATURE_OUTPUT);
}

water_feature_set water_features_with_texture(
  water_feature_set features, const water_feature_texture* texture)
{
  const bool is_traced = (features & WATER_FEATURE_RAY_TRACED) != 0;
  const bool is_looked_up = (features & (WATER_FEATURE_RAY_TRACED | WATER_FEATURE_OFFSET)) != 0;
  return features | if_has(is_traced && texture->has_layer, WATER_FEATURE_TRANSLUCENT) |
    if_has(is_traced && texture->has_peel, WATER_FEATURE_PEELED) |
    if_has(is_looked_up && texture->is_enclosed, WATER_FEATURE_ENCLOSED) |
    if_has(is_traced && texture->is_enclosed && texture->has_sky_view, WATER_FEATURE_SKY_VIEW);
}

water_feature_set water_features_with_mesh(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_DISPLACED) == 0, WATER_FEATURE_MESH);
}

water_feature_set water_features_with_slopes(water_feature_set features, water_lookup_kind lookup)
{
  const water_feature_set looked_up =
    WATER_FEATURE_ENVIRONMENT | WATER_FEATURE_RAY_TRACED | WATER_FEATURE_OFFSET;
  const water_feature_set rays = lookup == WATER_LOOKUP_RAY_TRACED
    ? WATER_FEATURE_RAY_TRACED | WATER_FEATURE_SEVERAL_RAYS
    : WATER_FEATURE_OFFSET;
  if ((features & WATER_FEATURE_DISPLACED) != 0)
  {
    return features;
  }
  return features | WATER_FEATURE_MESH | WATER_FEATURE_SLOPED |
    if_has((features & looked_up) == 0, rays);
}

water_feature_set water_features_with_flow(water_feature_set features)
{
  const bool has_both =
    (features & WATER_FEATURE_MESH) != 0 && (features & WATER_FEATURE_WAVES) != 0;
  return features | if_has(has_both, WATER_FEATURE_FLOW);
}

water_feature_set water_features_with_matter(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_MATTER);
}

water_feature_set water_features_with_foam_data(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_FOAM) != 0, WATER_FEATURE_FOAM_DATA);
}

water_feature_set water_features_with_shore(water_feature_set features)
{
  return features | WATER_FEATURE_SHORE;
}

water_feature_set water_features_with_hulls(water_feature_set features)
{
  return features | WATER_FEATURE_HULLS;
}

water_feature_set water_features_with_rank_region(water_feature_set features)
{
  return features | WATER_FEATURE_RANK_REGION;
}

water_feature_set water_features_with_buffer(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MESH) != 0, WATER_FEATURE_BUFFERED);
}

water_feature_set water_features_with_port(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_PORT);
}

water_feature_set water_features_with_ground(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_GROUND);
}

water_feature_set water_features_with_open(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_OPEN);
}

water_feature_set water_features_with_samples(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_SAMPLES);
}

water_feature_set water_features_with_below_layer(water_feature_set features)
{
  return features | if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_BELOW_LAYER);
}

water_feature_set water_features_on_hardware(water_feature_set features)
{
  const bool is_traced = (features & WATER_FEATURE_RAY_TRACED) != 0;
  const bool is_peeled = (features & WATER_FEATURE_PEELED) != 0;
  const bool is_faceted =
    (features & WATER_FEATURE_ROUGH) != 0 && (features & WATER_FEATURE_COLUMN) == 0;
  const water_feature_set kept = is_peeled ? features : features & ~WATER_FEATURE_SEVERAL_RAYS;
  return kept | if_has(is_traced, WATER_FEATURE_HARDWARE_RAYS) |
    if_has(is_traced && is_faceted, WATER_FEATURE_HARDWARE_FACETS) |
    if_has((features & WATER_FEATURE_MEDIUM) != 0, WATER_FEATURE_HARDWARE_MEDIUM) |
    if_has((features & WATER_FEATURE_WAVES) != 0, WATER_FEATURE_HARDWARE_TILE);
}

water_feature_set water_features_secondary(const water_feature_look* look)
{
  return WATER_FEATURE_ENVIRONMENT | if_has(water_features_is_rough(look), WATER_FEATURE_ROUGH);
}

water_feature_set water_features_secondary_view(const water_feature_look* look)
{
  return if_has(water_features_is_rough(look),
    WATER_FEATURE_RAY_TRACED | WATER_FEATURE_SEVERAL_RAYS | WATER_FEATURE_ROUGH);
}
