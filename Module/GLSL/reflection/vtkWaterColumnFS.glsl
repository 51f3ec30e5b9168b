// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterColumnFS.glsl: slot facets of quality "high": what all slopes within a pixel reflect, not only those of some facets.
//
// The slopes vary along the azimuth of the view alone (vtkWaterFacetSlopesFS.glsl), so all rays of a pixel lie in one plane
// through the eye, and the reflection texture shows what they can meet in one column of it: those that rise more steeply
// than the ray of calm water above the place where that is seen, the others below. From place to place along this column, what
// is shown there is met by a ray of known slope. Rays of slopes that no place nearer to the calm one has met meet it, and
// its colour counts by the light that these slopes reflect. So shares of objects change evenly from pixel to pixel, where
// facets either meet an object or miss it. It is the scan of horizons for ambient occlusion, with colours.
// Source: Bavoil, Sainz and Dimitrov 2008, "Image-space horizon-based ambient occlusion" (SIGGRAPH talks).

const int WATER_COLUMN_UP = 5;             // places above the calm one, closer to each other near it
const int WATER_COLUMN_DOWN = 8;           // below it, where a thing that is low and far away is small
const float WATER_COLUMN_END = 2.5;        // spreads from the mean slope to the last one
const float WATER_COLUMN_LEAST = 0.004;    // share of the light for which one side is not looked at
const float WATER_COLUMN_HALF = 1.7320508; // spreads from the mean slope to the others whose reflectance is calculated
const float WATER_COLUMN_THIRD = 0.9674;   // below the mean by so many spreads is a sixth of all slopes

struct WaterColumn
{
  vec3 start;  // in the reflection texture: u, v, depth
  vec2 along;  // unit vector of the column
  vec4 gains;  // in place along the column and in depth: of a step ahead, of one upwards
  vec4 top;    // height of the highest thing; w over the start there, and of a step ahead; sign that the gains were given
  vec2 aside;  // in u, v: of a step to the side, over the determinant of these
  float tilt;  // slope of the pixel to the side, which turns its rays out of the column
  vec2 eye;    // cosine and sine of the angle at which the eye sees the plane
  vec2 slopes; // slope times x plus y: in spreads from the mean one
  float level; // slope whose ray is level, in spreads
  vec3 light;  // reflectance, as a polynomial of the slope
  float near;  // least depth that was found
  vec3 sum;    // of the light of what was met
  vec2 thirds; // light below the slopes that divide the sky into the parts of three facets
  vec3 sky;    // light of these parts
};

// Light of all slopes up to one. Exact for normally distributed slopes and the polynomial of the reflectance; the density is
// the derivative of the share.
float waterLightUpTo(vec3 light, float slope)
{
  float square = slope * slope;
  float share = waterNormalShare(slope);
  float density = (share - share * share) * (1.5957691 + 0.2140644 * square);
  return (light.x + light.z) * share - (light.y + light.z * slope) * density;
}

// Light of all slopes whose rays rise less steeply than that of one. Those of rays that go down meet the water again, which
// reflects them up.
float waterLightBelow(WaterColumn column, float slope)
{
  return waterLightUpTo(column.light, slope) - waterLightUpTo(column.light, 2.0 * column.level - slope);
}

// From the surface to a place of the column: ahead, and upwards; times the same.
//
// place  along the column and in depth, from the start
vec2 waterWayTo(WaterColumn column, vec2 place)
{
  return vec2(place.x * column.gains.w - place.y * column.gains.z,
    max(column.gains.x * place.y - column.gains.y * place.x, 0.0));
}

// Slope whose ray goes along a way: the tangent of half the angle between that ray and the one of calm water.
float waterSlopeTo(WaterColumn column, vec2 way)
{
  float far = length(way);
  return (column.eye.x * far - way.x) / max(way.y + column.eye.y * far, 1e-30);
}

float waterInSpreads(WaterColumn column, float slope)
{
  return max(min(column.slopes.x * slope + column.slopes.y, 6.0), column.level);
}

// How far to the side of the column, in u and v, a ray of some slope is at the end of its way.
vec2 waterAsideOf(WaterColumn column, vec2 way, float slope)
{
  float most = (WATER_COLUMN_END - column.slopes.y) / column.slopes.x;
  float turning = clamp(slope, -column.eye.y / (1.0 + column.eye.x), most);
  float lift = 2.0 * (turning * column.eye.x + column.eye.y) / (1.0 + turning * turning + column.tilt * column.tilt);
  return -column.tilt * lift * way.x / max(column.eye.x - turning * lift, 0.05) * column.aside;
}

