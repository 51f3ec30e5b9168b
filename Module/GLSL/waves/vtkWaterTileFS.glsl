// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterTileFS.glsl: slopes from a tile that repeats (vtkWaterSlopeTexture): mip levels average
// slopes and their squares alike, and what a pixel does not resolve is left as variance.

const int WATER_TILE_LOOKS = 4; // along the pixel's longer side: the anisotropy

// Is a tile looked at of which so much is seen? A branch takes software longer than the looks.
bool waterTileIsRead(float part)
{
  return true;
}

// The mean of a tile over a pixel.
//
// middle        of the pixel, in tiles; its third the tile's layer
// longer        side of the pixel, and the shorter one
// texel         size of one, in tiles
// looks         along the longer side; known early
vec4 waterTileMean(sampler2DArray tile, vec3 middle, vec2 longer, vec2 shorter, float texel, int looks)
{
  // GL's own anisotropic filter is not used: Mesa's software renderer needs minutes for it
  vec4 seen = vec4(0.0);
  float each = 1.0 / float(looks);
  for (int i = 0; i < looks; ++i)
  {
    float along = (float(i) + 0.5) * each - 0.5;
    seen += textureGrad(tile, middle + vec3(along * longer, 0.0), each * longer, shorter);
  }
  return each * seen;
}
