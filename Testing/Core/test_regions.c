// SPDX-License-Identifier: BSD-3-Clause
// test_regions.c: which points of a mesh hang together.
#include "test_main.h"

#include "water_regions.h"

TEST(points_that_cells_join_are_one_region)
{
  int64_t parents[7];
  water_regions_begin(parents, 7);
  const int64_t cells[3][3] = { { 6, 4, 2 }, { 1, 3, 5 }, { 2, 4, 6 } };
  for (int i = 0; i < 3; ++i)
  {
    water_regions_join(parents, cells[i], 3);
  }
  const int64_t expected[7] = { 0, 1, 2, 1, 2, 1, 2 };
  for (int64_t i = 0; i < 7; ++i)
  {
    assert_int_equal(water_regions_find(parents, i), expected[i]);
  }
}

// A long chain, joined from its end, is one region of its first point.
TEST(a_chain_is_one_region)
{
  enum
  {
    count = 10000
  };
  static int64_t parents[count];
  water_regions_begin(parents, count);
  for (int64_t i = count - 1; i > 0; --i)
  {
    const int64_t line[2] = { i, i - 1 };
    water_regions_join(parents, line, 2);
  }
  for (int64_t i = 0; i < count; i += 37)
  {
    assert_int_equal(water_regions_find(parents, i), 0);
  }
}

// A cell whose points are of three regions makes one of them; a cell of one point or none changes
// nothing.
TEST(a_cell_joins_all_regions_of_its_points)
{
  int64_t parents[6];
  water_regions_begin(parents, 6);
  const int64_t two[2][2] = { { 5, 4 }, { 3, 2 } };
  water_regions_join(parents, two[0], 2);
  water_regions_join(parents, two[1], 2);
  water_regions_join(parents, two[0], 1);
  water_regions_join(parents, NULL, 0);
  assert_int_equal(water_regions_find(parents, 5), 4);
  const int64_t all[4] = { 5, 3, 1, 4 };
  water_regions_join(parents, all, 4);
  const int64_t expected[6] = { 0, 1, 1, 1, 1, 1 };
  for (int64_t i = 0; i < 6; ++i)
  {
    assert_int_equal(water_regions_find(parents, i), expected[i]);
  }
}

TESTS(points_that_cells_join_are_one_region, a_chain_is_one_region,
  a_cell_joins_all_regions_of_its_points)