vec2 waterAsideAt(WaterColumn column, vec2 place)
{
  vec2 way = waterWayTo(column, place);
  return waterAsideOf(column, way, waterSlopeTo(column, way));
}

float waterDepthInColumn(WaterColumn column, float depth)
{
  return min(depth, waterReflectionZInfinity) - column.start.z;
}

// Depth, from the start, at which the ray of a place of the column is over all that there is, or the sky's: no thing that the
// ray can meet is deeper.
float waterTopInColumn(WaterColumn column, float along)
{
  vec4 gains = column.top.w * column.gains;
  float sky = waterDepthInColumn(column, WATER_UNMET);
  float perStep = gains.x - along * column.top.z;
  float ahead = (along * column.top.y - column.top.x * gains.z) / (abs(perStep) > 1e-20 ? perStep : 1e-20);
  float w = column.top.y + ahead * column.top.z;
  float depth = (ahead * gains.y + column.top.x * gains.w) / max(w, 1e-20);
  return w > 0.0 && depth > 0.0 ? min(depth, sky) : sky;
}

bool waterIsSameObject(float depth, float other)
{
  return abs(depth - other) <= waterSameWithin(min(depth, other));
}

// Depth that the rays of a place of the column can meet. How far they are to the side depends on how far away that is: first as
// far as the nearest thing yet, as what is seen straight in the column, or as any thing can be, then as far as what is found.
float waterDepthAlong(WaterColumn column, float along)
{
  vec2 at = column.start.xy + along * column.along;
  float guess = waterIsSky(column.near) ? waterDepthToMeet(at) : column.near;
  float guessed = waterIsSky(guess) ? waterTopInColumn(column, along) : waterDepthInColumn(column, guess);
  float depth = waterDepthToMeet(at + waterAsideAt(column, vec2(along, guessed)));
  if (!waterIsSameObject(depth, guess))
  {
    float second = waterDepthToMeet(at + waterAsideAt(column, vec2(along, waterDepthInColumn(column, depth))));
    depth = waterIsSameObject(depth, second) ? depth : max(depth, second);
  }
  return depth;
}

// Where between two places of the column its depth changes from that of one to that of the other: the last quarter of the way
// that is as the first place, 0 to 0.75.
//
// aside  of the nearer of the two
// limit  depth of what still belongs to it
float waterBorderAlong(WaterColumn column, float low, float high, vec2 aside, float limit, bool isLowNear)
{
  vec3 places = mix(vec3(low), vec3(high), vec3(0.25, 0.5, 0.75));
  vec2 at = column.start.xy + aside;
  vec3 depths = vec3(waterDepthToMeet(at + places.x * column.along), waterDepthToMeet(at + places.y * column.along),
    waterDepthToMeet(at + places.z * column.along));
  bvec3 isNear = lessThanEqual(depths, vec3(limit));
  return isNear.x != isLowNear ? 0.0 : (isNear.y != isLowNear ? 0.25 : (isNear.z != isLowNear ? 0.5 : 0.75));
}

// Adds what slopes see whose rays end between two places of the column.
//
// light  waterLightBelow of these slopes, from and to
// aside  of the places
void waterAddPart(vec2 light, bool isSky, float low, float high, vec2 aside, inout WaterColumn column)
{
  float share = light.y - light.x;
  if (isSky && waterIsSkyKnown())
  {
    vec2 ends = clamp(column.thirds, light.x, light.y);
    column.sky += vec3(ends.x - light.x, ends.y - ends.x, light.y - ends.y);
  }
  else if (share > 0.0)
  {
    WaterFacet seen = waterNoFacet();
    seen.isPlace = true;
    seen.uv = column.start.xy + aside + 0.5 * (low + high) * column.along;
    seen.apart = length((high - low) * column.along * waterReflectionPx());
    column.sum += share * waterFacetColor(seen);
  }
}

// Adds what slopes up to one see that none before has seen.
//
// side   1: above the calm place, -1: below
// slope  in spreads
// light  waterLightBelow of the last slope that sees something
void waterAddUpTo(float side, float slope, bool isSky, float low, float high, vec2 aside, inout float light, inout WaterColumn column)
{
  float next = waterLightBelow(column, slope);
  next = side > 0.0 ? max(next, light) : min(next, light);
  waterAddPart(vec2(min(light, next), max(light, next)), isSky, low, high, aside, column);
  light = next;
}

