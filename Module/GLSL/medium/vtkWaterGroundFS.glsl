// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGroundFS.glsl: slot ground: rays over ground that meet nothing in the picture. There is a bed under all of the
// water, so something is there.

const int WATER_MEDIUM_LOOKS_ASIDE = 24; // to each side of what hides the bed
const float WATER_MEDIUM_ASIDE_PX = 1.5; // of the first of them
const float WATER_MEDIUM_DEEP = 0.5; // of the bed's depth: likelier the bed than an object
const float WATER_MEDIUM_ASIDE_RATE = 1.3; // of a look's distance to that of the one before it: the last is 600 pixels away

// How far under the plane is what is seen there? 0: over it, or background.
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
//
// Returns the place, and how far away it is, pixels; 0: there is none
vec3 waterMediumBeside(vec2 end, vec2 side, vec2 onwards)
{
  vec3 found = vec3(end, 0.0);
  float aside = WATER_MEDIUM_ASIDE_PX;
  bool isDeep = false;
  float deep = WATER_MEDIUM_DEEP * waterBedDepth;
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
    found = isBetter ? vec3(isLevel ? level : oblique, aside) : found;
    aside *= WATER_MEDIUM_ASIDE_RATE;
  }
  return found;
}

// What a ray is taken to meet if an object hides all that it could meet: what is seen under the water to the left and
// to the right of the object, the nearer side the more. Returns whether there is anything.
//
// end  of the ray: u, v
// way  in the picture
bool waterMediumLookAside(vec2 end, vec2 way, inout WaterMediumView view)
{
  vec2 size = waterMediumSize();
  vec2 onwards = way / max(length(way * size), 1e-9);
  vec3 left = waterMediumBeside(end, vec2(-1.0, 0.0) / size, onwards);
  vec3 right = waterMediumBeside(end, vec2(1.0, 0.0) / size, onwards);
  if (max(left.z, right.z) <= 0.0)
  {
    return false;
  }
  vec2 from = left.z > 0.0 ? left.xy : right.xy;
  vec2 to = right.z > 0.0 ? right.xy : left.xy;
  view = WaterMediumView(false, view.s, from, to, left.z / (left.z + right.z), false, false);
  return true;
}

// What a ray over ground is taken to meet if the picture shows nothing: ground that is hidden by its own rim looks like
// what is seen straight through the surface, and what an object hides like what is beside that.
//
// dir   of the ray, in the plane's axes
// most  as of waterMediumMeets
void waterMediumGuess(WaterPoint point, vec3 dir, WaterMediumRay ray, float most, inout WaterMediumMet met)
{
  vec2 straight = waterMediumPlace(point.ndc);
  float depth = waterMediumDepth(straight);
  float height = waterMediumHeight(straight, depth);
  vec2 end = ray.start.xy + most / max(ray.w + most * ray.rate, 1e-6) * ray.way.xy;
  if (depth < 1.0 && height < 0.0)
  {
    met.view = WaterMediumView(true, met.view.s, straight, straight, 0.0, false, false);
    met.depth = depth;
    met.way = height / dir.z;
    met.isNothing = false;
  }
  else if (waterSide > 0.0 && waterMediumLookAside(end, ray.way.xy, met.view))
  {
    met.depth = waterMediumDepth(met.view.from);
    met.isNothing = false;
    met.isUnderBorder = false;
  }
}
