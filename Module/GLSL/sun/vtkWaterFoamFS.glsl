// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFoamFS.glsl: slot foam: at the shore and on crests, as a lace of bubbles.

uniform vec3 waterFoamColor;
uniform vec3 waterFoamSky; // share of it that all light but the sun's shows; water_daylight_foam
uniform float waterFoamDepth;    // depth of water over which the shore's foam ends; 0: none
uniform float waterFoamJacobian; // crests are foam where their points are closer than this; 0: no foam
uniform vec2 waterPatternOrigin; // of the foam's pattern, m, from the point under the eye
uniform float waterFoamUnit;     // m per unit of the scene
uniform float waterFoamTurn;     // share of the time after which the foam is as it was

const float WATER_FOAM_CELL = 0.8;   // m, of the larger bubbles; the smaller have a quarter of it
const float WATER_FOAM_PATCH = 4.0;  // m, of patches with more and with less of it
const float WATER_FOAM_SOFT = 0.08;  // over so much of the lace's values a thread fades
const int WATER_FOAM_LOOKS = 4;      // at the foam of a pixel
const float WATER_FOAM_PERIOD = 256.0; // cells, after which the pattern repeats

// A number in [0, 1] for a cell of a grid.
float waterHash(vec2 cell)
{
  vec2 p = fract(cell * vec2(0.1031, 0.1030));
  p += dot(p, p.yx + 33.33);
  return fract((p.x + p.y) * p.x * p.y * 8.0 + p.x);
}

float waterNoise(vec2 place)
{
  vec2 cell = floor(place);
  vec2 t = place - cell;
  t = t * t * (3.0 - 2.0 * t);
  cell = mod(cell, WATER_FOAM_PERIOD);
  vec2 next = mod(cell + 1.0, WATER_FOAM_PERIOD);
  return mix(mix(waterHash(cell), waterHash(vec2(next.x, cell.y)), t.x),
    mix(waterHash(vec2(cell.x, next.y)), waterHash(next), t.x), t.y);
}

// How much farther the second nearest of points is than the nearest. The points are scattered one to a cell, and go round
// in it.
float waterBubbles(vec2 place)
{
  vec2 middle = floor(place);
  vec2 nearest = vec2(8.0); // squares of the distances
  for (int i = 0; i < 9; ++i)
  {
    vec2 cell = middle + vec2(float(i % 3 - 1), float(i / 3 - 1));
    vec2 same = mod(cell, WATER_FOAM_PERIOD);
    vec2 turn = vec2(waterHash(same), waterHash(same.yx + 57.0));
    vec2 off = cell + 0.5 + 0.38 * sin(6.2831853 * (turn + waterFoamTurn * vec2(1.0, -1.0))) - place;
    float square = dot(off, off);
    nearest = square < nearest.x ? vec2(square, nearest.x) : vec2(nearest.x, min(nearest.y, square));
  }
  return sqrt(nearest.y) - sqrt(nearest.x);
}

// The mean of the shore's foam over a pixel, which may be many times as wide as all of it: what lies in the middle of such
// a pixel is foam or not, and a shore would be a row of white dots.
//
// depth   of the water, over the depth at which the foam ends
// change  of that over the pixel
float waterShoreFoamSeen(float depth, float change)
{
  float wide = max(change, 1e-3);
  // the last pixel of the water has the foam of the first of the land, too
  float start = depth < wide ? 0.0 : depth - 0.5 * wide;
  float end = depth + 0.5 * wide;
  float foamy = max(min(end, 1.0) - start, 0.0);
  float cover = 0.0;
  int looks = foamy > 0.0 ? WATER_FOAM_LOOKS : 0; // no branch: software renderers execute both sides
  for (int i = 0; i < looks; ++i)
  {
    float part = (float(i) + 0.5) / float(WATER_FOAM_LOOKS);
    cover += waterShoreFoam(start + part * foamy, waterFoamTurn);
  }
  // of the pixel, or where all of the water in it is foam of that: towards the land nothing is darker
  float whole = end < wide ? mix(end, wide, clamp(end - 1.0, 0.0, 1.0)) : wide;
  return min(cover / float(WATER_FOAM_LOOKS) * foamy / whole, 1.0);
}

// How much of the water foam covers there, its bubbles aside.
float waterFoamCover(WaterPoint point, vec2 place, float pixel)
{
  float cover = 0.0;
  if (waterFoamDepth > 0.0)
  {
    float perDepth = (0.85 + 0.3 * waterNoise(place / WATER_FOAM_PATCH)) / waterFoamDepth;
    cover = waterShoreFoamSeen(
      perDepth * waterTransmittedDepth(point), perDepth * waterTransmittedChange(point));
  }
  if (waterFoamJacobian > 0.0)
  {
    cover = max(cover, clamp(2.0 - 2.0 * point.jacobian / waterFoamJacobian, 0.0, 1.0));
  }
  return waterWithFoamData(max(cover, waterWhitecap(point, place, pixel)));
}

// How much of a pixel is foam, in [0, 1].
float waterFoamShare(WaterPoint point)
{
  vec2 place = waterFoamUnit * point.place + waterPatternOrigin;
  float pixel = waterFoamUnit * max(length(point.across), length(point.down));
  float cover = waterFoamCover(point, place, pixel);
  if (cover <= 0.0)
  {
    return 0.0;
  }
  float resolved = clamp(1.5 - 2.0 * pixel / WATER_FOAM_CELL, 0.0, 1.0); // else the pixel's mean, which is the cover
  if (resolved <= 0.0)
  {
    return cover;
  }
  float lace = 0.65 * waterBubbles(place / WATER_FOAM_CELL) + 0.35 * waterBubbles(4.0 * place / WATER_FOAM_CELL);
  float threshold = waterFoamThreshold(cover);
  float soft = min(WATER_FOAM_SOFT + pixel / WATER_FOAM_CELL, threshold + 1e-3); // no thread is wider than its middle
  return mix(cover, smoothstep(-soft, soft, threshold - lace), resolved);
}

// The colour of foam.
//
// sun  light of the sun that arrives
vec3 waterFoamLit(WaterPoint point, vec3 sun)
{
  return waterFoamColor * (waterFoamSky + 0.65 * sun * clamp(dot(point.normal, waterSunDir) * waterSide, 0.0, 1.0));
}
