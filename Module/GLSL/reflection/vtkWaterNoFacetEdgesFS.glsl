// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFacetEdgesFS.glsl: slot edges of lookups that know no depths: no facet sees an edge, and each sees one place at
// all depths.

vec2 waterRayAt(vec3 start, WaterFacet facet, float depth)
{
  return facet.line.xy;
}

float waterSameWithin(float depth)
{
  return 0.0;
}

float waterEdgeBetween(vec2 on, vec2 way, float depth, bool isWanted)
{
  return 1.0;
}

void waterKeepHit(WaterRayHit hit, inout WaterFacet facet)
{
  facet.line = vec3(hit.uv, 1.0);
  facet.depth = WATER_UNMET;
  facet.uv = hit.uv;
  facet.isPlace = hit.isPlace;
  facet.color = hit.color;
}
