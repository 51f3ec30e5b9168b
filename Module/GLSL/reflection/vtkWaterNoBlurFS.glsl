// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoBlurFS.glsl: slot blur of a reflection that has no reflection texture.

vec3 waterFacetColor(WaterFacet facet)
{
  return facet.color;
}
