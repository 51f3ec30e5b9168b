// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOthersFS.glsl: slot others of a multisampled picture: a pixel at an edge has several rays. A file of its own:
// software renderers execute what stands in a branch or a loop once at least.

const float WATER_MEDIUM_CONTRAST = 0.12; // of what lies on both sides of an edge
const int WATER_MEDIUM_FEWEST = 4; // rays of a pixel at an edge

// Does the picture have several colours around the place where the pixel's first ray has ended? Edges of depth without
// any need no other rays, and most rays that are near one.
bool waterMediumIsColorful()
{
  vec2 aside = 0.5 * waterSceneScale * waterViewport.zw;
  vec3 first = textureLod(waterSceneColor, waterMediumEnd - aside, 0.0).rgb;
  vec3 second = textureLod(waterSceneColor, waterMediumEnd + aside, 0.0).rgb;
  vec3 third = textureLod(waterSceneColor, waterMediumEnd + vec2(aside.x, -aside.y), 0.0).rgb;
  vec3 fourth = textureLod(waterSceneColor, waterMediumEnd + vec2(-aside.x, aside.y), 0.0).rgb;
  vec3 apart = max(max(first, second), max(third, fourth)) - min(min(first, second), min(third, fourth));
  return max(apart.r, max(apart.g, apart.b)) > WATER_MEDIUM_CONTRAST;
}

// Place of a ray in its pixel, from the middle: the first is there. Of the others no two are in one row or column: four are
// a turned square on its corner, more a lattice of rank one.
vec2 waterMediumRayPlace(int ray, int rays)
{
  vec2 corner = ray < 3 ? vec2(0.125, 0.375) : vec2(-0.125, -0.375);
  corner = (ray & 1) == 0 ? vec2(corner.y, -corner.x) : corner;
  float number = float(ray) - 0.5;
  vec2 lattice = vec2(number / float(rays), fract(0.618034 * number)) - 0.5;
  return ray == 0 ? vec2(0.0) : (rays > WATER_MEDIUM_FEWEST ? lattice : corner);
}

// Color of what lies beyond a point of the surface, and the light that the water adds. Of a multisampled picture a pixel
// at an edge has several rays, one for each sample: one ray shows stairs there.
vec3 waterTransmitted(WaterPoint point)
{
  WaterPointChange across = waterChangeAcross(point);
  WaterPointChange down = waterChangeDown(point);
  int rays = max(WATER_MEDIUM_FEWEST, waterSceneSide * waterSceneSide);
  vec3 sum = vec3(0.0);
  int last = 0;
  int ray = 0;
  do
  {
    vec3 seen = waterTransmittedRay(waterMovedPoint(point, waterMediumRayPlace(ray, rays), across, down));
    bool isFirst = ray == 0;
    vec3 change = isFirst ? max(abs(dFdx(seen)), abs(dFdy(seen))) : vec3(0.0);
    bool isEdge = max(change.r, max(change.g, change.b)) > WATER_MEDIUM_CONTRAST || waterMediumIsColorful();
    last = isFirst && isEdge ? rays * waterSceneHasSamples : last;
    sum += isFirst && last > 0 ? vec3(0.0) : seen;
    ++ray;
  } while (ray <= last);
  return sum / float(max(last, 1));
}
