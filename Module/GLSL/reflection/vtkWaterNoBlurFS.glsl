// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoBlurFS.glsl: slot blur of a reflection that has no reflection texture: its facets add up.

vec3 waterBlurred(WaterPlaces places, int count)
{
  return vec3(0.0);
}
