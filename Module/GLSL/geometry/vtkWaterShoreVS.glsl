// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterShoreVS.glsl: cuts a user's mesh at the shore while it is drawn (water_shore_draw.h). GL_CLIP_DISTANCE1 is on
// then. Between vertices the number is linear, so the cut is exact within a triangle.

in float waterShoreMC; // above 0 in water, below 0 on land

void waterCutShore()
{
  gl_ClipDistance[1] = waterShoreMC;
}
