// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRayWalkFS.glsl: slot walk for software renderers: a ray's reads of the reflection texture one after another,
// each only if the last one asks for it; vtkWaterHardwareRaysFS.glsl is the same for hardware. Software renderers execute
// both sides of a branch, and loops until the last of 8 pixels is done: there is one loop of each kind, and
// conditions choose values.

// The uniforms that rays need, read once per pixel. Software renderers take some 30 instructions to
// read each number, and would do so for every ray. Compilers would undo a plain copy.
mat4 waterHalfToReflection; // half of waterDirToReflection
vec2 waterToSlack;          // how far a ray may be off a depth and has converged: x depth + y
vec2 waterReflectionSize;   // texels
float waterHighest;         // waterReflectionTop
int waterProbesOfOne;
int waterProbesOfSeveral; // each

void waterReadOnce()
{
  waterHalfToReflection = 0.5 * waterDirToReflection;
  waterToSlack = waterReflectionTolerance.x * vec2(-1.0, waterReflectionZInfinity);
  waterReflectionSize = vec2(textureSize(waterReflection, 0));
  waterHighest = max(waterReflectionTop, 0.0);
  waterProbesOfOne = max(waterProbes, 0);
  waterProbesOfSeveral = min(waterProbes, WATER_FACET_PROBES);
}

vec4 waterHalfEnd(vec3 dir)
{
  return waterHalfToReflection * vec4(dir, 0.0);
}

float waterSlackAt(float depth)
{
  return waterToSlack.x * depth + waterToSlack.y;
}

vec2 waterReflectionPx()
{
  return waterReflectionSize;
}

float waterTop()
{
  return waterHighest;
}

// Has an estimate converged, as far as its own place tells?
bool waterHasConverged(vec3 start, WaterRayHit hit)
{
  float rayDepth = start.z + hit.s * hit.line.z;
  return hit.s >= 1.0 ? min(rayDepth, 1.0) <= hit.depth : abs(rayDepth - hit.depth) <= waterSlackAt(hit.depth);
}

// Tests whether an estimate has converged on what the ray meets.
//
// Loops are tested at their end: software renderers execute their bodies once more than needed otherwise.
//
// most  probes
void waterProbe(vec3 start, int most, inout WaterRayHit hit)
{
  vec3 way = hit.line;
  float s = hit.s;
  float depth = hit.depth;
  float rayDepth = min(start.z + s * way.z, 1.0);
  bool isSettled = waterHasConverged(start, hit);
  // nothing nearer on the way; of a short one fewer probes miss no more
  float lengthPx = s * length(way.xy * waterReflectionSize);
  int probes = isSettled ? min(most, int(lengthPx / WATER_PROBE_PX)) : 0;
  float part = s / float(probes + 1);
  float depthBefore = hit.depthStart;
  int probe = 1;
  float depthNear = depth;
  do
  {
    vec3 at = start + part * float(probe) * way;
    float depthProbe = waterDepthToMeet(at.xy);
    float atDepth = min(at.z, 1.0);
    bool isFree =
      atDepth <= depthProbe && !waterMayPassBehind(depthBefore, depthProbe, atDepth);
    bool isProbe = probe <= probes;
    isSettled = isSettled && (isFree || !isProbe);
    depthBefore = isProbe ? depthProbe : depthBefore;
    depthNear = isProbe && !isFree ? depthProbe : depthNear;
    ++probe;
  } while (probe <= probes && isSettled);
  hit.isSettled = isSettled && !waterMayPassBehind(depthBefore, depth, rayDepth);
  hit.near = depthNear;
}

