// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCell.glsl: what a grid of displaced points can hold of a wave; for both shaders.

uniform vec2 waterRowDir; // of the grid, from row to row

// Share of a wave's height that is left. With fewer than two points to a wave there is no wave.
//
// cell  distances of rows and of a row's points; 0: a mesh of the user's, taken as fine enough
float waterKept(vec2 k, vec2 cell)
{
  float fromRow = dot(k, cell.x * waterRowDir);
  float fromPoint = dot(k, cell.y * vec2(-waterRowDir.y, waterRowDir.x));
  return 1.0 - smoothstep(1.5707963, 3.1415927, max(abs(fromRow), abs(fromPoint))); // pi/2, pi
}
