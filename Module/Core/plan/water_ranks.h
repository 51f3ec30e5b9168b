// SPDX-License-Identifier: BSD-3-Clause
// water_ranks.h: what the ranks of a sort-last renderer agree on, so that each of them makes the
// same plan. Every rank has a part of the scene, and draws this part.
//
// Each rank sends what it knows as plain numbers; everything here is computed by every rank from
// all that was sent, so that equal input gives equal decisions. A rank is a process of a parallel
// program; rank 0 is the root. See Documentation/decisions/023-ranks.md.
//
// Flow, once a frame: water_rank_frame of all -> water_ranks_join_frames.
// Flow, once a mirrored view: water_rank_view of all, all props, the root's scene ->
// water_ranks_join_views -> water_ranks_scene -> water_plan_make; once its opaque part is drawn,
// water_rank_drawn of all -> water_ranks_join_drawn. Pixels: water_rank_pixels.h.
#ifndef water_ranks_h
#define water_ranks_h

#include "water_status.h"
#include "water_types.h"
#include "water_waves.h"

#ifdef __cplusplus
extern "C"
{
#endif

// Version of the next two structs and of the format in which scene and props are sent. Increase it
// with every change of these.
enum
{
  WATER_RANKS_FORMAT = 9
};

// What a rank sends once a frame, before anything is drawn: doubles only, as they travel.
typedef struct water_rank_frame
{
  double format;          // WATER_RANKS_FORMAT
  double scene_size;      // bytes of a water_scene
  double water_count;     // visible waters of the renderer that have a controller, >= 0
  double scene_bounds[6]; // of the rank's own props in world; min > max: it has none
  double is_gone;         // 1: the water that asked last is deleted; 0: it is not
  double has_error;       // 1: the rank's scene cannot be read, and it says why; 0: it can
  double automatic;       // water_ranks_digest_number of which waters choose their own extent
} water_rank_frame;

// What a rank sends for each mirrored view, before that is planned: doubles only.
typedef struct water_rank_view
{
  double sheet_count;       // waters that share the view
  double digest;            // of all that must be the same on all ranks; water_ranks_digest_number
  double prop_count;        // of the rank's own props
  double max_texture_px;    // the limit of the rank's GPU
  double is_software;       // 1: the CPU executes GL; 0: a GPU does
  double measured_ms;       // duration of the last view, for a quality that follows times
  double surface_bounds[6]; // of the water on this rank; min > max: it has none
  double has_error;         // 1: the rank cannot lay its water, and says why; 0: it can
  // What a mesh adds, of which a rank has a part, as in water_scene:
  double has_waves; // 1 or 0
  double slope_rms;
  double slope_max;
  double wave_height_max;
  double is_averaged; // 1: waves are averaged over a pixel; 0: they are not
  double max_samples; // a pixel, that the rank's GPU has; 0: none
  // Whose part of space is farthest from the eye, where the ranks' pictures are blended in
  // order; -1: they are compared by depth. The root's number counts.
  double farthest_rank;
  // By the rank's part of a mesh, too:
  double has_marched_rays; // 1: rays are traced in the reflection texture; 0: they are not
  double wants_peel;       // 1: and go on behind edges; 0: they do not
} water_rank_view;

// What the ranks agree on for a mirrored view.
typedef struct water_ranks_view
{
  size_t prop_count;        // of all ranks together
  size_t first_prop;        // of the rank's own in them: they are in the order of the ranks
  int max_texture_px;       // the least
  bool is_software;         // of any
  double measured_ms;       // the longest: a frame takes as long as its slowest rank
  double surface_bounds[6]; // all of the water
  bool has_waves;           // on any
  double slope_rms;         // the greatest
  double slope_max;
  double wave_height_max;
  bool is_averaged;      // on any
  bool has_marched_rays; // on any: all keep apart what they blend
  bool wants_peel;       // on any: all draw what is behind the first props
  int max_samples;       // the least
  int farthest_rank;     // the root's; -1: none
} water_ranks_view;

// Joins what all ranks sent for a frame.
//
// frames        rank_count of them, in the order of the ranks; rank_count >= 1
// scene_bounds  of all ranks together; min > max: there are none. Numbers that are not finite count
//               for nothing.
// bad_rank      set with an error: the first rank that differs from the root
//
// Returns WATER_OK, WATER_RANKS_DIFFERENT_VERSIONS, WATER_RANKS_BAD_WATER (of the first rank that
// has an error) or WATER_RANKS_DIFFERENT_WATERS: the same on every rank. With an error no rank may
// send anything more in this frame.
water_status water_ranks_join_frames(
  const water_rank_frame* frames, size_t rank_count, double scene_bounds[6], size_t* bad_rank);

// Have all ranks deleted the water that asked last, and do they show none? Then no rank needs to
// ask again until one is shown.
bool water_ranks_are_gone(const water_rank_frame* frames, size_t rank_count);

// Joins what all ranks sent for a mirrored view.
//
// views     rank_count of them, in the order of the ranks; rank_count >= 1
// rank      one's own, < rank_count
// bad_rank  as above
//
// Returns WATER_OK, WATER_RANKS_BAD_WATER (of the first rank that has an error),
// WATER_RANKS_DIFFERENT_WATERS (different numbers of waters share the view) or
// WATER_RANKS_DIFFERENT_LOOKS, or WATER_RANKS_NO_SUCH_RANK for a farthest rank that does not exist;
// with an error *joined is unchanged.
water_status water_ranks_join_views(const water_rank_view* views, size_t rank_count, size_t rank,
  water_ranks_view* joined, size_t* bad_rank);

// The scene that every rank plans: the root's eye, lights, sky and settings, the props of all and
// what was joined. It does not contain what only one rank's picture shows, such as whether the
// water is hidden.
//
// root   the root's scene; its props are not read
// props  joined->prop_count of them
water_scene water_ranks_scene(
  const water_scene* root, const water_ranks_view* joined, const water_prop* props);

// A checksum of numbers. Different sums prove that ranks differ; equal sums make it almost certain
// that they do not. Source: FNV-1a, 64 bits, over the numbers' bytes (Fowler, Noll, Vo).
//
// digest  of the numbers before; WATER_RANKS_DIGEST_BEGIN: there are none
uint64_t water_ranks_digest(uint64_t digest, const double* numbers, size_t count);
#define WATER_RANKS_DIGEST_BEGIN UINT64_C(14695981039346656037)

// Adds the settings of a mirrored view to a digest, field by field.
uint64_t water_ranks_digest_settings(uint64_t digest, const water_settings* settings);

// Adds waves at one time to a digest.
uint64_t water_ranks_digest_waves(uint64_t digest, const water_wave_term* terms, size_t term_count);

// A digest as a number that a double holds exactly: its upper 53 bits.
double water_ranks_digest_number(uint64_t digest);

// Does a rank's picture show the water? Where the ranks' pictures are compared by depth, all do.
// Where they are blended in order, the farthest does: the others are transparent at their water,
// so that they hide neither it nor what is in it.
//
// farthest_rank  of water_ranks_view
bool water_rank_shows_water(int farthest_rank, size_t rank);

// Is a box a part of space? Each minimum is below its maximum; both may be infinite.
bool water_rank_region_is_there(const double region[6]);

// The sides of a rank's part of space, for a surface of which the rank shows what lies in it:
// (x, y, height, 1) -> how far a point is inside. x, y: on the plane, from the point under the eye;
// height: towards the eye. The two sides of an axis come one after the other, as in bounds. A point
// on a side belongs to the part above: it is inside if the distance to a minimum is >= 0, and that
// to a maximum > 0. The two ranks of a side compute the same distance, except for its sign.
//
// plane   normalised, with the origin of its axes in world
// plan    of the view, with has_view
// region  in world; a side that is infinite contains all points
void water_rank_region_sides(const water_plane* plane, const double plane_origin[3],
  const water_plan* plan, const double region[6], double sides[6][4]);

// Numbers travel with WATER_RANKS_IS_HERE as the last one of each rank. If a rank is lost, a
// communicator may report this on its root only. On the other ranks the call then succeeds, but the
// numbers of the lost rank are the zeros that were there before.
#define WATER_RANKS_IS_HERE 1.0

// Have all ranks sent theirs? If so, the numbers of each are moved together, without that last one.
//
// numbers  count + 1 of each rank, in the order of the ranks; on return count of each
bool water_ranks_take_numbers(double* numbers, size_t count, size_t rank_count);

// The part of its picture in which a rank shows clear water: doubles only.
typedef struct water_rank_part
{
  double rect_px[4]; // x, y, width, height; nothing if one of the last two is not positive
  double samples;    // a pixel
} water_rank_part;

// The rectangle around the parts of all ranks, {0, 0, 0, 0} if none has one. Returns the samples of
// a pixel, 0 if not all ranks have as many.
//
// rank_count  >= 1
int water_ranks_join_parts(const water_rank_part* parts, size_t rank_count, int rect_px[4]);

// What a rank sends once its opaque part of a mirrored view is drawn: doubles only.
typedef struct water_rank_drawn
{
  double has_failed;        // 1: it could not draw, and says why; 0: it could
  double is_aborted;        // 1: the user, or another frame, ended the draw; 0: nothing did
  double wants_again;       // 1: its driver rejected something; 0: it did not
  double has_blended;       // 1: translucent props or volumes are to come; 0: none
  double blended_bounds[6]; // of those in world; min > max: there are none
} water_rank_drawn;

// Nothing is drawn, and nothing is blended anywhere.
water_rank_drawn water_rank_drawn_begin(void);

// Something with these bounds is blended, too; empty bounds, and numbers that are not finite, add
// nothing.
void water_rank_drawn_add(const double bounds[6], water_rank_drawn* drawn);

// What becomes of the view on all ranks.
typedef enum water_ranks_drawing
{
  WATER_RANKS_DRAW_AGAIN, // what was rejected on any rank is left out
  WATER_RANKS_ABORTED,
  WATER_RANKS_FAILED,
  WATER_RANKS_DRAWN
} water_ranks_drawing;

// Joins what all ranks sent after their draw.
//
// bounds       rank_count boxes: what each blends; empty ones of those that blend nothing
// has_blended  set: is anything blended on any rank?
// bad_rank     set with WATER_RANKS_FAILED: the first that has failed
water_ranks_drawing water_ranks_join_drawn(const water_rank_drawn* drawn, size_t rank_count,
  double (*bounds)[6], bool* has_blended, size_t* bad_rank);

#ifdef __cplusplus
}
#endif
#endif
