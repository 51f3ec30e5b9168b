// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterDisplacedFS.glsl: stage place of a surface that waves displace: its place at rest comes
// from the vertices (vtkWaterWavesVS.glsl).

in vec2 waterRestVSOutput;
uniform vec4 waterMapHeight; // NDC of the map -> height over the plane / w
uniform vec4 waterMapW;      // NDC of the map -> 1 / w
uniform float waterSlack;    // in heights: roundings of the map's depth, and its texels' size

vec2 waterPlaceOf(vec2 ndc)
{
  return waterRestVSOutput;
}

// Does the map show there what lies lower than a height? The mirrored view is cut at the deepest
// trough, and elsewhere has things that are under water. No ray meets them: it goes up from the
// surface.
bool waterIsUnder(vec2 uv, float depth, float height)
{
  vec4 ndc = vec4(2.0 * vec3(uv, depth) - 1.0, 1.0);
  return dot(waterMapHeight, ndc) < (height - waterSlack) * dot(waterMapW, ndc);
}
