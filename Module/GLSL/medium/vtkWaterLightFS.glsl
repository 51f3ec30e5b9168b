//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLightFS.glsl: what a photon's ellipse gives to a texel.
//VTK::Output::Dec

flat in vec3 waterPhotonVSOutput;
flat in vec3 waterShapeVSOutput;

void main()
{
  vec2 off = gl_FragCoord.xy - waterPhotonVSOutput.xy;
  float within = 1.0 - dot(waterShapeVSOutput, vec3(off.x * off.x, 2.0 * off.x * off.y, off.y * off.y));
  float weight = max(within, 0.0);
  gl_FragData[0] = vec4(waterPhotonVSOutput.z * weight * weight * weight);
}
