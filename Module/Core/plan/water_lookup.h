// SPDX-License-Identifier: BSD-3-Clause
// water_lookup.h: what a shader needs to look waves up in the
// reflection texture: places on the plane, and rays in the reflection texture's window.
//
// Waves turn the surface's normal, so that a pixel's reflected ray no longer meets the reflection
// texture where the pixel is. A ray is a straight line in the reflection texture's window, depth
// included; the shader walks it and compares with the reflection texture's depth. Coordinates are
// relative to the point below the eye, so they are small near the eye.
#ifndef water_lookup_h
#define water_lookup_h

#include "water_camera.h"
#include "water_status.h"
#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// The plane's axes as the lookup uses them.
typedef struct water_axes
{
  double x_dir[3]; // with y_dir the plane's own axes, of the plane as the user turned it
  double y_dir[3];
  double normal[3]; // towards the eye
  double origin[3]; // of the plane's own axes, in world
} water_axes;

// Those of a plane seen from a side.
//
// plane   normalised, as the user turned it
// origin  of the plane's own axes, in world
void water_lookup_axes(
  const water_plane* plane, water_side side, const double origin[3], water_axes* axes);

// The place on the plane at which a pixel of the eye looks.
//
// plane         normalised, normal towards the eye
// origin_xy     of the point under the eye, in the plane's own axes
// ndc_to_plane  (x, y, 1) in NDC of the eye -> (x, y, w), from origin_xy on; the largest entry is 1
//               or -1
//
// Returns WATER_OK or WATER_BAD_CAMERA (the plane is seen edge-on). On an error, the outputs are
// unchanged.
water_status water_lookup_places(const water_camera* camera, const water_eye* eye,
  const water_plane* plane, const water_axes* axes, double origin_xy[2], double ndc_to_plane[9]);

// Depth of the surface in a pixel: (x, y, 1) in NDC and 1 / w -> z in NDC, also outside [-1, 1]. In
// perspective it follows from w, for any height of the surface. In parallel projection w is 1, and
// the surface is treated as the plane.
//
// plane_clip, clip_w  of water_plan
void water_lookup_pixel_depth(
  const double plane_clip[4], const double clip_w[4], double pixel_depth[4]);

// Directions in the plane's axes (the third towards the eye) -> clip of a camera, not divided by w:
// where a ray ends. 4 rows of 3.
void water_lookup_dirs(const water_camera* camera, const water_axes* axes, double dir_to_clip[12]);

// The point under the eye in the repeating pattern of foam, m: within 2048 m, so that a float can
// hold it.
//
// origin_xy        of that point, in the plane's own axes
// metres_per_unit  > 0
void water_lookup_pattern(const double origin_xy[2], double metres_per_unit, double pattern_xy[2]);

// Phase of the foam's period of 12 s, in [0, 1).
//
// time  s, finite
double water_lookup_pattern_turn(double time);

// The part of the picture that can be visible through the surface. For an eye above a flat surface
// it is the part below the plane's horizon, which contains everything below the plane and the ends
// of all rays that go down from it. For any other eye or surface it is the whole picture.
//
// is_flat  the surface lies in the plane exactly
// rect_px  left, bottom, width and height; all 0: there is none
void water_lookup_under(
  const water_plan* plan, bool is_flat, const int viewport_px[2], int rect_px[4]);

// A direction of the world in the plane's axes (the third towards the eye), at unit length.
//
// Returns false, and leaves the output unchanged, if its length is 0 or not finite.
bool water_lookup_local(const water_axes* axes, const double dir[3], double local[3]);

// Directions in the plane's axes -> (right, up, back) of a picture of the surroundings: back =
// right x up, which is made orthogonal to up first. Parallel ones, or ones without a length, give
// the world's x, y and z. As vtkSkybox has it.
void water_lookup_environment(
  const water_axes* axes, const double up[3], const double right[3], double dir_to_environment[9]);

