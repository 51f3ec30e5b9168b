// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareRaysFS.glsl: slot walk for hardware: reads of the reflection texture whose places are known go out
// together, and are tested afterwards in the order of vtkWaterRayWalkFS.glsl, which says what the rules are: results
// are the same. Hardware waits hundreds of cycles for a read; branches and uniforms cost it little, and registers that
// are held over a read cost much.

uniform vec2 waterReflectionTexels; // its size: asking the texture takes as long as a read

void waterReadOnce() {} // uniforms are cheap

vec4 waterHalfEnd(vec3 dir)
{
  return 0.5 * (waterDirToReflection[0] * dir.x + waterDirToReflection[1] * dir.y + waterDirToReflection[2] * dir.z);
}

float waterSlackAt(float depth)
{
  return -waterReflectionTolerance.x * depth + waterReflectionTolerance.x * waterReflectionZInfinity;
}

vec2 waterReflectionPx()
{
  return waterReflectionTexels;
}

float waterTop()
{
  return max(waterReflectionTop, 0.0);
}

// Halves as the one in vtkWaterRayWalkFS.glsl, twice with each round of looks.
float waterEdgeBetween(vec2 on, vec2 way, float depth, bool isWanted)
{
  float part = 1.0;
  if (isWanted)
  {
    vec4 at = vec4(0.25, 0.5, 0.75, 1.0);
    vec4 met = vec4(waterDepthToMeet(on + at.x * way), waterDepthToMeet(on + at.y * way),
      waterDepthToMeet(on + at.z * way), waterDepthToMeet(on + way));
    if (met.w > depth)
    {
      float low = met.y <= depth ? (met.z <= depth ? 0.75 : 0.5) : (met.x <= depth ? 0.25 : 0.0);
      at.xyz = low + 0.25 * at.xyz;
      met.xyz = vec3(waterDepthToMeet(on + at.x * way), waterDepthToMeet(on + at.y * way),
        waterDepthToMeet(on + at.z * way));
      low = met.y <= depth ? (met.z <= depth ? at.z : at.y) : (met.x <= depth ? at.x : low);
      part = low + 0.03125;
    }
  }
  return part;
}

// Has an estimate converged, as far as its own place tells?
bool waterHasConverged(vec3 start, WaterRayHit hit)
{
  float rayDepth = start.z + hit.s * hit.line.z;
  return hit.s >= 1.0 ? min(rayDepth, 1.0) <= hit.depth
                      : abs(rayDepth - hit.depth) <= waterSlackAt(hit.depth);
}

// How many probes an estimate that has converged takes: of a short way fewer miss no more.
int waterProbesOf(WaterRayHit hit, int most)
{
  float lengthPx = hit.s * length(hit.line.xy * waterReflectionTexels);
  return min(most, int(lengthPx / WATER_PROBE_PX));
}

// Depths at three probes, those beyond the last one at the last.
vec3 waterReadProbes(vec3 start, vec3 way, float part, ivec3 probe)
{
  vec3 far = part * vec3(probe);
  return vec3(waterDepthToMeet(start.xy + far.x * way.xy), waterDepthToMeet(start.xy + far.y * way.xy),
    waterDepthToMeet(start.xy + far.z * way.xy));
}

// What a ray's probes have found so far.
struct WaterProbed
{
  bool isFree;       // nothing
  float depthBefore; // at the last one
  float near;        // depth of what they found
};

// Tests three probes, in their order. Those beyond the last one are at the last, and find no more than that.
void waterTestProbes(vec3 depths, vec3 start, vec3 way, float part, ivec3 probe, inout WaterProbed probed)
{
  vec3 rayDepth = min(start.z + part * vec3(probe) * way.z, 1.0);
  vec3 before = vec3(probed.depthBefore, depths.xy);
  vec3 slack = vec3(waterSlackAt(before.x), waterSlackAt(before.y), waterSlackAt(before.z));
  // as waterMayPassBehind
  vec3 passed = min(depths - (before + slack), rayDepth - (before - slack));
  bvec3 isMet = greaterThan(max(rayDepth - depths, passed), vec3(0.0));
  float near = isMet.x ? depths.x : (isMet.y ? depths.y : depths.z);
  bool isFirst = probed.isFree && any(isMet);
  probed.near = isFirst ? near : probed.near;
  probed.isFree = probed.isFree && !isFirst;
  probed.depthBefore = depths.z;
}

