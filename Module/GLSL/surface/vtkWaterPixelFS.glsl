// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPixelFS.glsl: slot pixel of a surface that is drawn itself: its pixel is the fragment's.

float waterPerW()
{
  return gl_FragCoord.w;
}

float waterDepthHere()
{
  return gl_FragCoord.z;
}

vec2 waterDepthSlope()
{
  return vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z));
}

void waterPlaceSlope(vec2 middle, out vec2 across, out vec2 down)
{
  across = dFdx(middle);
  down = dFdy(middle);
}

WaterPointChange waterChangeAcross(WaterPoint point)
{
  return WaterPointChange(dFdx(point.start), dFdx(point.startW), dFdx(point.ray), dFdx(point.normal));
}

WaterPointChange waterChangeDown(WaterPoint point)
{
  return WaterPointChange(dFdy(point.start), dFdy(point.startW), dFdy(point.ray), dFdy(point.normal));
}
