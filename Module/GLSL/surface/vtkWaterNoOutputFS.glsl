// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoOutputFS.glsl: slot output of water that shows its colour.

bool waterShowsMean()
{
  return false;
}

void waterShow(int reason, vec2 uv, float reflectance, inout vec4 color) {}
