// SPDX-License-Identifier: BSD-3-Clause
// water_waves.h: sine and Gerstner waves: dispersion, the surface at (x, y, t), buoys, shader rows.
//
// x and y are in the plane's own axes, z is height over the plane at rest, all in metres; time in
// seconds. A wave is height = A sin(angle), angle = k . x + phase - omega t; a steep one also moves
// its points by Q A cos(angle) along its direction, towards the crests.
// Sources: Fournier and Reeves 1986, "A Simple Model of Ocean Waves"; Finch 2004, "Effective Water
// Simulation from Physical Models" (GPU Gems, chapter 1).
//
// Time is as exact at 1e7 s as at 0. A phase is the product of two doubles, frequency and time; its
// whole turns are removed with an error below 2^-53 turn (1e-15 rad) at any time. The frequency
// itself has four roundings. They equal a shift in time of at most 5e-16 t, or three steps between
// neighbouring doubles at t, which is the precision of the caller's own time. Positions are treated
// in the same way. Flow: water_waves_at checks the waves and converts them to terms for one time;
// all other functions read terms.
#ifndef water_waves_h
#define water_waves_h

#include "water_status.h"

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_AMPLITUDE_MAX 1e9 // m: the shaders have floats

typedef struct water_wave
{
  double amplitude;     // m, half the height from trough to crest, in [0, WATER_AMPLITUDE_MAX]
  double wavelength;    // m, > 0
  double direction_rad; // of travel, from the first towards the second axis
  double phase_rad;     // of the origin at time 0
  double steepness;     // Q in [0, 1]: 0 is a sine, 1 Gerstner's trochoid
} water_wave;

typedef struct water_wave_term // a wave at one time; written by water_waves_at
{
  double dir[2];         // unit length
  double turns_per_m[2]; // wave vector / (2 pi)
  double k;              // rad/m
  double amplitude;      // m
  double steepness;
  double turns; // phase of the origin, in [-1/2, 1/2]
} water_wave_term;

typedef struct water_wave_point
{
  double displacement[3]; // m; from (x, y, 0) at rest to the surface
  double normal[3];       // unit length; the third is along the plane's normal
  double slope[2];        // dz/dx and dz/dy of the surface at this time; 0 on a cusp
  double jacobian;        // area over the plane per area at rest; 0 on a cusp, never less
} water_wave_point;

typedef struct water_wave_sum // of waves at a point at rest
{
  double moved[3];    // from the place at rest
  double gradient[2]; // of the height by the point at rest
  double stretch[3];  // xx, xy, yy of d place / d rest: symmetric; 1, 0, 1 where no wave is
} water_wave_sum;

// Adds waves that are no terms, as a sea's, at a place at rest; false: the place is too far.
typedef bool water_waves_add(const void* context, double x, double y, water_wave_sum* sum);

typedef struct water_wave_others
{
  water_waves_add* add;
  const void* context;
  double across; // how far they move a point in the plane
} water_wave_others;

typedef struct water_wave_row // a wave for the shader
{
  float k[2];      // rad/m
  float amplitude; // m
  float phase;     // rad in [-pi, pi], of the rows' own origin
  float steepness;
} water_wave_row;

// Angular frequency of a wave, sqrt(g k tanh(k depth)), g = 9.80665 m/s^2; no surface tension, so
// waves under some 5 cm are slower than real ones.
//
// k      rad/m, >= 0
// depth  m, > 0; infinity is deep water
// omega  rad/s
//
// Returns WATER_OK, WATER_BAD_WAVENUMBER or WATER_BAD_DEPTH. On an error, omega is unchanged.
// Source: Airy 1845, "Tides and Waves".
// Used only by tests, as a reference.
water_status water_waves_omega(double k, double depth, double* omega);

// The inverse: the wave number of an angular frequency, within 1e-14 of itself. Newton's method on
// y tanh y = omega^2 depth / g from Guo's start, which is within 1 %: each step squares the error,
// and four leave only rounding.
//
// Returns WATER_OK, WATER_BAD_FREQUENCY (also one whose wave number is no finite double) or
// WATER_BAD_DEPTH. On an error, k is unchanged.
// Source: Guo 2002, "Simple and Explicit Solution of Wave Dispersion Equation".
water_status water_waves_wavenumber(double omega, double depth, double* k);

