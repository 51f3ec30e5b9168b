// SPDX-License-Identifier: BSD-3-Clause
// water_buffer.h: in addition to the plan: whether a user's mesh is shaded once per pixel.
//
// A software renderer runs the shader for each triangle, on all pixels of a block of which the
// triangle covers a part. The shader of water is long. A mesh whose triangles are small is
// therefore drawn with a short shader into a buffer, which has its height, its slope and its
// distance at each pixel. Then the long shader runs once per pixel.
#ifndef water_buffer_h
#define water_buffer_h

#include "water_features.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// X(name, text): why a surface has a buffer, or has none.
#define WATER_BUFFER_LIST(X)                                                                       \
  X(NOT_DRAWN, "the surface has not been drawn")                                                   \
  X(IN_USE, "the surface is shaded once per pixel, from a buffer")                                 \
  X(OFF, "the setting is off")                                                                     \
  X(HARDWARE, "a GPU draws the surface, which is faster without a buffer")                         \
  X(NO_MESH, "the surface is not the user's mesh, or waves displace it")                           \
  X(FEATURE, "the water has hulls, a current, a dome port or another output")                      \
  X(SHORT_SHADER, "the shader is short: opaque calm water on a level mesh")                        \
  X(PARALLEL, "the camera has a parallel projection")                                              \
  X(SUBMERGED, "the camera is in the water, or close to it")                                       \
  X(LARGE_TRIANGLES, "the triangles are large enough")                                             \
  X(SIZE, "the picture is too large for a buffer, or has more than 8 samples a pixel")             \
  X(OTHER_DRAW, "the draw is of another kind: edges, points, a selection, a translucent surface")  \
  X(TARGET, "the picture's framebuffer has no single colour and depth texture")

typedef enum water_buffer_use
{
#define WATER_BUFFER_VALUE(name, text) WATER_BUFFER_##name,
  WATER_BUFFER_LIST(WATER_BUFFER_VALUE)
#undef WATER_BUFFER_VALUE
    WATER_BUFFER_COUNT
} water_buffer_use;

enum
{
  WATER_BUFFER_SAMPLES_MAX = 8 // per pixel
};

// A surface that is about to be drawn.
typedef struct water_buffer_input
{
  bool is_on; // the user's setting
  bool is_software;
  bool is_plain_draw;         // of an opaque surface's triangles, into the picture
  water_feature_set features; // of its shader
  const water_plan* plan;     // NULL: it has no view
  double sheet[4]; // the mesh's rectangle on the plane: x from, to, y from, to; its own axes
  int viewport_px[2];
  int samples; // per pixel; 0 or 1: one
  double triangle_count;
} water_buffer_input;

// Decides on a buffer. It pays if the shader would run on many more pixels than the surface covers.
water_buffer_use water_buffer_judge(const water_buffer_input* input);

// On how many pixels a software renderer runs the shader for triangles of one size, each of which
// has its own block of pixels.
//
// area_px  of a triangle, >= 0
// samples  per pixel, >= 1: a triangle that covers none is not shaded
double water_buffer_runs(double triangle_count, double area_px, int samples);

const char* water_buffer_text(water_buffer_use use);

#ifdef __cplusplus
}
#endif
#endif
