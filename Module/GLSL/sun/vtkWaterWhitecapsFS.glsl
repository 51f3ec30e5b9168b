// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWhitecapsFS.glsl: slot whitecaps: how much of a pixel of a wind sea is white; water_whitecap.h for the
// shader.

uniform vec2 waterWhitecaps; // the Jacobian to first order under which the sea is white; variance over which it turns so

uniform sampler2DArray waterOldFoam; // vtkWaterOldFoam: three parts of the foam that the first tile's crests have left
uniform vec4 waterOldFoamWeights;    // of these; size of a texel, in tiles

const float WATER_LEAST_WHITE = 1e-4; // of a pixel: what is less is not seen
const float WATER_FOAM_TORN = 8.0;    // m, of the patches that old foam is torn into; their edges have a fifth of it
const float WATER_FOAM_EDGE = 0.1;    // over so much of the patches' noise an edge fades

float waterNoise(vec2 place); // of the slot foam

// Share of a normal distribution below a number.
// Source: Page 1977, "Approximations to the Cumulative Normal Function and its Inverse".
float waterShareBelow(float number)
{
  float x = clamp(number, -6.0, 6.0);
  return 1.0 / (1.0 + exp(-x * (1.5976 + 0.07056 * x * x)));
}

// Foam of a share, which the sea's first tile knows to its points alone, in patches: as large a part of the water is in
// one as of a patch is foam. The patches stay where they are, and shrink while their foam decays.
//
// pixel  m
float waterTorn(float share, vec2 place, float pixel)
{
  float part = sqrt(clamp(share, 1e-6, 0.999));
  // a normal number that is exceeded so often, nearly; of noise with a mean of 0.46 and a deviation of 0.156
  float level = 0.46 + 0.092 * log(part / (1.0 - part));
  float noise = 0.6 * waterNoise(place / WATER_FOAM_TORN) + 0.4 * waterNoise(5.0 * place / WATER_FOAM_TORN);
  float patches = clamp((level - noise) / WATER_FOAM_EDGE + 0.5, 0.0, 1.0);
  return mix(share, part * patches, clamp(1.5 - 4.0 * pixel / WATER_FOAM_TORN, 0.0, 1.0));
}

// Share of a pixel that is foam which crests have left.
float waterFoamLeft(WaterPoint point, vec2 place, float pixel)
{
  vec4 tile = waterSeaTiles[0];
  vec3 middle = vec3(tile.xy + tile.z * waterSeaPlace + 0.5 * waterOldFoamWeights.w, 0.0);
  bool isWide = dot(point.across, point.across) > dot(point.down, point.down);
  vec2 longer = tile.z * (isWide ? point.across : point.down);
  vec2 shorter = tile.z * (isWide ? point.down : point.across);
  vec4 seen = waterTileMean(waterOldFoam, middle, longer, shorter, waterOldFoamWeights.w, WATER_TILE_LOOKS);
  float share = dot(seen.xyz, waterOldFoamWeights.xyz);
  return share > WATER_LEAST_WHITE ? waterTorn(share, place, pixel) : 0.0;
}

// What a pixel does not resolve of the slopes it does not resolve of the Jacobian either: they have the
// same variance.
//
// place  m, of the foam's pattern
// pixel  m
float waterWhitecap(WaterPoint point, vec2 place, float pixel)
{
  float unseen = dot(point.variance, vec4(1.0));
  float share = waterShareBelow((waterWhitecaps.x - waterFirstOrder) * inversesqrt(unseen + waterWhitecaps.y));
  share = max(share, waterFoamLeft(point, place, pixel));
  return share > WATER_LEAST_WHITE ? share : 0.0;
}
