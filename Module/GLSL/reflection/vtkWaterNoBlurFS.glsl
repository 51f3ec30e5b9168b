// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoBlurFS.glsl: stage blur of a reflection that has no map: its facets add up.
// Needs vtkWaterPointFS.glsl before it.

vec3 waterBlurred(WaterPlaces places, int count)
{
  return vec3(0.0);
}
