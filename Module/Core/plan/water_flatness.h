// SPDX-License-Identifier: BSD-3-Clause
// water_flatness.h: how high the points of a user's surface lie above the water's plane, and
// whether this is visible.
//
// A pixel of a flat surface looks up the reflection at its own place. Any other pixel also needs
// its height. The depth of the pixel is too inaccurate for this: if coordinates or the distances of
// the near and far planes are large, the rounding of the depth and of the clip coordinates exceeds
// the height. Therefore vertices compute their heights from their own coordinates.
#ifndef water_flatness_h
#define water_flatness_h

#include "water_types.h"

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The state of the inspection of a mesh.
typedef struct water_flatness
{
  double height[4];  // point in the mesh's own coordinates -> height over the plane
  double height_max; // of all points, over the plane or under it; infinity: too high
  double rounding;   // of heights: lower ones may be none
  double limit;      // higher ones are too high
  double reach;      // the height of the highest one, however high
} water_flatness;

// Heights of points in a mesh's own coordinates.
//
// unit           normalised plane of the water
// mesh_to_world  affine
//
// Returns false when the matrix is another one or not finite. Then the height is unchanged.
bool water_flatness_heights(
  const water_plane* unit, const double mesh_to_world[16], double height[4]);

// bounds     of the mesh in its own coordinates: xmin, xmax, ymin, ymax, zmin, zmax
// is_single  its coordinates are floats
//
// Returns false when there are no heights, as above.
bool water_flatness_begin(const water_plane* unit, const double mesh_to_world[16],
  const double bounds[6], bool is_single, water_flatness* flatness);

// Adds a point, in the mesh's own coordinates. Points that are not finite are ignored.
//
// Returns false if the point is too high: only reach needs the other points then.
bool water_flatness_add(const double point[3], water_flatness* flatness);

// Adds many points: rows of 3.
void water_flatness_add_points(const double* points, size_t count, water_flatness* flatness);

// Adds the points of another inspection that began with the same mesh and plane.
void water_flatness_join(const water_flatness* other, water_flatness* flatness);

// The largest distance of a point from the plane. 0: within the precision of their coordinates, the
// points lie in the plane; infinity: they do not, from any view.
double water_flatness_judge(const water_flatness* flatness);

// Does a surface look as if it lay in the plane? True if treating it as flat moves no reflection so
// far that a colour changes by 1 of 255.
//
// height_max  of water_flatness_judge
bool water_flatness_is_unseen(const water_plan* plan, double height_max, const int viewport_px[2]);

// Heights of vertices as a GPU has them, which is floats: (coordinate - shift) * scale.
//
// height  as water_flatness_heights has it
// side    of the plane that the eye is on
// bounds  of the mesh in its own coordinates
// origin  a vertex near the middle, which floats hold exactly: differences from it are exact
// rise    (vertex - origin, 1) -> height over the plane, towards the eye
void water_flatness_vertices(const double height[4], water_side side, const double bounds[6],
  const double shift[3], const double scale[3], double origin[3], double rise[4]);

// Another linear function of the points, such as a place along an axis, for the same vertices.
//
// row  point in the mesh's own coordinates -> value
// of   (vertex - origin, 1) -> value; may be row
void water_flatness_row(const double row[4], const double shift[3], const double scale[3],
  const double origin[3], double of[4]);

#ifdef __cplusplus
}
#endif
#endif
