// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPortFS.glsl: slot port: a camera behind a dome port, a half of a sphere of glass about the eye. Where a view ray
// meets the surface within it, the ray leaves the glass under water: it meets the glass at right angles, so it is
// neither bent nor reflected, and the surface is not seen. The eye is above the surface.

uniform float waterPortRadius;

// Share of a pixel whose ray begins under water; turns the normal there, in which the ray goes straight on. The
// waterline on the glass is a pixel wide, of which the larger share says where the ray goes: a normal between both would
// show a place between both.
float waterThroughPort(inout WaterPoint point)
{
  // 1 / the way to the surface, which changes evenly over the picture; 0: parallel rays, without an eye
  float near = waterPerW() * (waterDirToEye * vec4(point.ray, 0.0)).w;
  float within = (near * waterPortRadius - 1.0) / max(fwidth(near * waterPortRadius), 1e-6);
  float share = waterSide > 0.0 ? clamp(0.5 + within, 0.0, 1.0) : 0.0;
  waterAir = share * max(waterPortRadius - 1.0 / max(near, 1e-9), 0.0);
  point.normal = share > 0.5 ? -point.ray : point.normal;
  return share;
}
