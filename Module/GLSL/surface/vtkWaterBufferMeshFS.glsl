// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferMeshFS.glsl: in place of all slots but the first: a user's mesh writes its surface into a buffer, which
// vtkWaterBufferPixelFS.glsl reads. Slopes are those of the pixel's own triangle.

#include "vtkWaterDataColor.glsl"

uniform vec4 waterViewport; // as in vtkWaterPointFS.glsl

void waterShade(inout vec4 color)
{
  vec2 place = waterPlaceOf(2.0 * (gl_FragCoord.xy - waterViewport.xy) * waterViewport.zw - 1.0);
  float height = waterHeightOf(vec4(0.0)) / gl_FragCoord.w;
  vec2 tilt = waterTilt(dFdx(place), dFdy(place), vec2(dFdx(height), dFdy(height)));
  color = vec4(height, tilt, gl_FragCoord.w);
}

// The second texture of the buffer.
vec4 waterKeptData()
{
  return waterDataColor;
}
