// SPDX-License-Identifier: BSD-3-Clause
// water_target.h: how large the reflection texture is, and which part of it the water can look up.
#ifndef water_target_h
#define water_target_h

#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Size of the reflection texture: the picture's size times the scale, rounded, at least 1 pixel
// each.
//
// Returns WATER_OK, WATER_BAD_VIEWPORT, WATER_BAD_TEXTURE_SCALE or WATER_TEXTURE_TOO_LARGE; then
// texture_px is unchanged.
water_status water_target_size(
  const int viewport_px[2], double texture_scale, int max_texture_px, int texture_px[2]);

// The texture scale of frames that are averaged: twice as fine, so that filtering between two
// texels is not visible in the mean. Unchanged if the GPU has no texture that large.
//
// Source: measured, Documentation/decisions/006-lookup.md.
double water_target_fine_scale(const int viewport_px[2], double texture_scale, int max_texture_px);

// The part of the picture that water within a box, or the mirror image of this water, covers. A
// point at height h over the plane looks up the place at which the picture would show its mirror
// image; for h = 0 this is its own place.
//
// eye             the eye, not the mirrored camera
// plane           normalised
// surface_bounds  of the water surface in world, finite, not empty
// box             NDC of the eye in [-1, 1]: low x, low y, high x, high y; all of it where the box
//                 has no picture (a mirror image that reaches behind the eye)
void water_target_box(
  const water_camera* eye, const water_plane* plane, const double surface_bounds[6], double box[4]);

// Widens such a part by the area that waves look up beyond it. Each pixel of the reflection texture
// shows a direction. A reflected ray is a straight line in it, from the pixel of its calm
// reflection to the pixel of its own direction, so its length is limited by the angle between the
// two. Infinite for a parallel eye.
//
// slope_max  of the waves, >= 0, may be infinite
// box        may leave [-1, 1]
void water_target_reach(const water_camera* eye, double slope_max, double box[4]);

// The rectangle of the reflection texture, which is flipped in x, for a part of the picture. Two
// texels are added all around for filtering.
//
// reflection_scale  part of the reflection texture per axis that is the picture
// rect_px    x, y, width, height; within the reflection texture, never empty
void water_target_rect(
  const double box[4], const double reflection_scale[2], const int texture_px[2], int rect_px[4]);

// The same of a view that is not flipped: the sun view and the own view.
void water_target_rect_of_eye(
  const double box[4], const double reflection_scale[2], const int texture_px[2], int rect_px[4]);

// Factor by which the mirrored frustum is wider than the eye's, so that reflected rays find what
// lies beside the picture: waves of slope s turn them by up to 2 s. In [1, 1.25]: a wider band
// costs more than it gains. 1 for a parallel eye: its rays cross so much of the reflection texture
// that the march over a wider one would lose more by its coarser steps than it gains.
double water_target_guard_band(const water_camera* camera, double slope_rms);

// Widens a reflection texture by a guard band without a change of the size of its texels.
//
// guard_band  of each axis, >= 1; less counts as 1
// texture_px  changed; even margins, and no more than max_texture_px
// reflection_scale   part of the reflection texture per axis that is the picture without the band
void water_target_widen(
  const double guard_band[2], int max_texture_px, int texture_px[2], double reflection_scale[2]);

// The guard bands of a tile of a picture. Its margins are as wide as those of the whole picture.
//
// guard_band  of the whole picture
// tile_scale  as in water_scene
void water_target_tile_bands(double guard_band, const int tile_scale[2], double bands[2]);

// The camera of the picture that a camera's picture is a tile of: with the scale of the whole, but
// not its place.
water_camera water_target_whole(const water_camera* tile, const int tile_scale[2]);

#ifdef __cplusplus
}
#endif
#endif
