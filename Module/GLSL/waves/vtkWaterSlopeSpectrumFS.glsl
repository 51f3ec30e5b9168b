//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSlopeSpectrumFS.glsl: the spectrum of a wind sea's slopes at a time, a texel for each wave vector;
// water_tile_slope_row for the shader.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSlopeWaves;         // water_tile_slope_waves
uniform highp usampler2D waterFrequencies; // water_turns_frequency of a quadrant: water_tile_frequencies
uniform ivec2 waterUnits;                  // the bits of water_turns_time
uniform float waterTimeSign;               // -1 before time 0

#include "vtkWaterTurns.glsl"

void main()
{
  ivec2 size = textureSize(waterSlopeWaves, 0);
  ivec2 place = ivec2(texCoord * vec2(size));
  ivec2 last = textureSize(waterFrequencies, 0) - 1; // the highest waves, with no place there, are 0
  uvec4 frequency = texelFetch(waterFrequencies, min(min(place, size - place), last), 0);
  uint phase =
    waterPhase(frequency.x, frequency.y, frequency.z, uint(waterUnits.x), uint(waterUnits.y));
  vec4 waves = texelFetch(waterSlopeWaves, place, 0);
  vec2 spectrum = waterCosine(phase) * waves.xy + waterTimeSign * waterSine(phase) * waves.zw;
  gl_FragData[0] = vec4(spectrum, 0.0, 1.0);
}
