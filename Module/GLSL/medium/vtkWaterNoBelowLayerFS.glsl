// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoBelowLayerFS.glsl: slot below of a picture in which nothing translucent is kept apart.

float waterMediumDepth(vec2 uv)
{
  return textureLod(waterSceneDepth, uv, 0.0).r;
}

vec3 waterThroughBelowLayer(WaterPoint point, vec3 dir, vec3 behind)
{
  return behind;
}
