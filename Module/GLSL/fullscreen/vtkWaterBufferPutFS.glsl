//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferPutFS.glsl: the shaded surface of a buffer comes into the picture: into one sample of each pixel, which GL's
// sample mask chooses, or into the pixel.
//VTK::Output::Dec

in vec2 texCoord;
uniform vec4 waterViewport;        // as in vtkWaterPointFS.glsl
uniform sampler2D waterShadedNear; // of the first texels
uniform sampler2D waterShadedFar;  // of the second ones
uniform sampler2D waterShadedMasks;
uniform int waterShadedSample;

void main()
{
  ivec2 pixel = ivec2(waterViewport.xy + texCoord / waterViewport.zw);
  ivec2 masks = ivec2(255.0 * texelFetch(waterShadedMasks, pixel, 0).xy + 0.5);
  ivec2 isIn = (masks >> waterShadedSample) & 1;
  if (isIn.x + isIn.y == 0)
  {
    discard;
  }
  gl_FragData[0] = isIn.x != 0 ? texelFetch(waterShadedNear, pixel, 0) : texelFetch(waterShadedFar, pixel, 0);
}
