// SPDX-License-Identifier: BSD-3-Clause
// test_ground_ranks.c: a ground that is divided among processes is, once joined, the whole ground.
#include "test_main.h"

#include "water_ground.h"

#include <math.h>
#include <string.h>

enum
{
  POINTS = 129, // of a terrain along each axis
  PARTS = 4
};

// where the parts begin, on borders of cells and in the middle of them; the last is the end
static const int cuts[PARTS + 1] = { 0, 32, 57, 95, POINTS - 1 };
static const double scene[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 };
static const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };

typedef double (*height_of)(double x, double y);

static double hills(double x, double y)
{
  return 0.3 * sin(3.0 * x) * cos(2.0 * y) - 0.05;
}

static double deep(double x, double y)
{
  return 0.1 * hills(x, y) - 0.8;
}

static void place(height_of height, int i, int j, double point[3])
{
  point[0] = -2.0 + 4.0 * i / (POINTS - 1);
  point[1] = -1.0 + 2.0 * j / (POINTS - 1);
  point[2] = height(point[0], point[1]);
}

static water_ground begun(void)
{
  water_ground ground;
  assert_int_equal(water_ground_begin(&level, scene, &ground), WATER_OK);
  return ground;
}

// The faces, and the points, of the columns of a terrain from a first one up to a last one.
static void see_faces(
  height_of height, int first, int last, const water_ground* ground, water_relief* relief)
{
  for (int i = first; i < last; ++i)
  {
    for (int j = 0; j + 1 < POINTS; ++j)
    {
      double faces[2][3][3];
      place(height, i, j, faces[0][0]);
      place(height, i + 1, j, faces[0][1]);
      place(height, i, j + 1, faces[0][2]);
      place(height, i + 1, j + 1, faces[1][0]);
      memcpy(faces[1] + 1, faces[0] + 1, 2 * sizeof faces[0][0]);
      water_ground_see_face(ground, faces[0], relief);
      water_ground_see_face(ground, faces[1], relief);
    }
  }
}

static void see_points(
  height_of height, int first, int last, const water_ground* ground, water_relief* relief)
{
  for (int i = first; i <= last; ++i)
  {
    for (int j = 0; j < POINTS; ++j)
    {
      double point[3];
      place(height, i, j, point);
      water_ground_see_relief(ground, point, relief);
    }
  }
}

static void add_terrain(
  height_of height, int first, int last, const water_relief* relief, water_ground* ground)
{
  static water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = first; i <= last; ++i)
  {
    for (int j = 0; j < POINTS; ++j)
    {
      double point[3];
      place(height, i, j, point);
      water_ground_see_point(ground, point, &footprint);
    }
  }
  assert_true(water_ground_add_thing(&footprint, relief, ground));
}

static water_ground whole_of(height_of height)
{
  static water_relief relief;
  water_ground ground = begun();
  water_relief_begin(&relief);
  see_faces(height, 0, POINTS - 1, &ground, &relief);
  see_points(height, 0, POINTS - 1, &ground, &relief);
  add_terrain(height, 0, POINTS - 1, &relief, &ground);
  return ground;
}

// Joined from as many processes as there are parts, beginning with any of them.
static water_ground joined_of(height_of height, int begin, double level_at)
{
  static double numbers[PARTS][WATER_GROUND_NUMBERS];
  static double below[PARTS][WATER_GROUND_BELOW_NUMBERS];
  static water_relief relief;
  static water_relief heights;
  for (int part = 0; part < PARTS; ++part)
  {
    water_ground own = begun();
    water_relief_begin(&relief);
    see_faces(height, cuts[part], cuts[part + 1], &own, &relief);
    add_terrain(height, cuts[part], cuts[part + 1], NULL, &own);
    water_ground_write(&own, &relief, numbers[part]);
  }
  water_ground joined = begun();
  water_relief_begin(&heights);
  for (int i = 0; i < PARTS; ++i)
  {
    water_ground_join(numbers[(begin + i) % PARTS], &joined, &heights);
    assert_true(i == PARTS - 1 || !water_ground_is_under(&joined, level_at));
  }
  for (int part = 0; part < PARTS; ++part)
  {
    relief = heights;
    see_points(height, cuts[part], cuts[part + 1], &joined, &relief);
    memcpy(below[part], relief.below, sizeof below[part]);
  }
  for (int i = 0; i < PARTS; ++i)
  {
    water_relief_join_below(below[(begin + i) % PARTS], &heights);
  }
  water_ground_take_relief(&heights, &joined);
  return joined;
}

