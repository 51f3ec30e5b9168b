// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoPictureShadowsFS.glsl: slot casters of water that does not look at the picture.

float waterPictureShaded(WaterPoint point, vec3 dir, bool isWanted)
{
  return 0.0;
}
