// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareMediumFS.glsl: slot refraction for hardware, where a branch that a pixel does not take costs nothing, and
// registers count: a march that goes on behind what hides the bed, as in vtkWaterMediumWalkFS.glsl, took a quarter more of
// the surface's time on an H200. Here the color beside the edge is taken.

const float WATER_MEDIUM_JUMP = 8.0; // a silhouette's, in depths that the ray goes meanwhile

// Asking the texture takes as long as a read.
vec2 waterMediumSize()
{
  return floor(1.0 / (waterViewport.zw * waterSceneScale) + 0.5);
}

// Only beside the background, which may be much brighter, and what stands over the water: a look at more neighbours took
// 4 % of a frame on an H200. Several rays of a multisampled picture's pixel need all edges.
bool waterMediumIsNearEdge(vec2 middle, vec2 next, float depth)
{
  vec3 near = vec3(
    waterMediumDepth(next), waterMediumDepth(vec2(next.x, middle.y)), waterMediumDepth(vec2(middle.x, next.y)));
  float nearest = min(near.x, min(near.y, near.z));
  bool isOver = dot(waterHeightClip, vec4(2.0 * vec3(next, nearest) - 1.0, 1.0)) > 0.0;
  return waterMediumIsSorted != 0 || max(near.x, max(near.y, near.z)) >= 1.0 || isOver;
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

void waterMediumTestSteps(vec3 start, vec3 way, vec4 at, vec4 depths, inout WaterMediumHit found)
{
  for (int i = 0; i < 4; ++i)
  {
    if (!found.isHit)
    {
      waterMediumTest(at[i], start.z + at[i] * way.z, depths[i], found);
    }
  }
}

// Halves the step of a hit four times, each time with both of the next middles.
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
    float rayDepth = start.z + middle * way.z;
    bool isLower = rayDepth > depth;
    waterMediumTest(middle, rayDepth, depth, found);
    float next = isLower ? lower : upper;
    waterMediumTest(next, start.z + next * way.z, isLower ? depthLower : depthUpper, found);
  }
}

void waterMediumMarch(vec3 start, vec3 way, float reach, inout WaterMediumHit found)
{
  for (int first = 1; first <= WATER_MEDIUM_STEPS && !found.isHit; first += 4)
  {
    vec4 at = reach * (vec4(float(first)) + vec4(0.0, 1.0, 2.0, 3.0)) / float(WATER_MEDIUM_STEPS);
    waterMediumTestSteps(start, way, at, waterMediumReadSteps(start, way, at), found);
  }
  if (found.isHit)
  {
    waterMediumHalve(start, way, found);
  }
}

WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach)
{
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, waterMediumDepth(start.xy + reach * way.xy), 0.0, false, false);
  float pixels = length(way.xy * waterMediumSize()); // for all of the way
  bool isFound = start.z <= depth;
  if (isFound && start.z + reach * way.z > found.depthHigh)
  {
    isFound = waterMediumConverge(start, way, pixels, found);
  }
  if (!isFound || !waterMediumIsFree(start, way, found.high, found.high * pixels))
  {
    found = WaterMediumHit(0.0, reach, depth, depth, 0.0, false, false);
    waterMediumMarch(start, way, reach, found);
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
  vec2 size = waterMediumSize();
  float texel = 1.0 / max(length(way.xy * size), 1e-6);
  bool isEdge =
    found.isHit && found.depthLow - found.depthHigh > WATER_MEDIUM_JUMP * way.z * max(found.high - found.low, texel);
  // the false position between the two, which are close
  float missLow = start.z + found.low * way.z - found.depthLow;
  float missHigh = start.z + found.high * way.z - found.depthHigh;
  WaterMediumView view;
  view.s = found.isHit ? found.low - missLow * (found.high - found.low) / max(missHigh - missLow, 1e-20) : reach;
  view.isMet = !isEdge && (found.isHit || isInside);
  // behind something: what is beside it, not filtered
  view.from = isEdge ? (floor((start.xy + found.low * way.xy) * size) + 0.5) / size : start.xy + view.s * way.xy;
  view.to = isEdge ? (floor((start.xy + found.high * way.xy) * size) + 0.5) / size : view.from;
  view.share = 0.0;
  view.isOut = !found.isHit && !isInside;
  view.isHidden = isEdge && waterMediumHeight(view.to, found.depthHigh) > 0.0; // it stands over the water
  view.isBelow = view.isOut && waterMediumPassesBelow(start, way, leaves, deepest);
  return view;
}
