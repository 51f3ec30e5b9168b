// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRippleFS.glsl: slot waves: the surface's normal from sines, wind sea and normal maps
// together.

// dz/dx and dz/dy over a place in the plane's axes; see waterSlope.
vec2 waterAllSlopes(
  vec2 place, vec2 across, vec2 down, vec3 ray, inout vec4 variance, out float jacobian)
{
  vec2 sines = waterSlope(place, across, down, ray, variance, jacobian);
  vec3 bent = vec3(0.0); // of the sea, as waterBent
  vec2 sea = waterSeaSlope(place, across, down, variance, bent);
  return waterFolded(sines, sea, bent, jacobian) + waterMapSlope(place, across, down, variance);
}

void waterRipple(inout WaterPoint point)
{
  vec2 slope = waterFlowingSlopes(
    point, vec3(point.ray.xy, waterSide * point.ray.z), point.variance, point.jacobian);
  point.even = waterEven;
  point.both += waterBoth;
  point.normal = normalize(vec3(-waterSide * slope - point.tilt, 1.0));
}
