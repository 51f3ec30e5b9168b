// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMediumFS.glsl: slot medium: what is seen through the surface, refracted, and what the way
// through the water leaves of it; water_medium.c for the shader.
//
// Seen from above the refracted ray runs through the water, from below the view ray does.

// A ray through the water.
struct WaterMediumRay
{
  vec3 start; // in the picture's window: u, v, depth
  vec3 way;   // the ray is start + s way
  float w;    // of the start in view space
  float rate; // of w, per metre
};

// The ray into another direction from a point of one.
//
// dir     the direction, in the plane's axes
// metres  to the point
WaterMediumRay waterMediumTurn(WaterMediumRay ray, vec3 dir, float metres)
{
  float s = metres / (ray.w + metres * ray.rate);
  vec4 end = waterDirToScene * vec4(dir, 0.0);
  vec3 start = ray.start + s * ray.way;
  vec3 way = 0.5 * (end.xyz - (2.0 * start - 1.0) * end.w);
  return WaterMediumRay(start, way, ray.w + metres * ray.rate, end.w);
}

// Length of a ray before it leaves the part of the scene under the water's surface, m.
//
// inside  how far inside the border that is, m: what is there is surely under the water
float waterMediumBorder(vec2 place, vec2 dir, float inside)
{
  vec2 border = mix(waterSheet.xz + inside, waterSheet.yw - inside, greaterThan(dir, vec2(0.0)));
  vec2 ways = (border - place) / mix(dir, vec2(1e-9), equal(dir, vec2(0.0)));
  return max(min(ways.x, ways.y), 0.0);
}

// What a refracted ray meets.
struct WaterMediumMet
{
  WaterMediumView view;
  float depth;        // of the picture at the first of its places
  float way;          // m of water
  bool isUnderBorder; // the water ends before the ray meets anything: it is the bed under its border
  bool isNothing;     // there is none
  vec2 aside;         // the color is a mean over so much of the picture to each side: 0, of one place
};

// The place where a ray meets a surface that is interpolated between the centres of pixels, where
// the picture has its depths. At a low angle the ray would otherwise be found pixels away, over
// which the light of caustics changes.
float waterMediumBetween(WaterMediumRay ray, WaterMediumView view)
{
  vec2 size = waterMediumSize();
  vec2 middle = waterMediumMiddle(view.from);
  float depth = waterMediumDepth(middle); // at a pixel's border GPUs may have read that of the next one
  vec2 before = depth - vec2(waterMediumDepth(middle - vec2(1.0, 0.0) / size),
    waterMediumDepth(middle - vec2(0.0, 1.0) / size));
  vec2 after = vec2(waterMediumDepth(middle + vec2(1.0, 0.0) / size),
    waterMediumDepth(middle + vec2(0.0, 1.0) / size)) - depth;
  vec2 isAfter = vec2(lessThan(abs(after), abs(before))) * step(middle * size, size - 1.0);
  isAfter = max(isAfter, step(middle * size, vec2(1.0))); // beyond the border no depth is known
  vec2 slope = size * mix(before, after, isAfter);
  float miss = ray.start.z + view.s * ray.way.z - depth - dot(slope, view.from - middle);
  float rate = ray.way.z - dot(slope, ray.way.xy);
  float further = -miss / max(rate, 1e-20);
  bool isNear = rate > 0.0 && abs(further) * length(ray.way.xy * size) < WATER_MEDIUM_BETWEEN_PX;
  return view.s + (view.isMet && isNear ? further : 0.0);
}

// How far the scene reaches under the point that is looked through.
float waterMediumDeepest()
{
  return waterBedDepth + max(waterMediumTop, 0.0);
}

// Corrects what a ray is found to meet where the picture does not show it; of the slot ground.
//
// dir   of the ray, in the plane's axes
// most  as of waterMediumMeets
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met);

bool waterHasCaustics(); // of the slot caustics

// The point in the picture's window. The middle of a pixel with several samples lies between finer ones, whose depths are
// those of their own middles: thin water would be before its bed or behind it as one or the other is read. There the point
// moves along the plane to such a middle; elsewhere edges would move, too.
vec3 waterMediumStart(WaterPoint point)
{
  vec2 place = waterMediumPlace(point.ndc);
  vec2 size = waterMediumSize();
  float depth = waterWindowDepth(point.ndc, point.moved);
  vec2 slope = -waterHeightClip.xy / waterHeightClip.z; // of the plane's depth
  float thin = WATER_MEDIUM_THIN_PX * dot(abs(slope), 1.0 / size);
  bool isThin = waterSceneSide > 1 && abs(waterMediumDepth(place) - depth) < thin;
  vec2 off = isThin ? (floor(place * size + 0.01) + 0.5) / size - place : vec2(0.0);
  return vec3(place + off, depth + dot(slope, off));
}

