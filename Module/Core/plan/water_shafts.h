// SPDX-License-Identifier: BSD-3-Clause
// water_shafts.h: in addition to the plan: light shafts: the light that waves focus, as an eye
// under water sees it in the water and on objects there.
//
// The light is that of water_caustics_plan.h, on a level bed at the eye's depth, over a square of
// places around the eye. A view ray is followed through it in steps (vtkWaterAttenuation.glsl). In
// calm water, each step scatters the same amount of light in the channel with the least extinction.
// Nothing is random: what a step cannot resolve is averaged by the texture's coarser levels.
// Source: Iwasaki, Dobashi and Nishita 2002, "An Efficient Method for Rendering Underwater Optical
// Effects Using Graphics Hardware" (shafts as single scattering of the light that waves gather).
#ifndef water_shafts_h
#define water_shafts_h

#include "water_caustics_plan.h"

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_shafts
{
  water_caustics light;  // its texture has coarser levels
  double place_to_uv[3]; // factor and offsets: a place on the plane -> the texture, in [0, 1]
  double eye_depth;      // > 0
  double fade[2]; // squared distances from the texture's middle, in uv, over which it fades to calm
  int steps;      // of a view ray
} water_shafts;

// Plans the light around an eye. It does not use viewport_px of the input.
//
// Returns false when there are no shafts: no sun over the surface, an eye that is not under it,
// rays that are parallel, a channel of light without extinction, or an eye so deep in turbid water
// that the waves spread the light much wider than it sees. Then the output is unchanged.
bool water_shafts_plan(
  const water_plan* plan, const water_caustics_input* input, water_shafts* shafts);

#ifdef __cplusplus
}
#endif
#endif
