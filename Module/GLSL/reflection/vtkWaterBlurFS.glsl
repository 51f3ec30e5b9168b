// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBlurFS.glsl: slot blur of a reflection that is looked up in the reflection texture.

// What a facet sees. It is blurred as far as its neighbours' places: several sharp images would be seen as several.
vec3 waterFacetColor(WaterFacet facet)
{
  float level = log2(max(WATER_FACET_BLUR * facet.apart, 1.0));
  return facet.isPlace ? waterDrawn(textureLod(waterReflection, facet.uv, level), waterSkyBottom.rgb) : facet.color;
}
