// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferPlaceFS.glsl: slot place of a user's mesh whose surface is in a buffer: one run of the shader a pixel, for
// all of the triangles in it. vtkWaterBufferPixelFS.glsl reads it.

uniform mat3 waterNdcToPlane; // (NDC x, NDC y, 1) -> place on the plane, from under the eye

vec4 waterBuffered = vec4(0.0, 0.0, 0.0, 1.0); // of the buffer, as vtkWaterTangent.glsl has it
vec2 waterBufferedPlace = vec2(0.0);           // on the plane, from the point under the eye

vec2 waterPlaceOf(vec2 ndc)
{
  return waterBufferedPlace;
}

float waterMoving(float amplitude, float seen, vec2 k)
{
  return seen;
}

vec2 waterMiss(vec3 point, vec3 normal, vec3 ray, float side)
{
  return point.xy; // the mesh is where it is: waves turn rays and move no point
}

vec2 waterTilt(vec2 across, vec2 down, vec2 rise)
{
  return waterBuffered.yz;
}