// What the rays of one side of the column meet, above or below the calm one.
//
// line    length of the column, with its sign
// count   places
// side    1: above, -1: below
// depth   at the start
// light   waterLightBelow of the calm ray's slope
// isOver  rays steeper than the last one end over all that there is; those flatter than it meet what it meets
void waterScanColumn(
  float line, int count, float side, float depth, float light, bool isOver, inout WaterColumn column)
{
  float lowAlong = 0.0;
  float lowDepth = depth;
  vec2 lowAside = waterAsideAt(column, vec2(0.0, waterDepthInColumn(column, depth)));
  for (int i = 1; i <= count; ++i)
  {
    float part = float(i) / float(count);
    float along = line * (side > 0.0 ? part * part : part);
    float here = waterDepthAlong(column, along);
    column.near = min(column.near, here);
    float from = lowAlong;
    float near = min(here, lowDepth);
    float limit = near + waterSameWithin(near);
    if (max(here, lowDepth) > limit) // two objects: the slopes of the nearer end at its edge
    {
      bool isLowNear = lowDepth < here;
      vec2 nearAside = waterAsideAt(column, vec2(0.5 * (lowAlong + along), waterDepthInColumn(column, near)));
      float border = waterBorderAlong(column, lowAlong, along, nearAside, limit, isLowNear);
      // things that stand in the water end at the waterline
      from = mix(lowAlong, along, border + (side < 0.0 && isLowNear ? 0.25 : 0.125));
      vec2 place = vec2(from, waterDepthInColumn(column, near));
      float edge = waterInSpreads(column, waterSlopeTo(column, waterWayTo(column, place)));
      waterAddUpTo(side, edge, waterIsSky(lowDepth), lowAlong, from, lowAside, light, column);
    }
    vec2 way = waterWayTo(column, vec2(along, waterDepthInColumn(column, here)));
    float slope = waterSlopeTo(column, way);
    lowAside = waterAsideOf(column, way, slope);
    waterAddUpTo(side, waterInSpreads(column, slope), waterIsSky(here), from, along, lowAside, light, column);
    lowAlong = along;
    lowDepth = here;
  }
  vec2 rest = side > 0.0 ? vec2(light, max(light, column.light.x + column.light.z)) : vec2(min(light, 0.0), light);
  waterAddPart(rest, isOver || waterIsSky(lowDepth), lowAlong, lowAlong, lowAside, column);
}

// The column of a pixel's rays, and the light that all its slopes reflect.
//
// slopes  waterFacetSlopes
WaterColumn waterColumnOf(WaterPoint point, vec2 azimuth, vec2 slopes)
{
  WaterColumn column;
  column.start = point.start;
  column.eye = vec2(length(point.ray.xy), abs(point.ray.z));
  vec2 side = vec2(-azimuth.y, azimuth.x);
  vec2 own = -vec2(dot(point.normal.xy, azimuth), dot(point.normal.xy, side)) / point.normal.z;
  float perSpread = 1.0 / max(slopes.y, 1e-9);
  column.slopes = vec2(perSpread, -(own.x + slopes.x) * perSpread);
  column.tilt = own.y;
  column.level = waterLevelSlope(point, azimuth, slopes);
  float apart = WATER_COLUMN_HALF * slopes.y;
  vec3 light = vec3(waterFacetReflectance(point, waterFacetNormal(point, azimuth, slopes.x - apart)),
    waterFacetReflectance(point, waterFacetNormal(point, azimuth, slopes.x)),
    waterFacetReflectance(point, waterFacetNormal(point, azimuth, slopes.x + apart)));
  column.light = vec3(light.y, 0.5 / WATER_COLUMN_HALF * (light.z - light.x), (light.x + light.z - 2.0 * light.y) / 6.0);
  vec4 ahead = waterHalfEnd(vec3(azimuth, 0.0));
  vec4 upwards = waterHalfEnd(vec3(0.0, 0.0, 1.0));
  vec4 aside = waterHalfEnd(vec3(side, 0.0));
  vec3 centre = 2.0 * point.start - 1.0;
  vec3 aheadLine = ahead.xyz - centre * ahead.w;
  vec3 upLine = upwards.xyz - centre * upwards.w;
  bool isUp = dot(upLine.xy, upLine.xy) > dot(aheadLine.xy, aheadLine.xy);
  column.along = normalize(isUp ? upLine.xy : aheadLine.xy);
  column.gains = vec4(dot(aheadLine.xy, column.along), aheadLine.z, dot(upLine.xy, column.along), upLine.z);
  float turn = column.gains.x * column.gains.w - column.gains.y * column.gains.z;
  column.gains *= sign(turn);
  column.top = vec4(waterTop(), point.startW + 2.0 * waterTop() * upwards.w, 2.0 * ahead.w, sign(turn));
  column.aside = (aside.xy - centre.xy * aside.w) / max(abs(turn), 1e-30);
  column.thirds = vec2(waterLightBelow(column, -WATER_COLUMN_THIRD), waterLightBelow(column, WATER_COLUMN_THIRD));
  column.near = WATER_UNMET;
  column.sum = vec3(0.0);
  column.sky = vec3(0.0);
  return column;
}

