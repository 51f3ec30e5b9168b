// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetsFS.glsl: slot facets: what several facets a pixel reflect, one after another.

// The reflection of a pixel's facets, each weighted by its own reflectance, from the least slope to the greatest.
//
// One facet goes the way of the first of several: software renderers execute a branch for either, and
// a loop's body once at least. The others are only estimated and probed: what the first one meets and they would, too, they
// do not miss.
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
  float level = isOne ? 0.0 : waterLevelSlope(point, azimuth, slopes);
  waterSpread = isOne ? 0.0 : waterFacetSpread(slopes.y, count);
  bool isFresnel = waterReflectance < 0.0;
  float given = max(waterReflectance, 0.0);
  float eta = max(waterEta, 0.0);
  WaterFacet last = waterNoFacet();
  WaterRayHit hit;
  vec3 reflected = vec3(0.0);
  reflectance = 0.0;
  int i = 0;
  do
  {
    WaterFacet seen = waterNoFacet();
    float node = isOne ? 0.0 : waterFacetNode(i, count);
    seen.slope = isOne ? 0.0 : waterFacetAim(node, level, count);
    float cosine = waterFacing(point.ray, waterFacetNormal(point, azimuth, slopes.x + node * slopes.y));
    seen.light = isFresnel ? waterFresnel(cosine, eta) : given;
    seen.weight = waterFacetShare(i, count) * seen.light;
    reflectance += seen.weight;
    vec3 normal = waterFacetNormal(point, azimuth, slopes.x + seen.slope * slopes.y);
    bool isFirst = i == 0;
    hit = waterEstimateHit(point, normal);
    waterRefineHit(point.start, isOne, isFirst, hit);
    waterKeepHit(hit, seen);
    waterFindBorder(point.start, i, count, level, last, seen);
    if (!isOne)
    {
      waterCrossFacet(point, waterFacetNormal(point, azimuth, slopes.x + (seen.slope - WATER_LAYER_APART) * slopes.y),
        waterFacetNormal(point, azimuth, slopes.x + (seen.slope + WATER_LAYER_APART) * slopes.y), seen);
    }
    reflected += last.weight * waterFacetColor(last);
    last = seen;
    ++i;
  } while (i < count);
  waterMarchRay(point.start, isOne, hit);
  if (isOne)
  {
    waterTakeSky(hit);
    waterLookBehind(point.start, hit);
    hit.uv = waterPlaceOver(point.start, hit);
    waterCross(point, hit);
    reason = waterReason(hit);
    uv = hit.uv;
    waterKeepHit(hit, last);
  }
  reflected += last.weight * waterFacetColor(last);
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
