// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRayTracedFS.glsl: slot reflection: where the reflection texture shows
// what a reflected ray meets. The formulas of the rays are in water_lookup.h, the rules and what each is worth in
// Documentation/decisions/006-lookup.md.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
uniform mat4 waterDirToReflection; // direction in the plane's axes -> clip of the reflection texture
uniform float waterReflectionTop;  // height over the plane of all that the reflection texture shows
uniform float waterReflectionZInfinity;
uniform vec2 waterReflectionTolerance; // converged on a surface; a surface on both sides of a crossing
uniform int waterSkyIsOneColor;        // in all directions
uniform int waterSteps;                // of the march
uniform int waterProbes;               // between the water and where the ray converged

// Why a pixel has its colour (vtkWaterProperty::Confidences).
const int WATER_HIT = 1;
const int WATER_SKY = 2;
const int WATER_OFF_MAP = 3;
const int WATER_HIDDEN = 4;
const int WATER_DOWNWARD = 5;


const int WATER_FACET_PROBES = 3; // for one of several facets, but the first

const float WATER_PROBE_PX = 6.0; // between probes; the default's are closer on ways below 42

const float WATER_SCAN_PX = 6.0; // between the probes of the first of several facets, about
const int WATER_SCAN_ROUNDS = 3;   // of four probes, at most
const int WATER_SCAN_HALVINGS = 3; // of the step between two probes

const float WATER_OUT_STRIDE = 0.25; // of a step of the march: the depth of one surface changes little in it

float waterFloor = -1e30;   // height that no ray of this pixel meets anything below
float waterNearest = -1e30; // depth that the ray meets nothing before

// What rays need of the uniforms; of the slot walk.
void waterReadOnce();
vec4 waterHalfEnd(vec3 dir);     // a direction in clip space of the reflection texture, half of it
float waterSlackAt(float depth); // how far a ray may be off a depth and has converged
float waterTop();                // height over the plane of all that there is to meet

float waterDepthAt(vec2 uv); // of the reflection texture; of the slot layer

// Of the slot end. Is nothing but the sky that deep in the reflection texture? Is the sky known by a ray's direction, and
// not by the place in the reflection texture where the ray ends?
bool waterIsSky(float depth);
bool waterIsSkyByRay();

// Depth of what the ray may meet where the reflection texture has another. What lies under the surface, or before all of the ray, only hides
// what it meets.
float waterToMeet(vec2 uv, float depth)
{
  return depth < waterNearest || waterIsUnder(uv, depth, waterFloor) ? WATER_UNMET : depth;
}

float waterDepthToMeet(vec2 uv)
{
  return waterToMeet(uv, waterDepthAt(uv));
}

// Can a ray that is in front of the reflection texture before and after a step have been behind the edge of a thing
// on its way? The reflection texture's depth jumps back then, and the ray is as deep as the thing.
//
// depthBefore  of the reflection texture, before the step
// depth        of the reflection texture, after it
// rayDepth     after it
bool waterMayPassBehind(float depthBefore, float depth, float rayDepth)
{
  float slack = waterSlackAt(depthBefore);
  return depth > depthBefore + slack && rayDepth > depthBefore - slack;
}

// Rounds of four probes of the first of several facets, on a way of so many texels.
int waterScanRounds(float lengthPx)
{
  return clamp(int(lengthPx / (4.0 * WATER_SCAN_PX)), 1, WATER_SCAN_ROUNDS);
}

// What a ray meets in the reflection texture. Its path ends where it leaves the reflection texture,
// or above everything that it could meet.
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
  float rise;       // what the ray gains along its line: height over w
  float depthStart; // of the reflection texture, at the ray's ends
  float depth;
  bool isSettled; // the estimate is what it meets
  float near;     // depth of the nearest thing that a probe found before that
  float behind;   // how far behind the edge of a thing it went, over the thing's distance
  float passed;   // s where that is
  vec2 skyPlace;  // where in the reflection texture the sky is that it may meet; only
  bool isSkyThere; // if that is there
};

