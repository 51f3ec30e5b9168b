// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterNoTranslucentLayerFS.glsl: slot layer of a reflection texture in which nothing is translucent.

uniform sampler2D waterReflectionDepth; // window depth of the mirrored view, 1: nothing drawn; nearest

float waterDepthAt(vec2 uv)
{
  return textureLod(waterReflectionDepth, uv, 0.0).r;
}

void waterCross(WaterPoint point, inout WaterRayHit hit) {}

void waterCrossFacet(WaterPoint point, vec3 lower, vec3 upper, inout WaterFacet facet) {}
