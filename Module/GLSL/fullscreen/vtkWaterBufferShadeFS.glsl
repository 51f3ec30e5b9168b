// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferShadeFS.glsl: the end of the shader that shades the surface in a buffer.

void waterReadBuffer();
void waterShade(inout vec4 color);

void main()
{
  waterReadBuffer();
  vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
  waterShade(color);
  gl_FragData[0] = color;
}
