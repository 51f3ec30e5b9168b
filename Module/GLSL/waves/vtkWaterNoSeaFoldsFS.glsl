// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSeaFoldsFS.glsl: slot waves of a wind sea that moves no points in the plane, and of none.

vec3 waterSeaBend(sampler2DArray sea, vec3 middle, vec2 across, vec2 down, float texel, int looks)
{
  return vec3(0.0);
}

vec2 waterFolded(vec2 sines, vec2 sea, vec3 bent, inout float jacobian)
{
  return sines + sea;
}
