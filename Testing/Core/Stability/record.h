// SPDX-License-Identifier: BSD-3-Clause
// record.h: what the stress suite keeps of its cases: errors against the condition of the case, and
// against the bound that a header promises.
#ifndef record_h
#define record_h

#include <stdint.h>
#include <stdio.h>

// One list, so that enum, names and units cannot drift. Condition: what the error grows with.
#define STRESS_PROPERTY_LIST(X)                                                                    \
  X(UNIT_NORMAL, "unit normal", "length of the normal", "relative")                                \
  X(UNIT_OFFSET, "offset of the unit plane", "offset / length of the normal", "relative")          \
  X(MIRROR_TWICE, "mirrored twice, matrix", "distance of the plane", "absolute; shift per offset") \
  X(CAMERA_TWICE, "mirrored twice, camera", "reach", "absolute; shift per reach")                  \
  X(DETERMINANT, "determinant of the mirrored view - 1", "reach", "absolute")                      \
  X(OWN_PLACE, "a point of the water in mirrored view space", "reach / depth", "per reach")        \
  X(OWN_PIXEL, "a point of the water on its own pixel", "reach / half a picture", "NDC")           \
  X(MAP_PIXEL, "the same by the texture matrix", "reach / half a picture",                         \
    "shares of the texture")                                                                       \
  X(CLIP_HEIGHT, "height over the clip in mirrored view space", "reach / height", "per reach")     \
  X(CLIP_SIDE, "height over the clip in clip space", "bound / height", "per bound")                \
  X(EYE_SIDE, "side of the eye", "reach / height", "wrong sides")                                  \
  X(IN_RECT, "a visible point's texel in the texture's drawn part", "reach / depth", "lost")       \
  X(CULLING, "a prop that the water shows is drawn", "reach / depth", "lost")                      \
  X(FAR_PLANE, "a drawn prop's corner within the far plane", "far / near", "beyond, per depth")    \
  X(FRESNEL, "reflectance", "1 / distance from the critical cosine", "absolute")                   \
  X(FRESNEL_ORDER, "reflectance falls with the cosine", "1 / step of the cosine", "rise")          \
  X(SAME_PLAN, "equal plans for equal scenes", "none", "bytes")                                    \
  X(ACCEPTED, "a valid scene is accepted", "far / near", "rejected")

typedef enum stress_property
{
#define STRESS_PROPERTY_VALUE(name, text, condition, unit) name,
  STRESS_PROPERTY_LIST(STRESS_PROPERTY_VALUE)
#undef STRESS_PROPERTY_VALUE
    STRESS_PROPERTY_COUNT
} stress_property;

enum
{
  STRESS_DECADES = 48,
  STRESS_FIRST_DECADE = -20
};

typedef struct stress_bin // of cases whose condition has the same power of ten
{
  uint64_t count;
  double most;       // error
  double most_ratio; // error over bound
} stress_bin;

typedef struct stress_record
{
  stress_bin bins[STRESS_PROPERTY_COUNT][STRESS_DECADES];
  uint64_t seed;
  uint64_t number; // of the present case
  uint64_t failure_count;
  uint64_t worst[STRESS_PROPERTY_COUNT]; // number of the case with the largest ratio
} stress_record;

// Keeps an error; more than its bound, or no number, is a failure, and the first are printed.
void stress_keep(
  stress_record* record, stress_property property, double condition, double error, double bound);

// A line per property: count, largest error, largest ratio and the case it is of.
void stress_print(const stress_record* record);

// All bins that have cases, tab-separated: property, text, condition, unit, decade, count, error,
// ratio.
void stress_write(const stress_record* record, FILE* file);

#endif
