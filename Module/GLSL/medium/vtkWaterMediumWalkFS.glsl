// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumWalkFS.glsl: slot refraction for software renderers, where a branch costs as much untaken;
// vtkWaterHardwareMediumFS.glsl is the same for hardware.

const float WATER_MEDIUM_ASIDE = 0.7;    // of how far a ray goes on unseen
const int WATER_MEDIUM_PLACES = 16;      // of a mean
const float WATER_MEDIUM_PLACE = 0.25;   // weight of the first
const float WATER_MEDIUM_ALIKE = 0.25;   // depths of a bed differ by less of one of them
const int WATER_MEDIUM_HALVINGS = 5;
const int WATER_MEDIUM_TRIES = 2;    // so many steps may be halved
const float WATER_MEDIUM_JUMP = 1.2; // how much further than to where the ray was in front
const float WATER_MEDIUM_FURTHER_PX = 3.0;
const float WATER_MEDIUM_SLACK_PX = 0.8; // depths are those of pixels' middles

vec2 waterMediumSize()
{
  return vec2(textureSize(waterSceneColor, 0));
}

// Always looked at.
bool waterMediumIsNearEdge(vec2 middle, vec2 next, float depth)
{
  return true;
}

// Largest length of a ray: to the depth straight behind the surface, and beyond while it is still
// in front.
//
// depth  of the picture at the ray's start
float waterMediumReach(vec3 start, vec3 way, float depth)
{
  float perDepth = 1.0 / max(way.z, 1e-20);
  float level = max(depth - start.z, 0.0) * perDepth;
  float reach = level;
  for (int i = 0; i < 3; ++i)
  {
    vec3 at = start + reach * way;
    reach += max(waterMediumDepth(at.xy) - at.z, 0.0) * perDepth;
  }
  return level > 0.0 && depth < 1.0 && reach > WATER_MEDIUM_LEVEL * level
    ? waterMediumBedReach(start, way, depth, level, reach)
    : reach;
}