// Does the point of the plane below or above the eye lie within the surface's bounds? An eye below
// the plane is then in the water. False for a parallel eye, which has no position.
//
// plane           normalised
// surface_bounds  of the surface in world; NULL: it has no end
bool water_lookup_is_at_surface(const water_camera* camera, const water_eye* eye,
  const water_plane* plane, const double surface_bounds[6]);

// Does a part of the near plane lie on the other side of the water than the eye? The surface in
// front of the near plane is not drawn.
//
// plane_view  normal towards the eye
bool water_lookup_cuts_surface(const water_eye* eye, const double plane_view[4]);

// The reflection texture's window depth at infinity, beyond 1 for a perspective reflection texture,
// and how far a ray may be from the reflection texture's depth to have met it, in shares of
// (z_infinity - depth).
//
// tolerance  [0]: of a ray that converged on a surface; [1]: the largest difference between the
//            depths on both sides of a crossing that is a surface and not a silhouette
// Source: measured, Documentation/decisions/006-lookup.md.
void water_lookup_depths(const water_camera* mirrored, double* z_infinity, double tolerance[2]);

// The rows that give heights over the plane from NDC (x, y, z, 1) of the reflection texture: the
// height divided by w, and 1 / w.
//
// plane_view  in the eye's view space, normal towards the eye
//
// Returns WATER_OK or WATER_BAD_CAMERA. On an error, the outputs are not set.
water_status water_lookup_heights(const water_camera* mirrored, const double plane_view[4],
  double reflection_height[4], double reflection_w[4]);

// Height that a texel of the reflection texture spans, over w of what it shows; infinite straight
// down.
double water_lookup_texel(const double dir_to_reflection[12], const int texture_px[2]);

// Locates the waterline of the objects in the reflection texture. The texture has nothing below the
// water, so a filtered read next to the waterline would mix in what lies behind the object.
//
// reflection_height  of water_lookup_heights
// waterline          what the height over the plane / w gains per texel in x and y, at one depth;
//                    the texture's size, texels
void water_lookup_waterline(
  const double reflection_height[4], const int texture_px[2], double waterline[4]);

// Depth to which props reach under a plane, >= 0: a ray that is deeper meets none of them. Props
// that are not shown, or have no bounds, are ignored.
//
// plane  normalised, normal towards the eye
double water_lookup_bottom(const water_plane* plane, const water_prop* props, size_t prop_count);

// Height above a plane, >= 0, below which all drawn props lie: a ray that rises above it sees the
// sky. Infinite if a drawn prop has no bounds.
//
// plane  normalised, normal towards the eye
double water_lookup_top(const water_plane* plane, const water_prop* props, size_t prop_count,
  const water_cull_reason* reasons);

// Height above a plane at which a ray ends, above everything that it can meet. A flat bed or
// ceiling lies at the top itself, where rounding would decide whether the ray meets it.
//
// top  as of water_lookup_top, or infinite
double water_lookup_end(double top);

// Smallest difference between the colours of two neighbouring pixels at which both get that many
// rays: a share of white, 1 / (4 rays). Smaller differences are not worth the rays.
//
// rays  of such a pixel; below 1 counts as 1
//
// Source: measured, Documentation/decisions/006-lookup.md.
double water_lookup_contrast(int rays);

// Minimum of samples per pixel of a calm reflection where waves would have several rays: calm water
// has no rays.
int water_lookup_calm_samples(int rays);

// Does a drawn prop surround the eye, as a dome does that represents the sky? Its bounds contain
// the eye and reach above the plane by at least a quarter of their widest side; land around the eye
// is lower. Behind an object there may then be the dome instead of the background.
//
// plane  normalised, normal towards the eye
//
// Source: chosen; half a sphere reaches half of its widest side.
bool water_lookup_is_enclosed(const water_plane* plane, const water_eye* eye,
  const water_prop* props, size_t prop_count, const water_cull_reason* reasons);

#ifdef __cplusplus
}
#endif
#endif
