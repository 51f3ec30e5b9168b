//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTakeSampleFS.glsl: one sample of each pixel of a multisampled picture, as it is.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2DMS waterSampleColor;
uniform sampler2DMS waterSampleDepth;
uniform int waterSample;
uniform vec4 waterSampleRect; // x, y, width, height in pixels: what is taken

void main()
{
  ivec2 pixel = ivec2(waterSampleRect.xy) + ivec2(waterSampleRect.zw * texCoord);
  gl_FragData[0] = texelFetch(waterSampleColor, pixel, waterSample);
  gl_FragDepth = texelFetch(waterSampleDepth, pixel, waterSample).r;
}
