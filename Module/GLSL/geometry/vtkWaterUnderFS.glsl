// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUnderFS.glsl: slot under of a surface that leaves its plane: what of the reflection texture lies under it.

uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w
uniform float waterSlack;           // the most that a height may be off by for that

// Does the reflection texture show something below a height at this place? The mirrored view is cut
// at the deepest trough, and therefore contains objects that are under water elsewhere. No ray
// meets them, because rays go up from the surface. What lies at the height itself counts as above
// it, within a texel.
bool waterIsUnder(vec2 uv, float depth, float height)
{
  vec4 ndc = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  float perW = dot(waterReflectionW, ndc);
  float slack = min(waterTexel / perW, waterSlack);
  return dot(waterReflectionHeight, ndc) < (height - slack) * perW;
}

// What is a little under the plane is in the mirrored view of such a surface.
vec2 waterOverWaterline(vec2 uv, float height)
{
  return uv;
}
