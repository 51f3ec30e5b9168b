// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNormalsVS.glsl: the normals of a mesh, where VTK's vertex shader does not declare them: a mapper without light
// does not, and has them all the same.

in vec3 normalMC;
