// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCalmFS.glsl: stages waves and reflection of calm water: no waves, and one exact look at the
// map. Needs vtkWaterFlatFS.glsl, vtkWaterPointFS.glsl before it.

uniform sampler2D waterReflection; // mirrored view, flipped in x

void waterRipple(inout WaterPoint point) {}

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  reason = 1;
  uv = point.start.xy;
  return textureLod(waterReflection, uv, 0.0).rgb;
}
