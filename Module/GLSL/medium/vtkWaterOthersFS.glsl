// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOthersFS.glsl: slot others of a multisampled picture: what a pixel shows beside the thing with most of its
// samples. A file of its own: software renderers execute what stands in a branch or a loop once at least.

uniform sampler2D waterSceneOther; // of sorted samples: colour of the other thing, and its share of the pixel; nearest

const float WATER_MEDIUM_BEGUN_PX = 1.5;
const int WATER_MEDIUM_RAYS = 4; // of a pixel at an edge

// Mixes what is seen at a place with what else is in its pixel, both through the water. What stands before that hides what
// the ray goes behind, and is not met, unless the ray has only begun.
//
// others  1: there may be others; 2: the same, and the bed goes on instead of the background
// begun   how far the ray has come in the picture, pixels
// dir     of the ray, in the plane's axes
vec3 waterMediumWithOther(vec2 uv, float depth, int others, float begun, vec3 seen, vec3 dir, float caustic)
{
  if (others != 0)
  {
    vec4 other = textureLod(waterSceneOther, uv, 0.0);
    float depthOther = textureLod(waterSceneOtherPlace, uv, 0.0).r;
    float way = max(waterMediumHeight(uv, depthOther) / dir.z, 0.0);
    vec3 color = depthOther >= 1.0 ? waterDeepColor : waterAfter(caustic * other.rgb, way);
    bool isMet = (depthOther > depth || begun < WATER_MEDIUM_BEGUN_PX) && (others == 1 || depthOther < 1.0);
    seen = mix(seen, color, isMet ? other.a : 0.0);
  }
  return seen;
}

// Place of a ray in its pixel, from the middle: the first is there, the others are a square on its corner, turned so that no
// two are in one row or column.
vec2 waterMediumRayPlace(int ray)
{
  vec2 corner = ray < 3 ? vec2(0.125, 0.375) : vec2(-0.125, -0.375);
  corner = (ray & 1) == 0 ? vec2(corner.y, -corner.x) : corner;
  return ray == 0 ? vec2(0.0) : corner;
}

// Color of what lies beyond a point of the surface, and the light that the water adds. Of a multisampled picture a pixel
// at an edge has several rays: one shows stairs there.
vec3 waterTransmitted(WaterPoint point)
{
  WaterPointChange across = waterChangeAcross(point);
  WaterPointChange down = waterChangeDown(point);
  vec3 sum = vec3(0.0);
  int last = 0;
  int ray = 0;
  do
  {
    vec3 seen = waterTransmittedRay(waterMovedPoint(point, waterMediumRayPlace(ray), across, down));
    bool isFirst = ray == 0;
    last = isFirst && waterMediumIsEdge ? WATER_MEDIUM_RAYS * waterSceneIsSorted : last;
    sum += isFirst && last > 0 ? vec3(0.0) : seen;
    ++ray;
  } while (ray <= last);
  return sum / float(max(last, 1));
}