// Checks waves; the first wrong one is the bad_index, for WATER_WAVES_FOLD the one that reached 1.
// The sum of k A Q <= 1 is exact for one wave and on the safe side for several.
//
// Returns WATER_OK, or WATER_BAD_WAVE_AMPLITUDE, WATER_BAD_WAVELENGTH, WATER_BAD_WAVE_DIRECTION,
// WATER_BAD_WAVE_PHASE, WATER_BAD_STEEPNESS or WATER_WAVES_FOLD; bad_index is set only then.
water_status water_waves_check(const water_wave* waves, size_t count, size_t* bad_index);

// The waves at one time.
//
// depth    m, > 0; infinity is deep water
// terms    count of them, written
// bad_index  as above, unless the waves are good
//
// Returns WATER_OK, WATER_BAD_DEPTH, WATER_BAD_TIME, or as water_waves_check. On an error, terms
// are unchanged.
water_status water_waves_at(const water_wave* waves, size_t count, double depth, double time,
  water_wave_term* terms, size_t* bad_index);

// The surface's point that is at (x, y) when the water is at rest. x and y are finite.
// Used only by tests, as a reference.
void water_waves_point(
  const water_wave_term* terms, size_t count, double x, double y, water_wave_point* point);

// The surface over a place: for buoys and picks. point->displacement[2] is the height there.
//
// The point at rest is found by Newton's method with halved steps; the map from rest to place is
// the gradient of a convex function while the waves do not fold, so that it has one solution. The
// place is met within 8 roundings of the reach R = sum of Q A, or as near as rounding of the angles
// lets it. With s = sum of k A Q the error of the height is no more than the sum of k A times that,
// over 1 - s; at s = 1 exactly, on a cusp, it is below 1e-9 A.
//
// rest  the point at rest, x and y
//
// Returns WATER_OK or WATER_BAD_POINT (not finite, or too far for its phase). On an error, rest and
// point are unchanged.
water_status water_waves_find(const water_wave_term* terms, size_t count, double x, double y,
  double rest[2], water_wave_point* point);

// The same with other waves in addition to the terms. They may fold, and their derivatives may be
// approximate. The place is found within 1e-6 of their reach; where the surface folds over itself,
// the nearest place that the search reaches is used. Where the surface is steeper than breaking
// waves (an area below water_waves_least_area), the normal is that of an area of that size.
//
// others  NULL: none
water_status water_waves_find_all(const water_wave_term* terms, size_t count,
  const water_wave_others* others, double x, double y, double rest[2], water_wave_point* point);

// Lower limit of the area relative to that at rest, for a sea's normals: at smaller areas, crests
// have broken.
double water_waves_least_area(void);

// Root mean square height (m) and slope of checked waves, no two of the same wave vector:
// sqrt(sum A^2 / 2), sqrt(sum (k A)^2 / 2). Per area at rest and of the sines; steepness moves both
// by the order of s^2.
void water_waves_rms(const water_wave* waves, size_t count, double* height, double* slope);

// The wave number that represents all of them, rad/m: rms slope over rms height; 0 without waves.
double water_waves_number(const water_wave* waves, size_t count);

// Upper limit of the slopes with which reflections on checked waves are looked up: the steepest
// slope that all waves together can have, sum k A / (1 - sum s k A), times 4 for the facets that
// stand for waves within a pixel (1.4 times the rest of the slopes, and as much for facets that
// turn to a low eye) and the blur between them. Infinite for waves that are about to fold.
double water_waves_looked_up(const water_wave* waves, size_t count);

// Tilts a unit normal by the slope of other waves on top: it keeps its own slope and gets theirs.
void water_waves_tilt(const double slope[2], double normal[3]);

// Converts waves to a scene's units, given the units per metre (> 0).
void water_waves_scale(double units_per_m, water_wave_term* terms, size_t count);

// How far waves can move a point at most: up or down (the sum of the amplitudes), and in the plane.
void water_waves_reach(const water_wave* waves, size_t count, double* height, double* across);

// Newton steps that a shader takes to the point at rest: one from the chord that a displaced
// triangle is to the waves, three from a place on a flat sheet, none where no wave moves its
// points.
int water_waves_rest_steps(bool is_displaced, bool is_steep);

// Tolerance of the reflection texture's heights, m: a displaced surface treats what is lower than
// this as submerged.
//
// height_max  of water_waves_reach
double water_waves_slack(double height_max);

// The rows for the shader, as floats. Their phases are those at the origin (x, y). A shader first
// subtracts this origin from its coordinates, so that floats are precise enough near the eye.
//
// rows  count of them
void water_waves_rows(
  const water_wave_term* terms, size_t count, double x, double y, water_wave_row* rows);

#ifdef __cplusplus
}
#endif
#endif
