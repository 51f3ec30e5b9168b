// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetSlopesFS.glsl: slot facet_slopes: the facets that stand for all slopes within a pixel.
//
// The slopes are Gaussian about the pixel's mean one, along the azimuth of the view only: at a low
// view a slope across it turns the reflection little. A facet counts by the part of the pixel that
// it covers, nothing when it faces away from the eye. Of the slopes so weighted the mean and the
// variance are exact, and two nodes (Gauss and Hermite's) stand for them, or three for rough water. Here is also what makes
// several facets one picture: the edges between what they see.
// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 25.10.

const float WATER_OVER_LEVEL = 0.3; // spreads; rays of rough water's facets are at least that far over a level one
const float WATER_LAYER_APART = 0.55; // spreads, from a facet to its two rays to the translucent layer
const float WATER_ROUGH = 1e-3; // slope variance whose reflection blurs by four degrees
// At a low angle even small slopes change how much is reflected: a pixel has one facet only if they differ by no more than
// 22 % of the sine of the angle at which the eye sees the plane. This is the square.
const float WATER_GRAZING = 0.05;

// Cumulative normal distribution, within 2e-4.
// Source: Page 1977, "Approximations to the Cumulative Normal Function and its Inverse for Use on a
// Pocket Calculator".
float waterNormalShare(float x)
{
  return 1.0 / (1.0 + exp(-x * (1.5957691 + 0.0713548 * x * x)));
}

// Any direction will do for a view straight down.
vec2 waterAzimuth(WaterPoint point)
{
  float across2 = dot(point.ray.xy, point.ray.xy);
  return across2 > 1e-12 ? inversesqrt(across2) * point.ray.xy : vec2(1.0, 0.0);
}

// Mean and spread of the slopes that face the eye, against the pixel's own normal: x, y.
//
// spread  of all slopes
vec2 waterFacetSlopes(WaterPoint point, float spread)
{
  // in units of the spread: how far the mean facet is from facing away
  float edge = -dot(point.ray, point.normal) /
    (spread * point.normal.z * max(length(point.ray.xy), 1e-6));
  float from = max(edge, -1.0);
  float share = waterNormalShare(from);
  float density = 0.39894228 * exp(-0.5 * from * from);
  float perArea = 1.0 / (from * share + density);
  float mean = share * perArea;
  float variance = (from * share + 2.0 * density) * perArea - mean * mean;
  // Steep views see all facets, and on a flat sheet all alike.
  float low = 1.0 - smoothstep(3.0, 6.0, edge);
  float shift = low * (mean + from - edge);
  variance = mix(1.0, variance, low);
  return spread * vec2(shift, sqrt(max(variance, 0.0)));
}

// Number of facets that represent slopes of this variance.
//
// sine  of the angle at which the eye sees the plane
int waterFacetCount(float variance, float sine)
{
  float mostOfOne = min(waterSmooth, WATER_GRAZING * sine * sine);
  int count = variance > WATER_ROUGH ? 3 : (variance > mostOfOne ? 2 : 1);
  return waterShowsMean() ? 1 : count;
}

// The slope of one of several facets, from the least to the greatest, in spreads: Gauss and Hermite's nodes.
float waterFacetNode(int i, int count)
{
  return count == 3 ? 1.7320508 * float(i) - 1.7320508 : 2.0 * float(i) - 1.0;
}

// The share of all slopes that are less than those of a facet, where it sees the same object as the facet before it.
float waterFacetBegins(int i, int count)
{
  return count == 3 ? max(0.6666667 * float(i) - 0.5, 0.0) : 0.5 * float(i);
}

// The share of all slopes that a facet stands for, where all see the same object.
float waterFacetShare(int i, int count)
{
  return (i + 1 < count ? waterFacetBegins(i + 1, count) : 1.0) - waterFacetBegins(i, count);
}

// The share of all slopes that are less than one between two facets. Between only two it goes from 0 to 1, and its mean up
// to 0 is that of a Gaussian: an edge that passes one of them would be seen as a line otherwise.
//
// level  slope whose ray is level: lesser ones meet the water again, which reflects them up, as the greater ones at the same
//        distance
float waterSlopeShare(float slope, float level, int count)
{
  float square = slope * slope;
  return count == 2 ? 0.5 + 0.5 * sign(slope) * square * square
                    : waterNormalShare(slope) - waterNormalShare(2.0 * level - slope);
}

