// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFacetsFS.glsl: stage facets of smooth water: the one that the normal is of.
// Needs vtkWaterPointFS.glsl before it.

int waterFacetCount(WaterPoint point)
{
  return 1;
}

vec3 waterFacet(WaterPoint point, int number, int count, out float weight)
{
  weight = 1.0;
  return point.normal;
}