// The ray of a slope, in spreads.
vec3 waterColumnRay(WaterPoint point, vec2 azimuth, vec2 slopes, float slope)
{
  vec3 dir = reflect(point.ray, waterFacetNormal(point, azimuth, slopes.x + slope * slopes.y));
  return vec3(dir.xy, max(dir.z, 1e-6));
}

// The light of all slopes, through a layer of translucent things.
vec3 waterThroughLayer(WaterPoint point, vec2 azimuth, vec2 slopes, WaterColumn column, float reflectance)
{
  vec3 mean = column.sum / max(reflectance, 1e-6);
  vec3 through = vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    WaterFacet facet = waterNoFacet();
    facet.color = mean;
    float node = waterFacetNode(i, 3);
    float slope = waterFacetAim(node, column.level, 3);
    waterCrossFacet(point, waterFacetNormal(point, azimuth, slopes.x + (slope - WATER_LAYER_APART) * slopes.y),
      waterFacetNormal(point, azimuth, slopes.x + (slope + WATER_LAYER_APART) * slopes.y), facet);
    float light = column.light.x + node * (column.light.y + node * column.light.z);
    through += waterFacetShare(i, 3) * light * waterFacetColor(facet);
  }
  return through;
}

// What all slopes of a pixel reflect, times their reflectance.
vec3 waterAllSlopesSee(WaterPoint point, vec2 azimuth, float variance, out float reflectance)
{
  vec2 slopes = waterFacetSlopes(point, sqrt(variance));
  waterFloor = point.height;
  waterNearest = -1e30; // not that of another ray
  WaterColumn column = waterColumnOf(point, azimuth, slopes);
  reflectance = column.light.x + column.light.z;
  float depth = waterDepthAlong(column, 0.0);
  column.near = depth;
  float light = waterLightBelow(column, waterInSpreads(column, 0.0));
  float greatest = max(WATER_COLUMN_END, column.level + 0.5);
  WaterRayHit hit = waterAim(point.start, point.startW, waterColumnRay(point, azimuth, slopes, greatest));
  int count = reflectance - light > WATER_COLUMN_LEAST * reflectance ? WATER_COLUMN_UP : 0;
  waterScanColumn(dot(hit.line.xy, column.along), count, 1.0, depth, light, hit.isOver, column);
  float least = max(column.level + 0.15, -WATER_COLUMN_END);
  hit = waterAim(point.start, point.startW, waterColumnRay(point, azimuth, slopes, least));
  count = light > WATER_COLUMN_LEAST * reflectance ? WATER_COLUMN_DOWN : 0;
  waterScanColumn(dot(hit.line.xy, column.along), count, -1.0, depth, light, false, column);
  waterSpread = waterFacetSpread(slopes.y, 3);
  for (int i = 0; i < 3; ++i)
  {
    float slope = waterFacetAim(waterFacetNode(i, 3), column.level, 3);
    column.sum += column.sky[i] * waterSky(waterColumnRay(point, azimuth, slopes, slope));
  }
  return waterThroughLayer(point, azimuth, slopes, column, reflectance);
}

// As in vtkWaterFacetsFS.glsl.
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  vec3 reflected = vec3(0.0);
  if (waterFacetCount(variance, point.ray.z) == 1)
  {
    waterSpread = 0.0;
    reflectance = waterFacetReflectance(point, point.normal);
    reflected = reflectance * waterReflected(point, reason, uv);
  }
  else
  {
    reflected = waterAllSlopesSee(point, azimuth, variance, reflectance);
  }
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