// Probes the way of the first of several facets closely, all of it if the estimate has not converged.
void waterScan(vec3 start, bool isWanted, inout WaterRayHit hit)
{
  vec3 way = hit.line;
  float end = waterHasConverged(start, hit) ? hit.s : 1.0;
  int probes = isWanted ? 4 * waterScanRounds(end * length(way.xy * waterReflectionSize)) : 0;
  float part = end / float(probes + 1);
  bool isMet = false;
  bool isBehind = false;
  float high = 0.0;
  float depthLow = hit.depthStart; // of the reflection texture
  float depthHigh = hit.depthStart;
  for (int probe = 1; probe <= probes && !isMet; ++probe)
  {
    high = part * float(probe);
    float rayDepth = min(start.z + high * way.z, 1.0);
    depthLow = depthHigh;
    depthHigh = waterDepthToMeet(start.xy + high * way.xy);
    isBehind = rayDepth > depthHigh;
    isMet = isBehind || waterMayPassBehind(depthLow, depthHigh, rayDepth);
  }
  float low = high - part;
  for (int i = 0; i < WATER_SCAN_HALVINGS; ++i)
  {
    float middle = 0.5 * (low + high);
    float depth = waterDepthToMeet(start.xy + middle * way.xy);
    float rayDepth = min(start.z + middle * way.z, 1.0);
    bool isHigh = rayDepth > depth || (!isBehind && waterMayPassBehind(depthLow, depth, rayDepth));
    isBehind = isBehind || rayDepth > depth;
    low = isHigh ? low : middle;
    depthLow = isHigh ? depthLow : depth;
    high = isHigh ? middle : high;
    depthHigh = isHigh ? depth : depthHigh;
  }
  hit.uv = isMet ? start.xy + (isBehind ? high : low) * way.xy : hit.uv;
  hit.depth = isMet ? (isBehind ? depthHigh : depthLow) : hit.depth;
  hit.isPlace = hit.isPlace || isMet;
}

