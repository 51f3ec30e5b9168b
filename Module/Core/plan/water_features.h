// SPDX-License-Identifier: BSD-3-Clause
// water_features.h: in addition to the plan: the features of a water's shader, and their files.
//
// A feature is a bit. The shader is a sequence of slots, each filled by one file of Module/GLSL or
// by none: files and not branches, because software renderers execute both sides of a branch. The
// lists below are the only place that names files, their order and what each stands for; the shader
// is put together from them, Documentation/architecture.md has their table, and tests compile a
// selection of the combinations of files that a look can ask for (check_glsl.sh --all: every one).
#ifndef water_features_h
#define water_features_h

#include "water_types.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// X(name, what), in the order of their bits.
#define WATER_FEATURE_LIST(X)                                                                      \
  X(WAVES, "waves change the normal")                                                              \
  X(RAY_TRACED, "reflected rays are traced in the reflection texture")                             \
  X(OFFSET, "the texture is looked up at an offset")                                               \
  X(ENVIRONMENT, "a static picture is reflected, or the background")                               \
  X(MEDIUM, "the scene is visible through the surface")                                            \
  X(CAUSTICS, "waves focus light on the bed")                                                      \
  X(GLITTER, "glitter of the sun on slopes that a pixel does not resolve")                         \
  X(SEA, "a wind sea on a tile")                                                                   \
  X(NORMAL_MAPS, "one or two normal maps move over the water")                                     \
  X(ROUGH, "several facets per pixel")                                                             \
  X(DISPLACED, "waves displace the surface")                                                       \
  X(FOAM, "foam at the shore and on crests")                                                       \
  X(SHADOWS, "shadows on glitter and foam")                                                        \
  X(OUTPUT, "the pixel shows the source of its colour")                                            \
  X(TRANSLUCENT, "the reflection texture has a layer of translucent props")                        \
  X(SEVERAL_RAYS, "several rays if a neighbouring pixel has another colour")                       \
  X(ENCLOSED, "a mesh in the reflection texture may be the sky")                                   \
  X(PEELED, "the reflection texture has a peel: a second layer of depth")                          \
  X(HARDWARE_RAYS, "hardware: reads of a ray are issued together")                                 \
  X(HARDWARE_FACETS, "hardware: facets with separate branches")                                    \
  X(HARDWARE_MEDIUM, "hardware: a refracted ray is marched only if needed")                        \
  X(HARDWARE_TILE, "hardware: only as many samples of a tile as needed")                           \
  X(MESH, "a user's mesh: its vertices carry their heights")                                       \
  X(SAMPLES, "the picture below the surface is multisampled")                                      \
  X(SEA_MOVES, "the wind sea displaces the surface")                                               \
  X(WHITECAPS, "foam where the points of the sea are closest")                                     \
  X(SKY_SCREEN, "the background is a picture, or a gradient")                                      \
  X(SKY_MAP, "the sky is a picture in longitude and latitude")                                     \
  X(SKY_CUBE, "the sky is a cube map")                                                             \
  X(SKY_FLOOR, "a skybox has a floor")                                                             \
  X(SLOPED, "a user's mesh that is not flat: rays follow its slopes")                              \
  X(HULLS, "hulls float in the water, with no water inside")                                       \
  X(PORT, "a camera behind a dome port, which may be half under water")                            \
  X(FLOW, "a current carries the waves over a user's mesh")                                        \
  X(GROUND, "there is ground under all of the water")                                              \
  X(BUFFERED, "a user's mesh whose surface is in a buffer: it is shaded once per pixel")           \
  X(MATTER, "data give the concentration of matter in the water")                                  \
  X(FOAM_DATA, "data give the foam cover")                                                         \
  X(SKY_VIEW, "meshes that may be the sky have a view of their own")                               \
  X(SHORE, "a user's mesh is cut at the shore while it is drawn")                                  \
  X(OPEN, "open water: no ground is under it")                                                     \
  X(BELOW_LAYER, "the own view has a layer of translucent props")                                  \
  X(RANK_REGION, "a rank shows the water in its own part of space")                                \
  X(COLUMN, "a pixel reflects what all of its slopes see, not only some facets")

typedef enum water_feature_bit
{
#define WATER_FEATURE_BIT(name, what) WATER_FEATURE_BIT_##name,
  WATER_FEATURE_LIST(WATER_FEATURE_BIT)
#undef WATER_FEATURE_BIT
    WATER_FEATURE_COUNT
} water_feature_bit;

