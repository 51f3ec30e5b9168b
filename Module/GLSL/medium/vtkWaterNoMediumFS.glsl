// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoMediumFS.glsl: slot body of water that nothing is seen in.

vec3 waterTransmitted(WaterPoint point)
{
  return waterDeepColor;
}

vec3 waterSeenFrom(WaterPoint point, vec3 color)
{
  return color;
}

// Depth of the water where the pixel looks, m.
float waterTransmittedDepth(WaterPoint point)
{
  return 1e9; // not known
}

float waterTransmittedChange(WaterPoint point)
{
  return 0.0;
}
