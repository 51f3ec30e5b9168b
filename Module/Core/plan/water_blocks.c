// SPDX-License-Identifier: BSD-3-Clause
#include "water_blocks.h"

#include <string.h>

// Sets the size of the blocks of a square of so many cells along each axis.
static void set_size(water_blocks* blocks, int x, int y, int cells, int size)
{
  for (int row = y; row < y + cells; ++row)
  {
    memset(blocks->size[row] + x, size, (size_t)cells);
  }
}

// Are the four quarters of a block whole blocks themselves?
static bool has_quarters(const water_blocks* blocks, int x, int y, int size)
{
  const int half = 1 << (size - 1);
  for (int i = 0; i < 4; ++i)
  {
    const int row = y + (i / 2) * half;
    const int column = x + (i % 2) * half;
    if (blocks->cell[row][column] != WATER_CELL_WHOLE || blocks->size[row][column] != size - 1)
    {
      return false;
    }
  }
  return true;
}

// The smallest size of what lies beside a block's side; its own size where there is nothing.
static int size_beside(const water_blocks* blocks, int x, int y, int side)
{
  const int own = blocks->size[y][x];
  const int cells = 1 << own;
  int smallest = own;
  for (int i = 0; i < cells; ++i)
  {
    const int column = side == 1 ? x + cells : (side == 3 ? x - 1 : x + i);
    const int row = side == 0 ? y - 1 : (side == 2 ? y + cells : y + i);
    const bool is_inside =
      column >= 0 && column < WATER_BLOCKS_CELLS && row >= 0 && row < WATER_BLOCKS_CELLS;
    if (is_inside && blocks->cell[row][column] != WATER_CELL_NONE)
    {
      const int size = blocks->size[row][column];
      smallest = size < smallest ? size : smallest;
    }
  }
  return smallest;
}

// Quarters a block that has a neighbour less than half as wide. Returns whether it had one.
static bool balance(water_blocks* blocks, int x, int y)
{
  const int size = blocks->size[y][x];
  for (int side = 0; side < 4; ++side)
  {
    if (size_beside(blocks, x, y, side) + 1 < size)
    {
      set_size(blocks, x, y, 1 << size, size - 1);
      return true;
    }
  }
  return false;
}

void water_blocks_merge(water_blocks* blocks)
{
  memset(blocks->size, 0, sizeof blocks->size);
  for (int size = 1; size <= WATER_BLOCKS_LARGEST; ++size)
  {
    const int cells = 1 << size;
    for (int y = 0; y < WATER_BLOCKS_CELLS; y += cells)
    {
      for (int x = 0; x < WATER_BLOCKS_CELLS; x += cells)
      {
        if (has_quarters(blocks, x, y, size))
        {
          set_size(blocks, x, y, cells, size);
        }
      }
    }
  }
  bool is_changed = true;
  while (is_changed) // each time a block is quartered, and none is smaller than a cell
  {
    is_changed = false;
    for (int i = 0; i < WATER_BLOCKS_CELLS * WATER_BLOCKS_CELLS; ++i)
    {
      const int x = i % WATER_BLOCKS_CELLS;
      const int y = i / WATER_BLOCKS_CELLS;
      is_changed = (water_blocks_begins(blocks, x, y) && balance(blocks, x, y)) || is_changed;
    }
  }
}

bool water_blocks_begins(const water_blocks* blocks, int x, int y)
{
  const int cells = 1 << blocks->size[y][x];
  return blocks->cell[y][x] == WATER_CELL_WHOLE && x % cells == 0 && y % cells == 0;
}

bool water_blocks_has_middle(const water_blocks* blocks, int x, int y, int side)
{
  return size_beside(blocks, x, y, side) < blocks->size[y][x];
}
