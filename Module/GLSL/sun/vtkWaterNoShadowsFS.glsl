// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoShadowsFS.glsl: slot shadows of water that nothing casts shadows on: a second ray costs
// software renderers as much where a uniform says that it has no use.

vec3 waterShadowed(WaterPoint point, vec3 shaded, vec3 lit)
{
  return lit;
}
