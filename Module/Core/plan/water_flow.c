// SPDX-License-Identifier: BSD-3-Clause
#include "water_flow.h"

#include "water_math.h"

double water_flow_component(double velocity)
{
  return fabs(velocity) <= WATER_FLOW_SPEED_MAX ? velocity : 0.0;
}

water_flow water_flow_at(double time, double period)
{
  water_flow flow;
  // fmod is exact: no time is too late
  const double gone = fmod(time, period) / period;
  flow.gone[0] = gone < 0.0 ? gone + 1.0 : gone;
  flow.gone[0] = flow.gone[0] < 1.0 ? flow.gone[0] : 0.0; // rounded up, from just under 0
  flow.gone[1] = flow.gone[0] < 0.5 ? flow.gone[0] + 0.5 : flow.gone[0] - 0.5;
  flow.weight = 1.0 - fabs(2.0 * flow.gone[0] - 1.0);
  return flow;
}

void water_flow_ways(const water_axes* axes, const double mesh_to_world[16], double period,
  double metres_per_unit, double across[3], double down[3])
{
  double columns[3][3];
  for (int i = 0; i < 9; ++i)
  {
    columns[i % 3][i / 3] = mesh_to_world[4 * (i / 3) + i % 3];
  }
  // the matrix makes areas in the plane det M / |transposed M n| times as large (Nanson's formula)
  double cross[3];
  water_vec3_cross(columns[1], columns[2], cross);
  const double up[3] = { water_vec3_dot(columns[0], axes->normal),
    water_vec3_dot(columns[1], axes->normal), water_vec3_dot(columns[2], axes->normal) };
  const double size = sqrt(fabs(water_vec3_dot(columns[0], cross)) / sqrt(water_vec3_dot(up, up)));
  const double way = size > 0.0 && isfinite(size) ? period / metres_per_unit / size : 0.0;
  for (int i = 0; i < 3; ++i)
  {
    across[i] = way * water_vec3_dot(axes->x_dir, columns[i]);
    down[i] = way * water_vec3_dot(axes->y_dir, columns[i]);
  }
}

double water_flow_likeness(double longest)
{
  return longest > 0.0 ? longest / 8.0 : 1e30;
}
