//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterBufferSortFS.glsl: the samples of a surface buffer's pixel become one texel, or two where they show parts of the
// surface that lie behind each other, or are turned against each other. Each sample has the pixel's middle on the plane of
// its own triangle, so the mean of many triangles is the surface in that middle. vtkWaterBufferSampleFS.glsl or
// vtkWaterBufferOneFS.glsl reads the samples.
//
// A pixel beside the surface, with a pixel of it within two by two, gets the texel that it would have: the shader takes
// derivatives there.
//
// Depth: 0.25 where there is one texel, 0.5 where there are two, 1 where there is none.
//VTK::Output::Dec

in vec2 texCoord;
uniform int waterBufferSamples;
uniform vec4 waterViewport; // as in vtkWaterPointFS.glsl
uniform mat3 waterNdcToRay;
uniform mat4 waterDirToEye;

#include "vtkWaterTangent.glsl"

const float WATER_BUFFER_WITHIN = 0.5; // pixels: samples of one surface are no farther from its plane
const float WATER_BUFFER_EVEN = 1e-3;  // the same of 1 / w, where the plane is seen from straight above
const float WATER_BUFFER_TURN = 0.02;  // of slope: triangles that a shore cuts turn by more, and look different

vec4 waterBufferAt(ivec2 pixel, int number);     // texel of a sample
vec4 waterBufferDataAt(ivec2 pixel, int number); // its data's colour

// View ray of length 1 along w, so many pixels beside this one.
vec3 waterSortRay(vec2 moved)
{
  vec2 ndc = 2.0 * (gl_FragCoord.xy + moved - waterViewport.xy) * waterViewport.zw - 1.0;
  vec3 dir = waterNdcToRay * vec3(ndc, 1.0);
  return dir / (waterDirToEye * vec4(dir, 0.0)).w;
}

// How far 1 / w of a pixel's samples may be from that of a texel.
float waterSortTolerance(vec4 texel)
{
  vec3 here = waterSortRay(vec2(0.0));
  float change = abs(waterTangentPerW(texel, here, waterSortRay(vec2(1.0, 0.0))) - texel.w) +
    abs(waterTangentPerW(texel, here, waterSortRay(vec2(0.0, 1.0))) - texel.w);
  return WATER_BUFFER_WITHIN * change + WATER_BUFFER_EVEN * texel.w;
}

// That of a pixel without one, from the others of two by two.
vec4 waterSortFilled(vec4 texel)
{
  vec2 side = waterTangentSide();
  vec4 besideX = texel + side.x * dFdx(texel);
  vec4 besideY = texel + side.y * dFdy(texel);
  vec4 besideBoth = besideY + side.x * dFdx(besideY);
  vec4 source = besideX.w > 0.0 ? besideX : (besideY.w > 0.0 ? besideY : besideBoth);
  vec2 from = besideX.w > 0.0 ? vec2(side.x, 0.0) : (besideY.w > 0.0 ? vec2(0.0, side.y) : side);
  vec4 filled = waterTangentTexel(source, waterSortRay(from), waterSortRay(vec2(0.0)));
  return texel.w > 0.0 || !(source.w > 0.0) ? texel : filled;
}

void main()
{
  ivec2 pixel = ivec2(waterViewport.xy + texCoord / waterViewport.zw);
  vec4 first = vec4(0.0); // the texel that a sample is compared with
  float tolerance = 0.0;
  vec4 texels[2] = vec4[2](vec4(0.0), vec4(0.0));
  vec4 data[2] = vec4[2](vec4(0.0), vec4(0.0));
  vec2 counts = vec2(0.0);
  vec2 masks = vec2(0.0); // of the samples: bits
  float bit = 1.0;
  for (int i = 0; i < waterBufferSamples; ++i)
  {
    vec4 texel = waterBufferAt(pixel, i);
    vec4 color = clamp(waterBufferDataAt(pixel, i), 0.0, 1.0); // beyond the triangle's end it may be any
    bool isThere = texel.w > 0.0;
    bool isFirst = isThere && counts.x == 0.0;
    first = isFirst ? texel : first;
    tolerance = isFirst ? waterSortTolerance(texel) : tolerance;
    bool isNear = abs(texel.w - first.w) <= tolerance && length(texel.yz - first.yz) <= WATER_BUFFER_TURN;
    vec2 share = isThere ? (isNear ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) : vec2(0.0);
    texels[0] += share.x * texel;
    texels[1] += share.y * texel;
    data[0] += share.x * color;
    data[1] += share.y * color;
    counts += share;
    masks += bit * share;
    bit *= 2.0;
  }
  vec2 per = 1.0 / max(counts, vec2(1.0));
  gl_FragData[0] = waterSortFilled(per.x * texels[0]);
  gl_FragData[1] = waterSortFilled(per.y * texels[1]);
  gl_FragData[2] = vec4(masks / 255.0, 0.0, 0.0);
  gl_FragData[3] = per.x * data[0];
  gl_FragData[4] = per.y * data[1];
  gl_FragDepth = counts.y > 0.0 ? 0.5 : (counts.x > 0.0 ? 0.25 : 1.0);
}
