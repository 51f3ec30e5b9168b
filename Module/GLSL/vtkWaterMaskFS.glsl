//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMaskFS.glsl: closes the pixels of the map that no visible water looks up, for calm water,
// which looks up its own pixel: the nearest depth there, so that nothing that is drawn later passes
// the test. The draw's depth range gives the depth.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSceneDepth; // of the eye's picture, without the water
uniform ivec2 waterSceneCorner;    // the picture's lower right pixel in it: the map is flipped in x
uniform vec4 waterHeightClip;      // NDC of the eye -> height over the plane, times a positive number
uniform float waterRounding;       // of that

void main()
{
  ivec2 pixel = waterSceneCorner + ivec2(gl_FragCoord.xy) * ivec2(-1, 1);
  float depth = texelFetch(waterSceneDepth, pixel, 0).r;
  vec4 clip = vec4(2.0 * vec3(1.0 - texCoord.x, texCoord.y, depth) - 1.0, 1.0);
  // what lies under the plane is seen through the water, if there is any
  if (dot(waterHeightClip, clip) <= waterRounding)
  {
    discard;
  }
  gl_FragData[0] = vec4(0.0);
}
