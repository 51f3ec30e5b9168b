// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterSeaTiles.glsl: the tiles of a wind sea (water_cascade.h); for both shaders.

uniform sampler2DArray waterSea; // vtkWaterSea: slopes of the tiles; their bends (xx, yy, xy); what they move points by
uniform int waterSeaCount;       // tiles, from the longest waves to the shortest
uniform vec4 waterSeaTiles[3];   // where under the eye, in tiles: x, y; tiles per m; half a texel
