// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoPortFS.glsl: slot port of an eye without a dome port.

float waterThroughPort(inout WaterPoint point)
{
  return 0.0;
}
