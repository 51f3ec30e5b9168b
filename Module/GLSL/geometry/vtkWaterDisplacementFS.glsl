// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDisplacementFS.glsl: slot place of a surface that waves displace: its place at rest comes
// from the vertices (vtkWaterDisplacementVS.glsl).

in vec2 waterRestVSOutput;
in vec3 waterMovedVSOutput; // from there to the triangle
in vec2 waterCellVSOutput;
uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w
uniform float waterSlack;           // the most that a height may be off by for that

vec2 waterPlaceOf(vec2 ndc)
{
  return waterRestVSOutput;
}

// Amplitude with which a wave moves the points themselves.
float waterMoving(float amplitude, float seen, vec2 k)
{
  return amplitude * waterKept(k, waterCellVSOutput);
}

// How far a point of the waves misses the view ray, in the plane; along the waves, to first order.
//
// point  of the waves, from the pixel's place at rest; as in water_waves.h, the third up
// normal of the waves there, any length
// ray    the view ray
// side   1: seen from above, -1: from below
//
// The triangle is a chord of the waves, which the ray meets a little before or behind; seen at a
// low angle a long way, in which the waves turn. At their silhouettes there is no such point.
vec2 waterMiss(vec3 point, vec3 normal, vec3 ray, float side)
{
  vec3 chord = point - waterMovedVSOutput;
  // the eye sees the side of the waves that it is on
  float cosine = side * min(side * dot(normalize(normal), ray), -0.05);
  float way = dot(normalize(normal), chord) / cosine;
  return chord.xy - way * ray.xy;
}

// Does the reflection texture show there what lies lower than a height? The mirrored view is cut at the deepest
// trough, and elsewhere has things that are under water. No ray meets them: it goes up from the
// surface. What is on the height itself counts as over it, to a texel.
bool waterIsUnder(vec2 uv, float depth, float height)
{
  vec4 ndc = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  float perW = dot(waterReflectionW, ndc);
  float slack = min(waterTexel / perW, waterSlack);
  return dot(waterReflectionHeight, ndc) < (height - slack) * perW;
}
