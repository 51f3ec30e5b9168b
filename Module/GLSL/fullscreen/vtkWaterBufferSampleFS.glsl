// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferSampleFS.glsl: reads a surface buffer of several samples a pixel, for vtkWaterBufferSortFS.glsl.

uniform sampler2DMS waterBufferKept;
uniform sampler2DMS waterBufferKeptData;
uniform int waterBufferHasData;

vec4 waterBufferAt(ivec2 pixel, int number)
{
  return texelFetch(waterBufferKept, pixel, number);
}

vec4 waterBufferDataAt(ivec2 pixel, int number)
{
  return waterBufferHasData != 0 ? texelFetch(waterBufferKeptData, pixel, number) : vec4(0.0);
}
