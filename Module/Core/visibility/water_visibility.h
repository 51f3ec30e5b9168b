// SPDX-License-Identifier: BSD-3-Clause
// water_visibility.h: which parts of the reflection
// texture visible water looks up, in square cells of pixels. That is known once the eye's picture
// is there, and leaves out what only hidden water would reflect.
#ifndef water_visibility_h
#define water_visibility_h

#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_VISIBILITY_CELLS_MAX = 1 << 16 // they are found out in every frame
};

typedef struct water_visibility
{
  int texture_px[2];
  int rect_px[4];   // of the reflection texture, what the cells cover: x, y, width, height
  int cell_px;      // a side of a cell
  int size[2];      // cells per axis; the last of an axis may reach over the rectangle
  uint32_t* counts; // room for (size[0] + 1) * (size[1] + 1), rows of x: how many cells below and
                    // to the left of a corner are looked up (Crow 1984, "Summed-area tables for
                    // texture mapping")
} water_visibility;

// The pixels of the eye's picture (flipped in x, as the reflection texture is) that may look up a
// pixel of a cell: along each axis, size pixels from floor(first + step * cell) on.
typedef struct water_visibility_walk
{
  double first[2];
  double step[2];
  int size[2];
  double pixel[2]; // its size in NDC
} water_visibility_walk;

// cell_px      a side of a cell, in pixels of the reflection texture
// viewport_px  size of the eye's picture
void water_visibility_walk_of(const int texture_px[2], const int rect_px[4],
  const int viewport_px[2], int cell_px, water_visibility_walk* walk);

// The cells of a rectangle of the reflection texture: the smallest of which there are not too many,
// but not single pixels. What they tell is not set.
void water_visibility_begin(const int texture_px[2], const int rect_px[4], water_visibility* seen);

// Which cells are looked up, by the depths of the eye's picture without the water: what lies under
// the plane is seen through the water, if there is any.
//
// viewport_px  size of the eye's picture
// is_endless   the water is drawn beyond the far plane, too: over the background
// plane_clip   NDC of the eye -> height over the plane, times a positive number
// rounding     of that
// rows         first and count, of the picture: those of depths, which are at least the rows that
//              the walk asks for (water_visibility_rows)
// depths       in [0, 1], rows of x
// work         room for viewport_px[0]
// cells        rows of size[0]; 0: no pixel of the cell is looked up
void water_visibility_mark(const water_visibility* seen, const int viewport_px[2], bool is_endless,
  const double plane_clip[4], double rounding, const int rows[2], const float* depths,
  int32_t* work, uint8_t* cells);

// The rows of the eye's picture, first and count, that decide about the cells.
void water_visibility_rows(const water_visibility* seen, const int viewport_px[2], int rows[2]);

// Fills the counts.
//
// cells  rows of size[0]; 0: no pixel of the cell is looked up
void water_visibility_sum(water_visibility* seen, const uint8_t* cells);

// The cells that are not looked up, as rectangles in NDC of the reflection texture: low x, low y,
// high x, high y.
//
// boxes  room for size[1] * (size[0] + 1) / 2
//
// Returns how many there are.
size_t water_visibility_closed(const water_visibility* seen, float (*boxes)[4]);

bool water_visibility_is_open(const water_visibility* seen, int x, int y); // a cell

// Is any cell looked up that has a pixel of a rectangle?
//
// first_px, last_px  from the corner of rect_px on, inside it
bool water_visibility_has(
  const water_visibility* seen, const int first_px[2], const int last_px[2]);

// May a box have a pixel in a cell that is looked up? Conservative.
//
// to_clip   from the box's space to the reflection texture's clip space
// reach_px  how far its picture reaches beyond it, >= 0
bool water_visibility_meets(
  const water_visibility* seen, const double to_clip[16], const double bounds[6], double reach_px);

// Gives props that were to be drawn, but cannot be seen, the reason WATER_CULL_OUT_OF_WATER.
//
// skips  of the scene; without WATER_MAY_SKIP_PROPS nothing is done
void water_visibility_cull(const water_visibility* seen, const water_camera* mirrored,
  const water_prop* props, size_t prop_count, unsigned skips, water_cull_reason* reasons);

#ifdef __cplusplus
}
#endif
#endif
