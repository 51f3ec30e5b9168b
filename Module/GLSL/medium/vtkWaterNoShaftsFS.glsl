// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoShaftsFS.glsl: slot shafts of water whose waves gather no light, or that is not looked through from below.

float waterShaftEnd(vec3 ray, float way)
{
  return 1.0;
}

vec3 waterShaftsAlong(vec3 ray, float way)
{
  return vec3(1.0);
}
