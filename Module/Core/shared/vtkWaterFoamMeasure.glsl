// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamMeasure.glsl: how much foam a measure of breaking water tells; for shaders and, by water_shared.c, for C.

// The share of the surface that foam covers: none up to the first value, all of it from the last one on, and linear
// between them (water_foam_measure.h).
float waterFoamOfMeasure(float value, float first, float last)
{
  return min(max((value - first) / (last - first), 0.0), 1.0);
}
