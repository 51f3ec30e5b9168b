// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumWalkFS.glsl: slot refraction for software renderers: the refracted ray's looks at the picture one after
// another; vtkWaterHardwareMediumFS.glsl is the same for hardware.

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

WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach)
{
  float low = 0.0;
  float high = reach;
  float depthLow = depth;
  float depthHigh = waterMediumDepth(start.xy + reach * way.xy);
  bool isHit = false;
  for (int i = 1, halvings = 0; i <= WATER_MEDIUM_STEPS + 5 && halvings < 5; ++i)
  {
    float middle = isHit ? 0.5 * (low + high) : reach * float(i) / float(WATER_MEDIUM_STEPS);
    depth = waterMediumDepth(start.xy + middle * way.xy);
    if (start.z + middle * way.z > depth)
    {
      high = middle;
      depthHigh = depth;
      isHit = true;
    }
    else
    {
      low = middle;
      depthLow = depth;
      if (middle >= reach)
      {
        break;
      }
    }
    halvings += isHit ? 1 : 0;
  }
  return WaterMediumHit(low, high, depthLow, depthHigh, isHit);
}
