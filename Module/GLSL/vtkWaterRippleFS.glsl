// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRippleFS.glsl: stage waves: the surface's normal from the sines and the wind sea together.
// Needs vtkWaterPointFS.glsl, vtkWaterWavesFS.glsl and vtkWaterNoSeaFS.glsl before it, or
// vtkWaterSeaFS.glsl in place of the last.

void waterRipple(inout WaterPoint point)
{
  vec2 slope = waterSlope(point.place, point.across, point.down, point.variance) +
    waterSeaSlope(point.place, point.across, point.down, point.variance);
  point.normal = normalize(vec3(-waterSide * slope, 1.0));
}
