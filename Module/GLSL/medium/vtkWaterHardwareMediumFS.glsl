// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareMediumFS.glsl: slot refraction for hardware, where a branch that a pixel does not take costs nothing: the
// march ends early, and short ways take fewer steps. What hides the bed is passed as in vtkWaterMediumWalkFS.glsl, but
// whether a surface goes on is told from one place, not from three.

const float WATER_MEDIUM_STEP_PX = 1.0;  // least length of a step
// Up to so many times as steep as on the whole way a bed is one surface. Of less, far beds are marched for nothing; of
// 6, rays go through silhouettes under water.
const float WATER_MEDIUM_SLACK_PX = 2.5;
// A ray that has come to a surface since it was last in front is behind it by the depth that it went meanwhile, or a
// little more. Behind a silhouette it is further.
const float WATER_MEDIUM_JUMP = 1.3;

// Asking the texture takes as long as a read.
vec2 waterMediumSize()
{
  return float(waterSceneSide) * floor(1.0 / (waterViewport.zw * waterSceneScale) + 0.5);
}

// Only beside the background, which may be much brighter, and what stands over the water: a look at more neighbours took
// 4 % of a frame on an H200. In a multisampled picture all edges are looked for: what filtering mixes beside them has no
// sample.
bool waterMediumIsNearEdge(vec2 middle, vec2 next, float depth)
{
  vec3 near = vec3(
    waterMediumDepth(next), waterMediumDepth(vec2(next.x, middle.y)), waterMediumDepth(vec2(middle.x, next.y)));
  float nearest = min(near.x, min(near.y, near.z));
  bool isOver = dot(waterHeightClip, vec4(2.0 * vec3(next, nearest) - 1.0, 1.0)) > 0.0;
  return waterSceneSide > 1 || max(near.x, max(near.y, near.z)) >= 1.0 || isOver;
}

// As in vtkWaterMediumWalkFS.glsl.
float waterMediumReach(vec3 start, vec3 way, float depth)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  float level = max(depth - start.z, 0.0) * perDepth;
  float reach = level;
  for (int i = 0; i < 3; ++i)
  {
    vec3 at = start + reach * way;
    float further = waterMediumDepth(at.xy) - at.z;
    if (further <= 0.0)
    {
      break; // it would stay there
    }
    reach += further * perDepth;
  }
  return level > 0.0 && depth < 1.0 && reach > WATER_MEDIUM_LEVEL * level
    ? waterMediumBedReach(start, way, depth, level, reach)
    : reach;
}

// The depth at a place of a ray of what is as high as its start.
float waterMediumLevel(vec3 start, vec3 way, float at)
{
  return start.z - at * dot(waterHeightClip.xy, way.xy) / waterHeightClip.z;
}

// Tests a place of a ray. What stands over the water hides the bed, and so does a surface that the ray is far behind.
// Neither tells where the ray is. The first such surface under the water is kept as a hit until there is a better one:
// something is likelier than nothing.
//
// Returns whether the ray is behind a surface that it has come to since it was last in front.
bool waterMediumTestKnown(vec3 start, vec3 way, float at, float depth, inout WaterMediumHit found)
{
  float level = waterMediumLevel(start, way, at);
  float miss = start.z + at * way.z - depth;
  bool isBehind = miss > 0.0 && depth >= level;
  bool isMet = isBehind && miss <= WATER_MEDIUM_JUMP * way.z * (at - found.low);
  bool isNone = found.high <= found.low;
  bool isLow = miss <= 0.0 && depth >= level && (depth < 1.0 || isNone);
  bool isHigh = isMet || (isBehind && isNone);
  found.low = isLow ? at : found.low;
  found.depthLow = isLow ? depth : found.depthLow;
  found.high = isHigh ? at : found.high;
  found.depthHigh = isHigh ? depth : found.depthHigh;
  return isMet;
}

// Halves the part where a ray is met four times, each time with both of the next middles.
void waterMediumHalve(vec3 start, vec3 way, inout WaterMediumHit found)
{
  for (int i = 0; i < 2; ++i)
  {
    float middle = 0.5 * (found.low + found.high);
    float lower = 0.5 * (found.low + middle);
    float upper = 0.5 * (middle + found.high);
    float depth = waterMediumDepth(start.xy + middle * way.xy);
    float depthLower = waterMediumDepth(start.xy + lower * way.xy);
    float depthUpper = waterMediumDepth(start.xy + upper * way.xy);
    bool isLower = start.z + middle * way.z > depth;
    waterMediumTestKnown(start, way, middle, depth, found);
    waterMediumTestKnown(start, way, isLower ? lower : upper, isLower ? depthLower : depthUpper, found);
  }
}

