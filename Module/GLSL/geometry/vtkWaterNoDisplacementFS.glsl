// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoDisplacementFS.glsl: slot place of a surface that lies in its plane: a pixel's place follows from
// the pixel alone.

uniform mat3 waterNdcToPlane;       // (NDC x, NDC y, 1) -> place on the plane, from under the eye
uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w

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

bool waterIsUnder(vec2 uv, float depth, float height)
{
  return false; // the mirrored view is cut at the surface
}
