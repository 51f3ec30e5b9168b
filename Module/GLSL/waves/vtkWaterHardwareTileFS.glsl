// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareTileFS.glsl: slot tile for hardware: as vtkWaterTileFS.glsl, with fewer looks where a pixel is
// small against a texel, and a level in place of gradients for a single look: hardware filters four numbers of 32 bits
// several times as slowly as it reads a depth.

const int WATER_TILE_LOOKS = 4;
const float WATER_TILE_ONE = 0.05; // up to so many texels along the longer side one look is the mean of four,
const float WATER_TILE_TWO = 0.3;   // and up to so many two: between texels the slope is linear

// The mean of four looks along the pixel's longer side.
vec4 waterTileFour(sampler2DArray tile, vec3 middle, vec2 longer, vec2 shorter, bool isFine)
{
  vec3 inner = vec3(0.125 * longer, 0.0);
  vec3 outer = vec3(0.375 * longer, 0.0);
  if (isFine)
  {
    return 0.25 * (textureLod(tile, middle - outer, 0.0) + textureLod(tile, middle - inner, 0.0) +
      textureLod(tile, middle + inner, 0.0) + textureLod(tile, middle + outer, 0.0));
  }
  vec2 part = 0.25 * longer;
  return 0.25 * (textureGrad(tile, middle - outer, part, shorter) + textureGrad(tile, middle - inner, part, shorter) +
    textureGrad(tile, middle + inner, part, shorter) + textureGrad(tile, middle + outer, part, shorter));
}

// As in vtkWaterTileFS.glsl; of several looks as many as the pixel needs.
vec4 waterTileMean(sampler2DArray tile, vec3 middle, vec2 longer, vec2 shorter, float texel, int looks)
{
  float texels = length(longer) / texel;
  if (looks == 1 || texels < WATER_TILE_ONE)
  {
    return textureLod(tile, middle, log2(max(texels, 1.0)));
  }
  if (texels < WATER_TILE_TWO)
  {
    vec3 part = vec3(0.2795085 * longer, 0.0);
    return 0.5 * (textureLod(tile, middle - part, 0.0) + textureLod(tile, middle + part, 0.0));
  }
  return waterTileFour(tile, middle, longer, shorter, max(0.25 * texels, length(shorter) / texel) < 1.0);
}

// As there; a look takes longer than a branch.
bool waterTileIsRead(float part)
{
  return part > 0.0;
}
