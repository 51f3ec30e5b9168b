// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferHeightFS.glsl: slot height of a user's mesh whose surface is in a buffer.

float waterHeightOf(vec4 ndc)
{
  return waterBuffered.x * waterBuffered.w;
}