// Probes an estimate that has converged, three and three at once.
void waterProbe(vec3 start, int probes, WaterRayHit hit, inout WaterProbed probed)
{
  float part = hit.s / float(probes + 1);
  for (int first = 1; first <= probes && probed.isFree; first += 6)
  {
    ivec3 probe = min(first + ivec3(0, 1, 2), probes);
    ivec3 next = min(probe + 3, probes);
    vec3 depths = waterReadProbes(start, hit.line, part, probe);
    vec3 more = depths;
    bool areMore = first + 3 <= probes;
    if (areMore)
    {
      more = waterReadProbes(start, hit.line, part, next);
    }
    waterTestProbes(depths, start, hit.line, part, probe, probed);
    if (areMore)
    {
      waterTestProbes(more, start, hit.line, part, next, probed);
    }
  }
}

// Where an estimate that has converged meets something: two more steps.
//
// s, depth  after the first of them
void waterRefine(vec3 start, float s, float depth, inout WaterRayHit hit)
{
  if (s < 1.0)
  {
    s = waterPlaceOnRay(start, waterPerDepth(hit.line), depth);
    if (s >= 1.0)
    {
      depth = waterDepthToMeet(start.xy + s * hit.line.xy);
    }
  }
  bool isEnd = s >= 1.0; // nothing was met
  bool isSky = isEnd && (hit.isOver || (waterIsSky(depth) && (waterIsSkyByRay() || !hit.isInside)));
  hit.uv = start.xy + s * hit.line.xy;
  hit.reason = isEnd ? (hit.isInside ? WATER_SKY : WATER_OFF_MAP) : WATER_HIT;
  hit.isPlace = !isSky || !waterIsSkyKnown();
}

// Where a march is: in front of the reflection texture at low; behind it, or beyond an edge, at high.
struct WaterMarch
{
  float low;
  float high;
  float depthLow; // of the reflection texture
  float depthHigh;
  float rayHigh; // depth of the ray
  bool isHit;    // behind at high
  int rest;      // looks that are left
};

// Steps until one ends behind the reflection texture, or may have been there on its way. Returns whether one did.
bool waterMarchSteps(vec3 start, vec3 way, inout WaterMarch march)
{
  float stride = 1.0 / float(waterSteps);
  bool isFound = false;
  do
  {
    vec4 at; // summed up as where one step follows another
    at.x = min(march.low + stride, 1.0);
    at.y = min(at.x + stride, 1.0);
    at.z = min(at.y + stride, 1.0);
    at.w = min(at.z + stride, 1.0);
    vec4 depths = vec4(waterDepthToMeet(start.xy + at.x * way.xy), waterDepthToMeet(start.xy + at.y * way.xy),
      waterDepthToMeet(start.xy + at.z * way.xy), waterDepthToMeet(start.xy + at.w * way.xy));
    for (int i = 0; i < 4; ++i)
    {
      if (!isFound && march.rest > 0 && march.low < 1.0)
      {
        float rayDepth = min(start.z + at[i] * way.z, 1.0);
        march.isHit = rayDepth > depths[i];
        isFound = march.isHit || waterMayPassBehind(march.depthLow, depths[i], rayDepth);
        march.high = isFound ? at[i] : march.high;
        march.depthHigh = isFound ? depths[i] : march.depthHigh;
        march.rayHigh = isFound ? rayDepth : march.rayHigh;
        march.low = isFound ? march.low : at[i];
        march.depthLow = isFound ? march.depthLow : depths[i];
        --march.rest;
      }
    }
  } while (!isFound && march.rest > 0 && march.low < 1.0);
  return isFound;
}

// Takes one half of a step. Returns whether that is the lower one.
bool waterHalve(vec3 start, vec3 way, float middle, float depth, inout WaterMarch march)
{
  float rayDepth = min(start.z + middle * way.z, 1.0);
  bool isBehind = rayDepth > depth;
  bool isHigh = isBehind || (!march.isHit && depth >= march.rayHigh); // beyond the edge
  march.isHit = march.isHit || isBehind;
  march.high = isHigh ? middle : march.high;
  march.depthHigh = isHigh ? depth : march.depthHigh;
  march.rayHigh = isHigh ? rayDepth : march.rayHigh;
  march.low = isHigh ? march.low : middle;
  march.depthLow = isHigh ? march.depthLow : depth;
  --march.rest;
  return isHigh;
}

// Halves a step four times, each time with both of the next middles. Returns whether all of it was done.
bool waterMarchHalvings(vec3 start, vec3 way, inout WaterMarch march)
{
  int halvings = 0;
  while (halvings < 4 && march.rest > 0)
  {
    float middle = 0.5 * (march.low + march.high);
    float lower = 0.5 * (march.low + middle);
    float upper = 0.5 * (middle + march.high);
    float depth = waterDepthToMeet(start.xy + middle * way.xy);
    float depthLower = waterDepthToMeet(start.xy + lower * way.xy);
    float depthUpper = waterDepthToMeet(start.xy + upper * way.xy);
    bool isLower = waterHalve(start, way, middle, depth, march);
    ++halvings;
    if (march.rest > 0)
    {
      waterHalve(start, way, isLower ? lower : upper, isLower ? depthLower : depthUpper, march);
      ++halvings;
    }
  }
  return halvings == 4;
}

