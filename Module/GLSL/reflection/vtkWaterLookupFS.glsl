// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterLookupFS.glsl: stage reflection: where the map shows what a reflected ray meets. The formulas
// of the rays are in water_lookup.h, the rules and what each is worth in
// Documentation/decisions/006-lookup.md. Needs vtkWaterPointFS.glsl before it, and vtkWaterNoLayerFS.glsl
// or another of its stage after it.

uniform sampler2D waterReflection; // mirrored view, flipped in x; linear
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

const int WATER_FACET_PROBES = 3; // for one of several facets

const float WATER_PROBE_PX = 6.0; // between probes; the default's are closer on ways below 42

const float WATER_UNMET = 2.0; // depth of what a ray cannot meet: beyond the background's

float waterFloor = -1e30;   // height that no ray of this pixel meets anything below
float waterNearest = -1e30; // depth that the ray meets nothing before

// What rays need of the uniforms, read once for all of a pixel: software renderers take some 30
// instructions to read each number, and would for every ray. A plain copy would be undone by compilers.
mat4 waterHalfToMap;   // half of waterDirToMap
vec2 waterToSlack;     // how far a ray may be off a depth and has settled: x depth + y
mat2x3 waterHalfToSky; // direction -> half of its y and w on the user's screen
vec4 waterSkyLow;      // waterSkyBottom
vec3 waterSkyRise;     // from its bottom to its top
vec2 waterMapSize;     // texels
float waterTop;        // waterMapTop
int waterProbesOfOne;
int waterProbesOfSeveral; // each

void waterReadOnce()
{
  waterHalfToMap = 0.5 * waterDirToMap;
  waterToSlack = waterMapTolerance.x * vec2(-1.0, waterMapZInfinity);
  mat4 rows = transpose(waterDirToEye);
  waterHalfToSky = 0.5 * mat2x3(rows[1].xyz, rows[3].xyz);
  waterSkyLow = max(waterSkyBottom, vec4(0.0));
  waterSkyRise = waterSkyTop.rgb - waterSkyBottom.rgb;
  waterMapSize = vec2(textureSize(waterReflection, 0));
  waterTop = max(waterMapTop, 0.0);
  waterProbesOfOne = max(waterProbes, 0);
  waterProbesOfSeveral = min(waterProbes, WATER_FACET_PROBES);
}

// waterSky, from these.
vec3 waterSkyOfRay(vec3 dir)
{
  vec2 eye = dir * waterHalfToSky;
  float height = eye.y > 0.0 ? 0.5 + 0.5 * eye.x / eye.y : step(0.0, eye.x);
  return waterSkyLow.rgb + clamp(height, 0.0, 1.0) * waterSkyRise;
}

float waterDepthAt(vec2 uv); // of the map; of the stage layer

// Depth of what the ray may meet there. What lies under the surface, or before all of the ray, only hides
// what it meets.
float waterMapDepth(vec2 uv)
{
  float depth = waterDepthAt(uv);
  return depth < waterNearest || waterIsUnder(uv, depth, waterFloor) ? WATER_UNMET : depth;
}

// Can a ray that is in front of the map before and after a step have been behind the edge of a thing
// on its way? The map's depth jumps back then, and the ray is as deep as the thing.
//
// depthBefore  of the map, before the step
// depth        of the map, after it
// rayDepth     after it
bool waterMayPassBehind(float depthBefore, float depth, float rayDepth)
{
  float slack = waterToSlack.x * depthBefore + waterToSlack.y;
  return depth > depthBefore + slack && rayDepth > depthBefore - slack;
}

// What a ray meets in the map. Its way goes from its start to where it leaves the map, or all that there
// is to meet.
struct WaterLook
{
  vec2 uv;      // where in the map that is
  bool isPlace; // or else the color is known without the map
  vec3 color;
  int reason;   // one of the first four
  bool isDown;  // it would have met the water again
  vec3 line;    // the ray is start + s line, s in [0, 1]
  bool isOver;  // ends over all that the map shows
  bool isInside; // ends on the map
  float s;
  float depthStart; // of the map, at the ray's ends
  float depth;
  bool isSettled; // the glance is what it meets
  float near;     // depth of the nearest thing that a probe found before that
  float behind;   // how far behind the edge of a thing it went, over the thing's distance
};

