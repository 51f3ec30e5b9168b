// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoRankRegionFS.glsl: slot region of water that is shown in all of the space.

void waterKeepToRegion(WaterPoint point) {}
