//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCoverFS.glsl: depth alone is written.
//VTK::Output::Dec

void main()
{
  gl_FragData[0] = vec4(0.0);
}
