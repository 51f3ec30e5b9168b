// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDisplacementVS.glsl: moves the vertices of a surface by its waves; water_waves.c for the shader.
// Everything happens in clip space: whatever the vertices' own coordinates are, and wherever the
// world's origin is, numbers are small near the eye.

in vec2 waterCell;            // distances of the grid's rows and of a row's points; 0 on a user's mesh
uniform sampler2D waterWaves; // as in vtkWaterWavesFS.glsl
uniform int waterWaveCount;
uniform mat4 waterAxesToClip;   // direction in the plane's axes (third: its normal) -> clip
uniform vec4 waterHeightOfClip; // clip -> height over the plane
uniform mat3 waterClipToPlace;  // clip (x, y, w) of a point on the plane -> place from under the eye
out vec2 waterRestVSOutput;
out vec3 waterMovedVSOutput; // by sines: the sea's part needs no step to the view ray
out vec2 waterCellVSOutput;

void waterDisplace(inout vec4 position)
{
  vec4 rest = position - dot(waterHeightOfClip, position) * waterAxesToClip[2];
  vec3 place = waterClipToPlace * rest.xyw;
  waterRestVSOutput = place.xy / place.z;
  waterCellVSOutput = waterCell;
  vec3 moved = vec3(0.0);
  for (int i = 0; i < waterWaveCount; ++i)
  {
    vec4 wave = texelFetch(waterWaves, ivec2(0, i), 0);
    float steepness = texelFetch(waterWaves, ivec2(1, i), 0).x;
    vec2 k = wave.xy;
    float kept = wave.z * waterKept(k, waterCell);
    float angle = dot(k, waterRestVSOutput) + wave.w;
    moved += kept * vec3(steepness * cos(angle) * inversesqrt(dot(k, k)) * k, sin(angle));
  }
  waterMovedVSOutput = moved;
  position += waterAxesToClip * vec4(moved + waterSeaMoved(waterRestVSOutput, waterCell), 0.0);
}
