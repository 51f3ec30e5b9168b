// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterHullsFS.glsl: slot hulls: no water inside hulls that float in it; the table is that of water_waterline.h.

uniform sampler2D waterHulls;     // rows of edges
uniform vec4 waterHullRows;       // x, y of the middle of all, from the point under the eye; half of their sides
uniform int waterHullAxis;        // rows lie one after another along that: 0, 1

// How often waterlines go round a place: their crossings of a line from there along the row.
int waterTurnsRound(vec2 place)
{
  ivec2 size = textureSize(waterHulls, 0);
  // along the rows' axis, and along a row
  vec2 at = waterHullAxis == 0 ? place : place.yx;
  float reach = waterHullAxis == 0 ? waterHullRows.z : waterHullRows.w;
  int row = clamp(int(floor(0.5 * (at.x / reach + 1.0) * float(size.y))), 0, size.y - 1);
  bool isNear = all(lessThanEqual(abs(place), waterHullRows.zw));
  int edges = isNear ? int(texelFetch(waterHulls, ivec2(0, row), 0).r) : 0;
  int turns = 0;
  for (int i = 1; i <= edges; ++i)
  {
    vec4 edge = texelFetch(waterHulls, ivec2(i, row), 0);
    edge = waterHullAxis == 0 ? edge : edge.yxwz;
    bool isUp = edge.z > at.x;
    bool isPassed = (edge.x > at.x) != isUp;
    float meets = edge.y + (at.x - edge.x) / (isPassed ? edge.z - edge.x : 1.0) * (edge.w - edge.y);
    turns += isPassed && meets > at.y ? (isUp ? 1 : -1) : 0;
  }
  return turns;
}

// At the end: what neighbours differ by is known until then.
void waterLeaveHulls(WaterPoint point)
{
  if (waterTurnsRound(waterOverPlane(point) - waterHullRows.xy) != 0)
  {
    discard;
  }
}
