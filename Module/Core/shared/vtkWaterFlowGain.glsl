// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFlowGain.glsl: two layers of waves as steep as one (water_flow.h); for shaders and, by water_shared.c, for C.

// The factor that keeps the variance of the slopes while two layers share the weight: their mean has less, the less they
// are alike. Their correlation is taken for a Gaussian. 1 for a single layer, and for two in one place.
//
// weight    of the first layer, in [0, 1]; the second one has the rest
// apart     the layers, >= 0
// likeness  distance over which slopes become unlike, > 0
float waterFlowGain(float weight, float apart, float likeness)
{
  float far = apart / likeness;
  return 1.0 / sqrt(1.0 - 2.0 * weight * (1.0 - weight) * (1.0 - exp(-far * far)));
}

// The same for a band of waves whose slopes have as much variance in each octave, as those of a wind sea: a wave has
// become unlike where 1.1 of its lengths, divided by 2 pi, lie between the layers. Long waves keep their height then, and
// short ones do not fade.
//
// apart  the layers, >= 0
// first  wave number of the band's longest waves, rad per unit of apart, > 0
// last   of its shortest; > first
float waterFlowBandGain(float weight, float apart, float first, float last)
{
  float low = apart * first / 1.1;
  float high = apart * last / 1.1;
  float likeness = 1.0 - 0.5 * log((1.0 + high * high) / (1.0 + low * low)) / log(last / first);
  return 1.0 / sqrt(1.0 - 2.0 * weight * (1.0 - weight) * (1.0 - likeness));
}
