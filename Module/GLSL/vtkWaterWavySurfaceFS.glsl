// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWavySurfaceFS.glsl: the colour of a water pixel with waves.
// Needs vtkWaterOptics.glsl, vtkWaterWavesFS.glsl and vtkWaterLookupFS.glsl before it.

uniform int waterIsReflecting;  // 0: there is no mirrored view, show the plain colour
uniform vec4 waterViewport;     // x, y, 1 / width, 1 / height of the draw, in pixels
uniform mat3 waterNdcToPlane;   // (NDC x, NDC y, 1) -> place on the plane, from under the eye
uniform mat3 waterNdcToRay;     // (NDC x, NDC y, 1) -> view ray in the plane's axes
uniform float waterSide;        // 1: seen from above, -1: from below
uniform float waterDepthScale;  // depth in the map / depth in the picture, of the surface
uniform float waterEta;         // index beyond the surface / index on the eye's side
uniform float waterReflectance; // 0 to 1, or below 0: Fresnel
uniform vec3 waterDeepColor;
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

void waterShade(inout vec4 color)
{
  vec2 ndc = 2.0 * (gl_FragCoord.xy - waterViewport.xy) * waterViewport.zw - 1.0;
  vec3 seen = waterNdcToPlane * vec3(ndc, 1.0);
  vec2 place = seen.xy / seen.z;
  vec3 normal =
    normalize(vec3(-waterSide * waterSlope(place, dFdx(place), dFdy(place)), 1.0));
  vec3 rgb = waterDeepColor;
  int reason = 0;
  vec2 uv = vec2(0.0);
  if (waterIsReflecting != 0)
  {
    vec3 ray = normalize(waterNdcToRay * vec3(ndc, 1.0));
    float cosine = clamp(-dot(ray, normal), 0.0, 1.0);
    vec3 start = vec3(0.5 + 0.5 * waterMapScale * vec2(-ndc.x, ndc.y), waterDepthScale * gl_FragCoord.z);
    vec3 reflection = waterReflected(start, ray, normal, reason, uv);
    float reflectance =
      waterReflectance < 0.0 ? waterFresnel(cosine, waterEta) : waterReflectance;
    rgb = mix(rgb, reflection, reflectance);
  }
  color = waterOutput == 0 ? vec4(rgb, color.a * waterOpacity)
                           : vec4(waterOutput == 1 ? vec3(float(reason) / 255.0) : waterPack(uv), 1.0);
}
