// SPDX-License-Identifier: BSD-3-Clause
// water_placement.h: does a surface that a user gives lie in the water's plane? The plane is the
// mirror: a surface that lies off the plane, or stands upright, would show the wrong reflection.
//
// Waves in the surface are allowed: their heights cancel, and their slopes are small. The test
// therefore uses the mean height and the mean angle. It does not use which side of a triangle is
// its front.
#ifndef water_placement_h
#define water_placement_h

#include "water_types.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

// The state of the inspection of a surface.
typedef struct water_placement
{
  water_plane unit;
  double area;        // twice
  double level_area;  // twice, of its projection onto the plane
  double area_height; // sum of areas times heights
  double bounds[6];   // xmin, xmax, ymin, ymax, zmin, zmax in world
} water_placement;

typedef struct water_placement_verdict
{
  double height;     // mean, over the plane
  double height_max; // that is accepted, over it and under it
  double angle_rad;  // mean, to the plane
  double angle_max_rad;
  bool is_off; // the plane
  bool is_upright;
} water_placement_verdict;

// unit  normalised plane of the water
void water_placement_begin(const water_plane* unit, water_placement* placement);

// Looks at a triangle: its corners in world. What is not finite is left out.
void water_placement_add(
  const double a[3], const double b[3], const double c[3], water_placement* placement);

// Nothing is wrong with a surface without area.
water_placement_verdict water_placement_judge(const water_placement* placement);

#ifdef __cplusplus
}
#endif
#endif
