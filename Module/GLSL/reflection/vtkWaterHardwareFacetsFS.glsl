// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareFacetsFS.glsl: slot facets for hardware: as vtkWaterFacetsFS.glsl, but one facet goes a way of its
// own, and several go one after the other in a small loop. Two side by side, and one loop for one and several, were
// slower on an H200: what counts there is how few registers a pixel needs.

// The depth that a ray may meet where the reflection texture has another; as waterDepthToMeet.
float waterFacetDepth(vec2 uv, float depth, float nearest)
{
  return depth < nearest || waterIsUnder(uv, depth, waterFloor) ? WATER_UNMET : depth;
}

// The share of the light that a facet reflects.
float waterFacetReflectance(WaterPoint point, vec3 normal)
{
  float cosine = waterFacing(point.ray, normal);
  return waterReflectance < 0.0 ? waterFresnel(cosine, max(waterEta, 0.0)) : waterReflectance;
}

// A facet on its way: little more than its ray, since registers that wait for reads keep others from being read for.
struct WaterFacet
{
  WaterRayHit hit;
  float perDepth; // waterPerDepth of its ray
  float nearest;  // waterNearest
  float share;    // of the light
};

// aimed  the normal for its ray
// depth  that the reflection texture has at the point
// share  of the pixel
WaterFacet waterAimFacet(WaterPoint point, vec3 normal, vec3 aimed, float depth, float share)
{
  WaterFacet facet;
  facet.share = share * waterFacetReflectance(point, normal);
  vec3 dir = reflect(point.ray, aimed);
  dir.z = max(abs(dir.z), 1e-6);
  facet.hit = waterAim(point.start, point.startW, dir);
  facet.hit.color = waterSky(dir);
  facet.perDepth = waterPerDepth(facet.hit.line);
  facet.nearest = waterNearest;
  facet.hit.depthStart = waterFacetDepth(point.start.xy, depth, facet.nearest);
  facet.hit.depth = facet.hit.depthStart;
  return facet;
}

void waterStepFacet(vec3 start, inout WaterFacet facet)
{
  facet.hit.s = waterPlaceOnRay(start, facet.perDepth, facet.hit.depth);
  facet.hit.uv = start.xy + facet.hit.s * facet.hit.line.xy;
}

// How many probes a facet takes: none where two steps have not converged.
int waterFacetProbes(vec3 start, WaterFacet facet)
{
  return waterHasConverged(start, facet.hit)
    ? waterProbesOf(facet.hit, min(waterProbes, WATER_FACET_PROBES)) : 0;
}

// Takes its place where a probe has found something, about where that is.
void waterProbeFacet(vec3 start, int probes, inout WaterFacet facet)
{
  ivec3 probe = min(ivec3(1, 2, 3), probes);
  float part = facet.hit.s / float(probes + 1);
  waterNearest = facet.nearest;
  vec3 depths = waterReadProbes(start, facet.hit.line, part, probe);
  WaterProbed probed = WaterProbed(true, facet.hit.depthStart, facet.hit.depth);
  waterTestProbes(depths, start, facet.hit.line, part, probe, probed);
  if (probed.near < facet.hit.depth)
  {
    facet.hit.uv = start.xy + clamp((probed.near - start.z) * facet.perDepth, 0.0, 1.0) * facet.hit.line.xy;
    facet.hit.isPlace = true;
  }
}

// A facet, from its first steps to its place.
void waterTraceFacet(vec3 start, inout WaterFacet facet)
{
  waterStepFacet(start, facet);
  facet.hit.depth = waterFacetDepth(facet.hit.uv, waterDepthAt(facet.hit.uv), facet.nearest);
  waterStepFacet(start, facet);
  facet.hit.depth = waterFacetDepth(facet.hit.uv, waterDepthAt(facet.hit.uv), facet.nearest);
  waterJudge(facet.hit);
  int probes = waterFacetProbes(start, facet);
  if (probes > 0)
  {
    waterProbeFacet(start, probes, facet);
  }
}

vec3 waterOneFacet(WaterPoint point, out float reflectance, out int reason, out vec2 uv)
{
  vec3 normal = normalize(point.normal);
  reflectance = waterFacetReflectance(point, normal);
  WaterRayHit hit = waterEstimateHit(point, normal);
  waterFollowRay(point.start, hit);
  waterTakeSky(hit);
  waterLookBehind(point.start, hit);
  hit.uv = waterPlaceOver(point.start, hit);
  waterCross(point, hit);
  reason = waterReason(hit);
  uv = hit.uv;
  vec3 color = hit.color;
  if (hit.isPlace)
  {
    color = waterDrawn(textureLod(waterReflection, uv, 0.0), color);
  }
  return reflectance * color;
}

vec3 waterSeveralFacets(WaterPoint point, vec2 azimuth, float variance, int count, out float reflectance)
{
  vec2 slopes = waterFacetSlopes(point, sqrt(variance));
  waterFloor = point.height;
  float depth = waterDepthAt(point.start.xy);
  float share = count == 4 ? 0.25 : 0.5;
  waterSpread = waterFacetSpread(slopes.y, count);
  WaterPlaces places = WaterPlaces(vec4(0.0), vec4(0.0), vec4(0.0));
  vec3 reflected = vec3(0.0);
  reflectance = 0.0;
  for (int i = 0; i < count; ++i)
  {
    vec3 normal = waterFacetNormal(point, azimuth, slopes.x + waterFacetNode(i, count) * slopes.y);
    vec3 aimed = normal;
    if (waterRay > 0)
    {
      aimed = waterFacetNormal(point, azimuth, slopes.x + waterFacetAim(i, count, waterRay) * slopes.y);
    }
    WaterFacet facet = waterAimFacet(point, normal, aimed, depth, share);
    reflectance += facet.share;
    waterTraceFacet(point.start, facet);
    waterCrossFacet(point, aimed, i, facet.hit);
    reflected += facet.hit.isPlace ? vec3(0.0) : facet.share * facet.hit.color;
    // the last four move along
    places.inner = vec4(places.inner.zw, places.outer.xy);
    places.outer = vec4(places.outer.zw, facet.hit.uv);
    places.shares = vec4(places.shares.yzw, facet.hit.isPlace ? facet.share : 0.0);
  }
  if (count == 2)
  {
    places = WaterPlaces(places.outer, vec4(0.0), vec4(places.shares.zw, 0.0, 0.0));
  }
  return reflected + waterBlurred(places, count);
}

// As in vtkWaterFacetsFS.glsl.
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  int count = waterFacetCount(variance, point.ray.z);
  vec3 reflected = vec3(0.0);
  if (count == 1)
  {
    reflected = waterOneFacet(point, reflectance, reason, uv);
  }
  else
  {
    reflected = waterSeveralFacets(point, azimuth, variance, count, reflectance);
  }
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
