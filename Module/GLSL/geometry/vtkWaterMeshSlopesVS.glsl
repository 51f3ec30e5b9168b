// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshSlopesVS.glsl: where the vertices of a user's mesh lie along the plane's axes, and their normals. The
// attribute normalMC is declared by VTK, or by vtkWaterNormalsVS.glsl.

uniform vec4 waterVertexAcross; // (from waterVertexOrigin, 1) -> place on the plane, from the point under the eye
uniform vec4 waterVertexDown;
uniform mat3 waterNormalToPlane; // normal of the mesh -> in the plane's axes, the third to the eye
out vec2 waterPlaceVSOutput;
out vec3 waterNormalVSOutput;

void waterMeasureSlope(vec4 vertex, vec3 normal)
{
  vec4 off = vec4(vertex.xyz - waterVertexOrigin, 1.0);
  waterPlaceVSOutput = vec2(dot(waterVertexAcross, off), dot(waterVertexDown, off));
  waterNormalVSOutput = waterNormalToPlane * normal;
}
