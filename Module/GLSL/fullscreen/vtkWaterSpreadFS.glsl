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
uniform vec2 waterSamplePlaces[32];   // pixels, from the middle
uniform ivec4 waterSampleRect;        // of the picture in its framebuffer: x, y, width, height in pixels
uniform ivec4 waterSamplePart;        // of that what is drawn
uniform int waterSampleNumbers[16];   // of the sample nearest to each of a pixel's finer ones, by rows

const int WATER_SPREAD_SAMPLES = 4; // of a pixel: the number is replaced
const int WATER_SPREAD_SIDE = 2;    // finer pixels along each of its sides: the number is replaced

const float WATER_SPREAD_EVEN = 0.02; // of how much the depth changes in a pixel: so far from a plane, it is of one surface
const float WATER_SPREAD_ALIKE = 0.25; // the same of how much it changes to a neighbour

float waterSpreadFirst(ivec2 at)
{
  return texelFetch(waterSampleDepth, clamp(at, waterSampleRect.xy, waterSampleRect.xy + waterSampleRect.zw - 1), 0).r;
}

// Does the depth change to one of two neighbours as it does in the pixel? Two surfaces that share the samples evenly lie in
// one plane, too, but the next pixel has one of them.
//
// most  that the depth changes in any direction
bool waterSpreadGoesOn(ivec2 at, ivec2 side, float change, float most)
{
  float first = waterSpreadFirst(at);
  float off = min(abs(waterSpreadFirst(at + side) - first - change), abs(first - waterSpreadFirst(at - side) - change));
  return off <= WATER_SPREAD_ALIKE * most + 1e-7;
}

// The depth at a place of a pixel, from its middle, if all of its samples are of one surface, else that of one sample. At a
// low angle a surface is metres deeper at one end of a pixel than at the other: what lies close behind the water must not
// seem to be before it.
float waterSpreadDepth(ivec2 at, vec2 place, float own)
{
  vec2 across = vec2(0.0);
  vec2 change = vec2(0.0);
  float mean = 0.0;
  for (int i = 0; i < WATER_SPREAD_SAMPLES; ++i)
  {
    float depth = texelFetch(waterSampleDepth, at, i).r - own;
    mean += depth / float(WATER_SPREAD_SAMPLES);
    change += depth * waterSamplePlaces[i];
    across += waterSamplePlaces[i] * waterSamplePlaces[i];
  }
  change /= max(across, vec2(1e-6));
  float most = 0.0;
  float off = 0.0;
  for (int i = 0; i < WATER_SPREAD_SAMPLES; ++i)
  {
    float depth = texelFetch(waterSampleDepth, at, i).r - own - mean;
    most = max(most, abs(depth));
    off = max(off, abs(depth - dot(change, waterSamplePlaces[i])));
  }
  float steepest = max(abs(change.x), abs(change.y));
  bool isOne = off <= WATER_SPREAD_EVEN * most + 1e-7 && waterSpreadGoesOn(at, ivec2(1, 0), change.x, steepest) &&
    waterSpreadGoesOn(at, ivec2(0, 1), change.y, steepest);
  return isOne ? own + mean + dot(change, place) : own;
}

void main()
{
  ivec2 fine = ivec2(texCoord * vec2(WATER_SPREAD_SIDE * waterSamplePart.zw));
  ivec2 pixel = fine / WATER_SPREAD_SIDE;
  ivec2 inside = fine - WATER_SPREAD_SIDE * pixel;
  pixel += waterSamplePart.xy;
  int number = waterSampleNumbers[inside.y * WATER_SPREAD_SIDE + inside.x];
  ivec2 bits = ivec2(texelFetch(waterSampleSeen, pixel, 0).ba);
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
  gl_FragDepth = waterSpreadDepth(pixel, middle, texelFetch(waterSampleDepth, pixel, number).r);
}
