// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNothingUnderFS.glsl: slot under of a surface that lies in its plane.

uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w

bool waterIsUnder(vec2 uv, float depth, float height)
{
  return false; // the mirrored view is cut at the surface
}
