// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareBlurFS.glsl: slot blur for hardware: as vtkWaterBlurFS.glsl, with all reads together.

vec3 waterBlurred(WaterPlaces places, int count)
{
  // from one to the next
  vec2 apart = count == 4 ? (places.outer.zw - places.outer.xy) / 3.0 : places.inner.zw - places.inner.xy;
  float level = log2(max(0.3 * length(apart * waterReflectionTexels), 1.0));
  vec3 first = waterDrawn(textureLod(waterReflection, places.inner.xy, level), waterSkyBottom.rgb);
  vec3 second = waterDrawn(textureLod(waterReflection, places.inner.zw, level), waterSkyBottom.rgb);
  vec3 third = vec3(0.0);
  vec3 fourth = vec3(0.0);
  if (count == 4)
  {
    third = waterDrawn(textureLod(waterReflection, places.outer.xy, level), waterSkyBottom.rgb);
    fourth = waterDrawn(textureLod(waterReflection, places.outer.zw, level), waterSkyBottom.rgb);
  }
  return places.shares.x * first + places.shares.y * second + places.shares.z * third + places.shares.w * fourth;
}
