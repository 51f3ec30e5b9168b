// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBlurFS.glsl: slot blur of a reflection that is looked up in the reflection texture.

// The places that some facets see, blurred over their distance: several sharp images would be seen as
// several.
//
// count  1: the first place, sharp; 2, or 4
vec3 waterBlurred(WaterPlaces places, int count)
{
  // from one to the next
  vec2 apart = count == 4 ? (places.outer.zw - places.outer.xy) / 3.0 : places.inner.zw - places.inner.xy;
  apart = count == 1 ? vec2(0.0) : apart;
  float level = log2(max(0.3 * length(apart * vec2(textureSize(waterReflection, 0))), 1.0));
  vec3 blurred = vec3(0.0);
  int i = 0;
  do
  {
    vec4 pair = i < 2 ? places.inner : places.outer;
    vec2 shares = i < 2 ? places.shares.xy : places.shares.zw;
    bool isFirst = (i & 1) == 0;
    blurred += (isFirst ? shares.x : shares.y) *
      waterDrawn(textureLod(waterReflection, isFirst ? pair.xy : pair.zw, level), waterSkyBottom.rgb);
    ++i;
  } while (i < count);
  return blurred;
}
