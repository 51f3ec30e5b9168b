// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetEdgesFS.glsl: slot edges: what the search of edges between facets needs to know of rays that are traced.

vec2 waterReflectionPx(); // size of the reflection texture; of the slot walk

// Where a facet's ray has a depth.
vec2 waterRayAt(vec3 start, WaterFacet facet, float depth)
{
  return start.xy + waterPlaceOnRay(start, facet.line.z, depth) * facet.line.xy;
}

// How much deeper than that the same object may be.
float waterSameWithin(float depth)
{
  return waterReflectionTolerance.y * (waterReflectionZInfinity - depth);
}

// Where on a way that begins on an object its edge is, within 1/32 of the way: 1 if all of it is on the object; of the slot
// walk.
//
// depth     no part of the object is deeper
// isWanted  or else nothing is looked at
float waterEdgeBetween(vec2 on, vec2 way, float depth, bool isWanted);

void waterKeepHit(WaterRayHit hit, inout WaterFacet facet)
{
  facet.line = vec3(hit.line.xy, waterPerDepth(hit.line));
  facet.depth = hit.isPlace && !waterIsSky(hit.depth) ? hit.depth : WATER_UNMET;
  facet.uv = hit.uv;
  facet.isPlace = hit.isPlace;
  facet.color = hit.color;
}
