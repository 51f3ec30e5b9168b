// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoGlitterFS.glsl: slot glitter of water that has none.

void waterGlint(WaterPoint point, vec3 sun, inout vec3 rgb) {}
