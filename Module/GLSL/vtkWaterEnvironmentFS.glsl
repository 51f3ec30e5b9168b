// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterEnvironmentFS.glsl: stage reflection: a static picture of the surroundings, in latitude and
// longitude as vtkSkybox has it, or the background. Needs vtkWaterPointFS.glsl before it.

uniform sampler2D waterEnvironment;
uniform int waterHasEnvironment; // 0: the background
uniform mat3 waterDirToEnvironment;

vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  vec3 dir = reflect(point.ray, point.normal);
  dir.z = abs(dir.z); // met the water again: bounced off it once more
  vec3 around = waterDirToEnvironment * dir;
  reason = 2;
  uv = vec2(0.5 + 0.15915494 * atan(around.z, around.x),
    0.5 + 0.31830989 * atan(around.y, length(around.xz)));
  return waterHasEnvironment != 0 ? textureLod(waterEnvironment, uv, 0.0).rgb : waterSky(dir);
}

// How much of the light from a direction something keeps off, as far as the map shows it.
float waterShaded(WaterPoint point, vec3 dir)
{
  return 0.0;
}

// What one of several facets sees: a place of the map, or a colour.
//
// Returns whether it is a place.
bool waterFacetSees(WaterPoint point, out vec2 uv, out vec3 color)
{
  int reason;
  color = waterReflected(point, reason, uv);
  return false;
}

vec3 waterBlurred(WaterPlaces places, int count)
{
  return vec3(0.0);
}
