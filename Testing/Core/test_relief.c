// SPDX-License-Identifier: BSD-3-Clause
// test_relief.c: the heights of a surface at the corners of cells: exact for a plane, and never
// over the surface.
#include "test_main.h"

#include "water_ground.h"
#include "water_relief.h"

#include <math.h>

static const double scene[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 };
static const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };

typedef double (*height_of)(double x, double y);

static double slope(double x, double y)
{
  return 0.3 * x - 0.2 * y + 0.013;
}

static double hills(double x, double y)
{
  return 0.3 * sin(3.0 * x) * cos(2.0 * y) - 0.05;
}

static double ridged(double x, double y)
{
  return 0.02 * fabs(fmod(12.0 * x + 7.0 * y + 40.0, 2.0) - 1.0) + 0.1 * x;
}

static const height_of lands[3] = { slope, hills, ridged };

// Corner i of a grid of points over a part of the scene, from its lowest x and y.
static void corner_of(int i, int points, double part, height_of height, double corner[3])
{
  corner[0] = -2.0 + part * 4.0 * (i % (points + 1)) / points;
  corner[1] = -1.0 + 2.0 * (i / (points + 1)) / points;
  corner[2] = height(corner[0], corner[1]);
}

static water_ground ground_of(height_of height, int points, double part)
{
  static water_relief relief;
  static water_footprint thing;
  water_ground ground;
  assert_int_equal(water_ground_begin(&level, scene, &ground), WATER_OK);
  water_footprint_begin(&thing);
  water_relief_begin(&relief);
  for (int i = 0; i < points * points; ++i)
  {
    const int first = i / points * (points + 1) + i % points;
    const int at[6] = { first, first + 1, first + points + 2, first, first + points + 2,
      first + points + 1 };
    double face[6][3];
    for (int k = 0; k < 6; ++k)
    {
      corner_of(at[k], points, part, height, face[k]);
    }
    water_ground_see_face(&ground, face, &relief);
    water_ground_see_face(&ground, face + 3, &relief);
  }
  for (int i = 0; i < (points + 1) * (points + 1); ++i)
  {
    double point[3];
    corner_of(i, points, part, height, point);
    water_ground_see_point(&ground, point, &thing);
    water_ground_see_relief(&ground, point, &relief);
  }
  assert_int_equal(water_footprint_shape_of(&thing), WATER_FOOTPRINT_SURFACE);
  assert_true(water_ground_add_thing(&thing, &relief, &ground));
  return ground;
}

static bool is_inside(const double part[12], double x, double y)
{
  for (int i = 0; i < 4; ++i)
  {
    const double* from = part + 3 * i;
    const double* to = part + 3 * ((i + 1) % 4);
    if ((to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]) < -1e-12)
    {
      return false;
    }
  }
  return true;
}

