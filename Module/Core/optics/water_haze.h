// SPDX-License-Identifier: BSD-3-Clause
// water_haze.h: the light that the water scatters towards an eye in it, by the direction, the depth
// and the length of the way.
//
// Quasi-single scattering (water_medium.h). The daylight falls off as exp(-Kd depth); a place of
// the way scatters a part of it towards the eye, by the angle to the sun's refracted light; a beam
// loses c = a + b per metre on its way to the eye. The integral has a closed form,
// waterHazeOver of vtkWaterHaze.glsl. It is scaled so that a look straight down from just under the
// surface, without an end, shows the water's deep colour: what an eye over the water sees.
//
// The result is the colour H of mix(H, colour, exp(-c way)): the light that the way adds, divided
// by the share of white light that it takes away. With daylight that is the same everywhere and no
// directions it is the deep colour.
#ifndef water_haze_h
#define water_haze_h

#include "water_medium.h"

#ifdef __cplusplus
extern "C"
{
#endif

typedef struct water_haze_input
{
  double deep[3];       // colour of deep water, linear, just under the surface, straight down
  double extinction[3]; // 1/m, as it is used
  water_medium medium;  // 1/m, as it is known: how much of its scattering is that of molecules
  double index;         // of refraction, >= 1
  double daylight[3];   // water_daylight.h
  double sun_color[3];  // of the sun's light: a white card that faces it
  double sun_dir[3];    // towards the sun in the air, unit length, third axis up; not up: no sun
} water_haze_input;

typedef struct water_haze
{
  double diffuse[3];   // Kd, 1/m
  double sun_dir[3];   // towards the sun's refracted light, unit length, third axis up
  double particles[3]; // light of the sun, times waterHazeParticles
  double molecules[3]; // the same, times waterHazeMolecules
  double sky[3][4];    // all other light: coefficients of 1, fall, fall^2, fall^3
} water_haze;

// Kd = 1.0395 D0 (a + b) for each channel. D0 is the mean length of the light's way per depth just
// under the surface: 1 / cos of the refracted sunlight, 1.197 for the light of the sky.
// Source: Gordon 1989 (as water_type_medium).
void water_haze_find(const water_haze_input* input, water_haze* haze);

// The share of the haze for an eye just under the surface. An eye over the water sees one colour,
// the deep colour, so the haze begins with this colour. Its dependence on depth and direction fades
// in with the depth of the eye, up to an optical depth of 0.1.
//
// extinction  1/m, of green
// depth       of the eye, m; 0: over the water
//
// Returns a number from 0 to 1.
double water_haze_share(double extinction, double depth);

// The smallest fall that the polynomial of the sky's light is for; use this for smaller ones.
#define WATER_HAZE_FALL_MIN (-0.7)

// The colour H of a way, linear; for tests, shaders have vtkWaterHazeFS.glsl.
//
// dir    of the way, unit length, third axis up
// depth  of its start, m
// way    m
void water_haze_color(const water_haze* haze, const double extinction[3], const double dir[3],
  double depth, double way, double color[3]);

#ifdef __cplusplus
}
#endif
#endif
