// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFacetsFS.glsl: the facets that stand for all slopes within a pixel.
// Needs vtkWaterPointFS.glsl before it.
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

// Number of facets: as a bound of a loop, which ends early also where branches do not save.
int waterFacetCount(WaterPoint point)
{
  vec2 azimuth = waterAzimuth(point);
  float variance = dot(point.variance.xy, azimuth * azimuth);
  return variance > WATER_ROUGH ? 4 : (variance > WATER_SMOOTH ? 2 : 1);
}

// Normal of a facet.
//
// weight  they add up to 1
vec3 waterFacet(WaterPoint point, int number, int count, out float weight)
{
  weight = 1.0;
  if (count == 1)
  {
    return point.normal;
  }
  vec2 azimuth = waterAzimuth(point);
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
  float node = float(number & 1) * 2.0 - 1.0;
  node *= count == 2 ? 1.0 : (number < 2 ? 0.378 : 1.363); // 4: quarters of the slopes
  float slope = spread * (shift + node * sqrt(max(variance, 0.0)));
  weight = 1.0 / float(count);
  return normalize(vec3(point.normal.xy - point.normal.z * slope * azimuth, point.normal.z));
}
