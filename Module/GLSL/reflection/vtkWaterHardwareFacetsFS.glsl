// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareFacetsFS.glsl: slot facets for hardware: as vtkWaterFacetsFS.glsl, but one facet goes a way of its
// own, and several go one after the other in a small loop. Two side by side, and one loop for one and several, were
// slower on an H200: what counts there is how few registers a pixel needs.

// The depth that a ray may meet where the reflection texture has another; as waterDepthToMeet.
float waterFacetDepth(vec2 uv, float depth, float nearest)
{
  return depth < nearest || waterIsUnder(uv, depth, waterFloor) ? WATER_UNMET : depth;
}

// A facet on its way: little more than its ray, since registers that wait for reads keep others from being read for.
struct WaterFacetRay
{
  WaterRayHit hit;
  float perDepth; // waterPerDepth of its ray
  float nearest;  // waterNearest
};

// normal  of the facet
// depth   that the reflection texture has at the point
WaterFacetRay waterAimFacet(WaterPoint point, vec3 normal, float depth)
{
  WaterFacetRay ray;
  vec3 dir = reflect(point.ray, normal);
  dir.z = max(abs(dir.z), 1e-6);
  ray.hit = waterAim(point.start, point.startW, dir);
  ray.hit.color = waterSky(dir);
  ray.perDepth = waterPerDepth(ray.hit.line);
  ray.nearest = waterNearest;
  ray.hit.depthStart = waterFacetDepth(point.start.xy, depth, ray.nearest);
  ray.hit.depth = ray.hit.depthStart;
  return ray;
}

void waterStepFacet(vec3 start, inout WaterFacetRay ray)
{
  ray.hit.s = waterPlaceOnRay(start, ray.perDepth, ray.hit.depth);
  ray.hit.uv = start.xy + ray.hit.s * ray.hit.line.xy;
  ray.hit.depth = waterFacetDepth(ray.hit.uv, waterDepthAt(ray.hit.uv), ray.nearest);
}

// How many probes a facet takes: none where two steps have not converged.
int waterFacetProbes(vec3 start, WaterRayHit hit)
{
  return waterHasConverged(start, hit) ? waterProbesOf(hit, min(waterProbes, WATER_FACET_PROBES)) : 0;
}

// Takes its place where a probe has found something, about where that is.
void waterProbeFacet(vec3 start, int probes, inout WaterFacetRay ray)
{
  ivec3 probe = min(ivec3(1, 2, 3), probes);
  float part = ray.hit.s / float(probes + 1);
  waterNearest = ray.nearest;
  vec3 depths = waterReadProbes(start, ray.hit.line, part, probe);
  WaterProbed probed = WaterProbed(true, ray.hit.depthStart, ray.hit.depth);
  waterTestProbes(depths, start, ray.hit.line, part, probe, probed);
  if (probed.near < ray.hit.depth)
  {
    ray.hit.uv = start.xy + clamp((probed.near - start.z) * ray.perDepth, 0.0, 1.0) * ray.hit.line.xy;
    ray.hit.isPlace = true;
    ray.hit.depth = probed.near;
  }
}

// The same of the first facet, whose way is probed closely, all of it where two steps have not converged. Written out: on an
// H200 the surface takes 8 % longer with the place in a function of its own.
void waterScanFacet(vec3 start, inout WaterFacetRay ray)
{
  waterNearest = ray.nearest;
  bool hasConverged = waterHasConverged(start, ray.hit);
  float end = hasConverged ? ray.hit.s : 1.0;
  int rounds = waterScanRounds(end * length(ray.hit.line.xy * waterReflectionTexels));
  float part = end / float(4 * rounds + 1);
  bool isMet = false;
  bool isBehind = false;
  float high = 0.0;
  float depthLow = ray.hit.depthStart; // of the reflection texture
  float depthHigh = depthLow;
  for (int k = 0; k < rounds && !isMet; ++k)
  {
    vec4 at = part * (vec4(1.0, 2.0, 3.0, 4.0) + 4.0 * float(k));
    vec4 met = vec4(waterDepthToMeet(start.xy + at.x * ray.hit.line.xy),
      waterDepthToMeet(start.xy + at.y * ray.hit.line.xy), waterDepthToMeet(start.xy + at.z * ray.hit.line.xy),
      waterDepthToMeet(start.xy + at.w * ray.hit.line.xy));
    for (int i = 0; i < 4 && !isMet; ++i)
    {
      high = at[i];
      float rayDepth = min(start.z + high * ray.hit.line.z, 1.0);
      depthLow = depthHigh;
      depthHigh = met[i];
      isBehind = rayDepth > depthHigh;
      isMet = isBehind || waterMayPassBehind(depthLow, depthHigh, rayDepth);
    }
  }
  if (isMet)
  {
    float low = high - part;
    for (int i = 0; i < WATER_SCAN_HALVINGS; ++i)
    {
      float middle = 0.5 * (low + high);
      float depth = waterDepthToMeet(start.xy + middle * ray.hit.line.xy);
      float rayDepth = min(start.z + middle * ray.hit.line.z, 1.0);
      bool isHigh = rayDepth > depth || (!isBehind && waterMayPassBehind(depthLow, depth, rayDepth));
      isBehind = isBehind || rayDepth > depth;
      low = isHigh ? low : middle;
      depthLow = isHigh ? depthLow : depth;
      high = isHigh ? middle : high;
      depthHigh = isHigh ? depth : depthHigh;
    }
    ray.hit.uv = start.xy + (isBehind ? high : low) * ray.hit.line.xy;
    ray.hit.isPlace = true;
    ray.hit.depth = isBehind ? depthHigh : depthLow;
  }
}

// A facet, from its first steps to its place.
void waterTraceFacet(vec3 start, bool isFirst, inout WaterFacetRay ray)
{
  waterStepFacet(start, ray);
  waterStepFacet(start, ray);
  waterJudge(ray.hit);
  int probes = waterFacetProbes(start, ray.hit);
  if (isFirst)
  {
    waterScanFacet(start, ray);
  }
  else if (probes > 0)
  {
    waterProbeFacet(start, probes, ray);
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
  float level = waterLevelSlope(point, azimuth, slopes);
  waterFloor = point.height;
  float depth = waterDepthAt(point.start.xy);
  waterSpread = waterFacetSpread(slopes.y, count);
  WaterFacet last = waterNoFacet();
  vec3 reflected = vec3(0.0);
  reflectance = 0.0;
  for (int i = 0; i < count; ++i)
  {
    WaterFacet seen = waterNoFacet();
    float node = waterFacetNode(i, count);
    seen.light = waterFacetReflectance(point, waterFacetNormal(point, azimuth, slopes.x + node * slopes.y));
    seen.weight = waterFacetShare(i, count) * seen.light;
    reflectance += seen.weight;
    seen.slope = waterFacetAim(node, level, count);
    vec3 normal = waterFacetNormal(point, azimuth, slopes.x + seen.slope * slopes.y);
    WaterFacetRay ray = waterAimFacet(point, normal, depth);
    waterTraceFacet(point.start, i == 0, ray);
    waterKeepHit(ray.hit, seen);
    waterFindBorder(point.start, i, count, level, last, seen);
    waterCrossFacet(point, waterFacetNormal(point, azimuth, slopes.x + (seen.slope - WATER_LAYER_APART) * slopes.y),
      waterFacetNormal(point, azimuth, slopes.x + (seen.slope + WATER_LAYER_APART) * slopes.y), seen);
    if (i > 0)
    {
      reflected += last.weight * waterFacetColor(last);
    }
    last = seen;
  }
  return reflected + last.weight * waterFacetColor(last);
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