static bool is_wet(const water_ground* ground, double x, double y)
{
  const int column = (int)fmin((x + 2.0) / 4.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  const int row = (int)fmin((y + 1.0) / 2.0 * WATER_GROUND_CELLS, WATER_GROUND_CELLS - 1.0);
  double parts[24];
  const int count = water_ground_wet(ground, 0.0, column, row, parts);
  return (count > 0 && is_inside(parts, x, y)) || (count > 1 && is_inside(parts + 12, x, y));
}

// Of places on a grid: those under water without a sheet, and those over it by more than a height
// with one.
static void count_wrong(
  const water_ground* ground, height_of height, int points, double most, int* missing, int* extra)
{
  *missing = 0;
  *extra = 0;
  for (int i = 0; i < (points + 1) * (points + 1); ++i)
  {
    double at[3];
    corner_of(i, points, 1.0, height, at);
    const bool has_sheet = is_wet(ground, at[0], at[1]);
    *missing += at[2] < -1e-12 && !has_sheet ? 1 : 0;
    *extra += at[2] > most && has_sheet ? 1 : 0;
  }
}

// A slope is cut at its waterline; hills a tenth of a cell further. No water is lost.
TEST(the_sheet_ends_at_the_waterline)
{
  const double rises[2] = { 1e-9, 0.005 }; // a cell of the hills rises by 0.06
  for (int i = 0; i < 2; ++i)
  {
    int missing;
    int extra;
    const water_ground ground = ground_of(lands[i], 200, 1.0);
    count_wrong(&ground, lands[i], 200, rises[i], &missing, &extra);
    assert_int_equal(missing, 0);
    assert_int_equal(extra, 0);
  }
}

TEST(no_water_is_lost)
{
  const int points[4] = { 63, 64, 100, 333 };
  for (int i = 0; i < 12; ++i)
  {
    int missing;
    int extra;
    const water_ground ground = ground_of(lands[i / 4], points[i % 4], 1.0);
    count_wrong(&ground, lands[i / 4], points[i % 4], 1.0, &missing, &extra); // its own points
    assert_int_equal(missing, 0);
  }
}

// Where a surface ends within a cell nothing is known of the rest of it.
TEST(beyond_a_rim_all_is_wet)
{
  const water_ground ground = ground_of(slope, 200, 0.51);
  for (double y = -0.99; y < 1.0; y += 0.01)
  {
    assert_true(is_wet(&ground, 0.05, y));
    assert_true(is_wet(&ground, 1.0, y));
  }
}

TEST(walls_and_numbers_that_are_none_count_nothing)
{
  static water_relief relief;
  water_relief_begin(&relief);
  double wall[3][3] = { { 1.0, 1.0, 0.0 }, { 3.0, 3.0, 0.0 }, { 3.0, 3.0, 2.0 } };
  double none[3][3] = { { 1.0, 1.0, 0.0 }, { 9.0, 1.0, (double)NAN }, { 1.0, 9.0, 2.0 } };
  double endless[3][3] = { { 1.0, 1.0, 0.0 }, { (double)INFINITY, 1.0, 1.0 }, { 1.0, 9.0, 2.0 } };
  water_relief_add_triangle(wall, &relief);
  water_relief_add_triangle(none, &relief);
  water_relief_add_triangle(endless, &relief);
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    assert_true(
      isinf(water_relief_at(&relief, i % WATER_RELIEF_CORNERS, i / WATER_RELIEF_CORNERS)));
  }
  // far out of the grid
  double wide[3][3] = { { -1e9, -1e9, 0.5 }, { 1e9, -1e9, 0.5 }, { 0.0, 1e9, 0.5 } };
  water_relief_add_triangle(wide, &relief);
  const double points[3][3] = { { 0.5, 0.5, 0.25 }, { 1.5, 0.5, 0.5 }, { 0.5, 1.5, (double)NAN } };
  for (int i = 0; i < 3; ++i)
  {
    water_relief_add_point(points[i], &relief);
  }
  ASSERT_CLOSE(water_relief_at(&relief, 0, 0), 0.25, 1e-6);
  assert_true(isinf(water_relief_at(&relief, 1, 1))); // cells without a point are beside it
}

// What is not finite is no face, even where a face of another surface is.
TEST(endless_faces_hide_no_others)
{
  static water_relief relief;
  water_relief_begin(&relief);
  double endless[3][3] = { { 0.0, 0.0, -(double)INFINITY }, { 20.0, 0.0, 0.0 },
    { 0.0, 20.0, 0.0 } };
  double face[3][3] = { { 0.0, 0.0, 1.0 }, { 20.0, 0.0, 1.0 }, { 0.0, 20.0, 1.0 } };
  for (int i = 0; i < 3; ++i)
  {
    water_relief_add_triangle(endless, &relief);
    endless[i][2] = 0.0;
    endless[(i + 1) % 3][2] = -(double)INFINITY;
  }
  water_relief_add_triangle(face, &relief);
  ASSERT_CLOSE(relief.height[3][4], 1.0, 1e-12);
  ASSERT_CLOSE(relief.height[0][0], 1.0, 1e-12);
}

// A face gives heights to the corners in it, not to those around it, whichever way it turns, and
// not to those of a grid that it does not reach.
TEST(faces_have_the_corners_in_them)
{
  const double shape[3][2] = { { 2.5, 2.5 }, { 12.5, 3.5 }, { 4.5, 13.5 } };
  for (int order = 0; order < 6; ++order)
  {
    static water_relief relief;
    water_relief_begin(&relief);
    double face[3][3];
    for (int i = 0; i < 3; ++i)
    {
      const int k = order < 3 ? (i + order) % 3 : (6 - i + order) % 3;
      face[i][0] = shape[k][0];
      face[i][1] = shape[k][1];
      face[i][2] = 0.5 * shape[k][0] - 0.25 * shape[k][1];
    }
    water_relief_add_triangle(face, &relief);
    for (int y = 0; y < 20; ++y)
    {
      for (int x = 0; x < 20; ++x)
      {
        bool is_in = true;
        for (int i = 0; i < 3; ++i)
        {
          const double* from = shape[i];
          const double* to = shape[(i + 1) % 3];
          is_in =
            is_in && (to[0] - from[0]) * (y - from[1]) - (to[1] - from[1]) * (x - from[0]) >= 0.0;
        }
        if (is_in)
        {
          ASSERT_CLOSE(relief.height[y][x], 0.5 * x - 0.25 * y, 1e-9);
        }
        else
        {
          assert_true(isinf(relief.height[y][x]));
        }
      }
    }
  }
  static water_relief relief;
  water_relief_begin(&relief);
  double below[3][3] = { { 0.0, -5.0, 1.0 }, { 9.0, -5.0, 1.0 }, { 0.0, -3.0, 1.0 } };
  double left[3][3] = { { -5.0, 0.0, 1.0 }, { -3.0, 0.0, 1.0 }, { -5.0, 9.0, 1.0 } };
  water_relief_add_triangle(below, &relief);
  water_relief_add_triangle(left, &relief);
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    assert_true(isinf(relief.height[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS]));
  }
}

