// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoFacetsFS.glsl: slot facets of smooth water: the one that the normal is of.

// The reflection, times the reflectance.
//
// reason, uv  of the reflection
vec3 waterFacets(WaterPoint point, out float reflectance, inout int reason, inout vec2 uv)
{
  reflectance = waterReflectance < 0.0
    ? waterFresnel(waterFacing(point.ray, point.normal), waterEta) : waterReflectance;
  vec3 reflected = vec3(0.0);
  if (waterIsReflecting != 0)
  {
    reflected = reflectance * waterReflected(point, reason, uv);
  }
  return reflected;
}
