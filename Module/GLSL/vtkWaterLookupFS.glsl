// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLookupFS.glsl: stage reflection: where the map shows what a reflected ray meets. The formulas
// of the rays are in water_lookup.h, the rules and what each is worth in
// Documentation/decisions/006-lookup.md. Needs vtkWaterPointFS.glsl before it.

uniform sampler2D waterReflection;      // mirrored view, flipped in x; linear
uniform sampler2D waterReflectionDepth; // its window depth, 1: nothing drawn; nearest
uniform mat4 waterDirToMap;             // direction in the plane's axes -> clip of the map
uniform float waterMapTop; // height over the plane of all that the map shows
uniform float waterMapZInfinity;
uniform vec2 waterMapTolerance; // settled on a surface; a surface on both sides of a crossing
uniform int waterSteps;         // of the march
uniform int waterProbes;        // between the water and where the ray settled

// Why a pixel has its colour (vtkWaterProperty::Confidences).
const int WATER_HIT = 1;
const int WATER_SKY = 2;
const int WATER_OFF_MAP = 3;
const int WATER_HIDDEN = 4;
const int WATER_DOWNWARD = 5;

const float WATER_THICKNESS = 0.05; // of things that cast shadows, over their distance

// How far behind the edge of a thing the last ray went, over the thing's distance.
float waterBehind = 0.0;

float waterFloor = -1e30; // height that no ray of this pixel meets anything below

float waterMapDepth(vec2 uv)
{
  float depth = textureLod(waterReflectionDepth, uv, 0.0).r;
  return waterIsUnder(uv, depth, waterFloor) ? 1.0 : depth;
}

// Can a ray that is in front of the map before and after a step have been behind the edge of a thing
// on its way? The map's depth jumps back then, and the ray is as deep as the thing.
//
// depthBefore  of the map, before the step
// depth        of the map, after it
// rayDepth     after it
bool waterMayPassBehind(float depthBefore, float depth, float rayDepth)
{
  float slack = waterMapTolerance.x * (waterMapZInfinity - depthBefore);
  return depth > depthBefore + slack && rayDepth > depthBefore - slack;
}

