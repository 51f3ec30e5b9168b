// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSeaVS.glsl: water whose sea moves no vertices, or that has none.

vec3 waterSeaMoved(vec2 place, vec2 cell)
{
  return vec3(0.0);
}
