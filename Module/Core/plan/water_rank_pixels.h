// SPDX-License-Identifier: BSD-3-Clause
// water_rank_pixels.h: the pixels that the ranks of a sort-last renderer send each other: in few
// bytes, the nearest of two ranks' pixels, and blended layers in the order of their depth.
//
// Only pixels that show something are sent, as runs: the active pixels of Ma et al., "Parallel
// volume rendering using binary-swap compositing", IEEE CG&A 14(4), 1994. Colours that repeat are
// sent once. Window depth is linear over a flat facet, so its second difference usually takes one
// byte. The compression is lossless.
#ifndef water_rank_pixels_h
#define water_rank_pixels_h

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Depth where nothing is drawn.
#define WATER_RANK_NOTHING UINT32_MAX

enum
{
  WATER_RANK_SAMPLES_MAX = 32 // of a pixel
};

// A part of a picture.
typedef struct water_rank_picture
{
  uint32_t* colors;   // words for each pixel: 1 for bytes, 2 for half floats, 4 for floats
  uint32_t* depths;   // 0 at the near plane; NULL: a layer, which is where a colour is not 0
  size_t words;       // 1 to 4
  size_t pixel_count; // with samples: of all pixels' samples
  size_t samples;     // of a pixel, next to each other, <= WATER_RANK_SAMPLES_MAX; 0 and 1: none
} water_rank_picture;

typedef enum water_rank_merge
{
  WATER_RANK_NEAREST, // keep what is nearer; of equal ones, what was there before
  WATER_RANK_REPLACE  // take what is sent
} water_rank_merge;

// Converts depths to the numbers that are sent, and back. Floats of at least 2^-8 are restored
// exactly, others within 2^-32. (A texture with fixed-point depths rounds each time a float is
// written to it.)
//
// depths  in [0, 1]; 1: nothing is drawn
void water_rank_pixels_from_depths(const float* depths, size_t count, uint32_t* numbers);
void water_rank_pixels_to_depths(const uint32_t* numbers, size_t count, float* depths);

// The most bytes that a picture takes.
size_t water_rank_pixels_limit(const water_rank_picture* picture);

// Writes a picture.
//
// has_background  also the colours of pixels where nothing is drawn
// bytes           of water_rank_pixels_limit
//
// Returns how many bytes it takes.
size_t water_rank_pixels_encode(
  const water_rank_picture* picture, bool has_background, unsigned char* bytes);

// Merges a received picture into another one of the same size. Pixels of a layer are always
// replaced if they were sent.
//
// Returns false when the bytes are no such picture; what was read until then stays.
bool water_rank_pixels_merge(const unsigned char* bytes, size_t byte_count, water_rank_merge merge,
  water_rank_picture* picture);

// Blends a layer over another, both premultiplied by their alpha: 4 bytes a pixel with 1 word,
// 4 floats with 4 words. Source: Porter and Duff, "Compositing digital images", 1984.
//
// back  what is behind; then the result
void water_rank_pixels_over(
  const uint32_t* front, size_t words, size_t pixel_count, uint32_t* back);

// The order, from front to back, in which the layers of several boxes are blended. It is correct if
// an axis separates each two boxes and no boxes hide each other in a cycle, which is always so for
// the parts of a k-d tree. Boxes that no axis separates are sorted by the distance of their
// centres.
//
// bounds       box_count boxes, xmin xmax ymin ...; empty ones (min > max) come last
// eye          world
// focal_point  that the eye looks at: not the eye's place
// is_parallel  the eye looks along one direction everywhere
// order        box_count numbers of boxes
// blockers     box_count numbers to compute with
void water_rank_pixels_order(const double (*bounds)[6], size_t box_count, const double eye[3],
  const double focal_point[3], bool is_parallel, size_t* order, size_t* blockers);

#ifdef __cplusplus
}
#endif
#endif
