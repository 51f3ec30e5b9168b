// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetsFS.glsl: the facets that stand for all slopes within a pixel.
//
// The slopes are Gaussian about the pixel's mean one, along the azimuth of the view only: at a low
// view a slope across it turns the reflection little. A facet counts by the part of the pixel that
// it covers, nothing when it faces away from the eye. Of the slopes so weighted the mean and the
// variance are exact, and two nodes (Gauss and Hermite's) stand for them, or four for rough water.
// Source: Abramowitz and Stegun 1964, "Handbook of Mathematical Functions", table 25.10.

const float WATER_SMOOTH = 2e-5; // slope variance whose reflection blurs by half a degree
const float WATER_ROUGH = 1e-3;  // and by four

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

// The reflection of a pixel's facets, each weighted by its own reflectance.
//
// One facet goes the way of the first of several: software renderers execute a branch for either, and
// a loop's body once at least. It alone is marched where an estimate and some probes do not converge: of
// several, which are blurred, they find each of them well enough.
//
// reflectance  of all
// reason, uv   of the pixel's mean one, which is the only one where these are shown
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  int count = variance > WATER_ROUGH ? 4 : (variance > WATER_SMOOTH ? 2 : 1);
  count = waterShowsMean() ? 1 : count;
  bool isOne = count == 1;
  vec2 slopes = isOne ? vec2(0.0) : waterFacetSlopes(point, sqrt(variance));
  WaterPlaces places = WaterPlaces(vec4(0.0), vec4(0.0), vec4(0.0));
  WaterRayHit hit;
  vec3 reflected = vec3(0.0);
  float share = 0.0;
  reflectance = 0.0;
  waterReadOnce();
  bool isFresnel = waterReflectance < 0.0;
  float given = max(waterReflectance, 0.0);
  float eta = max(waterEta, 0.0);
  int i = 0;
  do
  {
    // two nodes, or four: the means of the slopes' quarters
    float node = (i & 1) == 0 ? -1.0 : 1.0;
    node *= count == 4 ? (i < 2 ? 0.378 : 1.363) : 1.0;
    float slope = slopes.x + node * slopes.y;
    vec3 normal =
      normalize(vec3(point.normal.xy - point.normal.z * slope * azimuth, point.normal.z));
    float cosine = clamp(-dot(point.ray, normal), 0.0, 1.0);
    share = (isOne ? 1.0 : (count == 4 ? 0.25 : 0.5)) *
      (isFresnel ? waterFresnel(cosine, eta) : given);
    reflectance += share;
    hit = waterEstimateHit(point, normal);
    waterRefineHit(point.start, isOne, hit);
    if (!isOne)
    {
      waterCrossFacet(point, normal, i, hit);
    }
    float atPlace = hit.isPlace ? share : 0.0;
    places.inner = vec4(i == 0 ? hit.uv : places.inner.xy, i == 1 ? hit.uv : places.inner.zw);
    places.outer = vec4(i == 2 ? hit.uv : places.outer.xy, i == 3 ? hit.uv : places.outer.zw);
    places.shares = mix(places.shares, vec4(atPlace), equal(ivec4(i), ivec4(0, 1, 2, 3)));
    reflected += hit.isPlace ? vec3(0.0) : share * hit.color;
    ++i;
  } while (i < count);
  waterMarchRay(point.start, isOne, hit);
  if (isOne)
  {
    waterCross(point, hit);
    places.inner = hit.uv.xyxy;
    places.shares.x = hit.isPlace ? share : 0.0;
    reflected = hit.isPlace ? vec3(0.0) : share * hit.color;
    reason = waterReason(hit);
    uv = hit.uv;
  }
  reflected += waterBlurred(places, count);
  return waterIsReflecting != 0 ? reflected : vec3(0.0);
}