// A set of features. An enum of C has no values beyond an int's: 31 features would be its end.
typedef uint64_t water_feature_set;

#define WATER_FEATURE_FLAG(name) (UINT64_C(1) << WATER_FEATURE_BIT_##name)

// WATER_FEATURE_WAVES and so on; initializers of static objects take WATER_FEATURE_FLAG(WAVES).
#define WATER_FEATURE_VALUE(name, what)                                                            \
  static const water_feature_set WATER_FEATURE_##name = WATER_FEATURE_FLAG(name);
WATER_FEATURE_LIST(WATER_FEATURE_VALUE)
#undef WATER_FEATURE_VALUE

// Files of the surface's fragment shader, in order: X(slot, file, any_of, none_of, what). A file is
// there when the features have any of any_of (0: whatever they have) and none of none_of. For the
// features that a look can have, the conditions of one slot exclude each other.
// A sky that is looked up in a texture, or in more than a vertical gradient.
#define WATER_FEATURES_SKY                                                                         \
  (WATER_FEATURE_FLAG(SKY_SCREEN) | WATER_FEATURE_FLAG(SKY_MAP) | WATER_FEATURE_FLAG(SKY_CUBE) |   \
    WATER_FEATURE_FLAG(SKY_VIEW))
#define WATER_SURFACE_FILE_LIST(X)                                                                 \
  X(optics, vtkWaterOptics, 0, 0, "Fresnel's law")                                                 \
  X(gradient, vtkWaterGradient, 0, 0, "background colour in a direction")                          \
  X(attenuation, vtkWaterAttenuation, WATER_FEATURE_FLAG(MEDIUM), 0,                               \
    "attenuation of light in the water")                                                           \
  X(mixture, vtkWaterMatter, WATER_FEATURE_FLAG(MATTER) | WATER_FEATURE_FLAG(MEDIUM), 0,           \
    "water that carries matter")                                                                   \
  X(scattered, vtkWaterHaze, WATER_FEATURE_FLAG(MEDIUM), 0,                                        \
    "light that the water scatters towards an eye under water")                                    \
  X(slopes, vtkWaterSlopes, WATER_FEATURE_FLAG(GLITTER), 0, "slopes as a distribution")            \
  X(highlights, vtkWaterHighlights, WATER_FEATURE_FLAG(GLITTER), 0, "light brighter than white")   \
  X(cover, vtkWaterFoamCover, WATER_FEATURE_FLAG(FOAM), 0, "foam coverage")                        \
  X(measure, vtkWaterFoamMeasure, WATER_FEATURE_FLAG(FOAM_DATA), 0,                                \
    "foam cover from a Froude number or a breaking index")                                         \
  X(gain, vtkWaterFlowGain, WATER_FEATURE_FLAG(FLOW), 0,                                           \
    "makes two layers of waves as steep as one")                                                   \
  X(cell, vtkWaterCell, WATER_FEATURE_FLAG(DISPLACED), 0,                                          \
    "the part of a wave that a grid resolves")                                                     \
  X(place, vtkWaterDisplacementFS, WATER_FEATURE_FLAG(DISPLACED), 0,                               \
    "place at rest, from the vertices")                                                            \
  X(place, vtkWaterMeshPlaceFS, WATER_FEATURE_FLAG(SLOPED), WATER_FEATURE_FLAG(BUFFERED),          \
    "position and slope of a mesh, from the vertices")                                             \
  X(place, vtkWaterBufferPlaceFS, WATER_FEATURE_FLAG(BUFFERED), 0,                                 \
    "position and slope of a mesh, from a buffer")                                                 \
  X(place, vtkWaterNoDisplacementFS, 0,                                                            \
    WATER_FEATURE_FLAG(DISPLACED) | WATER_FEATURE_FLAG(SLOPED) | WATER_FEATURE_FLAG(BUFFERED),     \
    "place at rest, from the pixel")                                                               \
  X(under, vtkWaterUnderFS, WATER_FEATURE_FLAG(DISPLACED) | WATER_FEATURE_FLAG(SLOPED), 0,         \
    "the part of the reflection texture that rays ignore")                                         \
  X(under, vtkWaterNothingUnderFS, 0, WATER_FEATURE_FLAG(DISPLACED) | WATER_FEATURE_FLAG(SLOPED),  \
    "nothing: the texture is cut at the surface")                                                  \
  X(height, vtkWaterMeshHeightFS, WATER_FEATURE_FLAG(MESH), WATER_FEATURE_FLAG(BUFFERED),          \
    "height above the plane, from the vertices")                                                   \
  X(height, vtkWaterBufferHeightFS, WATER_FEATURE_FLAG(BUFFERED), 0,                               \
    "height above the plane, from a buffer")                                                       \
  X(height, vtkWaterPixelHeightFS, 0, WATER_FEATURE_FLAG(MESH),                                    \
    "height above the plane, from depth; 0 for a flat sheet")                                      \
  X(clarity, vtkWaterMatterFS, WATER_FEATURE_FLAG(MATTER), 0, "matter in the water, from data")    \
  X(clarity, vtkWaterClarityFS, 0, WATER_FEATURE_FLAG(MATTER), "the same water everywhere")        \
  X(point, vtkWaterPointFS, 0, 0, "values that all slots share")                                   \
  X(pixel, vtkWaterPixelFS, 0, WATER_FEATURE_FLAG(BUFFERED),                                       \
    "depth and derivatives, from the triangle")                                                    \
  X(pixel, vtkWaterBufferPixelFS, WATER_FEATURE_FLAG(BUFFERED), 0,                                 \
    "depth and derivatives, from a buffer")                                                        \
  X(hulls, vtkWaterHullsFS, WATER_FEATURE_FLAG(HULLS), 0, "no water inside hulls")                 \
  X(hulls, vtkWaterNoHullsFS, 0, WATER_FEATURE_FLAG(HULLS), "no hulls in the water")               \
  X(region, vtkWaterRankRegionFS, WATER_FEATURE_FLAG(RANK_REGION), 0,                              \
    "only the rank's own part of space")                                                           \
  X(region, vtkWaterNoRankRegionFS, 0, WATER_FEATURE_FLAG(RANK_REGION), "all of space")            \
  X(sky, vtkWaterSkyColorFS, 0, WATER_FEATURES_SKY, "the background: one colour")                  \
  X(sky, vtkWaterSkyScreenFS, WATER_FEATURE_FLAG(SKY_SCREEN), 0,                                   \
    "the background: a picture, or a gradient")                                                    \
  X(sky, vtkWaterSkyMapFS, WATER_FEATURE_FLAG(SKY_MAP), 0, "a picture in longitude and latitude")  \
  X(sky, vtkWaterSkyCubeFS, WATER_FEATURE_FLAG(SKY_CUBE), 0, "a cube map")                         \
  X(sky, vtkWaterSkyViewFS, WATER_FEATURE_FLAG(SKY_VIEW), 0, "meshes that may be the sky")         \
  X(floor, vtkWaterSkyFloorFS, WATER_FEATURE_FLAG(SKY_FLOOR), 0, "floor of a skybox")              \
  X(floor, vtkWaterNoSkyFloorFS, 0, WATER_FEATURE_FLAG(SKY_FLOOR), "none")                         \
  X(tile, vtkWaterTileFS, WATER_FEATURE_FLAG(WAVES), WATER_FEATURE_FLAG(HARDWARE_TILE),            \
    "slopes from a texture that repeats")                                                          \
  X(tile, vtkWaterHardwareTileFS, WATER_FEATURE_FLAG(HARDWARE_TILE), 0,                            \
    "the same, with one, two or four samples")                                                     \
  X(slope, vtkWaterTileSlopeFS, WATER_FEATURE_FLAG(WAVES), 0, "slope of a texture that repeats")   \
  X(sines, vtkWaterWavesFS, WATER_FEATURE_FLAG(WAVES), 0, "sine and Gerstner waves")               \
  X(tiles, vtkWaterSeaTiles, WATER_FEATURE_FLAG(SEA), 0, "the wind sea's tiles")                   \
  X(folds, vtkWaterSeaFoldsFS, WATER_FEATURE_FLAG(SEA_MOVES) | WATER_FEATURE_FLAG(WHITECAPS), 0,   \
    "spacing of a wind sea's points")                                                              \
  X(folds, vtkWaterNoSeaFoldsFS, WATER_FEATURE_FLAG(WAVES),                                        \
    WATER_FEATURE_FLAG(SEA_MOVES) | WATER_FEATURE_FLAG(WHITECAPS), "none")                         \
  X(sea, vtkWaterSeaFS, WATER_FEATURE_FLAG(SEA), 0, "wind sea")                                    \
  X(sea, vtkWaterNoSeaFS, WATER_FEATURE_FLAG(WAVES), WATER_FEATURE_FLAG(SEA), "none")              \
  X(normal_maps, vtkWaterNormalMapsFS, WATER_FEATURE_FLAG(NORMAL_MAPS), 0,                         \
    "normal maps that move")                                                                       \
  X(normal_maps, vtkWaterNoNormalMapsFS, WATER_FEATURE_FLAG(WAVES),                                \
    WATER_FEATURE_FLAG(NORMAL_MAPS), "none")                                                       \
  X(flow, vtkWaterFlowFS, WATER_FEATURE_FLAG(FLOW), 0, "a current carries the waves")              \
  X(flow, vtkWaterNoFlowFS, WATER_FEATURE_FLAG(WAVES), WATER_FEATURE_FLAG(FLOW), "none")           \
  X(waves, vtkWaterRippleFS, WATER_FEATURE_FLAG(WAVES), 0,                                         \
    "the normal, from sines, sea and normal maps")                                                 \
  X(waves, vtkWaterNoWavesFS, 0, WATER_FEATURE_FLAG(WAVES), "calm: the plane's normal")            \
  X(output, vtkWaterOutputFS, WATER_FEATURE_FLAG(OUTPUT), 0, "confidence, lookup or reflectance")  \
  X(output, vtkWaterNoOutputFS, 0, WATER_FEATURE_FLAG(OUTPUT), "colour")                           \
  X(reflection, vtkWaterEnvironmentFS, WATER_FEATURE_FLAG(ENVIRONMENT), 0, "static environment")   \
  X(reflection, vtkWaterRayTracedFS, WATER_FEATURE_FLAG(RAY_TRACED), 0,                            \
    "ray traced in the texture")                                                                   \
  X(reflection, vtkWaterOffsetFS, WATER_FEATURE_FLAG(OFFSET), 0, "offset lookup")                  \
  X(reflection, vtkWaterMirrorFS, 0,                                                               \
    WATER_FEATURE_FLAG(ENVIRONMENT) | WATER_FEATURE_FLAG(RAY_TRACED) | WATER_FEATURE_FLAG(OFFSET), \
    "calm: lookup at the pixel's own position")                                                    \
  X(dome, vtkWaterDomeFS, WATER_FEATURE_FLAG(ENCLOSED), WATER_FEATURE_FLAG(SKY_VIEW),              \
    "undrawn texels have no colour")                                                               \
  X(dome, vtkWaterSkyDomeFS, WATER_FEATURE_FLAG(SKY_VIEW), 0, "the sky has a view of its own")     \
  X(dome, vtkWaterNoDomeFS, 0, WATER_FEATURE_FLAG(ENCLOSED),                                       \
    "undrawn texels have the background's colour")                                                 \
  X(end, vtkWaterSkyEndFS, WATER_FEATURE_FLAG(SKY_VIEW), 0,                                        \
    "a ray that meets nothing ends in a mesh that may be the sky")                                 \
  X(end, vtkWaterNoSkyEndFS,                                                                       \
    WATER_FEATURE_FLAG(ENVIRONMENT) | WATER_FEATURE_FLAG(RAY_TRACED) | WATER_FEATURE_FLAG(OFFSET), \
    WATER_FEATURE_FLAG(SKY_VIEW), "a ray ends where nothing was drawn")                            \
  X(walk, vtkWaterRayWalkFS, WATER_FEATURE_FLAG(RAY_TRACED), WATER_FEATURE_FLAG(HARDWARE_RAYS),    \
    "sequential reads")                                                                            \
  X(walk, vtkWaterHardwareRaysFS, WATER_FEATURE_FLAG(HARDWARE_RAYS), 0, "several reads at once")   \
  X(edges, vtkWaterFacetEdgesFS, WATER_FEATURE_FLAG(RAY_TRACED), 0, "edges between facets")        \
  X(edges, vtkWaterNoFacetEdgesFS, WATER_FEATURE_FLAG(ENVIRONMENT) | WATER_FEATURE_FLAG(OFFSET),   \
    0, "none")                                                                                     \
  X(behind, vtkWaterBehindFS, WATER_FEATURE_FLAG(PEELED), 0, "rays continue behind edges")         \
  X(behind, vtkWaterNoBehindFS,                                                                    \
    WATER_FEATURE_FLAG(ENVIRONMENT) | WATER_FEATURE_FLAG(RAY_TRACED) | WATER_FEATURE_FLAG(OFFSET), \
    WATER_FEATURE_FLAG(PEELED), "rays end at edges")                                               \
  X(layer, vtkWaterTranslucentLayerFS, WATER_FEATURE_FLAG(TRANSLUCENT), 0,                         \
    "translucent props, and blur")                                                                 \
  X(layer, vtkWaterNoTranslucentLayerFS,                                                           \
    WATER_FEATURE_FLAG(ENVIRONMENT) | WATER_FEATURE_FLAG(RAY_TRACED) | WATER_FEATURE_FLAG(OFFSET), \
    WATER_FEATURE_FLAG(TRANSLUCENT), "none")                                                       \
  X(blur, vtkWaterBlurFS, WATER_FEATURE_FLAG(RAY_TRACED) | WATER_FEATURE_FLAG(OFFSET),             \
    WATER_FEATURE_FLAG(TRANSLUCENT), "facets, blurred over the distance between them")             \
  X(blur, vtkWaterNoBlurFS, WATER_FEATURE_FLAG(ENVIRONMENT), 0, "none")                            \
  X(caustics, vtkWaterCausticsFS, WATER_FEATURE_FLAG(CAUSTICS), 0, "light that waves focus")       \
  X(caustics, vtkWaterNoCausticsFS, 0, WATER_FEATURE_FLAG(CAUSTICS), "none")                       \
  X(picture, vtkWaterMediumPictureFS, WATER_FEATURE_FLAG(MEDIUM), 0,                               \
    "what is below the surface, as a picture with depths")                                         \
  X(haze, vtkWaterHazeFS, WATER_FEATURE_FLAG(MEDIUM), 0,                                           \
    "light that the water in front of an eye under water adds")                                    \
  X(medium, vtkWaterMediumFS, WATER_FEATURE_FLAG(MEDIUM), 0,                                       \
    "the scene, refracted and attenuated")                                                         \
  X(medium, vtkWaterNoMediumFS, 0, WATER_FEATURE_FLAG(MEDIUM), "the water's own colour")           \
  X(below, vtkWaterBelowLayerFS, WATER_FEATURE_FLAG(BELOW_LAYER), 0,                               \
    "translucent props of the own view, apart from the rest")                                      \
  X(below, vtkWaterNoBelowLayerFS, WATER_FEATURE_FLAG(MEDIUM), WATER_FEATURE_FLAG(BELOW_LAYER),    \
    "none")                                                                                        \
  X(shafts, vtkWaterShaftsFS, WATER_FEATURE_FLAG(CAUSTICS), 0,                                     \
    "light shafts: caustics in the water in front of an eye under water")                          \
  X(shafts, vtkWaterNoShaftsFS, WATER_FEATURE_FLAG(MEDIUM), WATER_FEATURE_FLAG(CAUSTICS), "none")  \
  X(others, vtkWaterOthersFS, WATER_FEATURE_FLAG(SAMPLES), 0,                                      \
    "several rays of a multisampled pixel")                                                        \
  X(others, vtkWaterNoOthersFS, WATER_FEATURE_FLAG(MEDIUM), WATER_FEATURE_FLAG(SAMPLES),           \
    "nothing")                                                                                     \
  X(refraction, vtkWaterMediumWalkFS, WATER_FEATURE_FLAG(MEDIUM),                                  \
    WATER_FEATURE_FLAG(HARDWARE_MEDIUM), "tracing of the refracted ray")                           \
  X(refraction, vtkWaterHardwareMediumFS, WATER_FEATURE_FLAG(HARDWARE_MEDIUM), 0,                  \
    "the same, with branches")                                                                     \
  X(ground, vtkWaterGroundFS, WATER_FEATURE_FLAG(GROUND), 0,                                       \
    "what a ray meets outside the picture")                                                        \
  X(ground, vtkWaterOpenFS, WATER_FEATURE_FLAG(OPEN), WATER_FEATURE_FLAG(GROUND),                  \
    "deep water, also where something hides the end of a ray")                                     \
  X(ground, vtkWaterNoGroundFS, WATER_FEATURE_FLAG(MEDIUM),                                        \
    WATER_FEATURE_FLAG(GROUND) | WATER_FEATURE_FLAG(OPEN), "deep water")                           \
  X(facet_slopes, vtkWaterFacetSlopesFS, WATER_FEATURE_FLAG(ROUGH), 0, "the slopes of the facets") \
  X(facets, vtkWaterFacetsFS, WATER_FEATURE_FLAG(ROUGH),                                           \
    WATER_FEATURE_FLAG(HARDWARE_FACETS) | WATER_FEATURE_FLAG(COLUMN), "several facets per pixel")  \
  X(facets, vtkWaterHardwareFacetsFS, WATER_FEATURE_FLAG(HARDWARE_FACETS), 0,                      \
    "the same, with branches")                                                                     \
  X(facets, vtkWaterColumnFS, WATER_FEATURE_FLAG(COLUMN), 0, "all slopes of a pixel")              \
  X(facets, vtkWaterNoFacetsFS, 0, WATER_FEATURE_FLAG(ROUGH), "one")                               \
  X(rays, vtkWaterRaysFS, WATER_FEATURE_FLAG(SEVERAL_RAYS), 0,                                     \
    "several rays per pixel where neighbours differ")                                              \
  X(rays, vtkWaterOneRayFS, 0, WATER_FEATURE_FLAG(SEVERAL_RAYS), "one")                            \
  X(shadows, vtkWaterShadowsFS, WATER_FEATURE_FLAG(SHADOWS), 0, "shadows on glitter and foam")     \
  X(shadows, vtkWaterNoShadowsFS, 0, WATER_FEATURE_FLAG(SHADOWS), "none")                          \
  X(glitter, vtkWaterGlitterFS, WATER_FEATURE_FLAG(GLITTER), 0, "the sun's glitter")               \
  X(glitter, vtkWaterNoGlitterFS, 0, WATER_FEATURE_FLAG(GLITTER), "none")                          \
  X(whitecaps, vtkWaterWhitecapsFS, WATER_FEATURE_FLAG(WHITECAPS), 0, "white crests of a sea")     \
  X(whitecaps, vtkWaterNoWhitecapsFS, WATER_FEATURE_FLAG(FOAM), WATER_FEATURE_FLAG(WHITECAPS),     \
    "none")                                                                                        \
  X(foam_data, vtkWaterFoamDataFS, WATER_FEATURE_FLAG(FOAM_DATA), 0, "foam, from data")            \
  X(foam_data, vtkWaterNoFoamDataFS, WATER_FEATURE_FLAG(FOAM), WATER_FEATURE_FLAG(FOAM_DATA),      \
    "none")                                                                                        \
  X(foam, vtkWaterFoamFS, WATER_FEATURE_FLAG(FOAM), 0, "foam at the shore and on crests")          \
  X(foam, vtkWaterNoFoamFS, 0, WATER_FEATURE_FLAG(FOAM), "none")                                   \
  X(sun, vtkWaterSunFS, WATER_FEATURE_FLAG(GLITTER) | WATER_FEATURE_FLAG(FOAM), 0,                 \
    "the sun on glitter and foam")                                                                 \
  X(sun, vtkWaterNoSunFS, 0, WATER_FEATURE_FLAG(GLITTER) | WATER_FEATURE_FLAG(FOAM), "none")       \
  X(port, vtkWaterPortFS, WATER_FEATURE_FLAG(PORT), 0, "pixels whose ray begins under water")      \
  X(port, vtkWaterNoPortFS, 0, WATER_FEATURE_FLAG(PORT), "none")                                   \
  X(surface, vtkWaterSurfaceFS, 0, 0, "the pixel's colour, from all slots")

