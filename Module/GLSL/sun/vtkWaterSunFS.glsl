// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSunFS.glsl: slot sun: its light, on glitter and foam.

uniform vec3 waterSunColor; // of the light; a white card facing it shows this

// Adds what the sun does to the surface's color.
void waterSunlit(WaterPoint point, inout vec3 rgb)
{
  vec3 sun = waterSunColor * step(0.0, waterSide * waterSunDir.z);
  float foam = waterFoamShare(point);
  vec3 lit = mix(rgb + waterGlint(point, sun, rgb), waterFoamLit(point, sun), foam);
  vec3 shaded = mix(rgb, waterFoamLit(point, vec3(0.0)), foam);
  rgb = waterShadowed(point, shaded, lit);
}
