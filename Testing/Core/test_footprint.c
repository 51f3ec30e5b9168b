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

TESTS(half_of_the_cells_with_a_gap_make_a_solid, fifteen_cells_are_a_surface)
