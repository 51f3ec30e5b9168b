// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBehindFS.glsl: slot behind: what a ray meets that has gone behind a thing of the reflection texture, as far as
// the peel shows it: what is behind the first things.

uniform sampler2D waterPeelColor;       // of the peel; linear
uniform sampler2D waterPeelBehindDepth; // of the peel, 1: nothing; nearest

// Depths that a ray may meet at a place: of the reflection texture and of the peel.
vec2 waterBothToMeet(vec2 uv)
{
  return vec2(waterDepthToMeet(uv), waterToMeet(uv, textureLod(waterPeelBehindDepth, uv, 0.0).r));
}

// Of two depths, how many are in front of a ray.
int waterInFront(vec2 depths, float rayDepth)
{
  return (depths.x < rayDepth ? 1 : 0) + (depths.y < rayDepth ? 1 : 0);
}

// A ray on its way behind things: a step, or a half of one, and what is at its ends.
struct WaterPassage
{
  float low;
  float high;
  vec2 depthsLow;
  vec2 depthsHigh;
  float rayLow; // depths of the ray
  float rayHigh;
};

// Has the ray met one of the two at the far end of the step? That is in front of it there, and was not at the near end.
bool waterHasMet(WaterPassage passage, float depth)
{
  vec2 apart = abs(passage.depthsLow - depth);
  bvec2 isSame = lessThanEqual(apart, vec2(waterReflectionTolerance.y * (waterReflectionZInfinity - depth)));
  bvec2 wasBehind = greaterThanEqual(passage.depthsLow, vec2(passage.rayLow));
  return depth < passage.rayHigh && ((isSame.x && wasBehind.x) || (isSame.y && wasBehind.y));
}

// Continues the march until another object is in front of the ray. If that is the edge of an
// object, it continues behind that one, too.
//
// Returns (met one of the reflection texture, one of the peel).
bvec2 waterMarchBehind(vec3 start, vec3 way, inout WaterPassage passage)
{
  float stride = max(1.0 - passage.low, 1e-6) / float(max(waterSteps, 1));
  int rest = waterSteps + 20; // what is met and four edges
  int halvings = 0;
  bvec2 met = bvec2(false);
  do
  {
    bool isHalving = halvings > 0;
    float middle = isHalving ? 0.5 * (passage.low + passage.high) : min(passage.low + stride, 1.0);
    float rayDepth = min(start.z + middle * way.z, 1.0);
    vec2 depths = waterBothToMeet(start.xy + middle * way.xy);
    bool isMore = waterInFront(depths, rayDepth) > waterInFront(passage.depthsLow, passage.rayLow);
    passage.high = isMore ? middle : passage.high;
    passage.depthsHigh = isMore ? depths : passage.depthsHigh;
    passage.rayHigh = isMore ? rayDepth : passage.rayHigh;
    halvings += isHalving || isMore ? 1 : 0;
    bool isDone = halvings >= 5;
    met = bvec2(isDone && waterHasMet(passage, passage.depthsHigh.x), isDone && waterHasMet(passage, passage.depthsHigh.y));
    bool isPast = isDone && !met.x && !met.y;
    passage.low = isPast ? passage.high : (isMore ? passage.low : middle);
    passage.depthsLow = isPast ? passage.depthsHigh : (isMore ? passage.depthsLow : depths);
    passage.rayLow = isPast ? passage.rayHigh : (isMore ? passage.rayLow : rayDepth);
    halvings = isPast ? 0 : halvings;
    --rest;
  } while (rest > 0 && halvings < 5 && (halvings > 0 || passage.low < 1.0));
  return met;
}

// Continues a ray that has passed behind an object. Its colour is already known, and stays if the
// second layer does not show what the ray meets.
void waterLookBehind(vec3 start, inout WaterRayHit hit)
{
  if (hit.reason == WATER_HIDDEN)
  {
    vec3 way = hit.line;
    float rayDepth = min(start.z + hit.passed * way.z, 1.0);
    vec2 depths = waterBothToMeet(start.xy + hit.passed * way.xy);
    WaterPassage passage = WaterPassage(hit.passed, hit.passed, depths, depths, rayDepth, rayDepth);
    bvec2 met = waterMarchBehind(start, way, passage);
    bool isMet = met.x || met.y;
    vec2 ends = passage.depthsLow;
    bool isFree = !isMet && waterInFront(ends, passage.rayLow) == 0; // in front of all once more
    bool isSky = !isMet && (waterIsSky(ends.x) || waterIsSky(ends.y));
    // of the two, which shows it
    bool isFirst = isMet ? met.x : isFree || waterIsSky(ends.x);
    bool isBetween = !isMet && !isSky && !isFree && !hit.isInside && ends.y >= passage.rayLow;
    bool isKnown = isMet || isSky || isFree || isBetween;
    vec2 uv = start.xy + (isMet ? passage.high : 1.0) * way.xy;
    vec4 texel = isFirst ? textureLod(waterReflection, uv, 0.0) : textureLod(waterPeelColor, uv, 0.0);
    hit.color = isSky && waterIsSkyKnown() ? hit.color : (isKnown ? waterDrawn(texel, hit.color) : hit.color);
    hit.isPlace = hit.isPlace && !isKnown;
    hit.uv = isKnown ? uv : hit.uv;
  }
}
