// SPDX-License-Identifier: BSD-3-Clause
// water_fft.h: a Fourier transform in passes that compute each number from a few others, as shaders
// do. What is transformed along a line of so many numbers is not reordered before or after.
//
// A pass of radix R turns a line a into the line b[o] = sum over r < R of w[o]^r a[f[o] + r size /
// R]. Source: Stockham 1966, "High-Speed Convolution and Correlation"; Govindaraju et al. 2008,
// "High Performance Discrete Fourier Transforms on Graphics Processors".
#ifndef water_fft_h
#define water_fft_h

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_FFT_LARGEST_RADIX = 16,
  WATER_FFT_MOST_PASSES = 6 // of sizes up to 16384: 5^6 has so many
};

typedef struct water_fft
{
  size_t size;
  int count; // of passes
  size_t radix[WATER_FFT_MOST_PASSES];
} water_fft;

// The fewest passes for a size from 2 to 16384, of radices as alike as can be.
//
// Returns false, and leaves plan as it is, when the size is no product of numbers up to
// WATER_FFT_LARGEST_RADIX.
bool water_fft_plan(size_t size, water_fft* plan);

// What a pass needs for each number o of a line: w[o] (real, imaginary), f[o], 0. With forward
// w[o], exp(-i angle), all passes together are the FFT with exp(-i k . x) without scale.
//
// pass   below count
// table  4 * size numbers, written
void water_fft_table(const water_fft* plan, int pass, float* table);

#ifdef __cplusplus
}
#endif
#endif