// Files of its vertex shader, in order: the same, for features that have any.
#define WATER_VERTEX_FILE_LIST(X)                                                                  \
  X(cell, vtkWaterCell, WATER_FEATURE_FLAG(DISPLACED), 0,                                          \
    "the part of a wave that a grid resolves")                                                     \
  X(tiles, vtkWaterSeaTiles, WATER_FEATURE_FLAG(SEA_MOVES), 0, "the wind sea's tiles")             \
  X(sea, vtkWaterSeaVS, WATER_FEATURE_FLAG(SEA_MOVES), 0, "displacement by a wind sea")            \
  X(sea, vtkWaterNoSeaVS, WATER_FEATURE_FLAG(DISPLACED), WATER_FEATURE_FLAG(SEA_MOVES), "none")    \
  X(displacement, vtkWaterDisplacementVS, WATER_FEATURE_FLAG(DISPLACED), 0,                        \
    "moves vertices by the waves")                                                                 \
  X(heights, vtkWaterMeshVS, WATER_FEATURE_FLAG(MESH), 0,                                          \
    "heights of the vertices above the plane")                                                     \
  X(slopes, vtkWaterMeshSlopesVS, WATER_FEATURE_FLAG(SLOPED), 0,                                   \
    "positions and normals of the vertices")                                                       \
  X(flow, vtkWaterFlowVS, WATER_FEATURE_FLAG(FLOW), 0, "current at the vertices")                  \
  X(matter, vtkWaterMatterVS, WATER_FEATURE_FLAG(MATTER), 0, "matter at the vertices")             \
  X(foam, vtkWaterFoamDataVS, WATER_FEATURE_FLAG(FOAM_DATA), 0, "foam at the vertices")            \
  X(shore, vtkWaterShoreVS, WATER_FEATURE_FLAG(SHORE), 0, "cuts a mesh at the shore")              \
  X(depth, vtkWaterDepthVS, 0, 0, "an endless surface is not cut at the near and far planes")

