// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSurfaceFS.glsl: the colour of a calm water pixel. Needs vtkWaterOptics.glsl before it.
//
// NDC come from gl_FragCoord and the viewport of the draw itself (read from the GL state), which is
// exact for a sheet of any size.

uniform sampler2D waterReflection; // mirrored view, flipped in x
uniform int waterIsReflecting;     // 0: there is no mirrored view, show the plain colour
uniform vec4 waterViewport;        // x, y, 1 / width, 1 / height of the draw, in pixels
uniform vec4 waterNormalClip;      // plane normal (towards the eye) in clip space, w included
uniform vec4 waterPlaneClip;       // clip space point -> height over the plane; 0 for a flat sheet
uniform mat3 waterNdcToRay;        // (NDC x, NDC y, 1) -> view ray in the plane's axes
uniform float waterEta;            // index beyond the surface / index on the eye's side
uniform float waterReflectance;    // 0 to 1, or below 0: Fresnel
uniform vec3 waterDeepColor;
uniform float waterOpacity;

// Where the mirrored view sees what this point of the surface reflects when it is calm.
vec2 waterLookup(vec2 ndc)
{
  vec4 clip = vec4(ndc, 2.0 * gl_FragCoord.z - 1.0, 1.0); // w cancels below
  vec4 mirrored = clip - 2.0 * dot(waterPlaneClip, clip) * waterNormalClip;
  return 0.5 + 0.5 / mirrored.w * vec2(-mirrored.x, mirrored.y);
}

void waterShade(inout vec4 color)
{
  vec3 rgb = waterDeepColor;
  if (waterIsReflecting != 0)
  {
    vec2 ndc = 2.0 * (gl_FragCoord.xy - waterViewport.xy) * waterViewport.zw - 1.0;
    float reflectance = waterReflectance;
    if (reflectance < 0.0)
    {
      vec3 ray = waterNdcToRay * vec3(ndc, 1.0);
      reflectance = waterFresnel(clamp(-ray.z * inversesqrt(dot(ray, ray)), 0.0, 1.0), waterEta);
    }
    rgb = mix(rgb, textureLod(waterReflection, waterLookup(ndc), 0.0).rgb, reflectance);
  }
  color = vec4(rgb, color.a * waterOpacity);
}
