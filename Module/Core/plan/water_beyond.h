// SPDX-License-Identifier: BSD-3-Clause
// water_beyond.h: the own view of clear water: what lies beyond its surface, as the eye itself sees
// it through the water's plane. It is wider than the picture, because refracted rays leave that.
//
// Measured, and the reason for its width: Documentation/decisions/006-lookup.md.
#ifndef water_beyond_h
#define water_beyond_h

#include "water_status.h"
#include "water_types.h"
#include "water_units.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Where the refracted colours come from.
typedef enum water_refraction_source
{
  WATER_FROM_PICTURE,
  WATER_FROM_OWN_VIEW,
  WATER_FROM_AUTOMATIC // the own view, if the picture lacks much
} water_refraction_source;

// Does the picture lack much of what a low eye sees in open water? Refracted rays leave it at its
// lower border, and objects hide each other. Seen from above they do so less, and the own view,
// whose objects are cut at the plane, would show their inside.
//
// plane  of any scale; not of an invalid one
// ahead  unit vector along which the camera looks
bool water_beyond_is_low(const water_plane* plane, const double eye[3], const double ahead[3]);

// Is it known that not all of the water has ground under it? Water to the horizon reaches beyond
// all that is under it. With the picture alone, what hides a ray hides a bed as likely as deep
// water.
bool water_beyond_is_open(water_units_bed bed, bool is_endless, water_refraction_source source);

// Is what lies beyond drawn in a view of its own? Always for a tile of a picture: refracted rays
// leave a tile, and the tiles beside it are not there to be looked up.
//
// is_open     water_beyond_is_open
// is_low      water_beyond_is_low
// tile_scale  as in water_scene
bool water_beyond_is_wanted(
  water_refraction_source source, bool is_open, bool is_low, const int tile_scale[2]);

// Size of the own view: the picture, and a band around it, without a change of the size of its
// pixels. The picture's pixels are pixels of it. The band of a tile is that of the whole picture.
//
// tile_scale     as in water_scene
// texture_px     no side longer than max_texture_px
// picture_scale  part of it per axis that is the picture, in (0, 1]
//
// Returns WATER_OK, WATER_BAD_VIEWPORT or WATER_TEXTURE_TOO_LARGE.
water_status water_beyond_size(const int viewport_px[2], const int tile_scale[2],
  int max_texture_px, int texture_px[2], double picture_scale[2]);

// A prop as the own view draws it: the prop itself, even if mirrored views draw a stand-in for it,
// or nothing. Its bounds are then not known. Rulers, too, are seen through the water, and no other
// labels.
water_prop water_beyond_prop(const water_prop* prop);

// Are translucent props and volumes kept apart in the own view, so that rays meet them where they
// are? Not with several ranks, whose own views are joined without such a layer. Not on a GPU that
// has a volume to draw: after it was drawn into a layer, an H200's main view showed it over the
// water.
bool water_beyond_keeps_layer(bool is_software, bool has_volumes, bool has_ranks);

// Widens a part of the picture that water covers, seen from above, by where its refracted rays are
// looked up. Calm, level water bends a view ray towards the vertical, so that its image moves
// from its pixel towards the vanishing point of verticals. Beside an object that hides the bed,
// places to its left and right are looked up: all of the width.
//
// dir_to_eye  of the plan
// box         low x, low y, high x, high y in NDC of the eye; may become infinite
void water_beyond_reach(const double dir_to_eye[12], double box[4]);

// The clip of the own view in the eye's view space: kept side >= 0, unit normal. A strip of some
// pixels on the eye's side of the plane is kept, too: at a shore rays look at land beside the
// water.
//
// plane_view  the plane in the eye's view space, normal towards the eye
// margin      how far the surface may rise towards the eye, >= 0
void water_beyond_clip_view(const water_camera* eye, const int viewport_px[2],
  const double plane_view[4], double margin, double clip_plane_view[4]);

// A point in clip space of the eye -> a number, as a row: the same for clip space of the own view.
//
// row  may be the same as of_own_view
void water_beyond_row(const double row[4], const double picture_scale[2], double of_own_view[4]);

// A direction in the plane's axes -> clip of the eye: the same for the own view.
void water_beyond_dirs(
  const double dir_to_eye[12], const double picture_scale[2], double dir_to_own_view[12]);

// Fills what a plan knows of the own view: camera, size, clip, and the reason for every prop.
//
// box        of the picture that the water covers, NDC of the eye
// plan       the fields of the view are set
// bad_index  the first prop that is drawn although its bounds are not finite; prop_count: none is
//
// Returns WATER_OK or the status of what cannot be planned.
water_status water_beyond_plan(const water_scene* scene, const double box[4], water_plan* plan,
  water_cull_reason* reasons, size_t* bad_index);

#ifdef __cplusplus
}
#endif
#endif
