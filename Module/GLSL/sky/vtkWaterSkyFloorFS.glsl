// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSkyFloorFS.glsl: slot floor of a vtkSkybox with the projection Floor: a plane over which a texture is repeated.
// Its colour fades where it is seen from its side. Source: the fragment shader of vtkOpenGLSkybox (VTK 9.6.2).

uniform sampler2D waterSkyFloor;
uniform vec4 waterFloorHeight; // point in the plane's axes, 1 -> distance from the floor
uniform vec4 waterFloorU;      // the same -> place in the texture
uniform vec4 waterFloorV;
uniform vec2 waterFloorShown;  // exponent of its colours, brightest colour

// A direction's sky, and the floor before it, from the pixel's point.
vec3 waterOverFloor(vec3 dir, vec3 color)
{
  float falls = dot(waterFloorHeight.xyz, dir);
  float way = -dot(waterFloorHeight, vec4(waterFrom, 1.0)) / (abs(falls) < 1e-4 ? 1e-4 : falls);
  vec4 met = vec4(waterFrom + way * dir, 1.0);
  vec2 size = vec2(textureSize(waterSkyFloor, 0));
  vec2 perLength = size * vec2(length(waterFloorU.xyz), length(waterFloorV.xyz));
  float wide = waterSpread * way * max(perLength.x, perLength.y) / max(abs(falls), 0.02);
  vec3 shown = textureLod(waterSkyFloor, vec2(dot(waterFloorU, met), dot(waterFloorV, met)), log2(max(wide, 1.0))).rgb;
  shown = waterFloorShown.x == 1.0 ? shown : pow(max(shown, vec3(0.0)), vec3(waterFloorShown.x));
  float share = way >= 0.0 && abs(falls) >= 1e-4 ? 50.0 * min(0.02, abs(falls)) : 0.0;
  return mix(color, min(shown, vec3(waterFloorShown.y)), share);
}

// A ray that is not seen to meet a thing may meet the floor.
bool waterHasFloor()
{
  return true;
}
