// SPDX-License-Identifier: BSD-3-Clause
// test_triangle_cull.h: a view and its triangles, for the tests of single triangles.
#ifndef test_triangle_cull_h
#define test_triangle_cull_h

#include "test_scene.h"

#include "water_triangle_cull.h"

enum
{
  WIDTH = 50, // of the drawn part
  HEIGHT = 40,
  PIXELS = WIDTH * HEIGHT
};

static const double focal = 1.5;
static const double near = 1.0;
static const double far = 100.0;

// An eye at the origin that looks along -z; above -3 in y is kept.
static inline water_triangle_cull_view view_made(float* depths)
{
  const double by_z = -(far + near) / (far - near);
  const double alone = -2.0 * far * near / (far - near);
  const water_triangle_cull_view made = { .to_clip = { focal, 0, 0, 0, 0, focal, 0, 0, 0, 0, by_z,
                                            alone, 0, 0, -1, 0 },
    .kept = { 0.0, 1.0, 0.0, 3.0 },
    .texture_px = { 64, 48 },
    .rect_px = { 5, 3, WIDTH, HEIGHT },
    .columns = { 0, WIDTH },
    .grid_px = 1.0 / 16.0,
    .depths = depths,
    .is_solid = true };
  return made;
}

static inline bool is_kept(const water_triangle_cull_view* view, float place[3][3])
{
  static const uint32_t triangle[3] = { 0, 1, 2 };
  const water_points points = { &place[0][0], NULL };
  double box[6] = { DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX };
  water_corner corners[3];
  for (int i = 0; i < 3; ++i)
  {
    water_triangle_cull_project(view, &points, triangle[i], corners + i);
    for (int j = 0; j < 3; ++j)
    {
      box[2 * j] = fmin(box[2 * j], (double)place[i][j]);
      box[2 * j + 1] = fmax(box[2 * j + 1], (double)place[i][j]);
    }
  }
  water_triangle_cull_slack slack;
  water_triangle_cull_allow(view, box, &slack);
  const water_corner* const all[3] = { corners, corners + 1, corners + 2 };
  return water_triangle_cull_add(view, &slack, all);
}

// A triangle on the reflection texture, all of it at one depth and height and at w = 1.
static inline bool is_kept_at(const water_triangle_cull_view* view,
  const water_triangle_cull_slack* slack, const double px[3][2], double depth, double height)
{
  water_corner corners[3];
  for (int i = 0; i < 3; ++i)
  {
    const water_corner made = { { 0.0, 0.0, depth, 1.0 }, 1.0, { px[i][0], px[i][1] }, depth,
      height };
    corners[i] = made;
  }
  const water_corner* const all[3] = { corners, corners + 1, corners + 2 };
  return water_triangle_cull_add(view, slack, all);
}

#endif
