// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareMediumFS.glsl: slot refraction for hardware, where a branch that a pixel does not take costs nothing: a
// ray that comes to a smooth bed, with nothing on the way, is not marched as in vtkWaterMediumWalkFS.glsl, and needs
// half of its reads or less. What it meets is the same to a part of a pixel.

const float WATER_MEDIUM_CLOSE_PX = 0.2; // two places are as good as one
const float WATER_MEDIUM_LONG_PX = 8.0; // ways that need eight looks, and not four

// Asking the texture takes as long as a read.
vec2 waterMediumSize()
{
  return floor(1.0 / waterViewport.zw + 0.5);
}

float waterMediumReach(vec3 start, vec3 way, float depth)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  float reach = max(depth - start.z, 0.0) * perDepth;
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
  return reach;
}

// Depths of the picture at the steps from one on.
vec4 waterMediumReadSteps(vec3 start, vec3 way, vec4 at)
{
  return vec4(waterMediumDepth(start.xy + at.x * way.xy), waterMediumDepth(start.xy + at.y * way.xy),
    waterMediumDepth(start.xy + at.z * way.xy), waterMediumDepth(start.xy + at.w * way.xy));
}

void waterMediumTest(float at, float rayDepth, float depth, inout WaterMediumHit found)
{
  bool isBehind = rayDepth > depth;
  found.high = isBehind ? at : found.high;
  found.depthHigh = isBehind ? depth : found.depthHigh;
  found.low = isBehind ? found.low : at;
  found.depthLow = isBehind ? found.depthLow : depth;
  found.isHit = found.isHit || isBehind;
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

// Is nothing before a place of the ray? So many looks on the way to it do not tell all, but see what the march does
// within some pixels.
bool waterMediumIsFree(vec3 start, vec3 way, float s, float lengthPx)
{
  vec4 parts = s * vec4(0.2, 0.4, 0.6, 0.8);
  bool areMore = lengthPx > WATER_MEDIUM_LONG_PX;
  vec4 more = parts - 0.1 * s;
  vec4 depths = waterMediumReadSteps(start, way, parts);
  vec4 depthsMore = vec4(1.0);
  if (areMore)
  {
    depthsMore = waterMediumReadSteps(start, way, more);
  }
  return all(lessThanEqual(start.z + parts * way.z, depths)) &&
    (!areMore || all(lessThanEqual(start.z + more * way.z, depthsMore)));
}

// Goes to where the line through two misses of a ray is none, up to three times, and from there to where the ray has
// the depth that is found: on one texel that is the place.
//
// pixels  of all of the way
//
// Returns whether the place is found.
bool waterMediumConverge(vec3 start, vec3 way, float pixels, inout WaterMediumHit found)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  for (int i = 0; i < 3; ++i)
  {
    float missLow = start.z + found.low * way.z - found.depthLow;
    float missHigh = start.z + found.high * way.z - found.depthHigh;
    float at = found.low - missLow * (found.high - found.low) / max(missHigh - missLow, 1e-20);
    float depth = waterMediumDepth(start.xy + at * way.xy);
    float there = (depth - start.z) * perDepth;
    waterMediumTest(at, start.z + at * way.z, depth, found);
    if (there > found.low && there < found.high || abs(there - at) * pixels < WATER_MEDIUM_CLOSE_PX)
    {
      float depthThere = waterMediumDepth(start.xy + there * way.xy);
      if (depthThere == depth)
      {
        found = WaterMediumHit(there, there, depth, depth, true);
        return true;
      }
      waterMediumTest(there, start.z + there * way.z, depthThere, found);
    }
    if ((found.high - found.low) * pixels < WATER_MEDIUM_CLOSE_PX)
    {
      return true;
    }
  }
  return false;
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
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, waterMediumDepth(start.xy + reach * way.xy), false);
  float pixels = length(way.xy * waterMediumSize()); // for all of the way
  bool isFound = start.z <= depth;
  if (isFound && start.z + reach * way.z > found.depthHigh)
  {
    isFound = waterMediumConverge(start, way, pixels, found);
  }
  if (!isFound || !waterMediumIsFree(start, way, found.high, found.high * pixels))
  {
    found = WaterMediumHit(0.0, reach, depth, depth, false);
    waterMediumMarch(start, way, reach, found);
  }
  return found;
}