// Of the slot end: finds the sky that a ray may meet; takes it where the ray meets nothing else.
void waterFindSky(vec3 start, float startW, vec3 dir, inout WaterRayHit hit);
void waterTakeSky(inout WaterRayHit hit);

// Where a ray goes, and how far: up to the ray's first look at the reflection texture.
//
// start   of the ray in the reflection texture's window: u, v, depth
// startW  w of the start in clip space of the reflection texture
// dir     in the plane's axes, upwards, of unit length
WaterRayHit waterAim(vec3 start, float startW, vec3 dir)
{
  WaterRayHit hit;
  vec4 halfEnd = waterHalfEnd(dir);
  vec3 line = halfEnd.xyz - (2.0 * start - 1.0) * halfEnd.w;
  float endW = 2.0 * halfEnd.w;
  float last = endW > 1e-6 ? 1.0 / endW : (line.z > 0.0 ? (1.0 - start.z) / line.z : 1e20);
  // over the highest thing there is nothing but sky
  float climb = waterTop() / max(dir.z, 1e-6);
  float climbW = startW + climb * endW;
  float overAll = climbW > 0.0 ? climb / climbW : 1e20;
  vec2 border =
    (step(0.0, line.xy) - start.xy) / mix(line.xy, vec2(1e-9), equal(line.xy, vec2(0.0)));
  float leaves = max(min(border.x, border.y), 0.0);
  hit.isOver = overAll < min(last, leaves);
  last = min(last, overAll);
  hit.isInside = last <= leaves;
  float end = min(last, leaves);
  hit.line = line * end;
  hit.rise = dir.z * end;
  // only where the sky in its place is known
  float nearest = min(start.z, start.z + hit.line.z);
  waterNearest = waterIsSkyKnown() ? nearest - waterSlackAt(nearest) : -1e30;
  return hit;
}

// What an estimate says before it is tested.
void waterJudge(inout WaterRayHit hit)
{
  bool isSky = hit.s >= 1.0 &&
    (hit.isInside ? (hit.isOver && hit.depth >= WATER_UNMET) || (waterIsSkyByRay() && waterIsSky(hit.depth))
                  : waterIsSky(hit.depth));
  hit.isPlace = !isSky || !waterIsSkyKnown();
  // a ray ends where it is over all that there is: the texture shows there what lies beyond in another direction, which is
  // the same if the sky has one colour, and mixes what is beside it into a blurred one
  bool isFree = hit.s >= 1.0 && hit.isInside && hit.isOver && waterIsSkyKnown();
  hit.isPlace = hit.isPlace && !(isFree && waterSkyIsOneColor == 0);
  hit.reason = WATER_HIT;
  hit.isDown = false;
  hit.isSettled = false;
  hit.near = hit.depth;
  hit.behind = 0.0;
  hit.passed = 0.0;
}

float waterPerDepth(vec3 line)
{
  return 1.0 / (abs(line.z) > 1e-20 ? line.z : 1e-20);
}

// Where on a ray it has a depth of the reflection texture. Where nothing was drawn that is the ray's end: the far plane,
// whose depth the background has, lies before it by as little as a dome of the sky may.
float waterPlaceOnRay(vec3 start, float perDepth, float depth)
{
  return depth >= 1.0 ? 1.0 : clamp((depth - start.z) * perDepth, 0.0, 1.0);
}

// Two steps along a ray, from its start, to the depth that the reflection texture has where the ray is.
void waterTwoSteps(vec3 start, inout WaterRayHit hit)
{
  float perDepth = waterPerDepth(hit.line);
  for (int i = 0; i < 2; ++i)
  {
    hit.s = waterPlaceOnRay(start, perDepth, hit.depth);
    hit.uv = start.xy + hit.s * hit.line.xy;
    hit.depth = waterDepthToMeet(hit.uv);
  }
}

