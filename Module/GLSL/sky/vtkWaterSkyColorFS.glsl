// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyColorFS.glsl: slot sky of a background that is one colour.

vec3 waterOverFloor(vec3 dir, vec3 color); // of the slot floor

vec4 waterSkyOfAll; // waterSkyBottom

// Reads what the sky needs of the uniforms, once for all of a pixel; waterReadOnce says why.
void waterReadSky()
{
  waterSkyOfAll = max(waterSkyBottom, vec4(0.0));
}

// The sky in a direction in the plane's axes.
vec3 waterSky(vec3 dir)
{
  return waterOverFloor(dir, waterSkyOfAll.rgb);
}

// Is it known in all directions?
bool waterIsSkyKnown()
{
  return waterSkyOfAll.a > 0.5;
}

// Where it is in its texture, if it has one.
vec2 waterSkyPlace(vec3 dir)
{
  return vec2(0.0);
}
