// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoBehindFS.glsl: slot behind of a reflection texture without a peel.

void waterLookBehind(vec3 start, inout WaterRayHit hit) {}
