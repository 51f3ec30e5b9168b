// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSunFS.glsl: slot sun of water that the sun does nothing to.

void waterSunlit(WaterPoint point, inout vec3 rgb) {}
