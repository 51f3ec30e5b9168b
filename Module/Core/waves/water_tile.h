// SPDX-License-Identifier: BSD-3-Clause
// water_tile.h: a wind sea on a square that repeats: random amplitudes, and the spectrum at a time.
//
// The surface is the sum over wave vectors (2 pi / length) (i, j) of h exp(i k . x); an inverse FFT
// without scale makes it. A spectrum is size * size complex numbers (real, imaginary), the x index
// fastest, in the order of an FFT: indices from size / 2 on stand for index - size. The mean and
// the highest frequency (index size / 2), which has no partner, are left 0.
// Source: Tessendorf 2001, "Simulating Ocean Water".
// Flow: water_tile_amplitudes once -> water_tile_at for each time -> water_tile_derive ->
// water_tile_pack -> FFT; water_tile_time.h has the same in less time. What comes out are values at
// the places (column, row) length / size; the surface between them is bilinear by definition, for
// buoys and shaders alike.
#ifndef water_tile_h
#define water_tile_h

#include "water_spectrum.h"

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define WATER_TILE_SHORTEST 370.0 // rad/m, of the waves that count (water_spectrum.h)

typedef struct water_tile
{
  size_t size;   // points a side, even, 4 to 16384
  double length; // m a side, in [0.001, 1e9]
  double period; // s after which the sea repeats itself exactly, >= 0; 0: it never does
  uint64_t seed; // the same seed gives the same sea
  double k_low;  // rad/m: shorter wave vectors are left out, >= 0
  double k_high; // and those from here on, > k_low; 0: the Nyquist wave number pi size / length
} water_tile;

typedef enum water_tile_field
{
  WATER_TILE_SLOPE_X,
  WATER_TILE_SLOPE_Y,
  WATER_TILE_CHOP_X, // horizontal displacement towards the crests; a Gerstner wave's of steepness 1
  WATER_TILE_CHOP_Y
} water_tile_field;

// Returns WATER_OK, WATER_BAD_TILE_SIZE, WATER_BAD_TILE_LENGTH, WATER_BAD_PERIOD,
// WATER_BAD_WAVENUMBER (the band), or as water_sea_check. The functions that return nothing require
// a checked tile.
water_status water_tile_check(const water_tile* tile, const water_sea* sea);

// Are two tiles the same?
bool water_tile_is_same(const water_tile* a, const water_tile* b);

// The amplitudes h0: normal numbers times sqrt(S(k) dk^2) / 2, S at the cell's middle. The normal
// numbers belong to (i, j) and the seed, not to the size: a finer tile of the same length has the
// same waves, and more. They have the same bits everywhere; S is as exact as the C library's pow
// and exp, so amplitudes agree within some 1e-14 of themselves between machines.
//
// Expected variance of the surface: the sum of S dk^2 over the tile; within 1 % of the integral of
// S for a length of at least 10 peak wavelengths.
//
// amplitudes  2 * size * size numbers, written
//
// Returns as water_tile_check. On an error, amplitudes are unchanged.
water_status water_tile_amplitudes(
  const water_tile* tile, const water_sea* sea, double* amplitudes);

// Frequency, in turns per second, of the wave with i and j wavelengths along the tile's sides. If
// the tile has a period, the frequency is in turns per period, rounded to a whole number of at
// least 1. Of a checked tile and sea.
double water_tile_frequency(const water_tile* tile, const water_sea* sea, size_t i, size_t j);

// The time that such frequencies multiply: s, or periods since the last whole one, in (-1, 1).
double water_tile_clock(const water_tile* tile, double time);

// The spectrum of the height at a time: h0(k) exp(-i w t) + conj(h0(-k)) exp(i w t), which travels
// along k and has a real surface: h(-k) = conj(h(k)). Phases are reduced as in water_waves.h.
//
// height  2 * size * size numbers, written; not amplitudes
//
// Returns as water_tile_check, or WATER_BAD_TIME. On an error, height is unchanged.
water_status water_tile_at(const water_tile* tile, const water_sea* sea, const double* amplitudes,
  double time, double* height);

// The spectrum of a field that follows from the height: slopes i k h, chop i k/|k| h.
//
// field  one of the list
// out    2 * size * size numbers, written; may be height
void water_tile_derive(
  const water_tile* tile, const double* height, water_tile_field field, double* out);

// The spectrum whose forward FFT (exp(-i k . x), no scale: VTK's) is first(x) + i second(x), for
// two fields at the price of one: conj(first) + i conj(second).
//
// first, second  spectra of real fields; second may be NULL: zero
// out            2 * size * size numbers, written; may be one of the two
void water_tile_pack(
  const water_tile* tile, const double* first, const double* second, double* out);

// Wavelength of the spectrum's peak at the sea's depth, m; 0 if there is none.
double water_tile_peak_wavelength(const water_sea* sea);

// A length that shows a sea well: 10 wavelengths of its peak at its depth, at least 0.001 m.
double water_tile_natural_length(const water_sea* sea);

// Slope variances along the plane's axes by the spectrum's integral: of the waves that the tile
// holds, from k_low up to k_high or its Nyquist wave number pi size / length; and of the shorter
// ones up to 370 rad/m (water_sea_moments), 0 for a tile that is finer than that.
// Used only by tests, as a reference.
void water_tile_slopes(
  const water_tile* tile, const water_sea* sea, double held[2], double left_out[2]);

// Root mean square slope of a sea of such variances together with other waves.
double water_tile_slope_rms(const double variance[2], double other_rms);

// Where in the tile a place is, as shares of its side in [0, 1). In doubles, so that it is exact
// far from the origin, too.
//
// Returns WATER_OK or WATER_BAD_POINT (not finite). On an error, share is unchanged.
water_status water_tile_place(const water_tile* tile, double x, double y, double share[2]);

// A field at a place, bilinear.
//
// values  size * size numbers, the column fastest
//
// Returns as water_tile_place. On an error, value is unchanged.
water_status water_tile_sample(
  const water_tile* tile, const double* values, double x, double y, double* value);

// Slopes for a texture: slope x, slope y and their squares, whose means over texels tell the
// variance.
//
// texels  4 * size * size numbers, written
void water_tile_texels(
  const water_tile* tile, const double* slope_x, const double* slope_y, float* texels);

#ifdef __cplusplus
}
#endif
#endif
