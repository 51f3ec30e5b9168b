// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoGlitterFS.glsl: slot glitter of water that has none.

vec3 waterGlint(WaterPoint point, vec3 sun, vec3 rgb)
{
  return vec3(0.0);
}
