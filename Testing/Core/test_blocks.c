// SPDX-License-Identifier: BSD-3-Clause
// test_blocks.c: blocks of whole cells are large, and meet without gaps.
#include "test_main.h"

#include "water_blocks.h"

#include <math.h>
#include <string.h>

enum
{
  CELLS = WATER_BLOCKS_CELLS
};

// Cells by a rule of x and y.
typedef water_cell (*rule)(int x, int y);

static water_cell all_whole(int x, int y)
{
  (void)x;
  (void)y;
  return WATER_CELL_WHOLE;
}

static water_cell none_at_all(int x, int y)
{
  (void)x;
  (void)y;
  return WATER_CELL_NONE;
}

static water_cell one_hole(int x, int y)
{
  return x == 37 && y == 21 ? WATER_CELL_PART : WATER_CELL_WHOLE;
}

static water_cell lake(int x, int y)
{
  const double off = hypot(x - 30.0, y - 25.0) - 22.0 - 3.0 * sin(0.4 * x);
  return off < -1.0 ? WATER_CELL_WHOLE : (off < 0.5 ? WATER_CELL_PART : WATER_CELL_NONE);
}

static water_cell noise(int x, int y)
{
  const unsigned number = ((unsigned)x * 2654435761U) ^ ((unsigned)y * 40503U * 65537U);
  return (water_cell)((number >> 13) % 3U);
}

static water_cell islands(int x, int y)
{
  const water_cell there = noise(x / 8, y / 8);
  return x % 8 == 3 && y % 8 == 3 ? noise(x, y) : there;
}

static water_blocks made(rule of)
{
  water_blocks blocks;
  for (int i = 0; i < CELLS * CELLS; ++i)
  {
    blocks.cell[i / CELLS][i % CELLS] = (unsigned char)of(i % CELLS, i / CELLS);
  }
  water_blocks_merge(&blocks);
  return blocks;
}

static int count_of(const water_blocks* blocks)
{
  int count = 0;
  for (int i = 0; i < CELLS * CELLS; ++i)
  {
    count += water_blocks_begins(blocks, i % CELLS, i / CELLS) ? 1 : 0;
  }
  return count;
}

static const rule rules[] = { all_whole, none_at_all, one_hole, lake, noise, islands };
enum
{
  RULES = sizeof rules / sizeof rules[0]
};

// Each whole cell is in one block, and others in none.
TEST(blocks_cover_whole_cells_once)
{
  for (int k = 0; k < RULES; ++k)
  {
    const water_blocks blocks = made(rules[k]);
    int covered[CELLS][CELLS];
    memset(covered, 0, sizeof covered);
    for (int i = 0; i < CELLS * CELLS; ++i)
    {
      const int x = i % CELLS;
      const int y = i / CELLS;
      const int cells = 1 << blocks.size[y][x];
      for (int j = 0; water_blocks_begins(&blocks, x, y) && j < cells * cells; ++j)
      {
        ++covered[y + j / cells][x + j % cells];
      }
    }
    for (int i = 0; i < CELLS * CELLS; ++i)
    {
      const bool is_whole = blocks.cell[i / CELLS][i % CELLS] == WATER_CELL_WHOLE;
      assert_int_equal(covered[i / CELLS][i % CELLS], is_whole ? 1 : 0);
    }
  }
}

// Marks the vertices of what is drawn: corners of blocks and of cells that are not whole, and
// middles of sides.
static void mark_vertices(const water_blocks* blocks, bool is_vertex[CELLS + 1][CELLS + 1])
{
  static const int half[4][2] = { { 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 } };
  memset(is_vertex, 0, sizeof(bool[CELLS + 1][CELLS + 1]));
  for (int i = 0; i < CELLS * CELLS; ++i)
  {
    const int x = i % CELLS;
    const int y = i / CELLS;
    const bool is_block = water_blocks_begins(blocks, x, y);
    const int cells = is_block ? 1 << blocks->size[y][x] : 1;
    if (is_block || blocks->cell[y][x] == WATER_CELL_PART)
    {
      is_vertex[y][x] = is_vertex[y][x + cells] = true;
      is_vertex[y + cells][x] = is_vertex[y + cells][x + cells] = true;
    }
    for (int side = 0; side < 4 && is_block && cells > 1; ++side)
    {
      if (water_blocks_has_middle(blocks, x, y, side))
      {
        is_vertex[y + half[side][1] * cells / 2][x + half[side][0] * cells / 2] = true;
      }
    }
  }
}

