// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoHullsFS.glsl: slot hulls of water that nothing floats in.

void waterLeaveHulls(WaterPoint point) {}
