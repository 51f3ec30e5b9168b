// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDisplacementFS.glsl: slot place of a surface that waves displace: its place at rest comes
// from the vertices (vtkWaterDisplacementVS.glsl).

in vec2 waterRestVSOutput;
in vec3 waterMovedVSOutput; // from there to the triangle
in vec2 waterCellVSOutput;
uniform mat3 waterNdcToPlane; // (NDC x, NDC y, 1) -> place on the plane, from under the eye

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

// The surface's own slope beside its waves'; of a mesh.
vec2 waterTilt(vec2 across, vec2 down, vec2 rise)
{
  return vec2(0.0);
}
