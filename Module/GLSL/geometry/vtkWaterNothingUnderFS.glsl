// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNothingUnderFS.glsl: slot under of a surface that lies in its plane.

uniform vec4 waterReflectionHeight; // NDC of the reflection texture -> height over the plane / w
uniform vec4 waterReflectionW;      // NDC of the reflection texture -> 1 / w
uniform float waterTexel;           // height that a texel of the reflection texture spans, over its w

bool waterIsUnder(vec2 uv, float depth, float height)
{
  return false; // the mirrored view is cut at the surface
}

uniform vec4 waterWaterline; // what the height over the plane / w gains per texel of the reflection texture; its size

const float WATER_UNDER = 0.02;  // texels, by which a texel's middle is under the water: not rounding
const float WATER_SLOPING = 0.5; // texels, from which on one is certainly over it: surfaces are not all upright

// A place of the reflection texture whose texels all show what is over the water, at most a texel away. It stays where it
// is the middle of such a texel: in calm water.
//
// height  over the plane / w, of what is there
vec2 waterOverWaterline(vec2 uv, float height)
{
  vec2 gain = waterWaterline.xy;
  float one = abs(gain.x) + abs(gain.y);
  vec2 place = uv * waterWaterline.zw;
  vec2 middle = floor(place) + 0.5;
  vec2 off = place - middle;
  float here = height - dot(off, gain);
  vec2 next = here + sign(off) * gain;
  float corner = next.x + next.y - here;
  bool isUnder = here < -WATER_UNDER * one;
  bvec2 isKept = lessThan(next, vec2(WATER_SLOPING * one));
  isKept = bvec2(isKept.x || isUnder, isKept.y || isUnder || corner < WATER_SLOPING * one);
  vec2 up = abs(gain.x) > abs(gain.y) ? vec2(sign(gain.x), 0.0) : vec2(0.0, sign(gain.y));
  return (mix(place, middle, isKept) + (isUnder ? up : vec2(0.0))) / waterWaterline.zw;
}
