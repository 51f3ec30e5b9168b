// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFlowVS.glsl: the way that a current goes at the vertices of a user's mesh (water_flow.h).

in vec3 waterFlowMC;           // the current, m/s along the mesh's axes; 0 where the mesh has none
uniform vec3 waterFlowAcross;  // current -> its way in a period, along the plane's first axis
uniform vec3 waterFlowDown;    // along the second
out vec2 waterFlowVSOutput;

void waterMeasureFlow()
{
  waterFlowVSOutput = vec2(dot(waterFlowAcross, waterFlowMC), dot(waterFlowDown, waterFlowMC));
}
