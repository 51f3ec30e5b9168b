// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceFS.glsl: the colour of a water pixel, from the stages.
// Needs vtkWaterOptics.glsl, vtkWaterPointFS.glsl, vtkWaterNoFacetsFS.glsl, vtkWaterCalmFS.glsl,
// vtkWaterMirrorFS.glsl, vtkWaterDeepFS.glsl and vtkWaterNoSunFS.glsl before it, or others of their
// stages.

uniform int waterHasView;       // 0: nothing is known of the view, show the plain colour
uniform float waterShoreSoftness; // m of depth
uniform float waterOpacity;

// A place in the map as a colour: 12 bits of u, then 12 bits of v.
vec3 waterPack(vec2 uv)
{
  vec2 parts = floor(clamp(uv, 0.0, 1.0) * 4095.0 + 0.5);
  vec2 low = mod(parts, vec2(16.0, 256.0));
  vec2 high = floor(parts / vec2(16.0, 256.0));
  return vec3(high.x, 16.0 * low.x + high.y, low.y) / 255.0;
}

// A share as a colour: 16 bits in red and green.
vec3 waterPack(float share)
{
  float whole = floor(clamp(share, 0.0, 1.0) * 65535.0 + 0.5);
  return vec3(floor(whole / 256.0), mod(whole, 256.0), 0.0) / 255.0;
}

void waterShade(inout vec4 color)
{
  vec3 rgb = waterDeepColor;
  int reason = 0;
  vec2 uv = vec2(0.0);
  float reflectance = 0.0;
  if (waterHasView != 0)
  {
    WaterPoint point = waterPoint();
    waterRipple(point);
    vec3 reflected = waterFacets(point, reflectance, reason, uv);
    rgb = waterBeneath(point);
    // where the water is thinner than that it begins
    float begun = clamp(waterBeneathDepth(point) / max(waterShoreSoftness, 1e-9), 0.0, 1.0);
    reflectance *= begun;
    if (waterIsReflecting != 0)
    {
      rgb = rgb * (1.0 - reflectance) + begun * reflected;
    }
    waterSunlit(point, rgb);
    rgb = waterSeenFrom(point, rgb);
  }
  color = vec4(rgb, color.a * waterOpacity);
  if (waterOutput != 0)
  {
    color = vec4(waterOutput == 1 ? vec3(float(reason) / 255.0)
        : (waterOutput == 2 ? waterPack(uv) : waterPack(reflectance)), 1.0);
  }
}
