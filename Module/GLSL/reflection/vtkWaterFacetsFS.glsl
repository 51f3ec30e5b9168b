// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetsFS.glsl: slot facets: what several facets a pixel reflect, one after another.

// The reflection of a pixel's facets, each weighted by its own reflectance.
//
// One facet goes the way of the first of several: software renderers execute a branch for either, and
// a loop's body once at least. It alone is marched where an estimate and some probes do not converge: of
// several, which are blurred, they find each of them well enough.
//
// reflectance  of all
// reason, uv   of the pixel's mean one, which is the only one where these are shown
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  int count = waterFacetCount(variance, point.ray.z);
  bool isOne = count == 1;
  vec2 slopes = isOne ? vec2(0.0) : waterFacetSlopes(point, sqrt(variance));
  waterSpread = isOne ? 0.0 : waterFacetSpread(slopes.y, count);
  WaterPlaces places = WaterPlaces(vec4(0.0), vec4(0.0), vec4(0.0));
  WaterRayHit hit;
  vec3 reflected = vec3(0.0);
  float share = 0.0;
  reflectance = 0.0;
  bool isFresnel = waterReflectance < 0.0;
  float given = max(waterReflectance, 0.0);
  float eta = max(waterEta, 0.0);
  int i = 0;
  do
  {
    vec3 normal = waterFacetNormal(point, azimuth, slopes.x + waterFacetNode(i, count) * slopes.y);
    float cosine = waterFacing(point.ray, normal);
    share = (isOne ? 1.0 : (count == 4 ? 0.25 : 0.5)) *
      (isFresnel ? waterFresnel(cosine, eta) : given);
    reflectance += share;
    normal = waterFacetNormal(point, azimuth, slopes.x + waterFacetAim(i, count, waterRay) * slopes.y);
    hit = waterEstimateHit(point, normal);
    waterRefineHit(point.start, isOne, hit);
    if (!isOne)
    {
      waterCrossFacet(point, normal, i, hit);
    }
    float atPlace = hit.isPlace ? share : 0.0;
    places.inner = vec4(i == 0 ? hit.uv : places.inner.xy, i == 1 ? hit.uv : places.inner.zw);
    places.outer = vec4(i == 2 ? hit.uv : places.outer.xy, i == 3 ? hit.uv : places.outer.zw);
    places.shares = mix(places.shares, vec4(atPlace), equal(ivec4(i), ivec4(0, 1, 2, 3)));
    reflected += hit.isPlace ? vec3(0.0) : share * hit.color;
    ++i;
  } while (i < count);
  waterMarchRay(point.start, isOne, hit);
  if (isOne)
  {
    waterTakeSky(hit);
    waterLookBehind(point.start, hit);
    hit.uv = waterPlaceOver(point.start, hit);
    waterCross(point, hit);
    places.inner = hit.uv.xyxy;
    places.shares.x = hit.isPlace ? share : 0.0;
    reflected = hit.isPlace ? vec3(0.0) : share * hit.color;
    reason = waterReason(hit);
    uv = hit.uv;
  }
  reflected += waterBlurred(places, count);
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
