// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGroundFS.glsl: slot ground: rays over ground that meet nothing in the picture. There is a bed under all of the
// water, so something is there.

const int WATER_MEDIUM_LOOKS_ASIDE = 24; // to each side of what hides the bed
const float WATER_MEDIUM_SHORT_PX = 3.0; // between two depths that tell a slope, beside an edge
const float WATER_MEDIUM_ASIDE_PX = 1.5; // of the first of them
const float WATER_MEDIUM_DEEP = 0.5; // of the bed's depth: likelier the bed than an object
const float WATER_MEDIUM_APART = 0.25; // of the way from what hides a ray to the ray
const float WATER_MEDIUM_LOWEST = 0.85; // of the same: surely the bed
const float WATER_MEDIUM_ASIDE_RATE = 1.3; // of a look's distance to that of the one before it: the last is 600 pixels away

// How far under the surface is what is seen there? 0: over it, or background.
float waterMediumUnder(vec2 uv)
{
  float depth = waterMediumDepth(uv);
  bool isInside = uv == clamp(uv, 0.0, 1.0);
  return isInside && depth < 1.0 ? max(-waterMediumHeight(uv, depth), 0.0) : 0.0;
}

// The nearest place to one side of an object where something under the water is seen, or obliquely beyond it. What
// is deep is likelier the bed than a part of the object.
//
// end      of a ray behind the object: u, v
// side     one pixel to the side, as part of the picture
// onwards  the same in the direction of the ray
// deep     what is under the surface by more than that is the bed
//
// Returns the place, how far away it is, pixels, and 1 if it is deep; all 0: there is none
vec4 waterMediumBeside(vec2 end, vec2 side, vec2 onwards, float deep)
{
  vec4 found = vec4(end, 0.0, 0.0);
  float aside = WATER_MEDIUM_ASIDE_PX;
  bool isDeep = false;
  for (int i = 0; i < WATER_MEDIUM_LOOKS_ASIDE && !isDeep; ++i)
  {
    vec2 level = end + aside * side;
    vec2 oblique = level + aside * onwards;
    float underLevel = waterMediumUnder(level);
    float underOblique = waterMediumUnder(oblique);
    float under = underLevel > 0.0 ? underLevel : underOblique;
    isDeep = max(underLevel, underOblique) > deep;
    bool isLevel = underLevel > (isDeep ? deep : 0.0);
    bool isBetter = isDeep || (under > 0.0 && found.z == 0.0);
    found = isBetter ? vec4(isLevel ? level : oblique, aside, isDeep ? 1.0 : 0.0) : found;
    aside *= WATER_MEDIUM_ASIDE_RATE;
  }
  return found;
}

// What a ray is taken to meet if an object hides all that it could meet: what is seen under the water to the left and
// to the right of the object, the nearer side the more, and what is not deep only if nothing is. Returns whether there is
// anything.
//
// end     of the ray: u, v, depth
// way     in the picture
// isPost  is the object narrow, with the bed on both sides, nearer to the ray than the object? Or else nothing is found
bool waterMediumLookAside(vec3 end, vec2 way, bool isPost, inout WaterMediumView view)
{
  vec2 size = waterMediumSize();
  vec2 onwards = way / max(length(way * size), 1e-9);
  float deep = (isPost ? WATER_MEDIUM_LOWEST : WATER_MEDIUM_DEEP) * waterMediumDeepest();
  vec4 left = waterMediumBeside(end.xy, vec2(-1.0, 0.0) / size, onwards, deep);
  vec4 right = waterMediumBeside(end.xy, vec2(1.0, 0.0) / size, onwards, deep);
  float nearest = min(waterMediumDepth(left.xy), waterMediumDepth(right.xy));
  bool isBed = min(left.w, right.w) > 0.0 &&
    (waterMediumUnder(end.xy) > deep || nearest > mix(waterMediumDepth(end.xy), end.z, WATER_MEDIUM_APART));
  if (max(left.z, right.z) <= 0.0 || (isPost && !isBed))
  {
    return false;
  }
  vec2 from = left.z > 0.0 && left.w >= right.w ? left.xy : right.xy;
  vec2 to = right.z > 0.0 && right.w >= left.w ? right.xy : left.xy;
  view = WaterMediumView(false, view.s, from, to, left.z / (left.z + right.z), false, false, true);
  return true;
}

// If an object hides the end of a ray, does the ray meet what is seen last before the object, if that goes on as a plane?
// It meets a floor behind a rim. What is seen over a post may be a wall far behind the ray.
//
// deepest  of s: there the ray is deeper than anything
bool waterMediumMeetsLast(WaterMediumRay ray, WaterMediumMet met, float deepest)
{
  float texel = 1.0 / max(length(ray.way.xy * waterMediumSize()), 1e-6);
  vec2 bases = texel * vec2(WATER_MEDIUM_SHORT_PX, WATER_MEDIUM_BASE_PX); // one may reach to something else
  vec2 before = met.view.s - bases;
  vec2 depths =
    vec2(waterMediumDepth(ray.start.xy + before.x * ray.way.xy), waterMediumDepth(ray.start.xy + before.y * ray.way.xy));
  float miss = ray.start.z + met.view.s * ray.way.z - met.depth;
  vec2 rates = (miss - ray.start.z - before * ray.way.z + depths) / bases;
  return -miss <= max(rates.x, rates.y) * (deepest - met.view.s);
}

// What a ray over ground is taken to meet if the picture shows nothing: ground that is hidden by its own rim looks like
// what is seen straight through the surface, and what an object hides like what is beside that. If an object hides the end
// of the ray, what is seen straight is above that end: the wall behind it, or another part of the bed.
//
// dir   of the ray, in the plane's axes
// most  as of waterMediumMeets
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
  if (!met.isNothing && met.depth < 1.0 && !met.view.isHidden)
  {
    return;
  }
  vec2 straight = waterMediumMiddle(waterMediumPlace(point.ndc));
  float depth = waterMediumDepth(straight);
  float height = waterMediumHeight(straight, depth);
  float deepest = most / max(ray.w + most * ray.rate, 1e-6);
  vec3 end = ray.start + deepest * ray.way;
  bool isOverEnd = met.view.isHidden && met.depth < 1.0 && !met.isNothing;
  bool isStraight = depth < 1.0 && height < 0.0 && !isOverEnd;
  bool isLast = waterMediumHeight(met.view.from, met.depth) < -WATER_MEDIUM_LOWEST * waterMediumDeepest() ||
    waterMediumMeetsLast(ray, met, deepest);
  if (isStraight)
  {
    met.view = WaterMediumView(true, met.view.s, straight, straight, 0.0, false, false, false);
    met.depth = depth;
    met.way = height / dir.z;
    met.isNothing = false;
  }
  else if (waterSide > 0.0 && !(isOverEnd && isLast) &&
    waterMediumLookAside(end, ray.way.xy, isOverEnd, met.view))
  {
    met.depth = waterMediumDepth(met.view.from);
    met.isNothing = false;
    met.isUnderBorder = false;
  }
}
