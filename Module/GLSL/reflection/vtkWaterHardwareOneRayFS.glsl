// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHardwareOneRayFS.glsl: slot rays for hardware: one. Several at edges (vtkWaterRaysFS.glsl) took 1.25 times the
// frame on an H200, and their code alone 1.1 times that of a wind sea.

vec3 waterMirrored(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  if (waterIsEnclosed != 0)
  {
    waterCalm = textureLod(waterReflection, point.start.xy, 0.0);
  }
  return waterFacets(point, reflectance, reason, uv);
}
