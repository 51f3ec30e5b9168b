// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOffsetFS.glsl: stage reflection: the calm one, shifted by the normal: what most programs do
// for waves. Needs vtkWaterFlatFS.glsl, vtkWaterPointFS.glsl before it.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform int waterLookup;           // vtkWaterProperty::Lookups
uniform float waterOffsetScale;

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  float scale = waterOffsetScale * (waterLookup == 2 ? gl_FragCoord.w : 1.0);
  vec2 offset = scale * waterMapScale * point.normal.xy;
  reason = 1;
  uv = point.start.xy + vec2(-offset.x, offset.y);
  return textureLod(waterReflection, uv, 0.0).rgb;
}
