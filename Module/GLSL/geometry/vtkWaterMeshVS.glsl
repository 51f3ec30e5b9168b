// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshVS.glsl: how high the vertices of a user's mesh lie over the plane, by their own coordinates: clip
// coordinates, and the depths that come from them, are rounded by more than that.

uniform vec3 waterVertexOrigin; // one that floats hold exactly, amid the mesh
uniform vec4 waterVertexRise;   // (from there, 1) -> height over the plane, towards the eye; 0 for a flat mesh
out float waterHeightVSOutput;

void waterMeasure(vec4 vertex)
{
  waterHeightVSOutput = dot(waterVertexRise, vec4(vertex.xyz - waterVertexOrigin, 1.0));
}
