// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareFacetsFS.glsl: slot facets for hardware: as vtkWaterFacetsFS.glsl, with branches in place of conditions.
//
// One loop for one facet and for several: two facets side by side, and a way of its own for one, were 40 % more code
// on sines. Depth reads were 0.9 of 6.2 ms of an ocean: there is little to hide.

// Traces a facet's ray up to what its probes find, and gives the share of the light that it reflects.
//
// depth  that the reflection texture has at the point
WaterRayHit waterTraceFacet(WaterPoint point, vec3 normal, float depth, int most, out float reflectance)
{
  float cosine = clamp(-dot(point.ray, normal), 0.0, 1.0);
  reflectance = waterReflectance < 0.0 ? waterFresnel(cosine, max(waterEta, 0.0)) : waterReflectance;
  vec3 dir = reflect(point.ray, normal);
  bool isDown = dir.z < 0.0;
  dir.z = max(abs(dir.z), 1e-6);
  WaterRayHit hit = waterAim(point.start, point.startW, dir);
  hit.color = waterSkyOfRay(dir);
  hit.depthStart = waterToMeet(point.start.xy, depth);
  hit.depth = hit.depthStart;
  waterTwoSteps(point.start, hit);
  waterJudge(hit);
  hit.isDown = isDown;
  waterSettle(point.start, most, hit);
  return hit;
}

// As in vtkWaterFacetsFS.glsl.
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  int count = waterFacetCount(variance);
  bool isOne = count == 1;
  vec2 slopes = isOne ? vec2(0.0) : waterFacetSlopes(point, sqrt(variance));
  int most = isOne ? max(waterProbes, 0) : min(waterProbes, WATER_FACET_PROBES);
  waterFloor = point.height;
  float depth = waterDepthAt(point.start.xy);
  WaterPlaces places = WaterPlaces(vec4(0.0), vec4(0.0), vec4(0.0));
  vec3 reflected = vec3(0.0);
  reflectance = 0.0;
  for (int i = 0; i < count; ++i)
  {
    vec3 normal = waterFacetNormal(point, azimuth, slopes.x + waterFacetNode(i, count) * slopes.y);
    float share;
    WaterRayHit hit = waterTraceFacet(point, normal, depth, most, share);
    share /= float(count);
    reflectance += share;
    if (isOne)
    {
      waterEndRay(point.start, hit);
      waterCross(point, hit);
      reason = waterReason(hit);
      uv = hit.uv;
    }
    else
    {
      waterTakeNear(point.start, hit);
      waterCrossFacet(point, normal, i, hit);
    }
    reflected += hit.isPlace ? vec3(0.0) : share * hit.color;
    // the last four, which move along
    places.inner = vec4(places.inner.zw, places.outer.xy);
    places.outer = vec4(places.outer.zw, hit.uv);
    places.shares = vec4(places.shares.yzw, hit.isPlace ? share : 0.0);
  }
  if (count < 4)
  {
    places.inner = isOne ? places.outer.zwzw : places.outer;
    places.shares = isOne ? vec4(places.shares.w, 0.0, 0.0, 0.0) : vec4(places.shares.zw, 0.0, 0.0);
  }
  reflected += waterBlurred(places, count);
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
