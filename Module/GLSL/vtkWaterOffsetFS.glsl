// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOffsetFS.glsl: the calm reflection, shifted by the normal: what most programs do for waves.
// In place of vtkWaterLookupFS.glsl.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform int waterLookup;           // vtkWaterProperty::Lookups
uniform float waterOffsetScale;
uniform vec2 waterMapScale;        // part of the map that is the picture itself, without its band

// Colour of the reflection: as in vtkWaterLookupFS.glsl.
vec3 waterReflected(vec3 start, vec3 ray, vec3 normal, out int reason, out vec2 uv)
{
  vec2 offset = waterOffsetScale * waterMapScale * normal.xy * (waterLookup == 2 ? gl_FragCoord.w : 1.0);
  reason = 1;
  uv = start.xy + vec2(-offset.x, offset.y);
  return textureLod(waterReflection, uv, 0.0).rgb;
}
