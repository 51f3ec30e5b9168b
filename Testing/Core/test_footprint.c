// SPDX-License-Identifier: BSD-3-Clause
// test_footprint.c: how many cells with a gap between base and top make a solid.
#include "test_main.h"

#include "water_footprint.h"

// Cells that touch no other: some have a base and a top, the others one height.
static water_footprint_shape shape_of(int cells, int solid_cells)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = 0; i < cells; ++i)
  {
    water_footprint_add(2 * (i % 4), 2 * (i / 4), 0.0, &footprint);
    water_footprint_add(2 * (i % 4), 2 * (i / 4), i < solid_cells ? 1.0 : 0.0, &footprint);
  }
  return water_footprint_shape_of(&footprint);
}

// Half of the cells is enough, less is a surface.
TEST(half_of_the_cells_with_a_gap_make_a_solid)
{
  assert_int_equal(shape_of(16, 7), WATER_FOOTPRINT_SURFACE);
  assert_true(shape_of(16, 8) != WATER_FOOTPRINT_SURFACE);
  assert_int_equal(shape_of(16, 16), WATER_FOOTPRINT_BLOCK);
}

// Of a few cells nothing is known.
TEST(fifteen_cells_are_a_surface)
{
  assert_int_equal(shape_of(15, 15), WATER_FOOTPRINT_SURFACE);
}

// The cells in use, whichever corner of the grid they are in.
TEST(cells_in_use_are_known)
{
  const int last_cell = WATER_FOOTPRINT_CELLS - 1;
  water_footprint footprint;
  water_footprint_begin(&footprint);
  assert_true(footprint.first[0] > footprint.last[0] && footprint.first[1] > footprint.last[1]);
  assert_true(isinf(water_footprint_wet_from(&footprint)));
  water_footprint_add(0, 0, 7.0, &footprint);
  assert_true(footprint.first[0] == 0 && footprint.last[0] == 0);
  assert_true(footprint.first[1] == 0 && footprint.last[1] == 0);
  ASSERT_CLOSE(water_footprint_wet_from(&footprint), 7.0, 0.0);
  water_footprint_add(5, last_cell, 9.0, &footprint);
  water_footprint_add(5, last_cell, -9.0, &footprint);
  water_footprint_add(last_cell, 3, 8.0, &footprint);
  assert_true(footprint.first[0] == 0 && footprint.last[0] == last_cell);
  assert_true(footprint.first[1] == 0 && footprint.last[1] == last_cell);
  ASSERT_CLOSE(footprint.low[last_cell][5], -9.0, 0.0);
  ASSERT_CLOSE(footprint.high[last_cell][5], 9.0, 0.0);
  int count = 0;
  for (int y = -2; y < WATER_FOOTPRINT_CELLS + 2; ++y)
  {
    for (int x = -2; x < WATER_FOOTPRINT_CELLS + 2; ++x)
    {
      count += water_footprint_has(&footprint, x, y);
    }
  }
  assert_int_equal(count, 3);
}

// Of 200 tops, the fourth lowest is a fiftieth of them; bases do not count.
TEST(a_fiftieth_of_the_top_is_under_the_water)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = 0; i < 200; ++i)
  {
    const int rank = (i * 77) % 200; // in no order
    water_footprint_add(40 + i % 20, 63 - i / 20, 10.0 + rank, &footprint);
    water_footprint_add(40 + i % 20, 63 - i / 20, -50.0, &footprint);
  }
  ASSERT_CLOSE(water_footprint_wet_from(&footprint), 13.0, 1e-4);
}

// Of 100 tops the second lowest is a fiftieth: a top at the level counts as under it, and one half
// way between the lowest and the highest is found without a rounding.
TEST(a_top_at_the_level_is_under_the_water)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = 0; i < 100; ++i)
  {
    water_footprint_add(i % 10, i / 10, i == 7 ? 0.0 : (i == 38 ? 0.5 : 1.0), &footprint);
  }
  ASSERT_CLOSE(water_footprint_wet_from(&footprint), 0.5, 0.0);
}

typedef double (*top)(double along, double across); // in [0, 1]; 0: it meets the base

static double tent(double along, double across)
{
  (void)across;
  return 1.0 - fabs(2.0 * along - 1.0);
}

static double lean_to(double along, double across)
{
  (void)across;
  return along;
}

static double cone(double along, double across)
{
  return 1.0 - 2.0 * hypot(along - 0.5, across - 0.5);
}

static double box(double along, double across)
{
  (void)along;
  (void)across;
  return 1.0;
}

// A solid of 25 x 25 cells, turned by quarters, or only its top.
static water_footprint_shape solid(top height, int quarters, bool has_base)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = 0; i < 25 * 25; ++i)
  {
    const int x = i % 25;
    const int y = i / 25;
    const int turned[4][2] = { { x, y }, { y, 24 - x }, { 24 - x, 24 - y }, { 24 - y, x } };
    const double z = height(turned[quarters][0] / 24.0, turned[quarters][1] / 24.0);
    if (z >= 0.0)
    {
      water_footprint_add(17 + x, 30 + y, z, &footprint);
      water_footprint_add(17 + x, 30 + y, has_base ? 0.0 : z, &footprint);
    }
  }
  return water_footprint_shape_of(&footprint);
}

