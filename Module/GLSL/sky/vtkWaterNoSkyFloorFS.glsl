// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSkyFloorFS.glsl: slot floor where there is none.

vec3 waterOverFloor(vec3 dir, vec3 color)
{
  return color;
}

bool waterHasFloor()
{
  return false;
}
