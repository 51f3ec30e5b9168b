//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFftFS.glsl: a pass of one or two Fourier transforms along the rows or columns of squares that lie one above the
// other (water_fft.h), and for the first the squares of what comes out, which the last pass is asked for.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterField;    // what the pass before left: a complex number of each transform
uniform sampler2D waterFftTable; // water_fft_table, a row for each pass
uniform vec4 waterFftPass;       // radix; size / radix; its row of the table; 0: along x, 1: along y
uniform int waterFftCount;       // of transforms: 1 or 2
uniform int waterFftSquares;     // 1: squares in place of the second transform

vec2 waterTurned(vec2 number, vec2 turn)
{
  return number * turn.x + vec2(-number.y, number.x) * turn.y;
}

void main()
{
  ivec2 place = ivec2(texCoord * vec2(textureSize(waterField, 0)));
  ivec2 along = waterFftPass.w < 0.5 ? ivec2(1, 0) : ivec2(0, 1);
  int size = textureSize(waterField, 0).x;
  int top = place.y / size * size; // of the square
  ivec2 line = along.x > 0 ? ivec2(0, place.y) : ivec2(place.x, top);
  int onLine = along.x > 0 ? place.x : place.y - top;
  vec4 entry = texelFetch(waterFftTable, ivec2(onLine, int(waterFftPass.z)), 0);
  int radix = int(waterFftPass.x);
  int next = int(waterFftPass.y);
  int at = int(entry.z) + radix * next;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < radix; ++i) // Horner
  {
    at -= next;
    vec4 number = texelFetch(waterField, line + at * along, 0);
    sum.xy = waterTurned(sum.xy, entry.xy) + number.xy;
    if (waterFftCount > 1)
    {
      sum.zw = waterTurned(sum.zw, entry.xy) + number.zw;
    }
  }
  gl_FragData[0] = waterFftSquares != 0 ? vec4(sum.xy, sum.xy * sum.xy) : sum;
}
