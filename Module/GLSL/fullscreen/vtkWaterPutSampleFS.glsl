//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPutSampleFS.glsl: a picture's colour and depth become those of one sample of each pixel, which GL's sample mask
// chooses.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterTakenColor;
uniform sampler2D waterTakenDepth;

void main()
{
  ivec2 pixel = ivec2(vec2(textureSize(waterTakenColor, 0)) * texCoord);
  gl_FragData[0] = texelFetch(waterTakenColor, pixel, 0);
  gl_FragDepth = texelFetch(waterTakenDepth, pixel, 0).r;
}
