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

TESTS(half_of_the_cells_with_a_gap_make_a_solid, fifteen_cells_are_a_surface,
  cells_in_use_are_known, a_fiftieth_of_the_top_is_under_the_water, walls_make_a_block)
