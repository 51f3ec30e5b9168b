// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterUnderFS.glsl: slot under of a surface that leaves its plane: what of the reflection texture lies under it.

uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w
uniform float waterSlack;           // the most that a height may be off by for that

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
