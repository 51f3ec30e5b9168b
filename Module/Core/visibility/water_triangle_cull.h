// SPDX-License-Identifier: BSD-3-Clause
// water_triangle_cull.h: finds triangles that change no pixel of the reflection texture that is
// looked up. Most triangles of a large mesh are such: they lie between the centres of pixels, under
// the water, where only hidden water would show them, or behind what is drawn before them. With
// software rendering each costs as much as several pixels.
//
// Hidden triangles are found as in Greene, Kass, Miller 1993, "Hierarchical Z-Buffer Visibility",
// with one level. Each drawn triangle stores its largest depth at the pixels that it covers however
// its corners are rounded. A triangle is left out if the depths at all of its pixels are smaller.
#ifndef water_triangle_cull_h
#define water_triangle_cull_h

#include "water_types.h"
#include "water_visibility.h"

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_points // xyz, one of the two
{
  const float* floats;
  const double* doubles;
} water_points;

static inline void water_points_get(const water_points* points, size_t number, double place[3])
{
  for (size_t i = 0; i < 3; ++i)
  {
    const size_t at = 3 * number + i;
    place[i] = points->floats ? (double)points->floats[at] : points->doubles[at];
  }
}

typedef struct water_triangle_cull_view
{
  double origin[3];             // in the mesh's own coordinates: the GPU's are relative to it
  double to_clip[16];           // from those to the reflection texture's clip space
  double kept[4];               // half-space in those: what is drawn
  double reach;                 // of the numbers that cancelled in it (water_frustum.h)
  int texture_px[2];            // of the reflection texture
  int rect_px[4];               // its drawn part: x, y, width, height
  int columns[2];               // of that, first and end: the tested part
  bool has_samples;             // of several places in a pixel, not of its middle alone
  double grid_px;               // of the places that the GPU puts corners at
  const water_visibility* seen; // of the drawn part; NULL: all of it is looked up
  float* depths; // rows of x of the drawn part, in NDC: nothing behind is seen; NULL: not known
  bool is_solid; // every pixel that a triangle covers gets its colour and depth
} water_triangle_cull_view;

// Sets the depths of a drawn part to those before anything is drawn.
//
// seen    NULL: all of it is looked up
// depths  room for rect_px[2] * rect_px[3]
void water_triangle_cull_begin(const int rect_px[4], const water_visibility* seen, float* depths);

// How far single precision may move what is drawn.
typedef struct water_triangle_cull_slack
{
  double clip[3]; // x, y in pixels and z in NDC, times w
  double height;  // over the kept half-space's plane, in its units
} water_triangle_cull_slack;

// For what lies in a box, relative to the view's origin. The bound: a product of single-precision
// matrix and point, in any order of its sums, is off by less than 16 units in the last place of the
// sum of its terms' sizes (Higham 2002, "Accuracy and Stability of Numerical Algorithms", 2nd ed.,
// section 3.5: n + 2 = 6 units, and two for the matrix' and the point's own rounding).
void water_triangle_cull_allow(
  const water_triangle_cull_view* view, const double box[6], water_triangle_cull_slack* slack);

typedef struct water_corner // of triangles
{
  double clip[4];
  double w_inverse; // of the following the sense is lost where clip[3] <= 0
  double px[2];     // from the corner of the drawn part
  double depth;     // NDC
  double height;    // over the plane of what is kept
} water_corner;

void water_triangle_cull_project(const water_triangle_cull_view* view, const water_points* points,
  size_t number, water_corner* corner);

// May a triangle change a pixel? Conservative. One that may is to be drawn: it leaves its depths.
bool water_triangle_cull_add(const water_triangle_cull_view* view,
  const water_triangle_cull_slack* slack, const water_corner* const corners[3]);

#ifdef __cplusplus
}
#endif
#endif