// Files of the shader that follows light from the surface to the bed (water_caustics.h), in order:
// the same, for features that have caustics. The surface counts as lying in its plane.
#define WATER_PHOTON_FILE_LIST(X)                                                                  \
  X(gradient, vtkWaterGradient, 0, 0, "background colour in a direction")                          \
  X(place, vtkWaterNoDisplacementFS, 0, 0, "place at rest, from the pixel")                        \
  X(height, vtkWaterPixelHeightFS, 0, 0, "height above the plane, from the pixel's depth")         \
  X(point, vtkWaterPointFS, 0, 0, "values that all slots share, and the sun")                      \
  X(pixel, vtkWaterPixelFS, 0, 0, "depth and derivatives, from the fragment")                      \
  X(tile, vtkWaterPhotonTileFS, 0, 0, "slopes from a texture that repeats, smooth between points") \
  X(sines, vtkWaterWavesFS, 0, 0, "sine and Gerstner waves")                                       \
  X(tiles, vtkWaterSeaTiles, WATER_FEATURE_FLAG(SEA), 0, "tiles of a wind sea")                    \
  X(folds, vtkWaterNoSeaFoldsFS, 0, 0, "none: the sea has no horizontal displacement")             \
  X(sea, vtkWaterSeaFS, WATER_FEATURE_FLAG(SEA), 0, "wind sea")                                    \
  X(sea, vtkWaterNoSeaFS, 0, WATER_FEATURE_FLAG(SEA), "none")                                      \
  X(normal_maps, vtkWaterNormalMapsFS, WATER_FEATURE_FLAG(NORMAL_MAPS), 0,                         \
    "normal maps that move")                                                                       \
  X(normal_maps, vtkWaterNoNormalMapsFS, 0, WATER_FEATURE_FLAG(NORMAL_MAPS), "none")               \
  X(flow, vtkWaterNoFlowFS, 0, 0, "no current: caustics treat waves as at rest")                   \
  X(waves, vtkWaterRippleFS, 0, 0, "the normal, from sines, sea and normal maps")                  \
  X(photon, vtkWaterPhotonFS, 0, 0, "where the light of a point reaches the bed")

