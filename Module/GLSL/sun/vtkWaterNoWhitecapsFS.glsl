// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoWhitecapsFS.glsl: slot whitecaps of a sea without them.

float waterWhitecap(WaterPoint point, vec2 place, float pixel)
{
  return 0.0;
}
