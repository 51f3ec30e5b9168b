// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShadowsFS.glsl: slot shadows: of things on the water's glitter and foam.

uniform float waterLeastLight; // light that changes no pixel

// The surface's color, where the sun may be kept off. The way to it is followed only where that is seen.
//
// shaded  its color without the sun
// lit     its color under it
vec3 waterShadowed(WaterPoint point, vec3 shaded, vec3 lit)
{
  vec3 change = abs(lit - shaded);
  bool isSeen = max(max(change.r, change.g), change.b) > waterLeastLight;
  float kept = waterShaded(point, waterSunDir, isSeen);
  kept = max(kept, waterPictureShaded(point, waterSunDir, isSeen && kept < 1.0));
  return mix(lit, shaded, kept);
}