// Files of the shader with which a user's mesh writes its surface into a buffer, in order: the
// same, for features that have one.
#define WATER_BUFFER_FILE_LIST(X)                                                                  \
  X(place, vtkWaterMeshPlaceFS, WATER_FEATURE_FLAG(SLOPED), 0,                                     \
    "position and slope of a mesh, from the vertices")                                             \
  X(place, vtkWaterNoDisplacementFS, 0, WATER_FEATURE_FLAG(SLOPED), "place, from the pixel")       \
  X(height, vtkWaterMeshHeightFS, 0, 0, "height above the plane, from the vertices")               \
  X(surface, vtkWaterBufferMeshFS, 0, 0, "into the buffer: height, slope, 1 / w, data")

// Is a file of the lists part of the shader of some features?
static inline bool water_features_want(
  water_feature_set features, water_feature_set any_of, water_feature_set none_of)
{
  return (any_of == 0 || (features & any_of) != 0) && (features & none_of) == 0;
}

typedef enum water_lookup_kind
{
  WATER_LOOKUP_RAY_TRACED,
  WATER_LOOKUP_OFFSET
} water_lookup_kind;

// What the features of a look depend on, and how waves are looked up: X(member, what).
#define WATER_FEATURE_LOOK_LIST(X)                                                                 \
  X(has_sines, "individual waves")                                                                 \
  X(has_sea, "a wind sea")                                                                         \
  X(has_normal_maps, "normal maps that move")                                                      \
  X(has_slope_variance, "slopes that are given as a distribution")                                 \
  X(has_wave_geometry, "sines and the sea displace the surface")                                   \
  X(has_whitecaps, "foam on the crests of the sea")                                                \
  X(has_environment, "a static picture is reflected")                                              \
  X(has_refraction, "the scene is visible through the surface")                                    \
  X(is_opaque, "drawn with the opaque geometry")                                                   \
  X(has_caustics, "waves focus light under water")                                                 \
  X(has_glitter, "glitter of the sun on slopes that a pixel does not resolve")                     \
  X(has_foam, "at the shore or on crests")                                                         \
  X(has_shadows, "on glitter and foam")                                                            \
  X(has_all_slopes, "water_rays_take_all_slopes")                                                  \
  X(has_output, "other than the colour")