// If a ray leaves the picture before it meets the bed: how much of the picture, to each side of the place where it leaves,
// is like what it meets? Of the slot refraction.
//
// dir  of the ray, in the plane's axes
vec2 waterMediumAside(vec3 dir, WaterMediumRay ray, WaterMediumMet met);

// A ray that leaves the water without having met its bed meets what lies under the water's border, as if that went on.
//
// dir  of the ray, in the plane's axes
WaterMediumMet waterMediumMeet(WaterPoint point, vec3 dir)
{
  vec3 start = waterMediumStart(point);
  WaterMediumRay ray =
    waterMediumTurn(WaterMediumRay(start, vec3(0.0), 1.0 / waterPerW(), 0.0), dir, 0.0);
  float pixel = max(length(point.across), length(point.down));
  float border = waterMediumBorder(point.place, dir.xy, 2.0 * pixel);
  bool isBounded = border * -dir.z < waterMediumDeepest() && waterSide > 0.0;
  // at the lowest angles a pixel is too wide to tell whether the bed ends with the water
  bool isFine = pixel < WATER_MEDIUM_FINE * waterBedDepth;
  float deepest = WATER_MEDIUM_DEEPER * waterMediumDeepest();
  float most = waterSide > 0.0 ? deepest / -dir.z : WATER_MEDIUM_ENDLESS;
  WaterMediumMet met;
  met.isUnderBorder = false;
  for (int i = 0; i < 2; ++i)
  {
    float tolerant = WATER_MEDIUM_TOLERANCE * most;
    met.view = waterMediumMeets(ray.start, ray.way, most / max(ray.w + most * ray.rate, 1e-6),
      tolerant / max(ray.w + tolerant * ray.rate, 1e-6));
    met.depth = waterMediumDepth(met.view.from);
    if (i > 0 && met.depth >= 1.0)
    {
      // between the background and the edge of the bed, which it comes to
      vec2 further = ray.way.xy / max(length(ray.way.xy * waterMediumSize()), 1e-6);
      met.view.from = met.view.isMet && isFine ? met.view.from + further : met.view.to;
      met.depth = waterMediumDepth(met.view.from);
    }
    if (i > 0 || met.depth < 1.0 || !isBounded)
    {
      break;
    }
    ray = waterMediumTurn(ray, vec3(0.0, 0.0, -1.0), border);
    most = deepest;
    met.isUnderBorder = true;
  }
  float way = met.view.s * ray.w / max(1.0 - met.view.s * ray.rate, 1e-6);
  // over a long way in the picture half of a pixel changes little but the light of caustics
  bool isShort = met.view.s * length(ray.way.xy * waterMediumSize()) < WATER_MEDIUM_SHORT_WAY_PX;
  float between = isShort || waterHasCaustics() ? waterMediumBetween(ray, met.view) : met.view.s;
  met.way = between * ray.w / max(1.0 - between * ray.rate, 1e-6);
  // along the view ray; parallel views have one w
  float behind = waterHeightClip.z * 2.0 * (met.depth - ray.start.z - met.view.s * ray.way.z) / point.ray.z;
  float apart = abs(waterClipW.z != 0.0 ? waterMediumW(met.view.from, met.depth) - ray.w - way * ray.rate : behind);
  // the bed is likelier than nothing where the picture does not show it
  bool isThere = met.depth < 1.0 &&
    (met.view.isOut || apart < WATER_MEDIUM_BELOW * waterBedDepth + WATER_MEDIUM_EDGE * pixel);
  met.isNothing = met.isUnderBorder ? !isThere : met.view.isBelow;
  waterMediumGuess(point, dir, ray, most, met);
  met.aside = waterMediumAside(dir, ray, met);
  return met;
}

// Light on what a ray through the water comes to, over that of calm water. The bed under the water's border is lit as if it
// went on as deep: where the ray would meet it.
float waterMediumLight(WaterPoint point, vec3 dir, float way)
{
  vec4 end = way * (waterDirToEye * vec4(dir, 0.0));
  float w = 1.0 / waterPerW() + end.w;
  vec2 ndc = (point.ndc / waterPerW() + end.xy) / max(w, 1e-6); // beyond the picture's border, too
  return waterCaustic(ndc, w, -way * dir.z, point.ndc);
}

// Color at the first place of what a ray meets, or the mean of the same bed to its sides; of the slot refraction.
vec3 waterMediumFrom(WaterMediumMet met);

// What a refracted ray sees with the translucent things on its way; of the slot below.
vec3 waterThroughBelowLayer(WaterPoint point, vec3 dir, vec3 behind);