// Two steps along a ray, to the depth that the map has where the ray is.
//
// start   of the ray in the map's window: u, v, depth
// startW  w of the start in clip space of the map
// dir     in the plane's axes, upwards, of unit length
WaterLook waterGlanceAlong(vec3 start, float startW, vec3 dir)
{
  WaterLook look;
  vec4 halfEnd = waterHalfToMap * vec4(dir, 0.0);
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
  look.isOver = overAll < min(last, leaves);
  last = min(last, overAll);
  look.isInside = last <= leaves;
  look.line = line * min(last, leaves);
  // only where the sky in its place is known
  float nearest = min(start.z, start.z + look.line.z);
  waterNearest =
    waterSkyLow.a > 0.5 ? nearest - (waterToSlack.x * nearest + waterToSlack.y) : -1e30;

  float perDepth = 1.0 / (abs(look.line.z) > 1e-20 ? look.line.z : 1e-20);
  look.depthStart = waterMapDepth(start.xy);
  look.depth = look.depthStart;
  look.s = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    look.s = clamp((look.depth - start.z) * perDepth, 0.0, 1.0);
    look.uv = start.xy + look.s * look.line.xy;
    look.depth = waterMapDepth(look.uv);
  }
  look.color = waterSkyOfRay(dir);
  bool isSky = look.s > 0.9999 &&
    (look.isInside ? look.isOver && look.depth >= WATER_UNMET : look.depth >= 1.0);
  look.isPlace = !isSky || waterSkyLow.a <= 0.5;
  look.reason = WATER_HIT;
  look.isDown = false;
  look.isSettled = false;
  look.near = look.depth;
  look.behind = 0.0;
  return look;
}

// The same, of a point's reflected ray.
WaterLook waterGlance(WaterPoint point, vec3 normal)
{
  vec3 dir = reflect(point.ray, normal);
  bool isDown = dir.z < 0.0;
  dir.z = max(abs(dir.z), 1e-6); // met the water again: bounced off it once more
  waterFloor = point.height;
  WaterLook look = waterGlanceAlong(point.start, point.startW, dir);
  look.isDown = isDown;
  return look;
}

// Looks whether a glance has settled on what the ray meets.
//
// Loops are tested at their end: software renderers execute their bodies once more than needed otherwise.
//
// most  probes
void waterProbe(vec3 start, int most, inout WaterLook look)
{
  vec3 way = look.line;
  float s = look.s;
  float depth = look.depth;
  float rayDepth = min(start.z + s * way.z, 1.0);
  bool isSettled = s > 0.9999
    ? rayDepth <= depth
    : abs(start.z + s * way.z - depth) <= waterToSlack.x * depth + waterToSlack.y;
  // nothing nearer on the way; of a short one fewer probes miss no more
  float lengthPx = s * length(way.xy * waterMapSize);
  int probes = isSettled ? min(most, int(lengthPx / WATER_PROBE_PX)) : 0;
  float part = s / float(probes + 1);
  float depthBefore = look.depthStart;
  int probe = 1;
  float depthNear = depth;
  do
  {
    vec3 at = start + part * float(probe) * way;
    float depthProbe = waterMapDepth(at.xy);
    float atDepth = min(at.z, 1.0);
    bool isFree =
      atDepth <= depthProbe && !waterMayPassBehind(depthBefore, depthProbe, atDepth);
    bool isProbe = probe <= probes;
    isSettled = isSettled && (isFree || !isProbe);
    depthBefore = isProbe ? depthProbe : depthBefore;
    depthNear = isProbe && !isFree ? depthProbe : depthNear;
    ++probe;
  } while (probe <= probes && isSettled);
  look.isSettled = isSettled && !waterMayPassBehind(depthBefore, depth, rayDepth);
  look.near = depthNear;
}

