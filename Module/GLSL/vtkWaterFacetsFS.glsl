// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetsFS.glsl: the facets that stand for all slopes within a pixel.
// Needs vtkWaterOptics.glsl, vtkWaterPointFS.glsl, vtkWaterColorFS.glsl and vtkWaterLookupFS.glsl before
// it, or others of the last two's stages.
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
  return length(point.ray.xy) > 1e-6 ? normalize(point.ray.xy) : vec2(1.0, 0.0);
}

// Number of facets: 1, 2, or 4, which see places on the line of two.
int waterFacetCount(WaterPoint point)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  return variance > WATER_ROUGH ? 4 : (variance > WATER_SMOOTH ? 2 : 1);
}

// Mean and spread of the slopes that face the eye, against the pixel's own normal: x, y.
vec2 waterFacetSlopes(WaterPoint point, vec2 azimuth)
{
  float spread = sqrt(dot(point.variance.xy, azimuth * azimuth));
  // in units of the spread: how far the mean facet is from facing away
  float edge = -dot(point.ray, point.normal) /
    (spread * point.normal.z * max(length(point.ray.xy), 1e-6));
  float from = max(edge, -1.0);
  float share = waterNormalShare(from);
  float density = 0.39894228 * exp(-0.5 * from * from);
  float area = from * share + density;
  float mean = share / area;
  float variance = (from * share + 2.0 * density) / area - mean * mean;
  // Steep views see all facets, and on a flat sheet all alike.
  float low = 1.0 - smoothstep(3.0, 6.0, edge);
  float shift = low * (mean + from - edge);
  variance = mix(1.0, variance, low);
  return spread * vec2(shift, sqrt(max(variance, 0.0)));
}

float waterFacetReflectance(WaterPoint point)
{
  return waterReflectance < 0.0
    ? waterFresnel(clamp(-dot(point.ray, point.normal), 0.0, 1.0), waterEta) : waterReflectance;
}

// The reflection of a pixel's facets, each weighted by its own reflectance.
//
// Loops stand where a branch would do: they end early also where both sides of a branch are
// executed, on software renderers, and most pixels have either one facet or several all around.
//
// reflectance  of all
// reason, uv   of the pixel's mean one, which is the only one where these are shown
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  int count = waterShowsMean() ? 1 : waterFacetCount(point);
  vec3 reflected = vec3(0.0);
  reflectance = 0.0;
  for (int i = 0; i < 2 - min(count, 2); ++i)
  {
    reflectance = waterFacetReflectance(point);
    if (waterIsReflecting != 0)
    {
      reflected = reflectance * waterReflected(point, reason, uv);
    }
  }
  int several = count > 1 ? count : 0;
  vec2 azimuth = vec2(0.0);
  vec2 slopes = vec2(0.0);
  for (int i = 0; i < min(several, 1); ++i)
  {
    azimuth = waterAzimuth(point);
    slopes = waterFacetSlopes(point, azimuth);
  }
  WaterPlaces places = WaterPlaces(vec4(0.0), vec2(0.0));
  for (int i = 0; i < min(several, 2); ++i)
  {
    float node = i == 0 ? -1.0 : 1.0;
    float slope = slopes.x + node * slopes.y;
    WaterPoint facet = point;
    facet.normal = normalize(
      vec3(point.normal.xy - point.normal.z * slope * azimuth, point.normal.z));
    float share = 0.5 * waterFacetReflectance(facet);
    reflectance += share;
    if (waterIsReflecting != 0)
    {
      vec3 color;
      vec2 place;
      bool isPlace = waterFacetSees(facet, place, color);
      places.two = i == 0 ? place.xyxy : vec4(places.two.xy, place);
      places.shares = isPlace ? (i == 0 ? vec2(share, 0.0) : vec2(places.shares.x, share))
                              : places.shares;
      reflected += isPlace ? vec3(0.0) : share * color;
    }
  }
  if (waterIsReflecting != 0)
  {
    reflected += waterBlurred(places, several);
  }
  return reflected;
}
