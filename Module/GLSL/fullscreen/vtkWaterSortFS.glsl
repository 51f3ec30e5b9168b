//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSortFS.glsl: the samples of a picture's pixel, sorted into those of one thing and those of another: colours and
// depths that are not mixed are what refracted rays can meet.
//
// What lies over the water is left out where something lies beyond its surface: that alone is seen through it. Of
// two things one is nearer to the eye by more than a plane's depth changes within the pixel. The background is
// always one of its own, or it would shine out of what is before it.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2DMS waterSampleColor;
uniform sampler2DMS waterSampleDepth; // window depth, 1: background
uniform vec2 waterSamplePlaces[32]; // pixels, from the middle
uniform vec4 waterSampleRect;       // of the picture in its framebuffer: x, y, width, height in pixels
uniform vec4 waterSamplePart;       // of that what is drawn
uniform vec4 waterHeightClip;       // as in vtkWaterMediumPictureFS.glsl

const int WATER_SORT_SAMPLES = 4; // of the picture: the number is replaced
const float WATER_SORT_BENT = 1.5; // a plane's depths are not so many times as far apart as its slope has them
const float WATER_SORT_NEARLY = 0.9999999; // the background

ivec2 waterCorner = ivec2(waterSampleRect.xy);
vec2 waterMiddle = waterSamplePart.xy + waterSamplePart.zw * texCoord; // of the pixel
ivec2 waterPixel = ivec2(waterMiddle);

float waterSampleDepthOf(ivec2 pixel, int i)
{
  ivec2 inside = clamp(pixel, ivec2(0), ivec2(waterSampleRect.zw) - 1);
  return texelFetch(waterSampleDepth, waterCorner + inside, i).r;
}

// Does a sample lie beyond the water's plane?
bool waterIsBeyond(int i, float depth)
{
  vec2 uv = (waterMiddle + waterSamplePlaces[i]) / waterSampleRect.zw;
  return depth >= 1.0 || dot(waterHeightClip, vec4(2.0 * vec3(uv, depth) - 1.0, 1.0)) < 0.0;
}

// How the depth changes before and after a pixel, on one axis.
//
// depth  there
vec2 waterDepthChange(float depth, ivec2 axis)
{
  return vec2(depth - waterSampleDepthOf(waterPixel - axis, 0), waterSampleDepthOf(waterPixel + axis, 0) - depth);
}

// On a plane both differences are its slope; at the edge of an object the smaller one is. A depth
// that is nearer or farther than both neighbours gives no slope.
float waterDepthSlope(vec2 change)
{
  float smaller = abs(change.x) < abs(change.y) ? change.x : change.y;
  return change.x * change.y > 0.0 ? smaller : 0.0;
}

void main()
{
  // Arrays, and a number of samples that compilers know: software renderers read a depth more slowly than they sort it.
  float depths[WATER_SORT_SAMPLES];
  float beyond[WATER_SORT_SAMPLES]; // 1: beyond the water's plane
  vec3 places = vec3(0.0); // sum of those beyond it, number
  vec2 range = vec2(2.0, -1.0);
  vec2 rangeBeyond = range;
  for (int i = 0; i < WATER_SORT_SAMPLES; ++i)
  {
    float depth = waterSampleDepthOf(waterPixel, i);
    bool isBeyond = waterIsBeyond(i, depth);
    vec2 wider = vec2(min(rangeBeyond.x, depth), max(rangeBeyond.y, depth));
    rangeBeyond = isBeyond ? wider : rangeBeyond;
    places += isBeyond ? vec3(waterSamplePlaces[i], 1.0) : vec3(0.0);
    range = vec2(min(range.x, depth), max(range.y, depth));
    depths[i] = depth;
    beyond[i] = isBeyond ? 1.0 : 0.0;
  }
  bool isSeen = places.z > 0.0;
  range = isSeen ? rangeBeyond : range;
  vec2 across = waterDepthChange(depths[0], ivec2(1, 0));
  vec2 up = waterDepthChange(depths[0], ivec2(0, 1));
  vec2 slope = vec2(waterDepthSlope(across), waterDepthSlope(up));
  float spread = WATER_SORT_BENT * (min(abs(across.x), abs(across.y)) + min(abs(up.x), abs(up.y))) + 1e-7;
  float middle = range.y - range.x > spread ? 0.5 * (range.x + range.y) : 2.0;
  middle = range.y >= 1.0 && range.x < 1.0 ? WATER_SORT_NEARLY : middle;

  vec4 near = vec4(0.0); // sum of colors, number
  vec4 far = vec4(0.0);
  vec2 sums = vec2(0.0); // of depths
  bool isPart = isSeen && places.z < float(WATER_SORT_SAMPLES);
  vec2 seen = isPart ? places.xy / places.z : vec2(0.0); // the surface's rays begin there
  for (int i = 0; i < WATER_SORT_SAMPLES; ++i)
  {
    float depth = depths[i];
    vec4 color = vec4(texelFetch(waterSampleColor, waterCorner + waterPixel, i).rgb, 1.0);
    bool isLeftOut = isSeen && beyond[i] == 0.0;
    bool isNear = depth <= middle;
    near += isLeftOut || !isNear ? vec4(0.0) : color;
    far += isLeftOut || isNear ? vec4(0.0) : color;
    float there = depth < 1.0 ? clamp(depth - dot(slope, waterSamplePlaces[i] - seen), 0.0, WATER_SORT_NEARLY) : depth;
    sums += isLeftOut ? vec2(0.0) : (isNear ? vec2(there, 0.0) : vec2(0.0, there));
  }
  bool isFarMore = far.w > near.w;
  vec4 more = isFarMore ? far : near;
  vec4 less = isFarMore ? near : far;
  sums /= max(vec2(near.w, far.w), vec2(1.0));
  float count = near.w + far.w;
  gl_FragData[0] = vec4(more.rgb / more.w, 1.0);
  gl_FragData[1] = vec4(less.rgb / max(less.w, 1.0), less.w / count);
  gl_FragData[2] = vec4(isFarMore ? sums.x : sums.y, seen, 0.0);
  gl_FragDepth = isFarMore ? sums.y : sums.x;
}