// A vertex on a block's side is one of the block: there is no gap.
TEST(sides_have_the_vertices_that_lie_on_them)
{
  for (int k = 0; k < RULES; ++k)
  {
    const water_blocks blocks = made(rules[k]);
    bool is_vertex[CELLS + 1][CELLS + 1];
    mark_vertices(&blocks, is_vertex);
    for (int i = 0; i < CELLS * CELLS; ++i)
    {
      const int x = i % CELLS;
      const int y = i / CELLS;
      const int cells = 1 << blocks.size[y][x];
      for (int at = 1; water_blocks_begins(&blocks, x, y) && at < cells; ++at)
      {
        const bool is_middle = 2 * at == cells;
        assert_int_equal(
          is_vertex[y][x + at], is_middle && water_blocks_has_middle(&blocks, x, y, 0));
        assert_int_equal(
          is_vertex[y + at][x + cells], is_middle && water_blocks_has_middle(&blocks, x, y, 1));
        assert_int_equal(
          is_vertex[y + cells][x + at], is_middle && water_blocks_has_middle(&blocks, x, y, 2));
        assert_int_equal(
          is_vertex[y + at][x], is_middle && water_blocks_has_middle(&blocks, x, y, 3));
      }
    }
  }
}

// Blocks are as large as the rules let them be.
TEST(blocks_are_large)
{
  water_blocks blocks = made(all_whole);
  assert_int_equal(count_of(&blocks), 1);
  assert_int_equal(blocks.size[63][63], 6);
  blocks = made(none_at_all);
  assert_int_equal(count_of(&blocks), 0);
  blocks = made(one_hole);
  assert_in_range(count_of(&blocks), 15, 60);
  assert_int_equal(blocks.size[20][37], 0);
  assert_int_equal(blocks.size[60][3], 4);
  blocks = made(lake);
  int whole = 0;
  for (int i = 0; i < CELLS * CELLS; ++i)
  {
    whole += blocks.cell[i / CELLS][i % CELLS] == WATER_CELL_WHOLE ? 1 : 0;
  }
  assert_in_range(whole, 1000, 1600);
  assert_in_range(count_of(&blocks), 60, whole / 4);
}

// A side without anything beside it has no vertex in its middle.
TEST(the_grid_ends)
{
  const water_blocks blocks = made(all_whole);
  for (int side = 0; side < 4; ++side)
  {
    assert_false(water_blocks_has_middle(&blocks, 0, 0, side));
  }
  assert_false(water_blocks_begins(&blocks, 1, 0));
  assert_false(water_blocks_begins(&blocks, 0, 32));
}

static water_cell west(int x, int y)
{
  (void)y;
  return x < CELLS / 2 ? WATER_CELL_WHOLE : WATER_CELL_NONE;
}

static water_cell parts_at_the_border(int x, int y)
{
  const bool is_part = (x == 0 && y == 15) || (x == 15 && y == 0);
  return is_part ? WATER_CELL_PART : WATER_CELL_WHOLE;
}

// Where nothing is drawn there is no vertex either: blocks beside it stay large.
TEST(nothing_beside_a_block_makes_it_no_smaller)
{
  const water_blocks blocks = made(west);
  assert_int_equal(count_of(&blocks), 2);
  assert_int_equal(blocks.size[0][0], 5);
  for (int side = 0; side < 4; ++side)
  {
    assert_false(water_blocks_has_middle(&blocks, 0, 0, side));
  }
}

// The first row and column have neighbours, as others have.
TEST(cells_at_the_border_are_neighbours)
{
  const water_blocks blocks = made(parts_at_the_border);
  assert_int_equal(blocks.size[16][0], 1);
  assert_int_equal(blocks.size[0][16], 1);
}

static water_cell hole_beside_the_first_column(int x, int y)
{
  return x == 1 && y == 2 ? WATER_CELL_NONE : WATER_CELL_WHOLE;
}

static water_cell hole_beside_the_first_row(int x, int y)
{
  return hole_beside_the_first_column(y, x);
}

// The cell (0, 2), or (2, 0), is the only one beside a side of the block of two cells at (0, 0).
TEST(the_first_row_and_column_are_neighbours)
{
  water_blocks blocks = made(hole_beside_the_first_column);
  assert_int_equal(blocks.size[0][0], 1);
  assert_int_equal(blocks.size[2][0], 0);
  assert_true(water_blocks_has_middle(&blocks, 0, 0, 2));
  blocks = made(hole_beside_the_first_row);
  assert_int_equal(blocks.size[0][0], 1);
  assert_int_equal(blocks.size[0][2], 0);
  assert_true(water_blocks_has_middle(&blocks, 0, 0, 1));
}

TESTS(the_first_row_and_column_are_neighbours, nothing_beside_a_block_makes_it_no_smaller,
  cells_at_the_border_are_neighbours, blocks_cover_whole_cells_once,
  sides_have_the_vertices_that_lie_on_them, blocks_are_large, the_grid_ends)
