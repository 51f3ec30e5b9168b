// SPDX-License-Identifier: BSD-3-Clause
// water_samples.h: the samples of a multisampled picture, spread over a finer picture that has one
// sample a pixel: what refracted rays meet in it is not mixed, and edges lie where the samples have
// them.
#ifndef water_samples_h
#define water_samples_h

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_SAMPLES_SIDE_MAX = 4,
  WATER_SAMPLES_MAX = 32 // of a pixel
};

// Finer pixels along each side of a pixel, so that there are at least as many as samples; fewer
// where the finer picture would be larger than a texture can be.
//
// samples  of a pixel; 0 or 1: there is one
//
// Returns at least 1, at most WATER_SAMPLES_SIDE_MAX.
int water_samples_side(int samples, const int size_px[2], int max_texture_px);

// The sample that is nearest to the middle of each of a pixel's finer pixels: a number of sample
// for each, by rows from the bottom.
//
// places   of the samples, from the pixel's middle, pixels
// numbers  side * side
void water_samples_nearest(const float places[][2], int samples, int side, int numbers[]);

#ifdef __cplusplus
}
#endif
#endif
