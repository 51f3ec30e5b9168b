//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaSpectrumFS.glsl: the spectra of one or two pairs of a wind sea's fields at a time, a texel for each wave
// vector, its tiles one above the other; water_tile_pair_row for the shader.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSlopeWaves;         // water_tile_pair_waves of the first pair
uniform sampler2D waterOtherWaves;         // and of the second
uniform highp usampler2D waterFrequencies; // water_turns_frequency of a quadrant: water_tile_frequencies
uniform int waterPairs;                    // 1 or 2
uniform int waterUnits[6];                 // the bits of water_turns_time of each tile
uniform float waterTimeSign;               // -1 before time 0

#include "vtkWaterTurns.glsl"

void main()
{
  int size = textureSize(waterSlopeWaves, 0).x;
  ivec2 place = ivec2(texCoord * vec2(textureSize(waterSlopeWaves, 0)));
  int tile = place.y / size;
  ivec2 inTile = ivec2(place.x, place.y - tile * size);
  int last = size / 2 - 1; // the highest waves, with no place there, are 0
  ivec2 quadrant = min(min(inTile, size - inTile), last) + ivec2(0, tile * (size / 2));
  uvec4 frequency = texelFetch(waterFrequencies, quadrant, 0);
  uint phase = waterPhase(frequency.x, frequency.y, frequency.z, uint(waterUnits[2 * tile]),
    uint(waterUnits[2 * tile + 1]));
  vec4 first = texelFetch(waterSlopeWaves, place, 0);
  vec4 second = vec4(0.0);
  if (waterPairs > 1)
  {
    second = texelFetch(waterOtherWaves, place, 0);
  }
  gl_FragData[0] = waterCosine(phase) * vec4(first.xy, second.xy) +
    waterTimeSign * waterSine(phase) * vec4(first.zw, second.zw);
}
