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

const float WATER_PROBE_PX = 6.0; // between probes; the default's are closer on ways below 42

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

// The way of a ray through the map's window, from its start to where it leaves the map, or all that
// there is to meet.
struct WaterWay
{
  vec3 line;     // the ray is start + s line, s in [0, 1]
  bool isOver;   // ends over all that the map shows
  bool isInside; // ends on the map
};

WaterWay waterWay(vec3 start, float startW, vec3 dir)
{
  WaterWay way;
  vec4 end = waterDirToMap * vec4(dir, 0.0);
  way.line = 0.5 * (end.xyz - (2.0 * start - 1.0) * end.w);
  float last = end.w > 1e-6 ? 1.0 / end.w : (way.line.z > 0.0 ? (1.0 - start.z) / way.line.z : 1e20);
  // over the highest thing there is nothing but sky
  float climb = waterMapTop / max(dir.z, 1e-6);
  float climbW = startW + climb * end.w;
  float overAll = climbW > 0.0 ? climb / climbW : 1e20;
  vec2 border = (step(0.0, way.line.xy) - start.xy) /
    mix(way.line.xy, vec2(1e-9), equal(way.line.xy, vec2(0.0)));
  float leaves = max(min(border.x, border.y), 0.0);
  way.isOver = overAll < min(last, leaves);
  last = min(last, overAll);
  way.isInside = last <= leaves;
  way.line *= min(last, leaves);
  return way;
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
  WaterWay bounded = waterWay(start, startW, dir);
  vec3 way = bounded.line;
  bool isOver = bounded.isOver;
  bool isInside = bounded.isInside;

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
  // nothing nearer on the way; of a short one fewer probes miss no more
  float lengthPx = s * length(way.xy * vec2(textureSize(waterReflectionDepth, 0)));
  int probes = isSettled ? min(waterProbes, int(lengthPx / WATER_PROBE_PX)) : 0;
  float part = s / float(probes + 1);
  float depthBefore = depthStart;
  for (int i = 1; i <= probes && isSettled; ++i)
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
  for (int i = 0; i < 2 && isSettled && s <= 0.9999; ++i)
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

// What one of several facets sees: a place of the map, or a colour.
//
// Returns whether it is a place.
bool waterFacetSees(WaterPoint point, out vec2 uv, out vec3 color)
{
  // All of them together are blurred: two steps find each of them well enough.
  vec3 dir = reflect(point.ray, point.normal);
  dir.z = max(abs(dir.z), 1e-6);
  waterFloor = point.height;
  WaterWay way = waterWay(point.start, point.startW, dir);
  float perDepth = 1.0 / (abs(way.line.z) > 1e-20 ? way.line.z : 1e-20);
  float depth = waterMapDepth(point.start.xy);
  float s = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    s = clamp((depth - point.start.z) * perDepth, 0.0, 1.0);
    uv = point.start.xy + s * way.line.xy;
    depth = waterMapDepth(uv);
  }
  color = waterSky(dir);
  bool isSky = s > 0.9999 && depth >= 1.0 && !way.isInside;
  return !isSky || waterSkyBottom.a <= 0.5;
}

// The places that some facets see, blurred over their distance: several sharp images would be seen as
// several.
//
// count  2, or 4: quarters of the slopes, on the line through the two; 0: none
vec3 waterBlurred(WaterPlaces places, int count)
{
  vec3 blurred = vec3(0.0);
  vec2 middle = 0.5 * (places.two.xy + places.two.zw);
  vec2 arm = 0.5 * (places.two.zw - places.two.xy);
  float level = 0.0;
  for (int i = 0; i < count; ++i)
  {
    if (i == 0)
    {
      float apart = length(arm * vec2(textureSize(waterReflection, 0))) * (count == 2 ? 2.0 : 0.909);
      level = log2(max(0.3 * apart, 1.0));
    }
    float node = float(i & 1) * 2.0 - 1.0;
    float share = (i & 1) == 0 ? places.shares.x : places.shares.y;
    node *= count == 2 ? 1.0 : (i < 2 ? 0.378 : 1.363);
    blurred += share * textureLod(waterReflection, middle + node * arm, level).rgb;
  }
  return blurred * (count == 4 ? 0.5 : 1.0);
}
