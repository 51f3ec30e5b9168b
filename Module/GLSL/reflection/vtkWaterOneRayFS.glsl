// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterOneRayFS.glsl: slot rays: one look at what a pixel reflects.

vec3 waterMirrored(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  waterLookCalm(point.start);
  return waterFacets(point, reflectance, reason, uv);
}
