// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumPictureFS.glsl: slot picture: what is seen through the surface, as a picture with depths: its places, what a
// ray in it meets, its colours. vtkWaterMediumFS.glsl follows the water's rays in it.
//
// The picture is what the eye sees without this water, or the water's own view (water_beyond.h), which is wider.

uniform sampler2D waterSceneColor; // the picture; linear
uniform sampler2D waterSceneDepth; // its window depth, 1: background; nearest
uniform vec2 waterSceneScale;      // part of it that the eye sees
uniform mat4 waterDirToScene;      // direction in the plane's axes -> its clip space
uniform int waterSceneSide;        // so many of its pixels lie along each side of one of the eye's: one for each sample
uniform int waterIsSubmerged;      // 1: the eye is in the water
uniform int waterSceneIsMixed;     // 1: pixels of the picture are means of several samples
uniform float waterBedDepth;       // how far the scene reaches under the plane
uniform vec4 waterSheet;           // from x, to x, from y, to y: where the water ends, from the point under the eye
uniform vec4 waterHeightClip;      // point in clip space of the picture -> height over the plane, times w
uniform vec4 waterClipW;           // the same -> w of the point in view space

const int WATER_MEDIUM_STEPS = 16;
const float WATER_MEDIUM_LEVEL = 2.0;    // a ray so many times longer than to a level bed has left what is straight behind
const int WATER_MEDIUM_GUESSES = 6;      // of where that is met, which lie on a bed that ends or beyond it
const float WATER_MEDIUM_BENT = 2.0;     // a depth that is so many steps from where a plane has it lies behind an edge
const float WATER_MEDIUM_BELOW = 0.02;  // a bed's edge lies under the border if it is no further from a plumb line than that part of all depths
const float WATER_MEDIUM_EDGE = 2.0;    // and so many widths of a pixel
const float WATER_MEDIUM_FINE = 0.4;     // of the depth, the width of a pixel
const float WATER_MEDIUM_DEEPER = 1.01;  // than what is deepest: bounds are rounded
const float WATER_MEDIUM_ENDLESS = 1e29; // length of a way that nothing limits
const float WATER_MEDIUM_CLOSE_PX = 0.2; // two places are as good as one
const float WATER_MEDIUM_BETWEEN_PX = 3.0; // further away it is something else
const float WATER_MEDIUM_INSIDE_PX = 1.0; // from the picture's border: beyond it there are no depths
const float WATER_MEDIUM_BASE_PX = 8.0; // between two depths that tell a slope
const float WATER_MEDIUM_TOLERANCE = 1.1; // where a slope that goes on is met, in the greatest depth
const int WATER_MEDIUM_LAST = 5;         // halvings of a step to what hides the rest of a ray
const float WATER_MEDIUM_SHORT_WAY_PX = 8.0; // whose length a depth half of a pixel away changes by 6 % or more
const float WATER_MEDIUM_THIN_PX = 3.0;  // water whose bed is no deeper than the plane so many pixels on
const float WATER_MEDIUM_LONG_PX = 8.0;  // ways that need eight looks, and not four

float waterAir = 0.0; // of a refracted ray, that is not water; of the slot port
float waterMediumTop = 0.0; // height over the plane of the point of the surface that is looked through

// Where the picture shows a place that the eye sees.
vec2 waterMediumPlace(vec2 ndc)
{
  return 0.5 + 0.5 * (waterSceneScale * ndc);
}

float waterMediumDepth(vec2 uv); // of the slot below

// Height of what the picture shows over the point of the surface that is looked through.
float waterMediumHeight(vec2 uv, float depth)
{
  vec4 clip = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  return dot(waterHeightClip, clip) / dot(waterClipW, clip) - waterMediumTop;
}

// Of the same, w in clip space.
float waterMediumW(vec2 uv, float depth)
{
  return 1.0 / dot(waterClipW, vec4(2.0 * vec3(uv, depth) - 1.0, 1.0));
}

// Light that is scattered into a way, over that of calm water; of the slot shafts.
vec3 waterShaftsAlong(vec3 ray, float way);

// What is left of white after a way of so many metres through the water.
vec3 waterLeft(float way)
{
  way = max(way - waterAir, 0.0);
  return vec3(waterTransmittance(waterExtinction.r, way),
    waterTransmittance(waterExtinction.g, way), waterTransmittance(waterExtinction.b, way));
}

// The same of a color, with the light that the water adds.
vec3 waterAfter(vec3 color, float way)
{
  return mix(waterDeepColor, color, waterLeft(way));
}

