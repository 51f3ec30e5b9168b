// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetSlopesFS.glsl: slot facet_slopes: the facets that stand for all slopes within a pixel.
//
// The slopes are Gaussian about the pixel's mean one, along the azimuth of the view only: at a low
// view a slope across it turns the reflection little. A facet counts by the part of the pixel that
// it covers, nothing when it faces away from the eye. Of the slopes so weighted the mean and the
// variance are exact, and two nodes (Gauss and Hermite's) stand for them, or four for rough water.
// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 25.10.

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
  int count = variance > WATER_ROUGH ? 4 : (variance > mostOfOne ? 2 : 1);
  return waterShowsMean() ? 1 : count;
}

// The place of one of several facets among its slopes: two nodes, or four: the means of the slopes' quarters.
float waterFacetNode(int i, int count)
{
  float node = (i & 1) == 0 ? -1.0 : 1.0;
  return node * (count == 4 ? (i < 2 ? 0.378 : 1.363) : 1.0);
}

// Where the ray of one of several facets goes among its slopes. One of several rays of a pixel has its own: of eight or
// sixteen parts of all slopes four rays have different ones. What only the steepest slopes show is lost between nodes.
//
// ray  of the pixel; 0: the only one
float waterFacetAim(int i, int count, int ray)
{
  int part = (ray + (i < 2 ? 0 : 2)) & 3;
  part = (i & 1) == 0 ? part : 3 - part;
  vec4 inner = count == 4 ? vec4(0.078, 0.237, 0.403, 0.580) : vec4(0.158, 0.491, 0.892, 1.647);
  vec4 means = i < 2 ? inner : vec4(0.777, 1.013, 1.325, 1.968);
  float aim = ((i & 1) == 0 ? -1.0 : 1.0) * dot(means, vec4(equal(ivec4(part), ivec4(0, 1, 2, 3))));
  return ray > 0 ? aim : waterFacetNode(i, count);
}

// How wide a part of the sky each of several facets stands for, radians: a slope turns a ray by twice its angle. The share
// of their distance is that of waterBlurred, of a way to both sides.
//
// spread  of the slopes
float waterFacetSpread(float spread, int count)
{
  return 0.6 * (count == 4 ? 0.9 : 2.0) * spread * 2.0;
}

// slope  against the pixel's own, along the azimuth
vec3 waterFacetNormal(WaterPoint point, vec2 azimuth, float slope)
{
  return normalize(vec3(point.normal.xy - point.normal.z * slope * azimuth, point.normal.z));
}