typedef struct water_feature_look
{
#define WATER_FEATURE_LOOK_MEMBER(member, what) bool member;
  WATER_FEATURE_LOOK_LIST(WATER_FEATURE_LOOK_MEMBER)
#undef WATER_FEATURE_LOOK_MEMBER
  water_lookup_kind lookup; // of waves
} water_feature_look;

// Does the surface have waves of any kind, or slopes?
bool water_features_is_rough(const water_feature_look* look);

// Is the reflection looked up along rays? Not with a calm look that has no confidence output.
bool water_features_needs_rays(const water_feature_look* look);

// Do waves displace the surface?
bool water_features_is_displaced(const water_feature_look* look);

// Do objects cast shadows on glitter or foam?
bool water_features_has_shadows(const water_feature_look* look);

// Do only sines turn reflected rays? Only they have a maximum slope, which bounds the turn of a
// ray. Extend this for a new kind of waves.
bool water_features_is_of_sines(const water_feature_look* look);

// The features of a water in the main view.
water_feature_set water_features_of(const water_feature_look* look);

// What a reflection texture has in addition to its colours and depths.
typedef struct water_feature_texture
{
  bool has_layer;    // of translucent props
  bool has_peel;     // of what lies behind its first surfaces
  bool is_enclosed;  // water_plan.is_enclosed
  bool has_sky_view; // water_sky_view.h
} water_feature_texture;

