// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumWalkFS.glsl: slot refraction for software renderers, where a branch costs as much untaken;
// vtkWaterHardwareMediumFS.glsl is the same for hardware.

vec2 waterMediumSize()
{
  return vec2(textureSize(waterSceneColor, 0));
}

float waterMediumReach(vec3 start, vec3 way, float depth)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  float reach = max(depth - start.z, 0.0) * perDepth;
  for (int i = 0; i < 3; ++i)
  {
    vec3 at = start + reach * way;
    reach += max(waterMediumDepth(at.xy) - at.z, 0.0) * perDepth;
  }
  return reach;
}