// Marches a ray that has not converged.
void waterMarchRay(vec3 start, inout WaterRayHit hit)
{
  vec3 way = hit.line;
  float depthEnd = waterDepthToMeet(start.xy + way.xy);
  WaterMarch march = WaterMarch(0.0, 0.0, hit.depthStart, 1.0, 1.0, false, waterSteps + 20);
  bool isMissed = true;
  while (isMissed && march.rest > 0 && march.low < 1.0)
  {
    isMissed = false;
    if (waterMarchSteps(start, way, march))
    {
      float next = march.high; // where the steps go on when the halvings meet nothing
      float depthNext = march.depthHigh;
      isMissed = waterMarchHalvings(start, way, march) && !march.isHit;
      march.low = isMissed ? next : march.low;
      march.depthLow = isMissed ? depthNext : march.depthLow;
    }
  }
  float toInfinity = waterReflectionZInfinity - march.depthHigh;
  hit.behind = (march.rayHigh - march.depthHigh) / toInfinity;
  hit.passed = march.high;
  bool isSurface = march.depthLow - march.depthHigh <= waterReflectionTolerance.y * toInfinity;
  if (march.isHit && !isSurface && hit.behind <= waterReflectionTolerance.y)
  {
    float leaves = march.high;
    isSurface = waterComesOut(start, way, true, march.depthHigh, leaves);
    march.high = isSurface ? leaves : march.high;
  }
  bool isOpen = hit.isInside && waterIsSky(depthEnd);
  // the front side, not filtered
  vec2 front = (floor((start.xy + march.low * way.xy) * waterReflectionTexels) + 0.5) / waterReflectionTexels;
  // met nothing; a surface: filtered; goes behind something, and where it ends there is sky; front
  vec2 uv = start.xy + (march.isHit && isSurface ? march.high : 1.0) * way.xy;
  hit.uv = march.isHit && !isSurface && !isOpen ? front : uv;
  bool isSky = march.isHit ? !isSurface && (isOpen ? waterIsSkyByRay() || depthEnd >= WATER_UNMET : waterIsSky(march.depthLow))
                           : hit.isOver || (waterIsSky(depthEnd) && (waterIsSkyByRay() || !hit.isInside));
  hit.reason = march.isHit ? (isSurface ? WATER_HIT : WATER_HIDDEN)
                           : (hit.isInside ? WATER_SKY : WATER_OFF_MAP);
  hit.isPlace = !isSky || !waterIsSkyKnown();
}

void waterFollowRay(vec3 start, inout WaterRayHit hit)
{
  hit.isSettled = false;
  if (waterHasConverged(start, hit))
  {
    float s = hit.s;
    float depth = hit.depth;
    if (s < 1.0) // read together with the probes, though it is of no use where these find something
    {
      s = waterPlaceOnRay(start, waterPerDepth(hit.line), depth);
      depth = waterDepthToMeet(start.xy + s * hit.line.xy);
    }
    WaterProbed probed = WaterProbed(true, hit.depthStart, hit.depth);
    waterProbe(start, waterProbesOf(hit, max(waterProbes, 0)), hit, probed);
    float rayDepth = min(start.z + hit.s * hit.line.z, 1.0);
    hit.isSettled = probed.isFree && !waterMayPassBehind(probed.depthBefore, hit.depth, rayDepth);
    if (hit.isSettled)
    {
      waterRefine(start, s, depth, hit);
    }
  }
  if (!hit.isSettled)
  {
    waterMarchRay(start, hit);
  }
}

// As in vtkWaterRayWalkFS.glsl, of one of several facets that is neither followed nor scanned.
void waterRefineHit(vec3 start, bool isFollowed, bool isScanned, inout WaterRayHit hit)
{
  int probes = waterHasConverged(start, hit) ? waterProbesOf(hit, min(waterProbes, WATER_FACET_PROBES)) : 0;
  WaterProbed probed = WaterProbed(true, hit.depthStart, hit.depth);
  waterProbe(start, probes, hit, probed);
  if (probed.near < hit.depth)
  {
    hit.uv = start.xy + clamp((probed.near - start.z) * waterPerDepth(hit.line), 0.0, 1.0) * hit.line.xy;
    hit.depth = probed.near;
    hit.isPlace = true;
  }
}
