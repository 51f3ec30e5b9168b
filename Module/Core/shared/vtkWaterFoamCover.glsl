// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamCover.glsl: how much of the water foam covers; for shaders and, by water_shared.c, for C.

// The share of the surface that a shore's foam covers: all of it along the waterline, and bands that travel towards it
// and end where the foam does.
//
// depth  of the water, over the depth at which the foam ends; >= 0
// turn   share of the time that it takes until the foam is as it was: two bands arrive in it
float waterShoreFoam(float depth, float turn)
{
  float left = max(1.0 - depth, 0.0);
  float rise = min(max((left - 0.45) / 0.4, 0.0), 1.0);
  float band = 0.5 + 0.5 * cos(6.283185307179586 * (1.5 * depth + 2.0 * turn));
  return max(rise * rise * (3.0 - 2.0 * rise), 0.8 * left * band * band);
}

// The value that a share of the lace is below: the lace is 0.65 and 0.35 times the difference between the distances of
// the two nearest of points that are scattered one to a cell, 0.38 of a cell about its middle, for two sizes of cells.
// Below it there is foam: threads between bubbles if the share is small, holes if it is large. The share comes out
// within 0.03.
//
// share  in [0, 1]
float waterFoamThreshold(float share)
{
  float share4 = share * share * share * share;
  return share <= 0.0 ? 0.0 : 0.4 * pow(share, 0.65) + 0.26 * share4 * share4 + 0.44 * pow(share, 60.0);
}
