// SPDX-License-Identifier: BSD-3-Clause
// water_caustics_plan.h: in addition to the plan: caustics: the points of the surface whose light
// is traced to the bed, and the position of the texture of light.
//
// The light is traced from the surface down. A grid of points of the surface is refracted; each
// takes the light of its cell to the bed that the eye's picture shows and spreads it there over an
// ellipse: the cell's own image, the sun's disc and the texel together. The ellipses are added up
// in a texture that lies over the eye's picture. All light of a cell arrives somewhere: light is
// conserved, and folds of it add up. Sources: Shah, Konttinen and Pattanaik 2007, "Caustics
// Mapping" (points of the surface, received in image space); Schjoth, Frisvad, Erleben and Sporring
// 2007, "Photon Differentials" (each spreads by its derivatives); Zwicker, Pfister, van Baar and
// Gross 2001, "EWA Volume Splatting" (ellipse and pixel as one covariance).
//
// Places are in the plane's axes from water_plan.origin_xy on; depths are under the plane, > 0.
#ifndef water_caustics_plan_h
#define water_caustics_plan_h

#include "water_types.h"

#ifdef __cplusplus
extern "C"
{
#endif

// What the plan does not know.
typedef struct water_caustics_input
{
  double index;       // of the water, > 1
  double slope_rms;   // of the waves, >= 0
  double extinction;  // the least of the colours', per unit of length, >= 0
  int viewport_px[2]; // of the eye's picture
  int max_texture_px; // the GPU's limit for a side
  bool is_software;   // no GPU: the CPU adds the light up
  double port_radius; // of the eye's dome port; 0: it has none
} water_caustics_input;

// A point of the bed is identified by its place: the point of the plane through which calm water
// would light it. With calm water, the place does not depend on the depth of the bed, and all
// places get the same light. The texture of light has the places where the eye would see them at
// the middle depth.
typedef struct water_caustics
{
  int texture_px[2];        // of the light
  int bed_px[2];            // of the bed's depths, over the picture
  int count[2];             // points of the grid, along its two sides
  bool is_added;            // the CPU adds the light up; it is not drawn
  bool is_level;            // the bed is level at depth, whatever the picture shows
  double sun_dir[3];        // towards the sun, unit length, the third > 0: out of the water
  double index;             // of the water
  double depth;             // the deepest that light is followed to
  double middle;            // depth
  double search[2];         // depths: beds are searched from, and read at beyond the picture
  double texel_of_ndc[4];   // NDC of the eye at the middle depth times the first two, plus the
                            // others: texels
  double grid_to_source[9]; // (x, y, 1), in [0, 1] over the grid -> (x, y, w): a place on the plane
  double place_to_light[9]; // (x, y, 1), a place on the plane -> (x, y, w) in texels
  double place_to_clip[9]; // (x, y, 1), a place on the plane -> x, y and w in clip space of the eye
  double rise_clip[3];     // what a height over the plane of 1 adds to that
  double calm_way[2];      // horizontal displacement of light in calm water, per depth
  double turn[3];          // change of that by the surface's slope: xx, xy, yy
  double sun_spread[3]; // covariance xx, xy, yy of the sun's disc on a level bed, per depth squared
  double near[3]; // (x, y, 1) in NDC -> 1 where a pixel is too wide for caustics, 2 where it is not
} water_caustics;

// Plans the grid and the texture. An eye whose dome port reaches into the water sees the bed along
// straight rays, from as near as the port: the texture lies where these see it.
//
// Returns false when there is no light to gather: no sun, an eye that is in the water or under the
// plane, nothing under the plane, or a camera without places on it. Then the output is unchanged.
bool water_caustics_plan(
  const water_plan* plan, const water_caustics_input* input, water_caustics* caustics);

#ifdef __cplusplus
}
#endif
#endif
