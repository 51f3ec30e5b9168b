//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyFS.glsl: a background that is a gradient or a picture, as the mirrored view sees it. It is painted on
// the user's screen, so a reflected ray finds its sky where the user's camera would see that direction.
//VTK::Output::Dec

in vec2 texCoord;
uniform mat3 waterReflectionNdcToEye; // (x, y, 1) in NDC of the reflection texture -> (x, y, w) in clip of the eye
uniform vec4 waterSkyBottom;
uniform vec4 waterSkyTop;
uniform sampler2D waterScreenPicture;
uniform int waterScreen;        // water_screen
uniform vec2 waterScreenBorder; // as in vtkWaterSkyScreenFS.glsl

#include "vtkWaterGradient.glsl"

void main()
{
  vec3 eye = waterReflectionNdcToEye * vec3(2.0 * texCoord - 1.0, 1.0);
  vec2 place = vec2(waterGradientHeight(eye.x, abs(eye.z)), waterGradientHeight(eye.y, eye.z));
  vec2 inside = clamp(place, waterScreenBorder, 1.0 - waterScreenBorder);
  vec4 color = mix(waterSkyBottom, waterSkyTop, waterGradientShare(waterScreen, place.x, place.y));
  vec3 painted = textureLod(waterScreenPicture, inside, 0.0).rgb;
  gl_FragData[0] = waterScreen == 5 ? vec4(painted, waterSkyBottom.a) : color;
}