// The place between low and high where a ray passes behind the surface that the picture shows. The
// two are close, or the part between them is hidden.
struct WaterMediumHit
{
  float low;
  float high;
  float depthLow; // of the picture
  float depthHigh;
  float share; // of the way from low to high, where the ray meets what is seen at high if that goes on
  bool isHit;  // or else low is the last place where the ray is known to be in front
  bool isGap;  // something hides what is between
};

vec2 waterMediumSize(); // of the picture, pixels; of the slot refraction

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

// Moves the last place where a ray is known to be in front on to what hides the rest of it: from row to row, whole steps
// end at places so far apart that a comb would be seen.
//
// next  the first place that is hidden
// most  halvings
void waterMediumLastSeen(vec3 start, vec3 way, float next, int most, inout WaterMediumHit found)
{
  float overRate = -dot(waterHeightClip.xy, way.xy) / waterHeightClip.z; // of the depth, along the plane
  for (int i = 0; i < most; ++i)
  {
    float middle = 0.5 * (found.low + next);
    float seen = waterMediumDepth(start.xy + middle * way.xy);
    bool isSeen = seen >= start.z + middle * overRate && start.z + middle * way.z <= seen &&
      (seen < 1.0 || found.depthLow >= 1.0);
    found.low = isSeen ? middle : found.low;
    found.depthLow = isSeen ? seen : found.depthLow;
    next = isSeen ? next : middle;
  }
}

// Length of a ray to what is seen straight behind the surface, if that goes on as a plane and is seen there. Near the end
// of a bed a ray meets its last part, and a step further on it is before something far away: no march finds that part.
//
// level  length of the ray to a level bed
// reach  of the ray, without this; it is returned if the bed is not met there
float waterMediumBedReach(vec3 start, vec3 way, float depth, float level, float reach)
{
  float texel = 1.0 / max(length(way.xy * waterMediumSize()), 1e-6);
  float s = min(WATER_MEDIUM_BASE_PX * texel, 0.5 * level);
  float before = 0.0; // the last place where the ray is in front of the bed
  float missBefore = start.z - depth;
  float miss = missBefore;
  for (int i = 0; i < WATER_MEDIUM_GUESSES; ++i)
  {
    miss = start.z + s * way.z - waterMediumDepth(start.xy + s * way.xy);
    float rate = (miss - missBefore) / max(s - before, 1e-20);
    if (miss >= 0.0)
    {
      break;
    }
    float next = rate > 0.0 ? s + WATER_MEDIUM_CLOSE_PX * texel - miss / rate : 0.5 * (before + s);
    before = rate > 0.0 ? s : before;
    missBefore = rate > 0.0 ? miss : missBefore;
    s = next;
  }
  return miss >= 0.0 && s < reach ? s : reach;
}

// Is the ray free up to a place? A few probes on the way do not find everything, but agree with the
// march within some pixels.
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
        found = WaterMediumHit(there, there, depth, depth, 0.0, true, false);
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

// The middle of the picture's pixel at a place, or nearest to it: the depth that is read is the one there.
vec2 waterMediumMiddle(vec2 uv)
{
  vec2 size = waterMediumSize();
  return (clamp(floor(uv * size), vec2(0.0), size - 1.0) + 0.5) / size;
}

// What the picture shows of what a ray meets.
struct WaterMediumView
{
  bool isMet; // or else it is guessed
  float s;    // the ray is start + s way
  vec2 from;  // u, v: the color is a mixture of two places
  vec2 to;
  float share; // of the second
  bool isBelow; // the ray meets nothing: it is deeper than anything
  bool isOut;   // it leaves the picture before it meets anything
  bool isHidden; // something hides where it ends
};

// Where a ray leaves the picture.
float waterMediumLeaves(vec3 start, vec3 way)
{
  vec2 border =
    (step(0.0, way.xy) - start.xy) / mix(way.xy, vec2(1e-9), equal(way.xy, vec2(0.0)));
  return max(min(border.x, border.y), 0.0);
}

