// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferOneFS.glsl: reads a surface buffer of one sample a pixel, for vtkWaterBufferSortFS.glsl.

uniform sampler2D waterBufferKept;
uniform sampler2D waterBufferKeptData;
uniform int waterBufferHasData;

vec4 waterBufferAt(ivec2 pixel, int number)
{
  return texelFetch(waterBufferKept, pixel, 0);
}

vec4 waterBufferDataAt(ivec2 pixel, int number)
{
  return waterBufferHasData != 0 ? texelFetch(waterBufferKeptData, pixel, 0) : vec4(0.0);
}
