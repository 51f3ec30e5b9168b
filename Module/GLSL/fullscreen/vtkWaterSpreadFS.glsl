//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSpreadFS.glsl: the samples of a picture's pixels, spread over a picture that is so many times finer: colours and
// depths that are not mixed are what refracted rays can meet.
//
// What lies over the water is left out where something lies beyond its surface in the same pixel: that alone is seen through
// it.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2DMS waterSampleColor;
uniform sampler2DMS waterSampleDepth; // window depth, 1: background
uniform sampler2D waterSampleSeen;    // of vtkWaterSeenFS.glsl
uniform sampler2D waterSamplePlane;   // the same
uniform vec2 waterSamplePlaces[32];   // pixels, from the middle
uniform ivec4 waterSampleRect;        // of the picture in its framebuffer: x, y, width, height in pixels
uniform ivec4 waterSamplePart;        // of that what is drawn
uniform int waterSampleNumbers[16];   // of the sample nearest to each of a pixel's finer ones, by rows

const int WATER_SPREAD_SAMPLES = 4; // of a pixel: the number is replaced
const int WATER_SPREAD_SIDE = 2;    // finer pixels along each of its sides: the number is replaced

void main()
{
  ivec2 fine = ivec2(texCoord * vec2(WATER_SPREAD_SIDE * waterSamplePart.zw));
  ivec2 pixel = fine / WATER_SPREAD_SIDE;
  ivec2 inside = fine - WATER_SPREAD_SIDE * pixel;
  pixel += waterSamplePart.xy;
  int number = waterSampleNumbers[inside.y * WATER_SPREAD_SIDE + inside.x];
  ivec2 bits = ivec2(texelFetch(waterSampleSeen, pixel, 0).ba);
  vec4 plane = texelFetch(waterSamplePlane, pixel, 0);
  int beyond = bits.x | (bits.y << 16);
  vec2 middle = (vec2(inside) + 0.5) / float(WATER_SPREAD_SIDE) - 0.5;
  if (beyond != 0 && ((beyond >> number) & 1) == 0)
  {
    float nearest = 1e9;
    for (int i = 0; i < WATER_SPREAD_SAMPLES; ++i)
    {
      vec2 apart = waterSamplePlaces[i] - middle;
      float away = ((beyond >> i) & 1) != 0 ? dot(apart, apart) : 1e9;
      number = away < nearest ? i : number;
      nearest = min(nearest, away);
    }
  }
  pixel += waterSampleRect.xy;
  gl_FragData[0] = vec4(texelFetch(waterSampleColor, pixel, number).rgb, 1.0);
  float own = texelFetch(waterSampleDepth, pixel, number).r;
  gl_FragDepth = plane.a > 0.0 ? plane.b + dot(plane.rg, middle) : own;
}
