// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoDomeFS.glsl: slot dome of a reflection texture in which the background is the sky.

void waterLookCalm(vec3 start) {}

vec3 waterDrawn(vec4 texel, vec3 background)
{
  return texel.rgb;
}
