//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeenFS.glsl: where in each pixel of a multisampled picture something beyond the water's plane is seen: the middle
// of those samples, from the pixel's, if something over the plane has the others; and which samples they are.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2DMS waterSampleDepth; // window depth, 1: background
uniform vec2 waterSamplePlaces[32]; // pixels, from the middle
uniform ivec4 waterSampleRect;      // of the picture in its framebuffer: x, y, width, height in pixels
uniform ivec4 waterSamplePart;      // of that what is drawn
uniform vec4 waterHeightClip;       // as in vtkWaterMediumPictureFS.glsl

const int WATER_SEEN_SAMPLES = 4; // of the picture: the number is replaced

void main()
{
  vec2 middle = vec2(waterSamplePart.xy) + vec2(waterSamplePart.zw) * texCoord;
  vec3 places = vec3(0.0); // sum of those beyond the plane, number
  int beyond = 0;          // a bit for each of them
  for (int i = 0; i < WATER_SEEN_SAMPLES; ++i)
  {
    float depth = texelFetch(waterSampleDepth, waterSampleRect.xy + ivec2(middle), i).r;
    vec2 uv = (middle + waterSamplePlaces[i]) / vec2(waterSampleRect.zw);
    bool isBeyond = depth >= 1.0 || dot(waterHeightClip, vec4(2.0 * vec3(uv, depth) - 1.0, 1.0)) < 0.0;
    beyond += isBeyond ? 1 << i : 0;
    places += isBeyond ? vec3(waterSamplePlaces[i], 1.0) : vec3(0.0);
  }
  bool isPart = places.z > 0.0 && places.z < float(WATER_SEEN_SAMPLES);
  vec2 bits = vec2(float(beyond & 65535), float((beyond >> 16) & 65535)); // a float has 24 exactly
  gl_FragData[0] = vec4(isPart ? places.xy / places.z : vec2(0.0), bits);
}
