// SPDX-License-Identifier: BSD-3-Clause
// water_chunks.h: in addition to water_regions.h: a mesh's cells in chunks, so that the next step
// of the same mesh need look only at the cells near its shore.
//
// A chunk is a row of consecutive cells, each of which shares a point with the one before. If all
// of its cells are under water, they are connected. The chunks that share points are known once for
// a mesh. A chunk is inside if it and all of those that it shares points with are under water: its
// points need not be read.
#ifndef water_chunks_h
#define water_chunks_h

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

typedef enum water_chunk_kind
{
  WATER_CHUNK_LAND, // no water
  WATER_CHUNK_PART, // some
  WATER_CHUNK_RIM,  // all of it is under water, but not all beside it
  WATER_CHUNK_INSIDE
} water_chunk_kind;

// Two chunks that share a point, the first being the lower one.
typedef struct water_chunk_link
{
  int32_t chunks[2];
} water_chunk_link;

// Splits a mesh's cells into chunks.
//
// starts   cells + 1: where each cell's corners begin in the list, and where the last one's end
// corners  points
// most     cells of a chunk, >= 1
// begins   the first cell of each chunk, and cells at the end; NULL: the call only returns the
//          number of chunks
//
// Returns the number of chunks.
size_t water_chunks_split(
  const int64_t* starts, const int64_t* corners, size_t cells, size_t most, int64_t* begins);

// Finds the links. If several chunks share a point, each of them is linked to the next one that has
// it, not to all others.
//
// begins  of so many chunks
// last    one for each point: memory to work with
// seen    one for each chunk: likewise
// links   written; NULL: the call only returns their number
//
// Returns the number of links.
size_t water_chunks_link(const int64_t* starts, const int64_t* corners, const int64_t* begins,
  size_t chunks, int32_t* last, size_t points, int32_t* seen, water_chunk_link* links);

// Lists the points of each chunk, each once.
//
// last    one for each point: memory to work with
// ends    chunks + 1: where the points of each chunk begin in the list, and where
//         the last one's end
// listed  the list, written; NULL: the call only returns the number of points
//
// Returns the number of points in the list, which must be below 2^31.
size_t water_chunks_list(const int64_t* starts, const int64_t* corners, const int64_t* begins,
  size_t chunks, int32_t* last, size_t points, int32_t* ends, int32_t* listed);

// Are the points of a chunk under water?
//
// depths  above 0: it is
// points  of the chunk: count of them
//
// Returns 1: all are, 0: none is, -1: some are.
int water_chunks_water(const double* depths, const int32_t* points, size_t count);

// What chunks are.
//
// cells  0: without water, 1: under water as a whole, others: with water
// kinds  one for each chunk: water_chunk_kind
void water_chunks_judge(const int64_t* begins, size_t chunks, const water_chunk_link* links,
  size_t link_count, const char* cells, unsigned char* kinds);

// Joins the regions of chunks that are inside with those that they share points with.
//
// parents  of water_regions.h, of the points and, after them, of the chunks
void water_chunks_join(const water_chunk_link* links, size_t link_count, const unsigned char* kinds,
  int64_t* parents, size_t points);

#ifdef __cplusplus
}
#endif
#endif
