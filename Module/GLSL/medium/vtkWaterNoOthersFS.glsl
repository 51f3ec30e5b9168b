// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoOthersFS.glsl: slot others of a picture with one sample a pixel: nothing.

// One ray: several need derivatives, and registers that hardware has no use for then.
vec3 waterTransmitted(WaterPoint point)
{
  return waterTransmittedRay(point);
}
