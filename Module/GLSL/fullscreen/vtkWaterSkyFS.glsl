//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyFS.glsl: the gradient background as the mirrored view sees it. A gradient is painted on
// the user's screen, so a reflected ray finds its sky where the user's camera would see that
// direction; beyond the screen's edge the gradient ends in its last colour.
//VTK::Output::Dec

in vec2 texCoord;
uniform mat3 waterReflectionNdcToEye; // (x, y, 1) in NDC of the reflection texture -> (x, y, w) in clip of the eye
uniform vec4 waterSkyBottom;
uniform vec4 waterSkyTop;

void main()
{
  vec3 eye = waterReflectionNdcToEye * vec3(2.0 * texCoord - 1.0, 1.0);
  // behind the user's camera (w <= 0) the direction is above or below all of the screen
  float height = eye.z > 0.0 ? 0.5 + 0.5 * eye.y / eye.z : step(0.0, eye.y);
  gl_FragData[0] = mix(waterSkyBottom, waterSkyTop, clamp(height, 0.0, 1.0));
}
