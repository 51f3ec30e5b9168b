// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoGroundFS.glsl: slot ground of water that may be without a bed: what meets nothing is deep water.

void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
}
