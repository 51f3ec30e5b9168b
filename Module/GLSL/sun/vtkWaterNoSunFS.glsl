// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoSunFS.glsl: slot sun of water that the sun does nothing to.
// Needs vtkWaterPointFS.glsl before it.

void waterSunlit(WaterPoint point, inout vec3 rgb) {}
