//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMaskFS.glsl: covers the pixels of the reflection texture that no visible water looks up, for calm water,
// which looks up its own pixel; or, drawn with a pixel for each cell of them, the cells. Into the
// reflection texture the draw's depth range gives the nearest depth, so that nothing that is drawn later passes the
// test.
//VTK::Output::Dec

in vec2 texCoord;
uniform sampler2D waterSceneDepth; // of the eye's picture, without the water
uniform ivec2 waterSceneCorner;    // the picture's lower right pixel in it: the reflection texture is flipped in x
uniform vec2 waterPixel;           // size of a pixel of it in NDC
uniform ivec2 waterLastPixel;      // of it
uniform vec2 waterCellCount;       // of the viewport
uniform vec2 waterWalkFirst;       // water_visibility_walk: which of its pixels, flipped, a cell asks
uniform vec2 waterWalkStep;
uniform ivec2 waterWalkSize;
uniform vec4 waterHeightClip; // NDC of the eye -> height over the plane, times a positive number
uniform float waterRounding;  // of that

void main()
{
  ivec2 first = ivec2(floor(waterWalkFirst + floor(texCoord * waterCellCount) * waterWalkStep));
  for (int y = 0; y < waterWalkSize.y; ++y)
  {
    for (int x = 0; x < waterWalkSize.x; ++x)
    {
      ivec2 pixel = clamp(first + ivec2(x, y), ivec2(0), waterLastPixel);
      float depth = texelFetch(waterSceneDepth, waterSceneCorner + pixel * ivec2(-1, 1), 0).r;
      vec2 place = (vec2(pixel) + 0.5) * waterPixel - 1.0;
      vec4 clip = vec4(-place.x, place.y, 2.0 * depth - 1.0, 1.0);
      // what lies under the plane is seen through the water, if there is any
      if (dot(waterHeightClip, clip) <= waterRounding)
      {
        discard;
      }
    }
  }
  gl_FragData[0] = vec4(0.0);
}
