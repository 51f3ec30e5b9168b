// SPDX-License-Identifier: BSD-3-Clause
// water_blocks.h: joins whole cells of a square grid into square blocks, as large as their
// neighbours allow: a balanced quadtree. Fewer triangles cost less: software renderers shade
// squares of pixels, once for each triangle in a square.
//
// A block is at most twice as wide as its neighbours, so each side has at most one vertex of a
// neighbour, in its middle. Blocks that are drawn with that vertex leave no gaps between them.
// Source: Samet 1984, "The Quadtree and Related Hierarchical Data Structures".
#ifndef water_blocks_h
#define water_blocks_h

#include <stdbool.h>

#ifdef __cplusplus
extern "C"
{
#endif

enum
{
  WATER_BLOCKS_CELLS = 64, // along each axis: a power of 2
  WATER_BLOCKS_LARGEST = 6 // doublings of a cell
};

typedef enum water_cell
{
  WATER_CELL_NONE, // nothing is drawn there
  WATER_CELL_PART, // a part of it, with vertices between its corners
  WATER_CELL_WHOLE
} water_cell;

typedef struct water_blocks
{
  unsigned char cell[WATER_BLOCKS_CELLS][WATER_BLOCKS_CELLS]; // [y][x], water_cell
  unsigned char size[WATER_BLOCKS_CELLS][WATER_BLOCKS_CELLS]; // of the block: doublings of a cell
} water_blocks;

// Finds the sizes, from the cells.
void water_blocks_merge(water_blocks* blocks);

// Is a cell whole, and the first of its block?
bool water_blocks_begins(const water_blocks* blocks, int x, int y);

// Has a side of such a cell's block a vertex in its middle?
//
// side  0: at the lowest y, 1: at the highest x, 2: at the highest y, 3: at the lowest x
bool water_blocks_has_middle(const water_blocks* blocks, int x, int y, int side);

#ifdef __cplusplus
}
#endif
#endif
