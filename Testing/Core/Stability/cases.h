// SPDX-License-Identifier: BSD-3-Clause
// cases.h: the generated cases of the stress suite: a scene of a number, the same on every machine,
// and what is true of it in 113 bits. Nothing here calls the core.
#ifndef cases_h
#define cases_h

#include "quad.h"
#include "water_types.h"

#include <stdint.h>

enum
{
  CASE_PROPS = 6,
  CASE_SHOWN = 3 // the first props are placed where the water shows them, at the border if it can
};

typedef struct stress_case
{
  uint64_t dice; // state of the generator
  water_scene scene;
  water_prop props[CASE_PROPS];
  double size;      // of the scene
  double center[3]; // on the water
  double near_z;
  double far_z;

  // of the exact plane, the doubles of the scene as they are
  quad normal[3]; // unit length, not turned
  quad offset;
  quad length; // of the normal as it is given

  // of the exact camera, the doubles of the scene as they are
  quad view_to_world[9]; // inverse of the rotation part
  quad eye[3];           // perspective: in world
  quad height_view[4];   // row: point in view space -> height over the exact plane
  quad side;             // 1: the eye is above; -1: below; 0: neither, exactly
  quad eye_height;       // signed; parallel: minus the sine of the view direction

  int is_shown[CASE_SHOWN];  // the case has such a prop
  quad shown[CASE_SHOWN][3]; // a point of it that the water shows
} stress_case;

void case_make(uint64_t seed, uint64_t number, stress_case* made);

// In [low, high); and spread evenly over the powers of ten between two of them.
double case_roll(stress_case* from, double low, double high);
double case_roll_decades(stress_case* from, double low, double high);

quad case_height(const stress_case* of, const quad point[3]); // over the exact plane

// The exact mirror image's clip coordinates for the eye: where the water shows a point.
void case_project_mirrored(const stress_case* of, const quad point[3], quad clip[4]);

// False for most points that the water does not show, in doubles: saves the exact question.
int case_may_be_shown(const stress_case* of, const double point[3]);

// Whether the calm water shows a point, exactly: it is on the eye's side, its mirror image is
// within the eye's picture and beyond the near plane, and the line of sight crosses the plane
// within the surface's bounds.
int case_is_shown(const stress_case* of, const quad point[3]);

#endif