// The march in equal steps to the first place where a ray is behind a surface that it has come to.
WaterMediumHit waterMediumMarch(vec3 start, vec3 way, float depth, float reach)
{
  float texel = 1.0 / max(length(way.xy * waterMediumSize()), 1e-6);
  int steps = 4 * clamp(int(ceil(0.25 * reach / (WATER_MEDIUM_STEP_PX * texel))), 1, WATER_MEDIUM_STEPS / 4);
  WaterMediumHit found = WaterMediumHit(0.0, 0.0, depth, depth, 0.0, false, false);
  for (int first = 1; first <= steps && !found.isHit; first += 4)
  {
    vec4 at = reach * (vec4(float(first)) + vec4(0.0, 1.0, 2.0, 3.0)) / float(steps);
    vec4 depths = waterMediumReadSteps(start, way, at);
    found.isHit = waterMediumTestKnown(start, way, at.x, depths.x, found) ||
      waterMediumTestKnown(start, way, at.y, depths.y, found) ||
      waterMediumTestKnown(start, way, at.z, depths.z, found) ||
      waterMediumTestKnown(start, way, at.w, depths.w, found);
  }
  found.isHit = found.high > found.low;
  if (found.isHit)
  {
    waterMediumHalve(start, way, found);
    float missLow = start.z + found.low * way.z - found.depthLow;
    float missHigh = start.z + found.high * way.z - found.depthHigh;
    found.share = -missLow / max(missHigh - missLow, 1e-20);
    // is that where the ray comes in, or is it hidden?
    WaterMediumHit there = found;
    float at = mix(found.low, found.high, found.share);
    waterMediumTestKnown(start, way, at, waterMediumDepth(start.xy + at * way.xy), there);
    bool isJump = missHigh > WATER_MEDIUM_JUMP * way.z * max(found.high - found.low, texel);
    found.isGap = isJump || (there.low == found.low && there.high == found.high);
    found.share = isJump ? 0.0 : found.share;
  }
  else if (found.low < reach * (1.0 - 1e-6))
  {
    waterMediumLastSeen(start, way, found.low + reach / float(steps), WATER_MEDIUM_LAST, found);
  }
  return found;
}

// Is it one surface that a ray is in front of at low and behind at high? On the whole the ray comes to a bed as fast as to
// what is straight behind the water, and is not far behind that.
//
// depth   straight behind the water
// pixels  of all of the way
bool waterMediumIsSurface(vec3 start, vec3 way, float depth, float pixels, WaterMediumHit found)
{
  float rate = depth < 1.0 ? max((depth - start.z) / max(found.high, 1e-20), way.z) : way.z;
  float wide = max(found.high - found.low, 1.0 / max(pixels, 1e-6));
  return found.depthHigh >= waterMediumLevel(start, way, found.high) &&
    found.depthLow - found.depthHigh <= WATER_MEDIUM_SLACK_PX * rate * wide;
}

WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach)
{
  float last = waterMediumDepth(start.xy + reach * way.xy);
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, last, 0.0, false, false);
  float pixels = length(way.xy * waterMediumSize()); // for all of the way
  bool isFound = start.z <= depth;
  if (isFound && start.z + reach * way.z > last)
  {
    bool isConverged = waterMediumConverge(start, way, pixels, found);
    isFound = waterMediumIsSurface(start, way, depth, pixels, found);
    if (isFound && !isConverged)
    {
      waterMediumHalve(start, way, found);
      isFound = waterMediumIsSurface(start, way, depth, pixels, found);
    }
  }
  else
  {
    found.low = reach;
    found.depthLow = last;
  }
  if (!isFound || !waterMediumIsFree(start, way, found.high, found.high * pixels))
  {
    found = waterMediumMarch(start, way, depth, reach);
  }
  return found;
}

WaterMediumView waterMediumMeets(vec3 start, vec3 way, float most, float deepest)
{
  float depth = waterMediumDepth(start.xy);
  float reach = waterMediumReach(start, way, depth);
  reach = depth < 1.0 ? reach : min(reach, most); // the background ends no ray
  float leaves = waterMediumLeaves(start, way);
  bool isInside = reach <= leaves;
  reach = min(reach, leaves);

  WaterMediumHit found = waterMediumWalk(start, way, depth, reach);
  // the false position between the two, which are close
  float missLow = start.z + found.low * way.z - found.depthLow;
  float missHigh = start.z + found.high * way.z - found.depthHigh;
  float share = found.isHit ? -missLow / max(missHigh - missLow, 1e-20) : 0.0;
  WaterMediumView view;
  view.isMet = found.isHit ? !found.isGap && found.depthLow < 1.0 : isInside && found.low >= reach * (1.0 - 1e-6);
  view.s = mix(found.low, found.high, share);
  view.share = view.isMet ? 0.0 : found.share;
  view.isOut = !found.isHit && !isInside;
  view.isHidden = !found.isHit && isInside && !view.isMet;
  // what is beside that which hides it, not filtered
  vec2 beside = waterMediumMiddle(start.xy + found.low * way.xy);
  view.from = found.isGap || view.isHidden ? beside : start.xy + view.s * way.xy;
  view.to = !view.isMet ? waterMediumMiddle(start.xy + found.high * way.xy) : view.from;
  view.isBelow = view.isOut && waterMediumPassesBelow(start, way, leaves, deepest);
  return view;
}

// One place: a mean over several took 0.37 ms of the 3.3 ms of a lake on an H200, though few rays leave the picture.
vec2 waterMediumAside(vec3 dir, WaterMediumRay ray, WaterMediumMet met)
{
  return vec2(0.0);
}

vec3 waterMediumFrom(WaterMediumMet met)
{
  return waterMediumColor(met.view.from, met.depth);
}