// Adds the features that a water's reflection texture needs.
water_feature_set water_features_with_texture(
  water_feature_set features, const water_feature_texture* texture);

// Adds the feature of a user's mesh that is drawn as it is: not if waves displace it, because these
// start from the plane.
water_feature_set water_features_with_mesh(water_feature_set features);

// Adds the features of such a mesh that is not flat: reflections are looked up along rays, as on
// waves.
water_feature_set water_features_with_slopes(water_feature_set features, water_lookup_kind lookup);

// Adds the feature of a mesh whose current carries the waves. It has no effect without waves, or if
// they displace the mesh.
water_feature_set water_features_with_flow(water_feature_set features);

// Adds the feature of a mesh whose data give the concentration of matter in the water. Only clear
// water has it: matter absorbs light only where light passes through the water.
water_feature_set water_features_with_matter(water_feature_set features);

// Adds the feature of a mesh whose data give the cover of foam. Only water with foam has it.
water_feature_set water_features_with_foam_data(water_feature_set features);

// Adds the feature of a mesh that is cut at the shore while it is drawn.
water_feature_set water_features_with_shore(water_feature_set features);

// Adds the feature that a window with several samples per pixel needs.
water_feature_set water_features_with_samples(water_feature_set features);

// Adds the feature of clear water whose own view keeps translucent props apart.
water_feature_set water_features_with_below_layer(water_feature_set features);

