//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCoverVS.glsl: rectangles in NDC at the nearest depth, so that nothing that is drawn later
// passes the test there.

in vec4 vertexMC;

void main()
{
  gl_Position = vec4(vertexMC.xy, -1.0, 1.0);
}
