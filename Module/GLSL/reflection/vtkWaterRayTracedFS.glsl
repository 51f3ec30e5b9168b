// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRayTracedFS.glsl: slot reflection: where the reflection texture shows
// what a reflected ray meets. The formulas of the rays are in water_lookup.h, the rules and what each is worth in
// Documentation/decisions/006-lookup.md.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform mat4 waterDirToReflection; // direction in the plane's axes -> clip of the reflection texture
uniform float waterReflectionTop;  // height over the plane of all that the reflection texture shows
uniform float waterReflectionZInfinity;
uniform vec2 waterReflectionTolerance; // converged on a surface; a surface on both sides of a crossing
uniform int waterSteps;                // of the march
uniform int waterProbes;               // between the water and where the ray converged

// Why a pixel has its colour (vtkWaterProperty::Confidences).
const int WATER_HIT = 1;
const int WATER_SKY = 2;
const int WATER_OFF_MAP = 3;
const int WATER_HIDDEN = 4;
const int WATER_DOWNWARD = 5;

const float WATER_THICKNESS = 0.05; // of things that cast shadows, over their distance

const int WATER_FACET_PROBES = 3; // for one of several facets

const float WATER_PROBE_PX = 6.0; // between probes; the default's are closer on ways below 42

const float WATER_UNMET = 2.0; // depth of what a ray cannot meet: beyond the background's

float waterFloor = -1e30;   // height that no ray of this pixel meets anything below
float waterNearest = -1e30; // depth that the ray meets nothing before

// What rays need of the uniforms, read once for all of a pixel: software renderers take some 30
// instructions to read each number, and would for every ray. A plain copy would be undone by compilers.
mat4 waterHalfToReflection; // half of waterDirToReflection
vec2 waterToSlack;          // how far a ray may be off a depth and has converged: x depth + y
mat2x3 waterHalfToSky;      // direction -> half of its y and w on the user's screen
vec4 waterSkyLow;           // waterSkyBottom
vec3 waterSkyRise;          // from its bottom to its top
vec2 waterReflectionSize;   // texels
float waterTop;             // waterReflectionTop
int waterProbesOfOne;
int waterProbesOfSeveral; // each

void waterReadOnce()
{
  waterHalfToReflection = 0.5 * waterDirToReflection;
  waterToSlack = waterReflectionTolerance.x * vec2(-1.0, waterReflectionZInfinity);
  mat4 rows = transpose(waterDirToEye);
  waterHalfToSky = 0.5 * mat2x3(rows[1].xyz, rows[3].xyz);
  waterSkyLow = max(waterSkyBottom, vec4(0.0));
  waterSkyRise = waterSkyTop.rgb - waterSkyBottom.rgb;
  waterReflectionSize = vec2(textureSize(waterReflection, 0));
  waterTop = max(waterReflectionTop, 0.0);
  waterProbesOfOne = max(waterProbes, 0);
  waterProbesOfSeveral = min(waterProbes, WATER_FACET_PROBES);
}

// waterSky, from these.
vec3 waterSkyOfRay(vec3 dir)
{
  vec2 eye = dir * waterHalfToSky;
  return waterSkyLow.rgb + waterGradientHeight(eye.x, eye.y) * waterSkyRise;
}

float waterDepthAt(vec2 uv); // of the reflection texture; of the slot layer

// Depth of what the ray may meet there. What lies under the surface, or before all of the ray, only hides
// what it meets.
float waterDepthToMeet(vec2 uv)
{
  float depth = waterDepthAt(uv);
  return depth < waterNearest || waterIsUnder(uv, depth, waterFloor) ? WATER_UNMET : depth;
}

// Can a ray that is in front of the reflection texture before and after a step have been behind the edge of a thing
// on its way? The reflection texture's depth jumps back then, and the ray is as deep as the thing.
//
// depthBefore  of the reflection texture, before the step
// depth        of the reflection texture, after it
// rayDepth     after it
bool waterMayPassBehind(float depthBefore, float depth, float rayDepth)
{
  float slack = waterToSlack.x * depthBefore + waterToSlack.y;
  return depth > depthBefore + slack && rayDepth > depthBefore - slack;
}

