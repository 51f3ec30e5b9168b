//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClipProbeVS.glsl: a rectangle whose corners bring their clip distances. A driver that knows
// clip distances cuts what is below 0 away while GL_CLIP_DISTANCE0 is on.

in vec4 vertexMC; // xy in NDC, the distance

void main()
{
  gl_Position = vec4(vertexMC.xy, 0.0, 1.0);
  gl_ClipDistance[0] = vertexMC.z;
}