// An estimate of what a ray meets; as waterAim.
WaterRayHit waterEstimateHitAlong(vec3 start, float startW, vec3 dir)
{
  WaterRayHit hit = waterAim(start, startW, dir);
  hit.depthStart = waterDepthToMeet(start.xy);
  hit.depth = hit.depthStart;
  hit.s = 0.0;
  waterTwoSteps(start, hit);
  hit.color = waterSky(dir);
  waterFindSky(start, startW, dir, hit);
  waterJudge(hit);
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

// A ray that has gone behind the edge of a surface, such as a shore that the mirrored eye sees from inside the land, meets
// the other side of that surface where it comes out of it.
//
// isWanted  or else nothing is looked at
// depth     of the reflection texture at s, in front of the ray
// s         where on the ray that is; where it comes out
//
// Returns whether it comes out.
bool waterComesOut(vec3 start, vec3 way, bool isWanted, float depth, inout float s)
{
  float stride = WATER_OUT_STRIDE / float(waterSteps);
  float behind = min(start.z + s * way.z, 1.0) - depth;
  bool isOut = false;
  bool isGone = !isWanted;
  int rest = 4 * waterSteps;
  do
  {
    float next = min(s + stride, 1.0);
    float depthNext = waterDepthToMeet(start.xy + next * way.xy);
    float behindNext = min(start.z + next * way.z, 1.0) - depthNext;
    // another object, or none
    isGone = isGone || abs(depthNext - depth) > waterReflectionTolerance.y * (waterReflectionZInfinity - depth);
    isOut = !isGone && behindNext <= 0.0;
    float part = isOut ? behind / max(behind - behindNext, 1e-20) : 1.0;
    s = isGone ? s : mix(s, next, part);
    depth = depthNext;
    behind = behindNext;
    --rest;
  } while (rest > 0 && !isGone && !isOut && s < 1.0);
  return isOut;
}

// Finds out where the ray of an estimate ends: one that has not converged is marched, others are refined; of the
// slot walk.
void waterFollowRay(vec3 start, inout WaterRayHit hit);

// Keeps the place of what a ray meets off the waterline. Surfaces are read with a filter, and beyond the waterline there is
// nothing of them.
vec2 waterPlaceOver(vec3 start, WaterRayHit hit)
{
  float s = dot(hit.uv - start.xy, hit.line.xy) / max(dot(hit.line.xy, hit.line.xy), 1e-20);
  return hit.reason == WATER_HIT ? waterOverWaterline(hit.uv, s * hit.rise) : hit.uv;
}

// Why the point has its reflection.
int waterReason(WaterRayHit hit)
{
  // converged on the far plane, where nothing is?
  bool isNothing = hit.reason == WATER_HIT && waterDepthToMeet(hit.uv) >= 1.0;
  return hit.isDown ? WATER_DOWNWARD : (isNothing ? WATER_SKY : hit.reason);
}

// Continues a ray that passed behind the edge of an object; of the slot behind.
void waterLookBehind(vec3 start, inout WaterRayHit hit);

// Lets a point's ray go through what is translucent; of the slot layer.
void waterCross(WaterPoint point, inout WaterRayHit hit);

// The colour of what was drawn at a place of the reflection texture; of the slot dome.
vec3 waterDrawn(vec4 texel, vec3 background);

// Colour of the reflection.
//
// reason  one of the above
// uv      where in the reflection texture that is
vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  WaterRayHit hit = waterEstimateHit(point, point.normal);
  waterFollowRay(point.start, hit);
  waterTakeSky(hit);
  reason = waterReason(hit);
  waterLookBehind(point.start, hit);
  hit.uv = waterPlaceOver(point.start, hit);
  uv = hit.uv;
  waterCross(point, hit);
  return hit.isPlace ? waterDrawn(textureLod(waterReflection, uv, 0.0), hit.color) : hit.color;
}
