//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeenFS.glsl: where in each pixel of a multisampled picture something beyond the water's plane is seen: the middle
// of those samples, from the pixel's, if something over the plane has the others; and which samples they are. Also the
// depth as a plane, if all samples are of one surface.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2DMS waterSampleDepth; // window depth, 1: background
uniform vec2 waterSamplePlaces[32]; // pixels, from the middle
uniform ivec4 waterSampleRect;      // of the picture in its framebuffer: x, y, width, height in pixels
uniform ivec4 waterSamplePart;      // of that what is drawn
uniform vec4 waterHeightClip;       // as in vtkWaterMediumPictureFS.glsl

const int WATER_SEEN_SAMPLES = 4; // of the picture: the number is replaced

const float WATER_SEEN_EVEN = 0.02; // of how much the depth changes in a pixel: so far from a plane, it is of one surface
const float WATER_SEEN_ALIKE = 0.25; // the same of how much it changes to a neighbour

float waterSeenFirst(ivec2 at)
{
  return texelFetch(waterSampleDepth, clamp(at, waterSampleRect.xy, waterSampleRect.xy + waterSampleRect.zw - 1), 0).r;
}

// Does the depth change to one of two neighbours as it does in the pixel? Two surfaces that share the samples evenly lie in
// one plane, too, but the next pixel has one of them.
//
// most  that the depth changes in any direction
bool waterSeenGoesOn(ivec2 at, ivec2 side, float change, float most)
{
  float first = waterSeenFirst(at);
  float off = min(abs(waterSeenFirst(at + side) - first - change), abs(first - waterSeenFirst(at - side) - change));
  return off <= WATER_SEEN_ALIKE * most + 1e-7;
}

// Change of the depth along x and y, depth in the middle of the pixel, 1; all 0 where the samples are of several surfaces.
//
// At a low angle a surface is metres deeper at one end of a pixel than at the other: what lies close behind the water must
// not seem to be before it, as another sample's depth would have it.
vec4 waterSeenPlane(ivec2 at, float depths[WATER_SEEN_SAMPLES])
{
  vec2 across = vec2(0.0);
  vec2 change = vec2(0.0);
  float mean = 0.0; // from the first
  for (int i = 0; i < WATER_SEEN_SAMPLES; ++i)
  {
    float depth = depths[i] - depths[0];
    mean += depth / float(WATER_SEEN_SAMPLES);
    change += depth * waterSamplePlaces[i];
    across += waterSamplePlaces[i] * waterSamplePlaces[i];
  }
  change /= max(across, vec2(1e-6));
  float most = 0.0;
  float off = 0.0;
  for (int i = 0; i < WATER_SEEN_SAMPLES; ++i)
  {
    float depth = depths[i] - depths[0] - mean;
    most = max(most, abs(depth));
    off = max(off, abs(depth - dot(change, waterSamplePlaces[i])));
  }
  float steepest = max(abs(change.x), abs(change.y));
  bool isOne = off <= WATER_SEEN_EVEN * most + 1e-7 && waterSeenGoesOn(at, ivec2(1, 0), change.x, steepest) &&
    waterSeenGoesOn(at, ivec2(0, 1), change.y, steepest);
  return isOne ? vec4(change, depths[0] + mean, 1.0) : vec4(0.0);
}

void main()
{
  vec2 middle = vec2(waterSamplePart.xy) + vec2(waterSamplePart.zw) * texCoord;
  vec3 places = vec3(0.0); // sum of those beyond the plane, number
  int beyond = 0;          // a bit for each of them
  float depths[WATER_SEEN_SAMPLES];
  for (int i = 0; i < WATER_SEEN_SAMPLES; ++i)
  {
    float depth = texelFetch(waterSampleDepth, waterSampleRect.xy + ivec2(middle), i).r;
    vec2 uv = (middle + waterSamplePlaces[i]) / vec2(waterSampleRect.zw);
    bool isBeyond = depth >= 1.0 || dot(waterHeightClip, vec4(2.0 * vec3(uv, depth) - 1.0, 1.0)) < 0.0;
    depths[i] = depth;
    beyond += isBeyond ? 1 << i : 0;
    places += isBeyond ? vec3(waterSamplePlaces[i], 1.0) : vec3(0.0);
  }
  bool isPart = places.z > 0.0 && places.z < float(WATER_SEEN_SAMPLES);
  vec2 bits = vec2(float(beyond & 65535), float((beyond >> 16) & 65535)); // a float has 24 exactly
  gl_FragData[0] = vec4(isPart ? places.xy / places.z : vec2(0.0), bits);
  gl_FragData[1] = waterSeenPlane(waterSampleRect.xy + ivec2(middle), depths);
}
