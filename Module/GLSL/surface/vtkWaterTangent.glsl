// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTangent.glsl: a surface beside its pixel, as the plane that touches it there has it; a part of the files that
// read the surface buffer. A texel of the buffer is the height over the plane, dz/dx, dz/dy and 1 / w; 1 / w is 0 where
// there is no surface.

const float WATER_TANGENT_MOST = 4.0; // times that 1 / w changes: a plane seen at its edge has no pixel beside it

// 1 or -1: where the other pixel of two by two is, for which derivatives are taken; along x and y.
vec2 waterTangentSide()
{
  return 1.0 - 2.0 * mod(floor(gl_FragCoord.xy), 2.0);
}

// 1 / w of the plane.
//
// here   view ray of the texel's pixel, of length 1 along w
// there  of the other pixel
float waterTangentPerW(vec4 texel, vec3 here, vec3 there)
{
  vec3 normal = vec3(-texel.yz, 1.0);
  float of = dot(normal, here);
  float ratio = dot(normal, there) * of / max(of * of, 1e-30);
  return texel.w * clamp(ratio, 1.0 / WATER_TANGENT_MOST, WATER_TANGENT_MOST);
}

// The texel of the plane.
//
// place  from the eye's foot, of the texel's pixel
vec4 waterTangentTexel(vec4 texel, vec3 here, vec3 there)
{
  float perW = waterTangentPerW(texel, here, there);
  vec2 place = here.xy / max(texel.w, 1e-30);
  return vec4(texel.x + dot(texel.yz, there.xy / max(perW, 1e-30) - place), texel.yz, perW);
}
