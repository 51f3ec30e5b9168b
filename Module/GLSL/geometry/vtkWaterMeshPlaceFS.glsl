// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshPlaceFS.glsl: slot place of a mesh of the user's that is not flat: place and slope come from the vertices
// (vtkWaterMeshSlopesVS.glsl).

in vec2 waterPlaceVSOutput;
in vec3 waterNormalVSOutput; // 0: the mesh has none
uniform mat3 waterNdcToPlane; // (NDC x, NDC y, 1) -> place on the plane, from under the eye

const float WATER_STEEPEST = 10.0; // a slope: walls of cells count as no steeper

vec2 waterPlaceOf(vec2 ndc)
{
  return waterPlaceVSOutput;
}

float waterMoving(float amplitude, float seen, vec2 k)
{
  return seen;
}

vec2 waterMiss(vec3 point, vec3 normal, vec3 ray, float side)
{
  return point.xy; // the mesh is where it is: waves turn rays and move no point
}

// dz/dx and dz/dy of the mesh, z towards the eye: of its normals, or else of the triangle.
//
// across, down  change of the place from pixel to pixel
// rise          that of the height
vec2 waterTilt(vec2 across, vec2 down, vec2 rise)
{
  float area = across.x * down.y - across.y * down.x;
  vec2 ofTriangle = vec2(rise.x * down.y - rise.y * across.y, rise.y * across.x - rise.x * down.x) /
    (abs(area) > 1e-30 ? area : 1e-30);
  vec3 normal = waterNormalVSOutput;
  float size = dot(normal, normal);
  float up = max(abs(normal.z), sqrt(size) / WATER_STEEPEST) * (normal.z < 0.0 ? -1.0 : 1.0);
  vec2 slope = size > 0.0 ? -normal.xy / up : ofTriangle;
  return slope * min(1.0, WATER_STEEPEST / max(length(slope), 1e-6));
}
