//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyFS.glsl: the gradient background as the mirrored view sees it. A gradient is painted on
// the user's screen, so a reflected ray finds its sky where the user's camera would see that
// direction.
//VTK::Output::Dec

in vec2 texCoord;
uniform mat3 waterReflectionNdcToEye; // (x, y, 1) in NDC of the reflection texture -> (x, y, w) in clip of the eye
uniform vec4 waterSkyBottom;
uniform vec4 waterSkyTop;

#include "vtkWaterGradient.glsl"

void main()
{
  vec3 eye = waterReflectionNdcToEye * vec3(2.0 * texCoord - 1.0, 1.0);
  gl_FragData[0] = mix(waterSkyBottom, waterSkyTop, waterGradientHeight(eye.y, eye.z));
}
