// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOutputFS.glsl: slot output of water that shows how it got its colour.

uniform int waterOutput; // vtkWaterProperty::Outputs

// A place in the reflection texture as a colour: 12 bits of u, then 12 bits of v.
vec3 waterPack(vec2 uv)
{
  vec2 parts = floor(clamp(uv, 0.0, 1.0) * 4095.0 + 0.5);
  vec2 low = mod(parts, vec2(16.0, 256.0));
  vec2 high = floor(parts / vec2(16.0, 256.0));
  return vec3(high.x, 16.0 * low.x + high.y, low.y) / 255.0;
}

// A share as a colour: 16 bits in red and green.
vec3 waterPack(float share)
{
  float whole = floor(clamp(share, 0.0, 1.0) * 65535.0 + 0.5);
  return vec3(floor(whole / 256.0), mod(whole, 256.0), 0.0) / 255.0;
}

// Is one reflection a pixel shown, that of the pixel's mean slope?
bool waterShowsMean()
{
  return waterOutput == 1 || waterOutput == 2;
}

void waterShow(int reason, vec2 uv, float reflectance, inout vec4 color)
{
  color = vec4(waterOutput == 1 ? vec3(float(reason) / 255.0)
      : (waterOutput == 2 ? waterPack(uv) : waterPack(reflectance)), 1.0);
}
