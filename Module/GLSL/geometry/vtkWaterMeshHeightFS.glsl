// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterMeshHeightFS.glsl: slot height of a user's mesh: its vertices know theirs (vtkWaterMeshVS.glsl).

in float waterHeightVSOutput;

float waterHeightOf(vec4 ndc)
{
  return waterHeightVSOutput * gl_FragCoord.w;
}