// Colour in a direction from a point of the water.
//
// start   of the ray in the map's window: u, v, depth
// startW  w of the start in clip space of the map
// dir     in the plane's axes, upwards, of unit length
// reason  one of the first four
// uv      where in the map that is
vec3 waterTrace(vec3 start, float startW, vec3 dir, out int reason, out vec2 uv)
{
  vec4 end = waterDirToMap * vec4(dir, 0.0);
  vec3 way = 0.5 * (end.xyz - (2.0 * start - 1.0) * end.w); // the ray is start + s way
  float last = end.w > 1e-6 ? 1.0 / end.w : (way.z > 0.0 ? (1.0 - start.z) / way.z : 1e20);
  // over the highest thing there is nothing but sky
  float climb = waterMapTop / max(dir.z, 1e-6);
  float climbW = startW + climb * end.w;
  float overAll = climbW > 0.0 ? climb / climbW : 1e20;
  vec2 border =
    (step(0.0, way.xy) - start.xy) / mix(way.xy, vec2(1e-9), equal(way.xy, vec2(0.0)));
  float leaves = max(min(border.x, border.y), 0.0);
  bool isOver = overAll < min(last, leaves);
  last = min(last, overAll);
  bool isInside = last <= leaves; // the ray ends on the map
  way *= min(last, leaves);       // from here on s is in [0, 1]

  // steps to the depth that the map has where the ray is now
  float perDepth = 1.0 / (abs(way.z) > 1e-20 ? way.z : 1e-20);
  float depthStart = waterMapDepth(start.xy);
  float depth = depthStart;
  float s = 0.0;
  vec3 at = start;
  for (int i = 0; i < 2; ++i)
  {
    s = clamp((depth - start.z) * perDepth, 0.0, 1.0);
    at = start + s * way;
    depth = waterMapDepth(at.xy);
  }
  bool isSettled = s > 0.9999
    ? min(at.z, 1.0) <= depth
    : abs(at.z - depth) <= waterMapTolerance.x * (waterMapZInfinity - depth);
  // nothing nearer on the way
  float part = s / float(waterProbes + 1);
  float depthBefore = depthStart;
  for (int i = 1; i <= waterProbes; ++i)
  {
    vec3 probe = start + part * float(i) * way;
    float rayDepth = min(probe.z, 1.0);
    float depthProbe = waterMapDepth(probe.xy);
    isSettled = isSettled && rayDepth <= depthProbe &&
      !waterMayPassBehind(depthBefore, depthProbe, rayDepth);
    depthBefore = depthProbe;
  }
  isSettled = isSettled && !waterMayPassBehind(depthBefore, depth, min(at.z, 1.0));

  // the depth there leads closer still
  for (int i = 0; i < 2 && isSettled; ++i)
  {
    s = clamp((depth - start.z) * perDepth, 0.0, 1.0);
    at = start + s * way;
    depth = waterMapDepth(at.xy);
  }
  uv = at.xy;
  bool isEnd = isSettled && s > 0.9999; // nothing was met
  bool isSky = isEnd && (isOver || (depth >= 1.0 && !isInside));
  reason = s <= 0.9999 ? WATER_HIT : (isInside ? WATER_SKY : WATER_OFF_MAP);
  if (!isSettled)
  {
    // steps; one that ends behind the map, or may have been there on its way, is halved
    float low = 0.0;
    float high = 0.0;
    float next = 0.0; // where the steps go on when the halvings met nothing
    float depthLow = depthStart;
    float depthHigh = 1.0;
    float depthNext = 1.0;
    float rayHigh = 1.0; // depth of the ray
    float depthEnd = waterMapDepth(start.xy + way.xy);
    bool isHit = false;
    float stride = 1.0 / float(waterSteps);
    for (int i = 0, halvings = 0; i < waterSteps + 20; ++i) // the hit and four edges
    {
      bool isHalving = halvings > 0;
      float middle = isHalving ? 0.5 * (low + high) : min(low + stride, 1.0);
      depth = waterMapDepth(start.xy + middle * way.xy);
      float rayDepth = min(start.z + middle * way.z, 1.0);
      bool isBehind = rayDepth > depth;
      bool isJump = !isHalving && !isBehind && waterMayPassBehind(depthLow, depth, rayDepth);
      bool isBeyond = isHalving && !isHit && depth >= rayHigh; // of the edge
      isHit = isHit || isBehind;
      if (isJump)
      {
        next = middle;
        depthNext = depth;
      }
      if (isBehind || isJump || isBeyond)
      {
        high = middle;
        depthHigh = depth;
        rayHigh = rayDepth;
      }
      else
      {
        low = middle;
        depthLow = depth;
      }
      halvings += (isHalving || isBehind || isJump) ? 1 : 0;
      if (halvings >= 5 && !isHit)
      {
        low = next;
        depthLow = depthNext;
        halvings = 0;
      }
      if (halvings >= 5 || (halvings == 0 && low >= 1.0))
      {
        break;
      }
    }
    waterBehind = (rayHigh - depthHigh) / (waterMapZInfinity - depthHigh);
    if (!isHit)
    {
      uv = start.xy + way.xy;
      isSky = isOver || (!isInside && depthEnd >= 1.0);
      reason = isInside ? WATER_SKY : WATER_OFF_MAP;
    }
    else if (depthLow - depthHigh <= waterMapTolerance.y * (waterMapZInfinity - depthHigh))
    {
      uv = start.xy + high * way.xy; // a surface: filtered
      reason = WATER_HIT;
    }
    else if (isInside && depthEnd >= 1.0)
    {
      uv = start.xy + way.xy; // it goes behind something; where it ends there is sky
      reason = WATER_HIDDEN;
    }
    else
    {
      vec2 size = vec2(textureSize(waterReflection, 0)); // the front side, not filtered
      uv = (floor((start.xy + low * way.xy) * size) + 0.5) / size;
      isSky = depthLow >= 1.0;
      reason = WATER_HIDDEN;
    }
  }
  if (reason == WATER_HIT && waterMapDepth(uv) >= 1.0)
  {
    reason = WATER_SKY; // settled on the far plane, where nothing is
  }
  bool isKnown = isSky && waterSkyBottom.a > 0.5;
  return isKnown ? waterSky(dir) : textureLod(waterReflection, uv, 0.0).rgb;
}

// Colour of the reflection.
//
// reason  one of the above
// uv      where in the map that is
vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  vec3 dir = reflect(point.ray, point.normal);
  bool isDownward = dir.z < 0.0;
  dir.z = max(abs(dir.z), 1e-6); // met the water again: bounced off it once more
  waterFloor = point.height;
  vec3 color = waterTrace(point.start, point.startW, dir, reason, uv);
  reason = isDownward ? WATER_DOWNWARD : reason;
  return color;
}

// How much of the light from a direction something keeps off, as far as the map shows it.
float waterShaded(WaterPoint point, vec3 dir)
{
  int reason;
  vec2 uv;
  waterTrace(point.start, point.startW, vec3(dir.xy, max(dir.z, 1e-6)), reason, uv);
  // a ray that goes close behind an edge meets a side that the map does not show
  bool isSide = reason == WATER_HIDDEN && waterBehind < WATER_THICKNESS;
  return reason == WATER_HIT || isSide ? 1.0 : 0.0;
}

// Is what a facet sees a place of the map?
bool waterIsOfMap(int reason)
{
  return reason != WATER_OFF_MAP;
}

// Places of the map with their shares, blurred over their distance.
//
// sharp  the same without a blur
vec3 waterBlurred(vec2 places[4], vec4 shares, int count, vec3 sharp)
{
  vec2 apart = (places[count - 2] - places[count - 1]) / float(count - 1);
  float level = log2(max(0.3 * length(apart * vec2(textureSize(waterReflection, 0))), 1.0));
  vec3 blurred = vec3(0.0);
  for (int i = 0; i < count; ++i)
  {
    blurred += shares[i] * textureLod(waterReflection, places[i], level).rgb;
  }
  return level > 0.0 ? blurred : sharp;
}
