// SPDX-License-Identifier: BSD-3-Clause
// water_status.h: what can be wrong with a scene; one list gives the codes and their texts.
//
// Up to WATER_BAD_PROP_BOUNDS the order is the order in which water_plan_make checks; the later
// ones belong to the waves, the spectrum, the medium, the presets, the quality and the ranks. A
// text names the accepted range; the caller adds the value it had.
#ifndef water_status_h
#define water_status_h

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_STATUS_LIST(X)                                                                       \
  X(WATER_OK, "no error")                                                                          \
  X(WATER_BAD_PLANE, "the water plane needs an origin within 1e100 and a finite nonzero normal")   \
  X(WATER_BAD_SURFACE,                                                                             \
    "the water has no surface: the scene is empty or its bounds exceed 1e100; add props, set "     \
    "SheetBounds or give the water a mapper")                                                      \
  X(WATER_BAD_VIEWPORT, "the picture must be at least 1 x 1 pixels")                               \
  X(WATER_BAD_TEXTURE_SCALE, "TextureScale must be finite and greater than 0")                     \
  X(WATER_TEXTURE_TOO_LARGE, "the reflection texture is larger than the GPU's limit")              \
  X(WATER_BAD_CLIP_MARGIN, "ClipMargin must lie in [0, 1e100]")                                    \
  X(WATER_BAD_PROP_SIZE, "MinimumPropSize must not be negative")                                   \
  X(WATER_BAD_REFLECTANCE_ERROR, "ReflectanceError must lie in [0, 1]")                            \
  X(WATER_BAD_INDEX, "IndexOfRefraction must be finite and at least 1")                            \
  X(WATER_BAD_REFLECTANCE, "Reflectance must lie in [0, 1]")                                       \
  X(WATER_BAD_CAMERA,                                                                              \
    "the camera's matrices must be finite and at most 1e100, the view rigid and the projection "   \
    "invertible")                                                                                  \
  X(WATER_CAMERA_ON_PLANE, "the camera lies on the water plane")                                   \
  X(WATER_BAD_PROP_BOUNDS, "the bounds of every prop must be finite")                              \
  X(WATER_BAD_WAVE_AMPLITUDE,                                                                      \
    "Amplitude of a wave must be finite, not negative and at most 1e9 m")                          \
  X(WATER_BAD_WAVELENGTH, "Wavelength must be finite and greater than 0")                          \
  X(WATER_BAD_WAVE_DIRECTION, "Direction of a wave must be finite")                                \
  X(WATER_BAD_WAVE_PHASE, "Phase of a wave must be finite")                                        \
  X(WATER_BAD_STEEPNESS, "Steepness must lie in [0, 1]")                                           \
  X(WATER_WAVES_FOLD,                                                                              \
    "the waves fold over: the sum of 2 pi Amplitude Steepness / Wavelength must not exceed 1")     \
  X(WATER_BAD_DEPTH, "Depth must be greater than 0; infinity is deep water")                       \
  X(WATER_BAD_TIME, "Time must be finite")                                                         \
  X(WATER_BAD_POINT, "the point must be finite")                                                   \
  X(WATER_BAD_WAVENUMBER, "wave numbers must be finite, not negative and in rising order")         \
  X(WATER_BAD_FREQUENCY, "the angular frequency must be finite and not negative")                  \
  X(WATER_BAD_SEA_MODEL, "the spectrum's model or spreading is not in the list")                   \
  X(WATER_BAD_WIND_SPEED, "WindSpeed must lie in [0.1, 100] m/s")                                  \
  X(WATER_BAD_WIND_DIRECTION, "WindDirection must be finite")                                      \
  X(WATER_BAD_FETCH, "Fetch must be at least 1 m; infinity is a fully developed sea")              \
  X(WATER_BAD_PEAK_ENHANCEMENT, "PeakEnhancement must lie in [1, 20]")                             \
  X(WATER_BAD_SPREADING_POWER, "SpreadingPower must lie in [0, 1000]")                             \
  X(WATER_BAD_TILE_SIZE, "the tile's size must be an even number from 4 to 16384")                 \
  X(WATER_BAD_TILE_LENGTH, "the tile's length must lie in [0.001, 1e9] m")                         \
  X(WATER_BAD_CASCADES, "SeaCascades must lie in [1, 3]")                                          \
  X(WATER_BAD_LIFE_TIME, "WhitecapLifeTime must lie in [0, 10] s")                                 \
  X(WATER_BAD_PERIOD, "the period must be finite and not negative; 0 does not repeat")             \
  X(WATER_BAD_ABSORPTION, "Absorption must be finite, not negative and at most 1e9")               \
  X(WATER_BAD_SCATTERING, "Scattering must be finite, not negative and at most 1e9")               \
  X(WATER_BAD_DIRECTION, "a direction must be finite and of unit length")                          \
  X(WATER_BAD_INDEX_RATIO, "the ratio of the indices must be finite and greater than 0")           \
  X(WATER_TOTAL_REFLECTION, "total internal reflection: there is no refracted ray")                \
  X(WATER_BAD_WATER_TYPE, "the Jerlov water type is not in the list")                              \
  X(WATER_BAD_NORMAL_MAP_SIZE, "Size of a normal map must lie in [1e-6, 1e9] m")                   \
  X(WATER_BAD_NORMAL_MAP_MOTION, "Speed and Direction of a normal map must be finite")             \
  X(WATER_BAD_NORMAL_MAP_STRENGTH, "Strength of a normal map must lie in [-1000, 1000]")           \
  X(WATER_BAD_PRESET, "the preset's name is not in the list")                                      \
  X(WATER_BAD_UNITS, "the unit's name is not in the list")                                         \
  X(WATER_BAD_QUALITY_NAME, "the quality's name must be fast, default, high or reference")         \
  X(WATER_BAD_TIME_BUDGET, "TimeBudget must be finite and greater than 0 ms")                      \
  X(WATER_BAD_TARGET_ERROR, "TargetError must be finite and greater than 0 pixels")                \
  X(WATER_BAD_ROUGHNESS,                                                                           \
    "the waves' slope, their turn per pixel and the picture's pixels per radian must be finite "   \
    "and not negative")                                                                            \
  X(WATER_RANKS_DIFFERENT_VERSIONS, "all ranks must run the same version of the water")            \
  X(WATER_RANKS_DIFFERENT_WATERS,                                                                  \
    "all ranks must show the same waters: equally many, visible on all or on none, and with "      \
    "an automatic extent on all or on none")                                                       \
  X(WATER_RANKS_DIFFERENT_LOOKS,                                                                   \
    "a water must have the same plane, look, time and settings on all ranks, and a RankRegion on " \
    "all or on none")                                                                              \
  X(WATER_RANKS_BAD_WATER, "a water must be without an error on all ranks")                        \
  X(WATER_RANKS_NO_SUCH_RANK, "FarthestRank must be one of the controller's ranks, or -1")         \
  X(WATER_RANKS_NO_COMMUNICATOR,                                                                   \
    "a controller must have a communicator: from before the first frame (Initialize) until after " \
    "the last (Finalize)")

typedef enum water_status
{
#define WATER_STATUS_VALUE(name, text) name,
  WATER_STATUS_LIST(WATER_STATUS_VALUE)
#undef WATER_STATUS_VALUE
    WATER_STATUS_COUNT
} water_status;

// Short English text of a status, never NULL; static storage.
const char* water_status_text(water_status status);

#ifdef __cplusplus
}
#endif
#endif
