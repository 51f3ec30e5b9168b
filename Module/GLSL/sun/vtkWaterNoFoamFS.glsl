// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFoamFS.glsl: slot foam of water that has none.

void waterFoam(WaterPoint point, vec3 sun, inout vec3 rgb) {}