// Could a ray that is deeper than everything before it meet the surface at the border of the
// picture, if that surface continued as a plane? A level bed is met. A wall that the border cuts is
// not met by a ray that goes down in front of it. Water with an end has a bed under it, whatever
// stands on that at the picture's border.
//
// leaves   where the ray leaves the picture
// deepest  there the ray is deeper than anything
bool waterMediumPassesBelow(vec3 start, vec3 way, float leaves, float deepest)
{
  float texel = 1.0 / max(length(way.xy * waterMediumSize()), 1e-6);
  float inside = leaves - WATER_MEDIUM_INSIDE_PX * texel;
  float further = inside - WATER_MEDIUM_BASE_PX * texel;
  float depth = waterMediumDepth(start.xy + inside * way.xy);
  float depthFurther = waterMediumDepth(start.xy + further * way.xy);
  bool isEdge = max(depth, depthFurther) >= 1.0; // it tells no slope
  float slope = isEdge ? way.z : (depth - depthFurther) / (inside - further);
  float inFront = depth - start.z - inside * way.z;
  return waterIsEndless != 0 && waterSide > 0.0 && inFront > (way.z - slope) * (deepest - inside);
}

// Where a ray into the scene meets what the picture shows; of the slot refraction.
//
// start  of the ray in the picture's window: u, v, depth
// way    the ray is start + s way
// most     of s: there the ray is deeper than anything
// deepest  the same with the tolerance of a slope that goes on
WaterMediumView waterMediumMeets(vec3 start, vec3 way, float most, float deepest);

// May filtering a place read what a pixel's neighbours show beyond an edge? Of the slot refraction.
//
// next  of the middles of the pixels that are read, the one that differs in u and v
bool waterMediumIsNearEdge(vec2 middle, vec2 next, float depth);

vec2 waterMediumEnd = vec2(0.0); // where in the picture the last ray of this pixel has ended

// A place of the picture whose colour is that of one object. Beside an edge, where filtering would
// mix both sides, it is the centre of a pixel. Pixels with several samples are mixed themselves:
// there it is the next pixel away from the edge. Along planes window depths are linear.
vec2 waterMediumUnmixed(vec2 uv, float depth)
{
  vec2 size = waterMediumSize();
  vec2 middle = waterMediumMiddle(uv);
  vec2 first = mix(vec2(-1.0), vec2(1.0), greaterThan(uv, middle)); // where filtering reads
  if (waterSceneIsMixed == 0 && !waterMediumIsNearEdge(middle, middle + first / size, depth))
  {
    return uv;
  }
  vec4 near = vec4(waterMediumDepth(middle - vec2(1.0, 0.0) / size), waterMediumDepth(middle - vec2(0.0, 1.0) / size),
    waterMediumDepth(middle + vec2(1.0, 0.0) / size), waterMediumDepth(middle + vec2(0.0, 1.0) / size));
  vec2 before = depth - near.xy;
  vec2 after = near.zw - depth;
  vec2 slope = mix(before, after, lessThan(abs(after), abs(before)));
  // edges of samples go to and fro: between two others a pixel has no slope
  slope *= mix(vec2(1.0), step(0.0, before * after), waterSceneSide > 1 ? 1.0 : 0.0);
  float edge = WATER_MEDIUM_BENT * (abs(slope.x) + abs(slope.y)) + 1e-7;
  vec2 isBefore = step(edge, abs(before - slope));
  vec2 isAfter = step(edge, abs(after - slope));
  vec2 away = isBefore - isAfter;
  int diagonals = waterSceneIsMixed != 0 ? 4 : 1;
  for (int i = 0; i < diagonals; ++i)
  {
    vec2 diagonal = first * (1.0 - 2.0 * vec2(float(i & 1), float(i / 2)));
    float bend = waterMediumDepth(middle + diagonal / size) - depth - dot(slope, diagonal);
    away -= abs(bend) > edge ? diagonal : vec2(0.0);
  }
  // what is seen at its edge has a slope that hides the jump to the background
  bool isSilhouette = depth < 1.0 && any(greaterThanEqual(near, vec4(1.0)));
  bool isEdge = isSilhouette || any(notEqual(vec4(isBefore, isAfter), vec4(0.0))) || any(notEqual(away, vec2(0.0)));
  if (waterSceneIsMixed != 0)
  {
    // filtering would read a mixed pixel that lies between
    vec2 second = vec2(waterMediumDepth(middle + vec2(2.0 * first.x, 0.0) / size),
      waterMediumDepth(middle + vec2(0.0, 2.0 * first.y) / size));
    isEdge = isEdge || any(greaterThan(abs(second - depth - 2.0 * first * slope), vec2(2.0 * edge)));
    middle += sign(away) / size;
  }
  return isEdge ? middle : uv;
}

vec3 waterMediumColor(vec2 uv, float depth)
{
  return textureLod(waterSceneColor, waterMediumUnmixed(uv, depth), 0.0).rgb;
}