// The slope whose ray is level, in spreads against the mean one: -tan(half the angle at which the eye sees the plane).
float waterLevelSlope(WaterPoint point, vec2 azimuth, vec2 slopes)
{
  float level = dot(point.normal.xy, azimuth) / point.normal.z - abs(point.ray.z) / (1.0 + length(point.ray.xy));
  return (level - slopes.x) / max(slopes.y, 1e-9);
}

// The slope that the ray of a facet has: those of rough water see what is over the water.
float waterFacetAim(float node, float level, int count)
{
  return count > 2 ? max(node, level + WATER_OVER_LEVEL) : node;
}

// The share of the light that a facet reflects.
float waterFacetReflectance(WaterPoint point, vec3 normal)
{
  float cosine = waterFacing(point.ray, normal);
  return waterReflectance < 0.0 ? waterFresnel(cosine, max(waterEta, 0.0)) : waterReflectance;
}

// Finds where two neighbours, of which one sees something nearer than the other, change from one to the other:
// the edge of the nearer. Without, the edges would be seen once per facet. A facet whose ray would meet the nearer
// object has missed it, and sees it, too; its edge to the facet before it stays. waterNearest is the ray's of the facet with
// the greater slope, and not greater than the other's.
void waterFindBorder(vec3 start, int i, int count, float level, inout WaterFacet last, inout WaterFacet seen)
{
  float depth = min(last.depth, seen.depth);
  float depthOn = depth + waterSameWithin(depth);
  bool isLast = last.depth <= seen.depth; // the nearer
  vec2 lastWay = waterRayAt(start, seen, last.depth) - last.uv;
  vec2 seenWay = waterRayAt(start, last, seen.depth) - seen.uv;
  vec2 on = isLast ? last.uv : seen.uv;
  vec2 way = isLast ? lastWay : seenWay;
  bool isBorder = i > 0 && depth < 1.0 && max(last.depth, seen.depth) > depthOn;
  float part = waterEdgeBetween(on, way, depthOn, isBorder);
  bool isMissed = isBorder && part >= 1.0;
  isBorder = isBorder && part < 1.0;
  float slope = mix(last.slope, seen.slope, isLast ? part : 1.0 - part);
  // slopes that change sides keep their reflectance
  float moved = isBorder ? waterSlopeShare(slope, level, count) - waterFacetBegins(i, count) : 0.0;
  float lit = clamp(moved * (moved > 0.0 ? seen.light : last.light), -last.weight, seen.weight);
  last.weight += lit;
  seen.weight -= lit;
  bool isSeenMissed = isMissed && isLast;
  bool isLastMissed = isMissed && !isLast;
  seen.uv = isSeenMissed ? on + way : seen.uv;
  seen.depth = isSeenMissed ? depth : seen.depth;
  seen.isPlace = seen.isPlace || isSeenMissed;
  last.uv = isLastMissed ? on + way : last.uv;
  last.depth = isLastMissed ? depth : last.depth;
  last.isPlace = last.isPlace || isLastMissed;
  // blurred as far as the next one, but not over the edge
  float lastApart = (isBorder && isLast ? part : 1.0) * length(waterReflectionPx() * (isLastMissed ? way : lastWay));
  last.apart = i > 1 ? 0.5 * (last.apart + lastApart) : lastApart;
  seen.apart = i > 0 ? (isBorder && !isLast ? part : 1.0) * length(waterReflectionPx() * (isSeenMissed ? way : seenWay)) : 0.0;
}

// How wide a part of the sky each of several facets stands for, radians: a share of the way to the next one. A slope turns a
// ray by twice its angle.
//
// spread  of the slopes
float waterFacetSpread(float spread, int count)
{
  return 0.6 * (count == 3 ? 1.7 : 2.0) * spread * 2.0;
}

// slope  against the pixel's own, along the azimuth
vec3 waterFacetNormal(WaterPoint point, vec2 azimuth, float slope)
{
  return normalize(vec3(point.normal.xy - point.normal.z * slope * azimuth, point.normal.z));
}
