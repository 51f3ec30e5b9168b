// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareMediumFS.glsl: slot refraction for hardware, where a branch that a pixel does not take costs nothing.

// Asking the texture takes as long as a read.
vec2 waterMediumSize()
{
  return floor(1.0 / waterViewport.zw + 0.5);
}

float waterMediumReach(vec3 start, vec3 way, float depth)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  float reach = max(depth - start.z, 0.0) * perDepth;
  for (int i = 0; i < 3; ++i)
  {
    vec3 at = start + reach * way;
    float further = waterMediumDepth(at.xy) - at.z;
    if (further <= 0.0)
    {
      break; // it would stay there
    }
    reach += further * perDepth;
  }
  return reach;
}
