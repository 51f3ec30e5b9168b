//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFogFS.glsl: the whole picture as an eye under water sees it: what lies under water, through
// the water between. Drawn before the surface, which does the same for itself. For an eye over the
// water: only where the near plane is under it, because there is no surface there.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSceneColor;
uniform sampler2D waterSceneDepth; // 1: background
uniform mat3 waterNdcToRay;        // as in vtkWaterPointFS.glsl
uniform mat4 waterDirToEye;
uniform vec4 waterHeightClip; // as in vtkWaterMediumPictureFS.glsl
uniform float waterSide;      // of the eye: 1 over the water, -1 under it
uniform vec4 waterClipW;
uniform vec3 waterDeepColor;
uniform vec3 waterExtinction;

#include "vtkWaterAttenuation.glsl"
#include "vtkWaterMatter.glsl"
#include "vtkWaterHaze.glsl"

// Of the slots haze and shafts, which follow.
vec3 waterHaze(vec3 ray, float fall, float way);
float waterShaftEnd(vec3 ray, float way);
vec3 waterShaftsAlong(vec3 ray, float way);

void main()
{
  float depth = textureLod(waterSceneDepth, texCoord, 0.0).r;
  vec4 clip = vec4(2.0 * vec3(texCoord, depth) - 1.0, 1.0);
  vec3 ray = normalize(waterNdcToRay * vec3(clip.xy, 1.0));
  float w = 1.0 / dot(waterClipW, clip);
  float way = w / (waterDirToEye * vec4(ray, 0.0)).w;
  float height = dot(waterHeightClip, clip) * w; // of the thing, towards the eye
  float below = -waterSide * height;
  float eyeBelow = -waterSide * (height - way * ray.z);
  float share = below / (below - eyeBelow); // of the way that is on the thing's side of the surface
  if (eyeBelow < 0.0)
  {
    if (dot(waterHeightClip, vec4(clip.xy, -1.0, 1.0)) >= 0.0)
    {
      discard; // the surface is drawn here, or the ray does not meet it
    }
    way *= share;
  }
  else if (below < 0.0)
  {
    way *= 1.0 - share;
  }
  if (below >= 0.0 && depth >= 1.0)
  {
    way = 1e9; // the background under water is without an end
  }
  vec3 color = textureLod(waterSceneColor, texCoord, 0.0).rgb;
  vec3 left = vec3(waterTransmittance(waterExtinction.r, way),
    waterTransmittance(waterExtinction.g, way), waterTransmittance(waterExtinction.b, way));
  color *= eyeBelow > 0.0 && below > 0.0 && depth < 1.0 ? waterShaftEnd(ray, way) : 1.0;
  gl_FragData[0] = vec4(mix(waterHaze(ray, -waterSide * ray.z, way) * waterShaftsAlong(ray, way), color, left), 1.0);
}