// The walk in equal steps. What stands over the water hides what the ray could meet, and so does what it goes behind:
// they are passed until what lies under the water is seen again. A place where the ray is behind is one where it came
// in if what is seen there goes on, as it does a little further, to where the ray was in front.
//
// Long because all of its states change in one loop: software renderers go through a loop once at least.
WaterMediumHit waterMediumMarch(vec3 start, vec3 way, float depth, float reach)
{
  // along the plane, of the depth
  float overRate = -dot(waterHeightClip.xy, way.xy) / waterHeightClip.z;
  float texel = 1.0 / max(length(way.xy * waterMediumSize()), 1e-6);
  float step = reach / float(WATER_MEDIUM_STEPS);
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, depth, 0.0, false, false);
  float apart = WATER_MEDIUM_FURTHER_PX * texel;
  float missFurther = 0.0;
  float at = 0.0;
  float veil = 1e9; // what the ray is further behind hides the bed
  vec2 before = vec2(-1.0); // the place before the first of what hides it, and the depth there
  vec2 gap = vec2(1.0, 0.0); // the first and the last hidden place between low and high; first > last: none
  int halvings = 0;
  int most = WATER_MEDIUM_HALVINGS;
  int probes = 0;
  for (int i = 0; i < WATER_MEDIUM_STEPS + WATER_MEDIUM_TRIES * (WATER_MEDIUM_HALVINGS + 4); ++i)
  {
    bool isDone = halvings >= most;
    vec2 beside = (halvings & 1) == 0 ? vec2(found.low, gap.x) : vec2(gap.y, found.high);
    vec2 ends = gap.x > gap.y ? vec2(found.low, found.high) : beside;
    float inside = isDone ? found.high + float(probes + 1) * apart : 0.5 * (ends.x + ends.y);
    float place = found.isHit ? inside : at + step;
    float seen = waterMediumDepth(start.xy + place * way.xy);
    float behind = start.z + place * way.z - seen;
    if (isDone && probes == 0)
    {
      missFurther = behind;
      probes = 1;
    }
    else if (isDone)
    {
      float missHigh = start.z + found.high * way.z - found.depthHigh;
      float rate = max(min(missFurther - missHigh, behind - missFurther) / apart, way.z);
      float wide = found.high - found.low;
      found.share = clamp(1.0 - missHigh / max(rate * wide, 1e-20), 0.0, 1.0);
      if (missHigh <= rate * (WATER_MEDIUM_JUMP * wide + WATER_MEDIUM_SLACK_PX * texel))
      {
        break;
      }
      veil = 0.5 * missHigh;
      before = before.x < 0.0 ? vec2(found.low, found.depthLow) : before;
      found.isHit = false;
      halvings = 0;
      probes = 0;
    }
    else
    {
      bool isKnown = seen >= start.z + place * overRate && behind < veil;
      bool isLow = isKnown && behind <= 0.0;
      bool isHigh = isKnown && behind > 0.0;
      vec2 wider = gap.x > gap.y ? vec2(place) : vec2(min(gap.x, place), max(gap.y, place));
      bool isOver = !found.isHit || (isLow && place > gap.y) || (isHigh && place < gap.x);
      gap = isOver ? vec2(1.0, 0.0) : (isKnown ? gap : wider);
      most = gap.x > gap.y ? WATER_MEDIUM_HALVINGS : WATER_MEDIUM_HALVINGS + 4;
      at = found.isHit ? at : place;
      halvings += found.isHit ? 1 : 0;
      veil = isLow && !found.isHit ? 1e9 : veil;
      found.low = isLow ? place : found.low;
      found.depthLow = isLow ? seen : found.depthLow;
      found.high = isHigh ? place : found.high;
      found.depthHigh = isHigh ? seen : found.depthHigh;
      found.isHit = found.isHit || isHigh;
    }
    if (!found.isHit && at >= reach - 0.5 * step)
    {
      break;
    }
  }
  if (!found.isHit && found.depthLow >= 1.0 && before.x >= 0.0)
  {
    found.low = before.x; // what is hidden is likelier than nothing
    found.depthLow = before.y;
  }
  bool isHidden = !found.isHit && found.low < reach - 0.5 * step;
  waterMediumLastSeen(start, way, found.low + step, isHidden ? WATER_MEDIUM_LAST : 0, found);
  found.isGap = found.isHit && gap.x <= gap.y; // however narrow: between the two is the color of what hides it
  return found;
}

// The first place where a ray is behind what the picture shows. One that comes to a smooth bed, with nothing on the way, is
// not marched: it needs half of the reads or less, and what it meets is the same to a part of a pixel.
WaterMediumHit waterMediumWalk(vec3 start, vec3 way, float depth, float reach)
{
  float last = waterMediumDepth(start.xy + reach * way.xy);
  float pixels = length(way.xy * waterMediumSize()); // for all of the way
  WaterMediumHit found = WaterMediumHit(0.0, reach, depth, last, 0.0, false, false);
  bool isFound = start.z <= depth;
  if (isFound && start.z + reach * way.z > last)
  {
    isFound = waterMediumConverge(start, way, pixels, found);
    // not behind a silhouette
    float rate = max((depth - start.z) / max(found.high, 1e-20), way.z);
    isFound = isFound && depth < 1.0 &&
      found.depthLow - found.depthHigh <= WATER_MEDIUM_SLACK_PX * rate / max(pixels, 1e-6);
  }
  else
  {
    found = WaterMediumHit(reach, reach, last, last, 0.0, false, false);
  }
  if (!isFound || !waterMediumIsFree(start, way, found.high, found.high * pixels))
  {
    found = waterMediumMarch(start, way, depth, reach);
  }
  return found;
}