// Follows a ray that has not settled, and settles others closer.
//
// isWanted  or else nothing that comes of it is used
void waterFollow(vec3 start, bool isWanted, inout WaterLook look)
{
  vec3 way = look.line;
  float s = look.s;
  float depth = look.depth;
  bool isSettled = look.isSettled || !isWanted;
  // the depth there leads closer still
  float perDepth = 1.0 / (abs(way.z) > 1e-20 ? way.z : 1e-20);
  vec2 uv = look.uv;
  for (int i = 0; i < 2; ++i)
  {
    s = s > 0.9999 ? s : clamp((depth - start.z) * perDepth, 0.0, 1.0);
    uv = start.xy + s * way.xy;
    depth = waterMapDepth(uv);
  }
  bool isEnd = s > 0.9999; // nothing was met
  bool isSky = isEnd && (look.isOver || (depth >= 1.0 && !look.isInside));
  int reason = isEnd ? (look.isInside ? WATER_SKY : WATER_OFF_MAP) : WATER_HIT;
  if (!isSettled)
  {
    // steps; one that ends behind the map, or may have been there on its way, is halved
    float low = 0.0;
    float high = 0.0;
    float next = 0.0; // where the steps go on when the halvings met nothing
    float depthLow = look.depthStart;
    float depthHigh = 1.0;
    float depthNext = 1.0;
    float rayHigh = 1.0; // depth of the ray
    float depthEnd = waterMapDepth(start.xy + way.xy);
    bool isHit = false;
    float stride = 1.0 / float(waterSteps);
    int rest = waterSteps + 20; // the hit and four edges
    int halvings = 0;
    do
    {
      bool isHalving = halvings > 0;
      float middle = isHalving ? 0.5 * (low + high) : min(low + stride, 1.0);
      depth = waterMapDepth(start.xy + middle * way.xy);
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
    look.behind = (rayHigh - depthHigh) / (waterMapZInfinity - depthHigh);
    bool isSurface = depthLow - depthHigh <= waterMapTolerance.y * (waterMapZInfinity - depthHigh);
    bool isOpen = look.isInside && depthEnd >= 1.0;
    // the front side, not filtered
    vec2 size = vec2(textureSize(waterReflection, 0));
    vec2 front = (floor((start.xy + low * way.xy) * size) + 0.5) / size;
    // met nothing; a surface: filtered; goes behind something, and where it ends there is sky; front
    uv = start.xy + (isHit && isSurface ? high : 1.0) * way.xy;
    uv = isHit && !isSurface && !isOpen ? front : uv;
    isSky = isHit ? !isSurface && (isOpen ? depthEnd >= WATER_UNMET : depthLow >= 1.0)
                  : look.isOver || (!look.isInside && depthEnd >= 1.0);
    reason = isHit ? (isSurface ? WATER_HIT : WATER_HIDDEN)
                   : (look.isInside ? WATER_SKY : WATER_OFF_MAP);
  }
  look.uv = uv;
  look.reason = reason;
  look.isPlace = !isSky || waterSkyLow.a <= 0.5;
}

// Probes. A ray that is not followed meets what they find, about where that is.
void waterSettle(vec3 start, bool isFollowed, inout WaterLook look)
{
  waterProbe(start, isFollowed ? waterProbesOfOne : waterProbesOfSeveral, look);
  float perDepth = 1.0 / (abs(look.line.z) > 1e-20 ? look.line.z : 1e-20);
  bool isNear = look.near < look.depth && !isFollowed;
  float s = clamp((look.near - start.z) * perDepth, 0.0, 1.0);
  look.uv = isNear ? start.xy + s * look.line.xy : look.uv;
  look.isPlace = look.isPlace || isNear;
}

// Why the point has its reflection.
int waterReason(WaterLook look)
{
  // settled on the far plane, where nothing is?
  bool isNothing = look.reason == WATER_HIT && waterMapDepth(look.uv) >= 1.0;
  return look.isDown ? WATER_DOWNWARD : (isNothing ? WATER_SKY : look.reason);
}

// Lets a point's ray go through what is translucent; of the stage layer.
void waterCross(WaterPoint point, inout WaterLook look);

// Colour of the reflection.
//
// reason  one of the above
// uv      where in the map that is
vec3 waterReflected(WaterPoint point, out int reason, out vec2 uv)
{
  waterReadOnce();
  WaterLook look = waterGlance(point, point.normal);
  waterProbe(point.start, waterProbes, look);
  waterFollow(point.start, true, look);
  reason = waterReason(look);
  uv = look.uv;
  waterCross(point, look);
  return look.isPlace ? textureLod(waterReflection, uv, 0.0).rgb : look.color;
}

// How much of the light from a direction something keeps off, as far as the map shows it.
float waterShaded(WaterPoint point, vec3 dir)
{
  waterReadOnce();
  WaterLook look =
    waterGlanceAlong(point.start, point.startW, vec3(dir.xy, max(dir.z, 1e-6)));
  waterProbe(point.start, waterProbes, look);
  waterFollow(point.start, true, look);
  int reason = waterReason(look);
  // a ray that goes close behind an edge meets a side that the map does not show
  bool isSide = reason == WATER_HIDDEN && look.behind < WATER_THICKNESS;
  return reason == WATER_HIT || isSide ? 1.0 : 0.0;
}
