// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterColorFS.glsl: stage output of water that shows its colour.

bool waterShowsMean()
{
  return false;
}

void waterShow(int reason, vec2 uv, float reflectance, inout vec4 color) {}