// No part has ground under all of the water; joined, in any order, they are the whole, to the bit,
// wherever the cuts are.
TEST(a_divided_terrain_is_the_whole)
{
  const struct
  {
    height_of height;
    double level;
  } cases[] = { { hills, 0.0 }, { hills, 0.2 }, { deep, 0.0 }, { deep, -0.9 } };
  for (size_t number = 0; number < sizeof cases / sizeof cases[0]; ++number)
  {
    static water_ground whole;
    whole = whole_of(cases[number].height);
    for (int begin = 0; begin < PARTS; ++begin)
    {
      static water_ground joined;
      joined = joined_of(cases[number].height, begin, cases[number].level);
      assert_memory_equal(joined.cell_low, whole.cell_low, sizeof whole.cell_low);
      assert_memory_equal(joined.corner_low, whole.corner_low, sizeof whole.corner_low);
      assert_true(water_ground_is_under(&joined, cases[number].level));
      assert_int_equal(water_ground_is_flat(&joined, cases[number].level),
        water_ground_is_flat(&whole, cases[number].level));
    }
  }
}

// All that was added travels: bounds of a wide thing, blocks, and places of the border. Corners of
// blocks stay unknown.
TEST(all_that_was_added_is_joined)
{
  static double numbers[WATER_GROUND_NUMBERS];
  static water_relief relief;
  static water_ground own;
  static water_ground joined;
  own = begun();
  water_relief_begin(&relief);
  const double wide[6] = { -2.0, 2.0, -1.0, 1.0, -1.0, -0.5 };
  water_ground_add_bounds(wide, &own);
  own.has_block[3] = true;
  own.block_from = -0.25;
  own.spread[5] = 0.125;
  own.cell_low[7][9] = 0.5;
  own.cell_has_block[7][9] = true;
  own.cell_low[7][30] = 0.5;
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    relief.height[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS] = 0.5;
  }
  water_ground_write(&own, &relief, numbers);
  joined = begun();
  water_relief_begin(&relief);
  joined.has_block[4] = true;
  joined.spread[5] = 0.25;
  joined.spread[6] = 0.5;
  water_ground_join(numbers, &joined, &relief);
  ASSERT_CLOSE(joined.bed_top, -0.5, 1e-15);
  ASSERT_CLOSE(joined.block_from, -0.25, 0.0);
  ASSERT_CLOSE(joined.spread[5], 0.125, 0.0);
  ASSERT_CLOSE(joined.spread[6], 0.5, 0.0);
  assert_true(joined.has_block[3] && joined.has_block[4] && !joined.has_block[5]);
  memset(relief.below, 0, sizeof relief.below);
  water_ground_take_relief(&relief, &joined);
  ASSERT_CLOSE(joined.corner_low[7][30], 0.5, 0.0);
  assert_true(isinf(joined.corner_low[7][9]) && joined.corner_low[7][9] < 0.0);
  assert_true(isinf(joined.corner_low[50][50]) && joined.corner_low[50][50] > 0.0);
  const water_ground before = joined;
  const water_ground nothing = begun();
  water_relief_begin(&relief);
  water_ground_write(&nothing, &relief, numbers);
  water_ground_join(numbers, &joined, &relief);
  assert_memory_equal(&joined, &before, sizeof joined);
}

TESTS(a_divided_terrain_is_the_whole, all_that_was_added_is_joined)