// Marches a ray that has not converged, and refines others.
//
// isWanted  or else nothing that comes of it is used
//
// Long because it is one loop: its state would be a dozen inout arguments, which software renderers copy.
void waterMarchRay(vec3 start, bool isWanted, inout WaterRayHit hit)
{
  vec3 way = hit.line;
  float s = hit.s;
  float depth = hit.depth;
  bool isSettled = hit.isSettled || !isWanted;
  // the depth there leads closer still
  float perDepth = waterPerDepth(way);
  vec2 uv = hit.uv;
  for (int i = 0; i < 2; ++i)
  {
    s = s >= 1.0 ? s : waterPlaceOnRay(start, perDepth, depth);
    uv = start.xy + s * way.xy;
    depth = waterDepthToMeet(uv);
  }
  bool isEnd = s >= 1.0; // nothing was met
  bool isSky = isEnd && (hit.isOver || (waterIsSky(depth) && (waterIsSkyByRay() || !hit.isInside)));
  int reason = isEnd ? (hit.isInside ? WATER_SKY : WATER_OFF_MAP) : WATER_HIT;
  if (!isSettled)
  {
    // steps; one that ends behind the reflection texture, or may have been there on its way, is halved
    float low = 0.0;
    float high = 0.0;
    float next = 0.0; // where the steps go on when the halvings met nothing
    float depthLow = hit.depthStart;
    float depthHigh = 1.0;
    float depthNext = 1.0;
    float rayHigh = 1.0; // depth of the ray
    float depthEnd = waterDepthToMeet(start.xy + way.xy);
    bool isHit = false;
    float stride = 1.0 / float(waterSteps);
    int rest = waterSteps + 20; // the hit and four edges
    int halvings = 0;
    do
    {
      bool isHalving = halvings > 0;
      float middle = isHalving ? 0.5 * (low + high) : min(low + stride, 1.0);
      depth = waterDepthToMeet(start.xy + middle * way.xy);
      float rayDepth = min(start.z + middle * way.z, 1.0);
      bool isBehind = rayDepth > depth;
      bool isJump = !isHalving && !isBehind && waterMayPassBehind(depthLow, depth, rayDepth);
      bool isBeyond = isHalving && !isHit && depth >= rayHigh; // of the edge
      isHit = isHit || isBehind;
      next = isJump ? middle : next;
      depthNext = isJump ? depth : depthNext;
      bool isHigh = isBehind || isJump || isBeyond;
      high = isHigh ? middle : high;
      depthHigh = isHigh ? depth : depthHigh;
      rayHigh = isHigh ? rayDepth : rayHigh;
      low = isHigh ? low : middle;
      depthLow = isHigh ? depthLow : depth;
      halvings += (isHalving || isBehind || isJump) ? 1 : 0;
      bool isMissed = halvings >= 5 && !isHit;
      low = isMissed ? next : low;
      depthLow = isMissed ? depthNext : depthLow;
      halvings = isMissed ? 0 : halvings;
      --rest;
    } while (rest > 0 && halvings < 5 && (halvings > 0 || low < 1.0));
    hit.behind = (rayHigh - depthHigh) / (waterReflectionZInfinity - depthHigh);
    hit.passed = high;
    bool isSurface = depthLow - depthHigh <= waterReflectionTolerance.y * (waterReflectionZInfinity - depthHigh);
    float leaves = high;
    bool isOut = waterComesOut(start, way, isHit && !isSurface && hit.behind <= waterReflectionTolerance.y, depthHigh, leaves);
    high = isOut ? leaves : high;
    isSurface = isSurface || isOut;
    bool isOpen = hit.isInside && waterIsSky(depthEnd);
    // the front side, not filtered
    vec2 size = vec2(textureSize(waterReflection, 0));
    vec2 front = (floor((start.xy + low * way.xy) * size) + 0.5) / size;
    // met nothing; a surface: filtered; goes behind something, and where it ends there is sky; front
    uv = start.xy + (isHit && isSurface ? high : 1.0) * way.xy;
    uv = isHit && !isSurface && !isOpen ? front : uv;
    isSky = isHit ? !isSurface && (isOpen ? waterIsSkyByRay() || depthEnd >= WATER_UNMET : waterIsSky(depthLow))
                  : hit.isOver || (waterIsSky(depthEnd) && (waterIsSkyByRay() || !hit.isInside));
    reason = isHit ? (isSurface ? WATER_HIT : WATER_HIDDEN)
                   : (hit.isInside ? WATER_SKY : WATER_OFF_MAP);
  }
  hit.uv = uv;
  hit.reason = reason;
  hit.isPlace = !isSky || !waterIsSkyKnown();
}

float waterEdgeBetween(vec2 on, vec2 way, float depth, bool isWanted)
{
  float low = 0.0;
  float high = 2.0; // the first look is at the end
  int rest = isWanted ? 5 : 0;
  for (int i = 0; i < rest; ++i)
  {
    float middle = 0.5 * (low + high);
    bool isOn = waterDepthToMeet(on + middle * way) <= depth;
    low = isOn ? middle : low;
    high = isOn ? high : middle;
    rest = low < 1.0 ? rest : 0;
  }
  return min(0.5 * (low + high), 1.0);
}

// Probes. A ray that is not marched meets what they find, about where that is.
void waterRefineHit(vec3 start, bool isFollowed, bool isScanned, inout WaterRayHit hit)
{
  waterProbe(start, isFollowed ? waterProbesOfOne : (isScanned ? 0 : waterProbesOfSeveral), hit);
  float perDepth = waterPerDepth(hit.line);
  bool isNear = hit.near < hit.depth && !isFollowed;
  float s = clamp((hit.near - start.z) * perDepth, 0.0, 1.0);
  hit.uv = isNear ? start.xy + s * hit.line.xy : hit.uv;
  hit.depth = isNear ? hit.near : hit.depth;
  hit.isPlace = hit.isPlace || isNear;
  waterScan(start, isScanned && !isFollowed, hit);
}

void waterFollowRay(vec3 start, inout WaterRayHit hit)
{
  waterProbe(start, waterProbesOfOne, hit);
  waterMarchRay(start, true, hit);
}
