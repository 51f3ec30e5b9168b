// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMirrorFS.glsl: slot reflection of calm water: one exact look at the reflection texture.

uniform sampler2D waterReflection; // mirrored view, flipped in x

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  reason = 1;
  uv = point.start.xy;
  return textureLod(waterReflection, uv, 0.0).rgb;
}
