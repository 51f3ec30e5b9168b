// SPDX-License-Identifier: BSD-3-Clause
// water_status.h: what can be wrong with a scene; one list gives the codes and their texts.
//
// The order is the order in which water_plan_make checks. A text names the accepted range; the
// caller adds the value it had.
#ifndef water_status_h
#define water_status_h

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_STATUS_LIST(X)                                                                       \
  X(WATER_OK, "no error")                                                                          \
  X(WATER_BAD_PLANE, "the water plane needs a finite origin and a finite normal that is not zero") \
  X(WATER_BAD_SURFACE,                                                                             \
    "the water has no surface: the scene is empty or its bounds are not finite; add props, set "   \
    "SheetBounds or give the water a mapper")                                                      \
  X(WATER_BAD_VIEWPORT, "the picture must be at least 1 x 1 pixels")                               \
  X(WATER_BAD_TEXTURE_SCALE, "TextureScale must be finite and greater than 0")                     \
  X(WATER_TEXTURE_TOO_LARGE, "the reflection texture is larger than the GPU's limit")              \
  X(WATER_BAD_CLIP_MARGIN, "ClipMargin must be finite and not negative")                           \
  X(WATER_BAD_INDEX, "IndexOfRefraction must be finite and at least 1")                            \
  X(WATER_BAD_REFLECTANCE, "Reflectance must lie in [0, 1]")                                       \
  X(WATER_BAD_CAMERA,                                                                              \
    "the camera's matrices must be finite, the view rigid and the projection "                     \
    "invertible")                                                                                  \
  X(WATER_CAMERA_ON_PLANE,                                                                         \
    "the camera lies exactly on the water plane; it must be above or below")                       \
  X(WATER_BAD_PROP_BOUNDS, "the bounds of every prop must be finite")

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
