// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOthersFS.glsl: slot others of a multisampled picture: a pixel at an edge has several rays. A file of its own:
// software renderers execute what stands in a branch or a loop once at least.

const float WATER_MEDIUM_CONTRAST = 0.12; // of what lies on both sides of an edge

uniform vec2 waterSamplePlaces[32]; // from the pixel's middle, pixels

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

// Color of what lies beyond a point of the surface, and the light that the water adds. In a multisampled picture a pixel
// at an edge has several rays: one through each sample in which the surface is seen. One ray would show stairs, and rays
// through the other samples would show what an object in front of the surface hides.
vec3 waterTransmitted(WaterPoint point)
{
  WaterPointChange across = waterChangeAcross(point);
  WaterPointChange down = waterChangeDown(point);
  int samples = waterSeenSamples();
  vec3 sum = vec3(0.0);
  float count = 0.0;
  int last = 0;
  int ray = 0; // 0: the pixel's point, otherwise through the sample before
  do
  {
    bool isFirst = ray == 0;
    vec2 place = isFirst ? vec2(0.0) : waterSamplePlaces[max(ray - 1, 0)] - point.moved;
    vec3 seen = waterTransmittedRay(waterMovedPoint(point, place, across, down));
    vec3 change = isFirst ? max(abs(dFdx(seen)), abs(dFdy(seen))) : vec3(0.0);
    bool isEdge = max(change.r, max(change.g, change.b)) > WATER_MEDIUM_CONTRAST || waterMediumIsColorful();
    last = isFirst && isEdge && samples != 0 ? waterSceneSamples : last;
    bool isPart = !isFirst || last == 0;
    sum += isPart ? seen : vec3(0.0);
    count += isPart ? 1.0 : 0.0;
    ++ray;
    while (ray <= last && ((samples >> (ray - 1)) & 1) == 0)
    {
      ++ray;
    }
  } while (ray <= last);
  return sum / count;
}