// A cell of which a corner is not known stays unknown, and so with two, also by points on its
// border.
TEST(cells_without_a_corner_stay_unknown)
{
  for (int round = 0; round < 64; ++round)
  {
    const int pair = round % 16;
    static water_relief relief;
    water_relief_begin(&relief);
    for (int i = 0; i < 4; ++i)
    {
      relief.height[7 + i / 2][5 + i % 2] = i == pair / 4 || i == pair % 4 ? (double)INFINITY : 0.5;
    }
    const double point[3] = { round / 16 % 2 == 0 ? 5.0 : 5.5, round / 32 == 0 ? 7.0 : 7.5, 0.25 };
    water_relief_add_point(point, &relief);
    assert_true(isinf(relief.below[7][5]));
  }
}

// A corner's height without what the surface reaches under it in the four cells around it, as
// water_relief.h says; minus infinity where one of them is unknown.
static double lowered_corner(const water_relief* relief, int x, int y)
{
  double most = 0.0;
  for (int row = y - 1; row <= y; ++row)
  {
    for (int column = x - 1; column <= x; ++column)
    {
      if (row >= 0 && column >= 0 && row < WATER_FOOTPRINT_CELLS && column < WATER_FOOTPRINT_CELLS)
      {
        most = fmax(most, relief->below[row][column]);
      }
    }
  }
  return relief->height[y][x] < (double)INFINITY && most < (double)INFINITY
    ? relief->height[y][x] - most
    : -(double)INFINITY;
}

// Corners are lowered by the deepest point of the cells around them, and by a quarter of the
// largest twist of those.
TEST(corners_are_lowered_by_the_cells_around_them)
{
  static water_relief relief;
  const int end = WATER_RELIEF_CORNERS - 1;
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    const int x = i % WATER_RELIEF_CORNERS;
    const int y = i / WATER_RELIEF_CORNERS;
    relief.height[y][x] = i % 89 == 5 ? (double)INFINITY : 4.0 * sin(1.7 * i) + sin(0.1 * x * y);
    if (x < end && y < end)
    {
      relief.below[y][x] = i % 97 == 3 ? (double)INFINITY : fabs(2.0 * sin(2.9 * i));
    }
  }
  int known = 0;
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    const int x = i % WATER_RELIEF_CORNERS;
    const int y = i / WATER_RELIEF_CORNERS;
    const double height = lowered_corner(&relief, x, y);
    double twist = 0.0;
    for (int row = y > 0 ? y - 1 : 0; row <= y && row < end; ++row)
    {
      for (int column = x > 0 ? x - 1 : 0; column <= x && column < end; ++column)
      {
        const double of = lowered_corner(&relief, column, row) +
          lowered_corner(&relief, column + 1, row + 1) - lowered_corner(&relief, column + 1, row) -
          lowered_corner(&relief, column, row + 1);
        twist = isfinite(of) ? fmax(twist, fabs(of)) : twist;
      }
    }
    if (isinf(height))
    {
      assert_true(water_relief_at(&relief, x, y) == -(double)INFINITY);
    }
    else
    {
      ASSERT_CLOSE(water_relief_at(&relief, x, y), height - 0.25 * twist, 1e-12);
      ++known;
    }
  }
  assert_true(known > 3000);
}

// A triangle of two sides of a millionth of a cell has an area still; a smaller one has none.
TEST(the_smallest_triangles_have_a_height)
{
  for (int i = 0; i < 2; ++i)
  {
    static water_relief relief;
    water_relief_begin(&relief);
    const double side = i == 0 ? 1e-6 : 0.9e-6;
    double face[3][3] = { { 0.0, 0.0, 3.0 }, { side, 0.0, 3.0 }, { 0.0, side, 3.0 } };
    water_relief_add_triangle(face, &relief);
    assert_int_equal(isfinite(relief.height[0][0]), i == 0);
  }
}

TESTS(the_smallest_triangles_have_a_height, endless_faces_hide_no_others,
  faces_have_the_corners_in_them, cells_without_a_corner_stay_unknown,
  corners_are_lowered_by_the_cells_around_them, the_sheet_ends_at_the_waterline, no_water_is_lost,
  beyond_a_rim_all_is_wet, walls_and_numbers_that_are_none_count_nothing)
