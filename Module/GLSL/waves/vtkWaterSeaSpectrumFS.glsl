//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaSpectrumFS.glsl: the spectra of one or two pairs of a wind sea's fields at a time, a texel for each wave
// vector; water_tile_pair_row for the shader.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSlopeWaves;         // water_tile_pair_waves of the first pair
uniform sampler2D waterOtherWaves;         // and of the second
uniform highp usampler2D waterFrequencies; // water_turns_frequency of a quadrant: water_tile_frequencies
uniform int waterPairs;                    // 1 or 2
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
  vec4 first = texelFetch(waterSlopeWaves, place, 0);
  vec4 second = vec4(0.0);
  if (waterPairs > 1)
  {
    second = texelFetch(waterOtherWaves, place, 0);
  }
  gl_FragData[0] = waterCosine(phase) * vec4(first.xy, second.xy) +
    waterTimeSign * waterSine(phase) * vec4(first.zw, second.zw);
}
