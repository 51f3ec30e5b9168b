// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPictureShadowsFS.glsl: slot casters: what keeps the sun off and is seen in the picture. The mirrored view does
// not show the sides that face the eye from above, the picture does. A water's own view shows nothing over the water.

uniform sampler2D waterPictureDepth; // of the picture, whatever is seen through the water

const int WATER_CASTER_STEPS = 128;      // of a ray to the border of the picture
const float WATER_CASTER_PX = 2.0;       // shortest step
const float WATER_CASTER_SLACK = 0.003;  // of a surface's depth, over its distance

// How far a ray is in front of the picture, a window depth.
float waterCasterGap(vec3 start, vec3 way, float s)
{
  return textureLod(waterPictureDepth, start.xy + s * way.xy, 0.0).r - (start.z + s * way.z);
}

// Does the ray go through a surface between two places a texel apart? Then its slope there is that of the surface beside.
bool waterCasterIsMet(vec3 start, vec3 way, float texel, float low, float gapLow, float gapHigh, float slack)
{
  float slopeLow = gapLow - waterCasterGap(start, way, low - texel);
  float slopeHigh = waterCasterGap(start, way, low + 2.0 * texel) - gapHigh;
  float change = gapHigh - gapLow;
  return low > 2.0 * texel && (abs(change - slopeLow) <= 0.5 * abs(slopeLow) + slack ||
    abs(change - slopeHigh) <= 0.5 * abs(slopeHigh) + slack);
}

// How much of the light from a direction is kept off by what the picture shows: what the ray goes through, from either
// side. Of what it only passes behind nothing is known.
//
// isWanted  or else nothing that comes of it is used
float waterPictureShaded(WaterPoint point, vec3 dir, bool isWanted)
{
  vec3 start = vec3(0.5 + 0.5 * point.ndc, waterWindowDepth(point.ndc, point.moved));
  vec4 end = waterDirToEye * vec4(dir, 0.0);
  vec3 way = 0.5 * (end.xyz - (2.0 * start - 1.0) * end.w);
  float last = waterMediumLeaves(start, way);
  last = end.w > 0.0 ? min(last, 1.0 / end.w) : last;
  last = way.z < 0.0 ? min(last, -start.z / way.z) : last;
  vec2 wayPx = abs(way.xy * floor(1.0 / waterViewport.zw + 0.5));
  float texel = 1.0 / max(max(wayPx.x, wayPx.y), 1e-6);
  float stride = max(WATER_CASTER_PX * texel, last / float(WATER_CASTER_STEPS));
  last = isWanted ? last - stride : 0.0;
  vec4 ahead = waterDirToEye * vec4(point.ray, 0.0);
  float farthest = ahead.w > 1e-6 ? 0.5 + 0.5 * ahead.z / ahead.w : 1.0;
  float s = 0.0;
  float gap = waterCasterGap(start, way, 0.0);
  bool isMet = false;
  while (s < last && !isMet)
  {
    float next = s + stride;
    float gapNext = waterCasterGap(start, way, next);
    if ((gap < 0.0) != (gapNext < 0.0))
    {
      float low = s;
      float high = next;
      float gapLow = gap;
      float gapHigh = gapNext;
      while (high - low > 1.01 * texel)
      {
        float middle = 0.5 * (low + high);
        float gapMiddle = waterCasterGap(start, way, middle);
        bool isLow = (gapMiddle < 0.0) == (gapLow < 0.0);
        low = isLow ? middle : low;
        gapLow = isLow ? gapMiddle : gapLow;
        high = isLow ? high : middle;
        gapHigh = isLow ? gapHigh : gapMiddle;
      }
      isMet = waterCasterIsMet(start, way, texel, low, gapLow, gapHigh,
        WATER_CASTER_SLACK * max(farthest - start.z - low * way.z, 0.0));
    }
    s = next;
    gap = gapNext;
  }
  return isMet ? 1.0 : 0.0;
}