// What a ray meets in the reflection texture. Its way goes from its start to where it leaves the reflection texture,
// or all that there is to meet.
struct WaterRayHit
{
  vec2 uv;      // where in the reflection texture that is
  bool isPlace; // or else the color is known without the reflection texture
  vec3 color;
  int reason;    // one of the first four
  bool isDown;   // it would have met the water again
  vec3 line;     // the ray is start + s line, s in [0, 1]
  bool isOver;   // ends over all that the reflection texture shows
  bool isInside; // ends on the reflection texture
  float s;
  float depthStart; // of the reflection texture, at the ray's ends
  float depth;
  bool isSettled; // the estimate is what it meets
  float near;     // depth of the nearest thing that a probe found before that
  float behind;   // how far behind the edge of a thing it went, over the thing's distance
};

// Two steps along a ray, to the depth that the reflection texture has where the ray is.
//
// start   of the ray in the reflection texture's window: u, v, depth
// startW  w of the start in clip space of the reflection texture
// dir     in the plane's axes, upwards, of unit length
WaterRayHit waterEstimateHitAlong(vec3 start, float startW, vec3 dir)
{
  WaterRayHit hit;
  vec4 halfEnd = waterHalfToReflection * vec4(dir, 0.0);
  vec3 line = halfEnd.xyz - (2.0 * start - 1.0) * halfEnd.w;
  float endW = 2.0 * halfEnd.w;
  float last = endW > 1e-6 ? 1.0 / endW : (line.z > 0.0 ? (1.0 - start.z) / line.z : 1e20);
  // over the highest thing there is nothing but sky
  float climb = waterTop / max(dir.z, 1e-6);
  float climbW = startW + climb * endW;
  float overAll = climbW > 0.0 ? climb / climbW : 1e20;
  vec2 border =
    (step(0.0, line.xy) - start.xy) / mix(line.xy, vec2(1e-9), equal(line.xy, vec2(0.0)));
  float leaves = max(min(border.x, border.y), 0.0);
  hit.isOver = overAll < min(last, leaves);
  last = min(last, overAll);
  hit.isInside = last <= leaves;
  hit.line = line * min(last, leaves);
  // only where the sky in its place is known
  float nearest = min(start.z, start.z + hit.line.z);
  waterNearest =
    waterSkyLow.a > 0.5 ? nearest - (waterToSlack.x * nearest + waterToSlack.y) : -1e30;

  float perDepth = 1.0 / (abs(hit.line.z) > 1e-20 ? hit.line.z : 1e-20);
  hit.depthStart = waterDepthToMeet(start.xy);
  hit.depth = hit.depthStart;
  hit.s = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    hit.s = clamp((hit.depth - start.z) * perDepth, 0.0, 1.0);
    hit.uv = start.xy + hit.s * hit.line.xy;
    hit.depth = waterDepthToMeet(hit.uv);
  }
  hit.color = waterSkyOfRay(dir);
  bool isSky = hit.s > 0.9999 &&
    (hit.isInside ? hit.isOver && hit.depth >= WATER_UNMET : hit.depth >= 1.0);
  hit.isPlace = !isSky || waterSkyLow.a <= 0.5;
  hit.reason = WATER_HIT;
  hit.isDown = false;
  hit.isSettled = false;
  hit.near = hit.depth;
  hit.behind = 0.0;
  return hit;
}