// Where a ray into the scene meets what the picture shows.
//
// start  of the ray in the picture's window: u, v, depth
// way    the ray is start + s way
// most, deepest  of s: as declared
WaterMediumView waterMediumMeets(vec3 start, vec3 way, float most, float deepest)
{
  float depth = waterMediumDepth(start.xy);
  float reach = waterMediumReach(start, way, depth);
  reach = depth < 1.0 ? reach : min(reach, most); // the background ends no ray
  float leaves = waterMediumLeaves(start, way);
  bool isInside = reach <= leaves;
  reach = min(reach, leaves);

  WaterMediumHit found = waterMediumWalk(start, way, depth, reach);
  float wide = found.high - found.low;
  // the false position between the two
  float missLow = start.z + found.low * way.z - found.depthLow;
  float missHigh = start.z + found.high * way.z - found.depthHigh;
  float share = found.isHit ? clamp(-missLow / max(missHigh - missLow, 1e-20), 0.0, 1.0) : 0.0;
  WaterMediumView view;
  view.isMet = found.isHit ? !found.isGap : isInside && found.low >= reach * (1.0 - 1e-6);
  view.s = found.low + share * wide;
  view.share = view.isMet ? share : (found.isHit ? found.share : 0.0);
  view.from = start.xy + (view.isMet ? view.s : found.low) * way.xy;
  view.to = view.isMet ? view.from : waterMediumMiddle(start.xy + found.high * way.xy);
  view.isOut = !found.isHit && !isInside;
  view.isHidden = !found.isHit && isInside && !view.isMet;
  view.isBelow = view.isOut && waterMediumPassesBelow(start, way, leaves, deepest);
  return view;
}

// The further a ray goes on beyond the picture, the more of the picture is like what it meets: the colour of one place, for a
// column of rays, would be seen as a bar.
vec2 waterMediumAside(vec3 dir, WaterMediumRay ray, WaterMediumMet met)
{
  float way = waterMediumHeight(met.view.from, met.depth) / dir.z; // to a level bed as deep as there
  vec2 size = waterMediumSize();
  vec2 end = ray.start.xy + way / max(ray.w + way * ray.rate, 1e-6) * ray.way.xy;
  vec2 along = ray.way.xy * size / max(length(ray.way.xy * size), 1e-6);
  float beyond = max(dot((end - met.view.from) * size, along), 0.0); // pixels
  bool isBed = met.depth < 1.0 && way > 0.0 && waterSide > 0.0;
  return met.view.isOut && isBed ? WATER_MEDIUM_ASIDE * beyond * vec2(-along.y, along.x) / size : vec2(0.0);
}

vec3 waterMediumFrom(WaterMediumMet met)
{
  float count = WATER_MEDIUM_PLACE;
  vec3 sum = count * waterMediumColor(met.view.from, met.depth);
  float height = waterMediumHeight(met.view.from, met.depth);
  int places = met.aside == vec2(0.0) ? 0 : WATER_MEDIUM_PLACES;
  vec2 back = vec2(met.aside.y, -met.aside.x) * waterMediumSize().yx / waterMediumSize(); // where the ray comes from
  for (int i = 0; i < places; ++i)
  {
    // a lattice of rank one
    vec2 part = vec2(2.0 * fract(0.618034 * (float(i) + 0.5)) - 1.0, (float(i) + 0.5) / float(WATER_MEDIUM_PLACES));
    vec2 place = waterMediumMiddle(met.view.from + part.x * met.aside + part.y * back);
    float depth = waterMediumDepth(place);
    bool isBed = depth < 1.0 && abs(waterMediumHeight(place, depth) - height) < WATER_MEDIUM_ALIKE * -height;
    float weight = isBed ? (1.0 - abs(part.x)) * (1.0 - part.y) : 0.0; // the furthest change from row to row the most
    sum += weight * textureLod(waterSceneColor, place, 0.0).rgb;
    count += weight;
  }
  return sum / count;
}
