// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferPixelFS.glsl: slot pixel of a user's mesh whose surface is in a buffer. Derivatives of where it is are those
// of the plane that touches it: neighbours may show another part of the surface, or none.

in vec2 texCoord;
uniform sampler2D waterBuffer;     // texels as vtkWaterTangent.glsl has them
uniform sampler2D waterBufferData; // waterDataColor
uniform int waterBufferHasData;
uniform int waterBufferIsSloped;   // 0: a pixel's place follows from the pixel alone

#include "vtkWaterTangent.glsl"

const float WATER_BUFFER_ALIKE = 0.25; // of how much 1 / w changes to the next pixel: so far off, it is of another surface
const float WATER_BUFFER_EVEN = 0.01;  // of slope: the same

vec2 waterBufferNdc(vec2 moved)
{
  return 2.0 * (gl_FragCoord.xy + moved - waterViewport.xy) * waterViewport.zw - 1.0;
}

// View ray of length 1 along w.
vec3 waterBufferRay(vec2 ndc)
{
  vec3 dir = waterNdcToRay * vec3(ndc, 1.0);
  return dir / (waterDirToEye * vec4(dir, 0.0)).w;
}

vec2 waterBufferPlace(vec2 ndc, float perW)
{
  vec3 seen = waterNdcToPlane * vec3(ndc, 1.0);
  return waterBufferIsSloped != 0 ? waterBufferRay(ndc).xy / perW : seen.xy / seen.z;
}

float waterBufferDepth(vec2 ndc, float perW)
{
  return 0.5 + 0.5 * dot(waterPixelDepth, vec4(ndc, 1.0, perW));
}

// The texel so many pixels beside this one.
vec4 waterBufferBeside(vec2 moved)
{
  return waterTangentTexel(waterBuffered, waterBufferRay(waterBufferNdc(vec2(0.0))), waterBufferRay(waterBufferNdc(moved)));
}

void waterReadBuffer()
{
  ivec2 pixel = ivec2(waterViewport.xy + texCoord / waterViewport.zw);
  vec4 texel = texelFetch(waterBuffer, pixel, 0);
  waterBuffered = texel.w > 0.0 ? texel : waterBuffered;
  waterBufferedPlace = waterBufferPlace(waterBufferNdc(vec2(0.0)), waterBuffered.w);
  waterDataColor = waterBufferHasData != 0 ? texelFetch(waterBufferData, pixel, 0) : vec4(0.0);
}

float waterPerW()
{
  return waterBuffered.w;
}

float waterDepthHere()
{
  return waterBufferDepth(waterBufferNdc(vec2(0.0)), waterBuffered.w);
}

vec2 waterDepthSlope()
{
  vec2 side = waterTangentSide();
  vec2 x = vec2(side.x, 0.0);
  vec2 y = vec2(0.0, side.y);
  return side * (vec2(waterBufferDepth(waterBufferNdc(x), waterBufferBeside(x).w),
                   waterBufferDepth(waterBufferNdc(y), waterBufferBeside(y).w)) - waterDepthHere());
}

void waterPlaceSlope(vec2 middle, out vec2 across, out vec2 down)
{
  vec2 side = waterTangentSide();
  vec2 x = vec2(side.x, 0.0);
  vec2 y = vec2(0.0, side.y);
  across = side.x * (waterBufferPlace(waterBufferNdc(x), waterBufferBeside(x).w) - middle);
  down = side.y * (waterBufferPlace(waterBufferNdc(y), waterBufferBeside(y).w) - middle);
}

// Of what the neighbour has, if it is of the same surface; else of what it would be there.
//
// taken   the derivative
// beside  where the neighbour is, pixels
// change  of the texel to the neighbour
WaterPointChange waterBufferChange(WaterPoint point, WaterPointChange taken, vec2 beside, vec4 change)
{
  vec4 texel = waterBufferBeside(beside);
  float off = abs(waterBuffered.w + change.w - texel.w);
  bool isAlike = off <= WATER_BUFFER_ALIKE * abs(texel.w - waterBuffered.w) + 1e-3 * texel.w &&
    length(change.yz) <= WATER_BUFFER_EVEN;
  WaterPoint other = point;
  other.ndc += 2.0 * beside * waterViewport.zw;
  other.ray = normalize(waterNdcToRay * vec3(other.ndc, 1.0));
  vec4 clip = vec4(other.ndc, 2.0 * waterBufferDepth(other.ndc, texel.w) - 1.0, 1.0);
  waterStart(other, clip, texel.x * texel.w, texel.w);
  float side = beside.x + beside.y;
  WaterPointChange made = WaterPointChange(side * (other.start - point.start), side * (other.startW - point.startW),
    side * (other.ray - point.ray), vec3(0.0));
  if (isAlike)
  {
    made = taken;
  }
  return made;
}

WaterPointChange waterChangeAcross(WaterPoint point)
{
  WaterPointChange taken =
    WaterPointChange(dFdx(point.start), dFdx(point.startW), dFdx(point.ray), dFdx(point.normal));
  float side = waterTangentSide().x;
  return waterBufferChange(point, taken, vec2(side, 0.0), side * dFdx(waterBuffered));
}

WaterPointChange waterChangeDown(WaterPoint point)
{
  WaterPointChange taken =
    WaterPointChange(dFdy(point.start), dFdy(point.startW), dFdy(point.ray), dFdy(point.normal));
  float side = waterTangentSide().y;
  return waterBufferChange(point, taken, vec2(0.0, side), side * dFdy(waterBuffered));
}
