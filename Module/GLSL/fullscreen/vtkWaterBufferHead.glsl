//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferHead.glsl: what VTK adds to a shader of ours stands here.
//VTK::Output::Dec
