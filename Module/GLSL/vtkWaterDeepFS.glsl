// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDeepFS.glsl: stage body of water that nothing is seen in.
// Needs vtkWaterFlatFS.glsl, vtkWaterPointFS.glsl before it.

vec3 waterBeneath(WaterPoint point)
{
  return waterDeepColor;
}

vec3 waterSeenFrom(WaterPoint point, vec3 color)
{
  return color;
}
