// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterPixelHeightFS.glsl: slot height of all other surfaces: a pixel's height over the plane follows from its depth.

uniform vec4 waterPlaneClip; // clip space point -> height over the plane; 0 for a flat sheet

// Over w.
float waterHeightOf(vec4 ndc)
{
  return dot(waterPlaneClip, ndc);
}