// Adds the feature of water in which hulls float.
water_feature_set water_features_with_hulls(water_feature_set features);

// Adds the feature of water that a rank shows only in its own part of space.
water_feature_set water_features_with_rank_region(water_feature_set features);

// Adds the feature of a user's mesh whose surface is in a buffer; not without heights of vertices.
water_feature_set water_features_with_buffer(water_feature_set features);

// Adds the feature of clear water with ground under all of it.
water_feature_set water_features_with_ground(water_feature_set features);

// Adds the feature of clear water that is known to have no ground under it.
water_feature_set water_features_with_open(water_feature_set features);

// Adds the feature of a camera behind a dome port. Only clear water has it.
water_feature_set water_features_with_port(water_feature_set features);

// Changes the features for a shader that a GPU executes. Several rays per pixel are too slow there,
// unless there is a peel, which is slower still.
water_feature_set water_features_on_hardware(water_feature_set features);

// The features of a water in the mirrored view of another one: it reflects the background, with the
// mean of all waves.
water_feature_set water_features_secondary(const water_feature_look* look);

// The features of such a water with a secondary view (water_secondary.h): it reflects the scene in
// place of the background.
water_feature_set water_features_secondary_view(const water_feature_look* look);

#ifdef __cplusplus
}
#endif
#endif
