// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPhotonTileFS.glsl: slot tile of the photons' shader: slopes from a tile, smooth between its points.
// Light shows how slopes change: between points that are joined by lines it would stand in blocks.

const int WATER_TILE_LOOKS = 4; // along a wide cell's longer side
const vec2 WATER_PHOTON_COARSE = vec2(0.5, 1.5); // texels a cell: from smooth to filtered

// Weights of four points in a row; Catmull and Rom 1974, "A Class of Local Interpolating Splines".
vec4 waterPhotonWeights(float t)
{
  return 0.5 * vec4(t * (t * (2.0 - t) - 1.0), 2.0 + t * t * (3.0 * t - 5.0), t * (1.0 + t * (4.0 - 3.0 * t)), t * t * (t - 1.0));
}

// As there; a look takes longer than a branch.
bool waterTileIsRead(float part)
{
  return part > 0.0;
}

// As in vtkWaterTileFS.glsl.
vec2 waterTileSlope(sampler2DArray tile, vec3 middle, vec2 across, vec2 down, float texel,
  int looks, inout vec4 variance)
{
  bool isWide = dot(across, across) > dot(down, down);
  vec2 longer = isWide ? across : down;
  vec2 shorter = isWide ? down : across;
  float texels = length(longer) / texel;
  float coarse = smoothstep(WATER_PHOTON_COARSE.x, WATER_PHOTON_COARSE.y, texels);

  ivec2 size = textureSize(tile, 0).xy;
  int layer = int(middle.z);
  vec2 place = (middle.xy - floor(middle.xy)) * vec2(size) - 0.5;
  ivec2 first = ivec2(floor(place)) + size - 1;
  vec4 columns = waterPhotonWeights(fract(place.x));
  vec4 rows = waterPhotonWeights(fract(place.y));
  vec2 fine = vec2(0.0);
  int count = coarse < 1.0 ? 4 : 0; // no branch: software renderers execute both sides
  for (int j = 0; j < count; ++j)
  {
    int y = (first.y + j) % size.y;
    fine += rows[j] * (columns.x * texelFetch(tile, ivec3(first.x % size.x, y, layer), 0).xy +
      columns.y * texelFetch(tile, ivec3((first.x + 1) % size.x, y, layer), 0).xy +
      columns.z * texelFetch(tile, ivec3((first.x + 2) % size.x, y, layer), 0).xy +
      columns.w * texelFetch(tile, ivec3((first.x + 3) % size.x, y, layer), 0).xy);
  }
  vec4 seen = vec4(0.0);
  int filtered = coarse > 0.0 ? looks : 0;
  float each = 1.0 / float(looks);
  for (int i = 0; i < filtered; ++i)
  {
    float along = (float(i) + 0.5) * each - 0.5;
    seen += textureGrad(tile, middle + vec3(along * longer, 0.0), each * longer, shorter);
  }
  seen *= each;
  variance.xy += coarse * max(seen.zw - seen.xy * seen.xy, 0.0);
  return mix(fine, seen.xy, coarse);
}