// A block has walls along two thirds of its rim: a lean-to has three of four, a tent two, a cone
// none.
TEST(walls_make_a_block)
{
  for (int quarters = 0; quarters < 4; ++quarters)
  {
    assert_int_equal(solid(box, quarters, true), WATER_FOOTPRINT_BLOCK);
    assert_int_equal(solid(lean_to, quarters, true), WATER_FOOTPRINT_BLOCK);
    assert_int_equal(solid(tent, quarters, true), WATER_FOOTPRINT_OBJECT);
    assert_int_equal(solid(cone, quarters, true), WATER_FOOTPRINT_OBJECT);
    assert_int_equal(solid(box, quarters, false), WATER_FOOTPRINT_SURFACE);
    assert_int_equal(solid(cone, quarters, false), WATER_FOOTPRINT_SURFACE);
  }
}

// A tent over 22 columns, whose first and last meet the base: the other columns have a wall at both
// ends. Of the 60 ends with 8 rows 40 have a wall, two thirds; with 9 rows it is less.
TEST(walls_along_two_thirds_of_the_rim_are_enough)
{
  for (int rows = 8; rows <= 9; ++rows)
  {
    water_footprint footprint;
    water_footprint_begin(&footprint);
    for (int i = 0; i < 22 * rows; ++i)
    {
      const int column = i % 22;
      water_footprint_add(column, i / 22, 0.0, &footprint);
      water_footprint_add(column, i / 22, column < 11 ? column : 21 - column, &footprint);
    }
    assert_int_equal(water_footprint_shape_of(&footprint),
      rows == 8 ? WATER_FOOTPRINT_BLOCK : WATER_FOOTPRINT_OBJECT);
  }
}

// A wall is four fifths as thick as the solid one cell further in, and no less.
TEST(a_wall_is_four_fifths_as_thick)
{
  const double walls[2] = { 0.8, 0.79 };
  for (int i = 0; i < 2; ++i)
  {
    water_footprint footprint;
    water_footprint_begin(&footprint);
    for (int j = 0; j < 20 * 20; ++j)
    {
      const int x = j % 20;
      const int y = j / 20;
      const bool is_rim = x == 0 || y == 0 || x == 19 || y == 19;
      water_footprint_add(x, y, 0.0, &footprint);
      water_footprint_add(x, y, is_rim ? walls[i] : 1.0, &footprint);
    }
    assert_int_equal(water_footprint_shape_of(&footprint),
      i == 0 ? WATER_FOOTPRINT_BLOCK : WATER_FOOTPRINT_OBJECT);
  }
}

// A box with a brim two cells wide that has no thickness: top and base meet along its rim.
TEST(a_flat_brim_is_no_wall)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  for (int i = 0; i < 24 * 24; ++i)
  {
    const int x = i % 24;
    const int y = i / 24;
    const bool is_brim = x < 2 || y < 2 || x > 21 || y > 21;
    water_footprint_add(x, y, 0.0, &footprint);
    water_footprint_add(x, y, is_brim ? 0.0 : 1.0, &footprint);
  }
  // beside the brim a cell is no thicker than its step: the 18 x 18 others have a gap, over half
  assert_int_equal(water_footprint_shape_of(&footprint), WATER_FOOTPRINT_OBJECT);
}

// A slope of 45 degrees is as thick in each cell as it rises to the next one.
TEST(a_slope_is_a_surface)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    water_footprint footprint;
    water_footprint_begin(&footprint);
    for (int i = 0; i < 64; ++i)
    {
      const int cell[2] = { i % 8, i / 8 };
      water_footprint_add(cell[0], cell[1], cell[axis], &footprint);
      water_footprint_add(cell[0], cell[1], cell[axis] + 1.0, &footprint);
    }
    assert_int_equal(water_footprint_shape_of(&footprint), WATER_FOOTPRINT_SURFACE);
  }
}

// Pairs of neighbours with a high step between them, of base or top alone, are no thicker than
// that: both know the other.
TEST(either_of_two_neighbours_knows_the_step)
{
  const double heights[3][4] = { { 0.0, 1.0, 5.0, 6.0 }, { -3.0, 3.0, 3.0, 3.5 },
    { -3.5, -3.0, -3.0, 3.0 } };
  for (int i = 0; i < 12; ++i)
  {
    const double* height = heights[i / 4];
    const int axis = i & 1;
    const int first = i & 2;
    water_footprint footprint;
    water_footprint_begin(&footprint);
    for (int pair = 0; pair < 9; ++pair)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int along = 3 * (pair % 3) + (k / 2 + first / 2) % 2;
        const int across = 2 * (pair / 3);
        water_footprint_add(
          axis == 0 ? along : across, axis == 0 ? across : along, height[k], &footprint);
      }
    }
    assert_int_equal(water_footprint_shape_of(&footprint), WATER_FOOTPRINT_SURFACE);
  }
}

TESTS(either_of_two_neighbours_knows_the_step, a_slope_is_a_surface,
  walls_along_two_thirds_of_the_rim_are_enough, a_wall_is_four_fifths_as_thick,
  a_flat_brim_is_no_wall, a_top_at_the_level_is_under_the_water,
  half_of_the_cells_with_a_gap_make_a_solid, fifteen_cells_are_a_surface, cells_in_use_are_known,
  a_fiftieth_of_the_top_is_under_the_water, walls_make_a_block)
