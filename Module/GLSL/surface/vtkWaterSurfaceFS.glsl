// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceFS.glsl: the colour of a water pixel, from the slots.

uniform int waterHasView;         // 0: nothing is known of the view, show the plain colour
uniform float waterShoreSoftness; // m of depth
uniform float waterOpacity;

void waterShade(inout vec4 color)
{
  vec3 rgb = mix(waterDeepColor, waterDataColor.rgb, waterDataColor.a);
  int reason = 0;
  vec2 uv = vec2(0.0);
  float reflectance = 0.0;
  if (waterHasView != 0)
  {
    waterReadSky();
    WaterPoint point = waterPoint();
    waterRipple(point);
    vec3 reflected = waterMirrored(point, reflectance, reason, uv);
    WaterPoint straight = point;
    float port = waterThroughPort(straight);
    rgb = mix(waterTransmitted(straight), waterDataColor.rgb, waterDataColor.a);
    // where the water is thinner than that it begins
    float begun = clamp(waterTransmittedDepth(point) / max(waterShoreSoftness, 1e-9), 0.0, 1.0) * (1.0 - port);
    reflectance *= begun;
    if (waterIsReflecting != 0)
    {
      rgb = rgb * (1.0 - reflectance) + begun * reflected;
    }
    vec3 under = rgb;
    waterSunlit(point, rgb);
    rgb = port > 0.0 ? mix(rgb, under, port) : rgb;
    rgb = waterSeenFrom(point, rgb);
    waterLeaveHulls(point);
    waterKeepToRegion(point);
  }
  color = vec4(rgb, waterOpacityOf(color) * waterOpacity);
  waterShow(reason, uv, reflectance, color);
}