// The same, of a point's reflected ray.
WaterRayHit waterEstimateHit(WaterPoint point, vec3 normal)
{
  vec3 dir = reflect(point.ray, normal);
  bool isDown = dir.z < 0.0;
  dir.z = max(abs(dir.z), 1e-6); // met the water again: bounced off it once more
  waterFloor = point.height;
  WaterRayHit hit = waterEstimateHitAlong(point.start, point.startW, dir);
  hit.isDown = isDown;
  return hit;
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
  bool isSettled = s > 0.9999
    ? rayDepth <= depth
    : abs(start.z + s * way.z - depth) <= waterToSlack.x * depth + waterToSlack.y;
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
  float perDepth = 1.0 / (abs(way.z) > 1e-20 ? way.z : 1e-20);
  vec2 uv = hit.uv;
  for (int i = 0; i < 2; ++i)
  {
    s = s > 0.9999 ? s : clamp((depth - start.z) * perDepth, 0.0, 1.0);
    uv = start.xy + s * way.xy;
    depth = waterDepthToMeet(uv);
  }
  bool isEnd = s > 0.9999; // nothing was met
  bool isSky = isEnd && (hit.isOver || (depth >= 1.0 && !hit.isInside));
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
    bool isSurface = depthLow - depthHigh <= waterReflectionTolerance.y * (waterReflectionZInfinity - depthHigh);
    bool isOpen = hit.isInside && depthEnd >= 1.0;
    // the front side, not filtered
    vec2 size = vec2(textureSize(waterReflection, 0));
    vec2 front = (floor((start.xy + low * way.xy) * size) + 0.5) / size;
    // met nothing; a surface: filtered; goes behind something, and where it ends there is sky; front
    uv = start.xy + (isHit && isSurface ? high : 1.0) * way.xy;
    uv = isHit && !isSurface && !isOpen ? front : uv;
    isSky = isHit ? !isSurface && (isOpen ? depthEnd >= WATER_UNMET : depthLow >= 1.0)
                  : hit.isOver || (!hit.isInside && depthEnd >= 1.0);
    reason = isHit ? (isSurface ? WATER_HIT : WATER_HIDDEN)
                   : (hit.isInside ? WATER_SKY : WATER_OFF_MAP);
  }
  hit.uv = uv;
  hit.reason = reason;
  hit.isPlace = !isSky || waterSkyLow.a <= 0.5;
}

// Probes. A ray that is not marched meets what they find, about where that is.
void waterRefineHit(vec3 start, bool isFollowed, inout WaterRayHit hit)
{
  waterProbe(start, isFollowed ? waterProbesOfOne : waterProbesOfSeveral, hit);
  float perDepth = 1.0 / (abs(hit.line.z) > 1e-20 ? hit.line.z : 1e-20);
  bool isNear = hit.near < hit.depth && !isFollowed;
  float s = clamp((hit.near - start.z) * perDepth, 0.0, 1.0);
  hit.uv = isNear ? start.xy + s * hit.line.xy : hit.uv;
  hit.isPlace = hit.isPlace || isNear;
}

// Why the point has its reflection.
int waterReason(WaterRayHit hit)
{
  // converged on the far plane, where nothing is?
  bool isNothing = hit.reason == WATER_HIT && waterDepthToMeet(hit.uv) >= 1.0;
  return hit.isDown ? WATER_DOWNWARD : (isNothing ? WATER_SKY : hit.reason);
}

// Lets a point's ray go through what is translucent; of the slot layer.
void waterCross(WaterPoint point, inout WaterRayHit hit);

// Colour of the reflection.
//
// reason  one of the above
// uv      where in the reflection texture that is
vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  waterReadOnce();
  WaterRayHit hit = waterEstimateHit(point, point.normal);
  waterProbe(point.start, waterProbes, hit);
  waterMarchRay(point.start, true, hit);
  reason = waterReason(hit);
  uv = hit.uv;
  waterCross(point, hit);
  return hit.isPlace ? textureLod(waterReflection, uv, 0.0).rgb : hit.color;
}

// How much of the light from a direction something keeps off, as far as the reflection texture shows it.
float waterShaded(WaterPoint point, vec3 dir)
{
  waterReadOnce();
  WaterRayHit hit =
    waterEstimateHitAlong(point.start, point.startW, vec3(dir.xy, max(dir.z, 1e-6)));
  waterProbe(point.start, waterProbes, hit);
  waterMarchRay(point.start, true, hit);
  int reason = waterReason(hit);
  // a ray that goes close behind an edge meets a side that the reflection texture does not show
  bool isSide = reason == WATER_HIDDEN && hit.behind < WATER_THICKNESS;
  return reason == WATER_HIT || isSide ? 1.0 : 0.0;
}
