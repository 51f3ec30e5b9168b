//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterVolumeDepthFS.glsl: gives a volume a depth in the reflection texture, where rays meet it: halfway, in the
// scene, through all that the reflection texture shows of its box (water_volume_planes.h).
//VTK::Output::Dec

in vec2 texCoord;
uniform vec4 waterSides[7];    // NDC of the reflection texture -> >= 0 inside
uniform vec4 waterReflectionW; // the same -> 1 / w

void main()
{
  vec3 place = vec3(2.0 * texCoord - 1.0, 1.0);
  float first = -1.0;
  float last = 1.0;
  for (int i = 0; i < 7; ++i)
  {
    float rest = dot(waterSides[i].xyw, place);
    float slope = waterSides[i].z;
    float edge = -rest / (slope == 0.0 ? 1e-30 : slope);
    first = slope >= 0.0 ? max(first, edge) : first;
    last = slope < 0.0 ? min(last, edge) : last;
  }
  if (first >= last)
  {
    discard;
  }
  // 1 / w goes evenly with depth, and the middle is where w is the mean of both
  float rest = dot(waterReflectionW.xyw, place);
  vec2 perW = rest + waterReflectionW.z * vec2(first, last);
  float middle = (first * perW.y + last * perW.x) / (perW.x + perW.y);
  gl_FragDepth = 0.5 + 0.5 * middle;
  gl_FragData[0] = vec4(0.0);
}
