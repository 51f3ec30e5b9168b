// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterRankRegionFS.glsl: slot region: no water outside the rank's part of the space; water_rank_region_sides.

uniform vec4 waterRankSides[6];

// At the end: what neighbours differ by is known until then.
void waterKeepToRegion(WaterPoint point)
{
  vec4 at = vec4(waterOverPlane(point), point.height, 1.0);
  bool isInside = true;
  for (int i = 0; i < 6; i += 2)
  {
    isInside = isInside && dot(waterRankSides[i], at) >= 0.0 && dot(waterRankSides[i + 1], at) > 0.0;
  }
  if (!isInside)
  {
    discard;
  }
}
