// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceFS.glsl: the colour of a water pixel, from the stages.
// Needs vtkWaterOptics.glsl, vtkWaterPointFS.glsl, vtkWaterNoFacetsFS.glsl, vtkWaterCalmFS.glsl,
// vtkWaterMirrorFS.glsl, vtkWaterDeepFS.glsl and vtkWaterNoSunFS.glsl before it, or others of their
// stages.

uniform int waterHasView;       // 0: nothing is known of the view, show the plain colour
uniform int waterIsReflecting;  // 0: there is no mirrored view
uniform float waterReflectance; // 0 to 1, or below 0: Fresnel
uniform float waterShoreSoftness; // m of depth
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

// The reflection of a pixel's facets, each weighted by its own reflectance.
//
// reflectance  of all
// reason, uv   of the pixel's mean one, which is the only one where these are shown
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec3 reflected = vec3(0.0);
  vec3 sharp = vec3(0.0);
  vec2 places[4] = vec2[4](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));
  vec4 shares = vec4(0.0);
  reflectance = 0.0;
  int count = waterOutput == 1 || waterOutput == 2 ? 1 : waterFacetCount(point);
  for (int i = count - 1; i >= 0; --i)
  {
    WaterPoint facet = point;
    float weight;
    facet.normal = waterFacet(point, i, count, weight);
    float share = weight * (waterReflectance < 0.0
      ? waterFresnel(clamp(-dot(point.ray, facet.normal), 0.0, 1.0), waterEta)
      : waterReflectance);
    reflectance += share;
    if (waterIsReflecting != 0)
    {
      vec3 seen = waterReflected(facet, reason, uv);
      bool isOfMap = waterIsOfMap(reason);
      places[i] = uv;
      shares[i] = isOfMap ? share : 0.0;
      sharp += shares[i] * seen;
      reflected += (share - shares[i]) * seen;
    }
  }
  // several sharp images would be seen as several: each is as wide as they are apart
  return reflected + (count > 1 && waterIsReflecting != 0
    ? waterBlurred(places, shares, count, sharp) : sharp);
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