// Color of the opaque surface that a refracted ray meets, and the light that the water adds.
vec3 waterTransmittedOpaque(WaterPoint point, vec3 dir)
{
  WaterMediumMet met = waterMediumMeet(point, dir);
  if (met.isNothing)
  {
    return waterDeepColor;
  }
  WaterMediumView view = met.view;
  waterMediumEnd = view.from;
  vec3 from = waterMediumFrom(met);
  vec3 to = from;
  vec3 ways = vec3(met.way); // of what is seen at the first place, at the second, and of both
  float depthTo = met.depth;
  bool areTwo = !view.isMet && !met.isUnderBorder;
  if (areTwo || met.isUnderBorder) // over level beds
  {
    depthTo = waterMediumDepth(view.to);
    to = waterMediumColor(view.to, depthTo);
    vec2 middle = waterMediumMiddle(view.from); // the picture has its depths there
    vec2 heights = vec2(waterMediumHeight(middle, waterMediumDepth(middle)), waterMediumHeight(view.to, depthTo));
    ways.xy = max(heights / dir.z, vec2(0.0));
    ways.z = areTwo ? mix(ways.x, ways.y, view.share) : ways.x;
  }
  if (waterSide < 0.0)
  {
    vec3 color = mix(from, to, view.share);
    bool isSky = met.depth >= 1.0 || (!view.isMet && waterHasFloor());
    return isSky && waterIsSkyKnown() ? waterSky(dir) : color;
  }
  float caustic = waterMediumLight(point, dir, ways.x);
  from = met.depth >= 1.0 ? waterDeepColor : waterAfter(caustic * from, ways.x);
  if (areTwo)
  {
    caustic = waterMediumLight(point, dir, ways.y);
    to = depthTo >= 1.0 ? waterDeepColor : waterAfter(caustic * to, ways.y);
    from = mix(from, to, view.share);
  }
  return from;
}

// Color of what a ray meets beyond a point of the surface, and the light that the water adds.
vec3 waterTransmittedRay(WaterPoint point)
{
  waterMediumTop = point.height;
  vec3 dir = refract(point.ray, point.normal, 1.0 / waterEta);
  if (dir.z >= 0.0)
  {
    return waterDeepColor; // total reflection: it has no weight
  }
  return waterThroughBelowLayer(point, dir, waterTransmittedOpaque(point, dir));
}

// Color of what lies beyond a point of the surface, and the light that the water adds; of the slot others.
vec3 waterTransmitted(WaterPoint point);

// Depth of the water where the pixel looks straight, m.
//
// What is found over the water shares the pixel's samples and stands before it: at the waterline
// that is the shore, and far over it as good as none, or silhouettes had a shore.
float waterTransmittedDepth(WaterPoint point)
{
  waterMediumTop = point.height;
  vec2 uv = waterMediumPlace(point.ndc);
  float depth = waterMediumDepth(uv);
  return depth >= 1.0 || waterSide < 0.0 ? 1e9 : abs(waterMediumHeight(uv, depth));
}

// Depth of what the picture shows straight behind a place; far away: nothing.
float waterMediumStraight(vec2 ndc)
{
  vec2 uv = waterMediumPlace(ndc);
  float depth = waterMediumDepth(uv);
  return depth >= 1.0 ? 1e9 : -waterMediumHeight(uv, depth);
}

// How much that depth changes over the pixel, m. To each side of a silhouette it jumps: the smaller change to
// one of two neighbours is that of the bed.
float waterTransmittedChange(WaterPoint point)
{
  waterMediumTop = point.height;
  vec2 pixel = 2.0 * waterViewport.zw;
  float here = waterMediumStraight(point.ndc);
  vec2 before = abs(here - vec2(waterMediumStraight(point.ndc - vec2(pixel.x, 0.0)),
    waterMediumStraight(point.ndc - vec2(0.0, pixel.y))));
  vec2 after = abs(here - vec2(waterMediumStraight(point.ndc + vec2(pixel.x, 0.0)),
    waterMediumStraight(point.ndc + vec2(0.0, pixel.y))));
  vec2 change = min(before, after);
  return change.x + change.y;
}

// The surface as the eye sees it, which may be under water.
vec3 waterSeenFrom(WaterPoint point, vec3 color)
{
  if (waterIsSubmerged == 0)
  {
    return color;
  }
  float along = (waterDirToEye * vec4(point.ray, 0.0)).w;
  // with several samples the middle of a pixel at the horizon may lie beyond it, where no point is
  float way = 1.0 / max(waterPerW() * along, 1e-9);
  vec3 haze = waterHaze(point.ray, -waterSide * point.ray.z, way);
  return mix(haze * waterShaftsAlong(point.ray, way), color, waterLeft(way));
}
