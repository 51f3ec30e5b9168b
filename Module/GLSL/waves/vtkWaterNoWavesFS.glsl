// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoWavesFS.glsl: slot waves of water that has none.

void waterRipple(inout WaterPoint point) {}
