// SPDX-License-Identifier: BSD-3-Clause
// water_normals.h: small ripples as a normal map that repeats, and how a map moves.
#ifndef water_normals_h
#define water_normals_h

#include "water_status.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_normal_map // a layer
{
  double size;          // m of water that the map covers once along each axis, in [1e-6, 1e9]
  double speed;         // m/s, of the map over the water
  double direction_rad; // direction of its motion, from the first towards the second axis
  double strength;      // factor of the map's slopes, in [-1000, 1000]
} water_normal_map;

// Returns WATER_OK, WATER_BAD_NORMAL_MAP_SIZE, WATER_BAD_NORMAL_MAP_MOTION or
// WATER_BAD_NORMAL_MAP_STRENGTH.
water_status water_normals_check(const water_normal_map* map);

// Where in a map, in shares of it in [0, 1), the place (x, y) is at a time. Exact to 1e-16 of the
// whole way for a way under 2^53 maps.
//
// x, y  m, in the plane's own axes
// time  s
void water_normals_place(
  const water_normal_map* map, double x, double y, double time, double place[2]);

// A normal map's slopes and their squares, for a texture whose mip levels keep both moments.
//
// pixels    channels * count bytes: red, green and blue are the normal, from -1 to 1 as 0 to 255
// channels  3 or 4
// texels    4 * count numbers, written: slope x, slope y and their squares; at most 20
void water_normals_texels(
  const unsigned char* pixels, size_t channels, size_t count, float* texels);

// Fills a normal map: 40 sines with whole wave numbers from 2 to 20 a side and random directions,
// in the manner of short waves: as much slope at all lengths. The rms slope is 0.1. Red and green
// are the normal's first two parts, blue the third, from -1 to 1 as 0 to 255.
//
// size    texels a side, >= 64
// seed    the same seed gives the same map
// pixels  3 * size * size bytes, rows along the second axis
void water_normals_fill(size_t size, uint64_t seed, unsigned char* pixels);

#ifdef __cplusplus
}
#endif
#endif
