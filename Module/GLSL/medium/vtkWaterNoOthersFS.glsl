// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoOthersFS.glsl: slot others of a picture with one sample a pixel: nothing.

vec3 waterMediumWithOther(vec2 uv, float depth, int others, float begun, vec3 seen, vec3 dir, float caustic)
{
  return seen;
}

// One ray: several need derivatives, and registers that hardware has no use for then.
vec3 waterTransmitted(WaterPoint point)
{
  return waterTransmittedRay(point);
}
