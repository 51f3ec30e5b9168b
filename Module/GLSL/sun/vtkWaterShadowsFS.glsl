// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShadowsFS.glsl: slot shadows: of things on the water's glitter and foam, looked up in the sun view
// (water_sun_view.h).

uniform sampler2D waterSunView; // depths
uniform vec3 waterSunViewDepth; // of a height over w, what lies under the plane; 1: there is a sun view

const float WATER_SUN_VIEW_ROUNDING = 5e-7; // of a window depth

// How much of the sun's light is kept off a point: the mean over its pixel's surroundings, or shadows had stairs.
float waterSunKept(WaterPoint point)
{
  float perW = waterPerW();
  vec4 fall = waterDirToEye * vec4(waterSunDir, 0.0);
  vec3 laid = vec3(point.ndc, 1.0) - point.height * perW / waterSunDir.z * fall.xyw;
  // rounding may put the lowest trough below the view's bottom
  float over = max(point.height + waterSunViewDepth.y, 0.0);
  float depth = 1.0 - waterSunViewDepth.x * over * perW / laid.z;
  ivec2 size = textureSize(waterSunView, 0);
  ivec2 middle = ivec2(floor((0.5 + 0.5 * laid.xy / laid.z) * vec2(size)));
  float kept = 0.0;
  for (int i = -1; i <= 1; ++i)
  {
    for (int j = -1; j <= 1; ++j)
    {
      ivec2 texel = clamp(middle + ivec2(i, j), ivec2(0), size - 1);
      float weight = (i == 0 ? 0.5 : 0.25) * (j == 0 ? 0.5 : 0.25);
      kept += weight * step(texelFetch(waterSunView, texel, 0).r, depth - WATER_SUN_VIEW_ROUNDING);
    }
  }
  return kept * waterSunViewDepth.z;
}

// The surface's color, where the sun may be kept off.
//
// shaded  its color without the sun
// lit     its color under it
vec3 waterShadowed(WaterPoint point, vec3 shaded, vec3 lit)
{
  return mix(lit, shaded, waterSunKept(point));
}
