// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceFS.glsl: the colour of a water pixel, from the stages.
// Needs vtkWaterOptics.glsl, vtkWaterFlatFS.glsl, vtkWaterPointFS.glsl, vtkWaterCalmFS.glsl and vtkWaterDeepFS.glsl before
// it, or others of their stages.

uniform int waterHasView;       // 0: nothing is known of the view, show the plain colour
uniform int waterIsReflecting;  // 0: there is no mirrored view
uniform float waterReflectance; // 0 to 1, or below 0: Fresnel
uniform float waterOpacity;
uniform int waterOutput;        // vtkWaterProperty::Outputs

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
    reflectance = waterReflectance < 0.0
      ? waterFresnel(clamp(-dot(point.ray, point.normal), 0.0, 1.0), waterEta)
      : waterReflectance;
    rgb = waterBeneath(point);
    if (waterIsReflecting != 0)
    {
      rgb = mix(rgb, waterReflected(point, reason, uv), reflectance);
    }
    rgb = waterSeenFrom(point, rgb);
  }
  color = vec4(rgb, color.a * waterOpacity);
  if (waterOutput != 0)
  {
    color = vec4(waterOutput == 1 ? vec3(float(reason) / 255.0)
        : (waterOutput == 2 ? waterPack(uv) : waterPack(reflectance)), 1.0);
  }
}
