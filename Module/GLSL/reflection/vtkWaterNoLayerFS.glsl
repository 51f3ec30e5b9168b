// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoLayerFS.glsl: stage layer of a map in which nothing is translucent.
// Needs vtkWaterPointFS.glsl and vtkWaterLookupFS.glsl before it, or another of the latter's stage.

uniform sampler2D waterReflectionDepth; // window depth of the mirrored view, 1: nothing drawn; nearest

float waterDepthAt(vec2 uv)
{
  return textureLod(waterReflectionDepth, uv, 0.0).r;
}

void waterCross(WaterPoint point, inout WaterLook look) {}

void waterCrossFacet(WaterPoint point, vec3 normal, int i, inout WaterLook look) {}
