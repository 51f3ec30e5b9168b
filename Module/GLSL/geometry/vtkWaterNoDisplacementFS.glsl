// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoDisplacementFS.glsl: slot place of a surface that lies in its plane: a pixel's place follows from
// the pixel alone.

uniform mat3 waterNdcToPlane;       // (NDC x, NDC y, 1) -> place on the plane, from under the eye

vec2 waterPlaceOf(vec2 ndc)
{
  vec3 seen = waterNdcToPlane * vec3(ndc, 1.0);
  return seen.xy / seen.z;
}

float waterMoving(float amplitude, float seen, vec2 k)
{
  return seen;
}

vec2 waterMiss(vec3 point, vec3 normal, vec3 ray, float side)
{
  return point.xy; // whatever its height, it is drawn at its place
}

// The surface's own slope beside its waves'; of a mesh.
vec2 waterTilt(vec2 across, vec2 down, vec2 rise)
{
  return vec2(0.0);
}
