// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaFoldsFS.glsl: slot waves of a wind sea whose points move in the plane, towards the crests.

uniform vec2 waterSeaChop; // factor of that motion in the slopes (0 on a flat sheet), and in the jacobian

const float WATER_LEAST_AREA = 0.1; // water_waves_least_area

// Derivatives of that motion, xx, xy, yy: the mean over a pixel.
vec3 waterSeaBend(sampler2DArray sea, vec3 middle, vec2 across, vec2 down, float texel, int looks)
{
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = isWide ? across : down;
  vec2 shorter = isWide ? down : across;
  vec3 other = vec3(0.0, 0.0, float(waterSeaCount)); // its layer
  return waterTileMean(sea, middle + other, longer, shorter, texel, looks).xzy;
}

float waterFirstOrder = 1.0; // of the sea's Jacobian, at the last place

float waterArea(vec3 bent)
{
  return bent.x * bent.z - bent.y * bent.y;
}

// The slope of all waves over a place.
//
// sines     of sines and Gerstner waves alone
// sea       of the sea, by the point at rest
// bent      of the sea, d place / d rest less 1
// jacobian  of the former; then of all
vec2 waterFolded(vec2 sines, vec2 sea, vec3 bent, inout float jacobian)
{
  waterFirstOrder = 1.0 + bent.x + bent.z;
  jacobian = waterArea(waterBent + waterSeaChop.y * bent);
  if (waterSeaChop.x < 0.0)
  {
    return sines + sea; // a flat sheet
  }
  vec3 all = waterBent + waterSeaChop.x * bent;
  vec2 gradient = waterGradient + sea;
  return vec2(all.z * gradient.x - all.y * gradient.y, all.x * gradient.y - all.y * gradient.x) /
    max(waterArea(all), WATER_LEAST_AREA);
}
