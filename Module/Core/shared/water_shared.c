// SPDX-License-Identifier: BSD-3-Clause
// water_shared.c: the shaders' scalar formulas read as C, in doubles.
#include "water_shared.h"

#include <math.h>

// Scalar GLSL means the same with these words.
#define float double
#define uint uint32_t
#define min fmin
#define max fmax
#define abs fabs
#define waterFresnel water_shared_fresnel
#define waterSchlick water_shared_schlick
#define waterTransmittance water_shared_transmittance
#define waterScatteredAt water_shared_scattered_at
#define waterScattered water_shared_scattered
#define waterHazeParticles water_shared_haze_particles
#define waterHazeMolecules water_shared_haze_molecules
#define waterHazeIntegral water_shared_haze_integral
#define waterHazeOver water_shared_haze_over
#define waterSlopeDensity water_shared_slope_density
#define waterFacingArea water_shared_facing_area
#define waterGlitterSpread water_shared_glitter_spread
#define waterRollOff water_shared_roll_off
#define waterShoreFoam water_shared_shore_foam
#define waterFlowGain water_shared_flow_gain
#define waterFlowBandGain water_shared_flow_band_gain
#define waterFoamThreshold water_shared_foam_threshold
#define waterFoamOfMeasure water_shared_foam_of_measure
#define waterWithMatter water_shared_with_matter
#define waterSentBack water_shared_sent_back
#define waterEncoded water_shared_encoded
#define waterGradientShare water_shared_gradient_share
#define waterGradientHeight water_shared_gradient_height
#define waterPhase water_shared_phase
#define waterCosine water_shared_cosine
#define waterSine water_shared_sine
#define waterUpperHalf water_shared_upper_half

#include "vtkWaterAttenuation.glsl"
#include "vtkWaterFlowGain.glsl"
#include "vtkWaterFoamCover.glsl"
#include "vtkWaterFoamMeasure.glsl"
#include "vtkWaterGradient.glsl"
#include "vtkWaterHaze.glsl"
#include "vtkWaterHighlights.glsl"
#include "vtkWaterMatter.glsl"
#include "vtkWaterOptics.glsl"
#include "vtkWaterSlopes.glsl"
#include "vtkWaterTurns.glsl"
