// SPDX-License-Identifier: BSD-3-Clause
// test_chunks.c: chunks of a mesh's cells join the same points as the cells do one by one.
#include "test_scene.h"

#include "water_chunks.h"
#include "water_regions.h"

enum
{
  WIDTH = 40, // cells
  HEIGHT = 30,
  CELLS = WIDTH * HEIGHT,
  POINTS = (WIDTH + 1) * (HEIGHT + 1),
  MOST = 7
};

// Quads in rows, and their chunks.
typedef struct grid
{
  int64_t starts[CELLS + 1];
  int64_t corners[4 * CELLS];
  int64_t begins[CELLS + 1];
  size_t chunks;
  water_chunk_link links[8 * CELLS];
  size_t link_count;
  unsigned char kinds[CELLS];
  char cells[CELLS];
} grid;

static grid mesh;

static void split(size_t most)
{
  static int32_t last[POINTS];
  static int32_t seen[CELLS];
  mesh.chunks = water_chunks_split(mesh.starts, mesh.corners, CELLS, most, NULL);
  assert_int_equal(
    water_chunks_split(mesh.starts, mesh.corners, CELLS, most, mesh.begins), mesh.chunks);
  mesh.link_count = water_chunks_link(
    mesh.starts, mesh.corners, mesh.begins, mesh.chunks, last, POINTS, seen, NULL);
  assert_true(mesh.link_count <= sizeof mesh.links / sizeof mesh.links[0]);
  assert_int_equal(water_chunks_link(mesh.starts, mesh.corners, mesh.begins, mesh.chunks, last,
                     POINTS, seen, mesh.links),
    mesh.link_count);
}

// Cells in rows, or, shuffled, in any order.
static void lay(dice* from, bool is_shuffled)
{
  int order[CELLS];
  for (int i = 0; i < CELLS; ++i)
  {
    order[i] = i;
  }
  for (int i = CELLS - 1; is_shuffled && i > 0; --i)
  {
    const int other = (int)dice_roll(from, 0.0, i + 1.0);
    const int held = order[i];
    order[i] = order[other];
    order[other] = held;
  }
  for (int i = 0; i < CELLS; ++i)
  {
    const int64_t first = order[i] / WIDTH * (WIDTH + 1) + order[i] % WIDTH;
    const int64_t own[4] = { first, first + 1, first + WIDTH + 2, first + WIDTH + 1 };
    memcpy(mesh.corners + (ptrdiff_t)4 * i, own, sizeof own);
    mesh.starts[i] = 4 * i;
  }
  mesh.starts[CELLS] = 4 * CELLS;
}

// Lakes between land: cells with all corners wet, or some.
static void flood(dice* from)
{
  bool is_wet[POINTS];
  const double size = dice_roll(from, 2.0, 12.0);
  const double level = dice_roll(from, -0.9, 1.3);
  const double phase = dice_roll(from, 0.0, 6.0);
  for (int i = 0; i < POINTS; ++i)
  {
    const double x = i % (WIDTH + 1);
    const double y = floor(i / (WIDTH + 1.0));
    is_wet[i] = sin(x / size + phase) * cos(y / size) < level;
  }
  for (int i = 0; i < CELLS; ++i)
  {
    int wet = 0;
    for (int k = 0; k < 4; ++k)
    {
      wet += is_wet[mesh.corners[4 * i + k]] ? 1 : 0;
    }
    mesh.cells[i] = wet == 4 ? 1 : (wet > 0 ? 2 : 0);
  }
}

static bool has_land(size_t chunk)
{
  for (int64_t cell = mesh.begins[chunk]; cell < mesh.begins[chunk + 1]; ++cell)
  {
    if (mesh.cells[cell] != 1)
    {
      return true;
    }
  }
  return false;
}

// Joins the cells with water; those of a chunk that is inside are left to it.
static void join(bool has_chunks, int64_t* parents)
{
  const size_t count = has_chunks ? mesh.chunks : 1;
  for (size_t chunk = 0; chunk < count; ++chunk)
  {
    if (has_chunks && mesh.kinds[chunk] == WATER_CHUNK_INSIDE)
    {
      continue;
    }
    const int64_t begin = has_chunks ? mesh.begins[chunk] : 0;
    const int64_t end = has_chunks ? mesh.begins[chunk + 1] : CELLS;
    for (int64_t cell = begin; cell < end; ++cell)
    {
      if (mesh.cells[cell] == 1)
      {
        water_regions_join(parents, mesh.corners + 4 * cell, 4);
      }
    }
    if (has_chunks && mesh.kinds[chunk] == WATER_CHUNK_RIM)
    {
      const int64_t same[2] = { POINTS + (int64_t)chunk, mesh.corners[4 * begin] };
      water_regions_join(parents, same, 2);
    }
  }
  if (has_chunks)
  {
    water_chunks_join(mesh.links, mesh.link_count, mesh.kinds, parents, POINTS);
  }
}

// Of the whole cells: each has the same partners, with chunks and without.
static void assert_same_regions(void)
{
  static int64_t alone[POINTS];
  static int64_t parents[POINTS + CELLS];
  static int64_t partner[POINTS + CELLS]; // of a region with chunks: the one without
  static int64_t back[POINTS];
  water_regions_begin(alone, POINTS);
  water_regions_begin(parents, POINTS + mesh.chunks);
  join(false, alone);
  join(true, parents);
  memset(partner, -1, sizeof partner);
  memset(back, -1, sizeof back);
  for (size_t chunk = 0; chunk < mesh.chunks; ++chunk)
  {
    for (int64_t cell = mesh.begins[chunk]; cell < mesh.begins[chunk + 1]; ++cell)
    {
      if (mesh.cells[cell] != 1)
      {
        continue;
      }
      const bool is_inside = mesh.kinds[chunk] == WATER_CHUNK_INSIDE;
      const int64_t own = is_inside ? POINTS + (int64_t)chunk : mesh.corners[4 * cell];
      const int64_t with = water_regions_find(parents, own);
      const int64_t without = water_regions_find(alone, mesh.corners[4 * cell]);
      partner[with] = partner[with] < 0 ? without : partner[with];
      back[without] = back[without] < 0 ? with : back[without];
      assert_int_equal(partner[with], without);
      assert_int_equal(back[without], with);
    }
  }
}

TEST(chunks_join_what_their_cells_join)
{
  dice from = dice_seeded(11);
  size_t inside = 0;
  for (int i = 0; i < 400; ++i)
  {
    lay(&from, i % 8 == 7);
    split(i % 3 ? MOST : 1);
    flood(&from);
    water_chunks_judge(
      mesh.begins, mesh.chunks, mesh.links, mesh.link_count, mesh.cells, mesh.kinds);
    for (size_t chunk = 0; chunk < mesh.chunks; ++chunk)
    {
      inside += mesh.kinds[chunk] == WATER_CHUNK_INSIDE ? 1 : 0;
      assert_int_equal(mesh.kinds[chunk] >= WATER_CHUNK_RIM, !has_land(chunk));
    }
    assert_same_regions();
  }
  assert_true(inside > 1000);
}

// What is beside land is not inside; all water is.
TEST(chunks_know_what_is_beside_them)
{
  dice from = dice_seeded(12);
  lay(&from, false);
  split(MOST);
  memset(mesh.cells, 1, sizeof mesh.cells);
  water_chunks_judge(mesh.begins, mesh.chunks, mesh.links, mesh.link_count, mesh.cells, mesh.kinds);
  for (size_t i = 0; i < mesh.chunks; ++i)
  {
    assert_int_equal(mesh.kinds[i], WATER_CHUNK_INSIDE);
  }
  mesh.cells[10 * WIDTH + 20] = 2; // of the third chunk of a row: 14 to 20
  water_chunks_judge(mesh.begins, mesh.chunks, mesh.links, mesh.link_count, mesh.cells, mesh.kinds);
  for (size_t i = 0; i < mesh.chunks; ++i)
  {
    const int64_t row = mesh.begins[i] / WIDTH;
    const int64_t column = mesh.begins[i] % WIDTH;
    const bool is_near = row >= 9 && row <= 11 && column >= 7 && column <= 21;
    const bool is_it = row == 10 && column == 14;
    if (row != 10 && is_near && column != 14)
    {
      continue; // at its corners: of four chunks, those that follow each other are linked
    }
    assert_int_equal(
      mesh.kinds[i], is_it ? WATER_CHUNK_PART : (is_near ? WATER_CHUNK_RIM : WATER_CHUNK_INSIDE));
  }
  memset(mesh.cells, 0, sizeof mesh.cells);
  water_chunks_judge(mesh.begins, mesh.chunks, mesh.links, mesh.link_count, mesh.cells, mesh.kinds);
  assert_int_equal(mesh.kinds[0], WATER_CHUNK_LAND);
}

// A row ends where the next cell has none of its points, and so does a chunk of as many as allowed.
TEST(chunks_are_connected_rows_of_cells)
{
  dice from = dice_seeded(13);
  lay(&from, false);
  split(CELLS);
  assert_int_equal(mesh.chunks, HEIGHT);
  assert_int_equal(mesh.begins[1], WIDTH);
  assert_int_equal(mesh.begins[HEIGHT], CELLS);
  assert_int_equal(mesh.link_count, HEIGHT - 1);
  split(MOST);
  assert_int_equal(mesh.begins[1], MOST);
  assert_int_equal(mesh.begins[6], WIDTH);
}

// Each point of a chunk is listed once; whether they are under water says what all of its cells
// are.
TEST(chunks_list_their_points)
{
  static int32_t last[POINTS];
  static int32_t ends[CELLS + 1];
  static int32_t listed[4 * CELLS];
  static double depths[POINTS];
  dice from = dice_seeded(14);
  int found[3] = { 0, 0, 0 };
  for (int turn = 0; turn < 40; ++turn)
  {
    lay(&from, turn % 4 == 3);
    split(MOST);
    const size_t count = water_chunks_list(
      mesh.starts, mesh.corners, mesh.begins, mesh.chunks, last, POINTS, ends, NULL);
    assert_int_equal(water_chunks_list(mesh.starts, mesh.corners, mesh.begins, mesh.chunks, last,
                       POINTS, ends, listed),
      count);
    assert_int_equal(ends[mesh.chunks], count);
    const double high = dice_roll(&from, -20.0, 20.0);
    for (int i = 0; i < POINTS; ++i)
    {
      depths[i] = high + i % (WIDTH + 1) - 0.5 * WIDTH;
    }
    for (size_t chunk = 0; chunk < mesh.chunks; ++chunk)
    {
      int corners = 0;
      int wet = 0;
      for (int64_t i = 4 * mesh.begins[chunk]; i < 4 * mesh.begins[chunk + 1]; ++i)
      {
        int times = 0;
        for (int32_t j = ends[chunk]; j < ends[chunk + 1]; ++j)
        {
          times += listed[j] == mesh.corners[i] ? 1 : 0;
        }
        assert_int_equal(times, 1);
        ++corners;
        wet += depths[mesh.corners[i]] > 0.0 ? 1 : 0;
      }
      const int said =
        water_chunks_water(depths, listed + ends[chunk], (size_t)(ends[chunk + 1] - ends[chunk]));
      assert_int_equal(said, wet == corners ? 1 : (wet == 0 ? 0 : -1));
      ++found[said + 1];
    }
  }
  assert_true(found[0] > 100 && found[1] > 100 && found[2] > 100);
}

// Two cells of 32 corners are compared; of larger ones each begins a chunk, though they share
// points.
TEST(large_cells_are_chunks_of_their_own)
{
  enum
  {
    EACH = 33
  };
  for (int64_t count = 32; count <= EACH; ++count)
  {
    int64_t corners[2 * EACH];
    for (int64_t i = 0; i < count; ++i)
    {
      corners[i] = i;
      corners[2 * count - 1 - i] = i;
    }
    const int64_t starts[3] = { 0, count, 2 * count };
    int64_t begins[3];
    assert_int_equal(water_chunks_split(starts, corners, 2, MOST, begins), count == 32 ? 1 : 2);
  }
}

// A point at the water's level, with a depth of 0, is not under it.
TEST(a_point_at_the_level_is_dry)
{
  const double depths[3] = { 0.0, 0.5, 0.0 };
  const int32_t points[2][2] = { { 0, 2 }, { 1, 2 } };
  assert_int_equal(water_chunks_water(depths, points[0], 2), 0);
  assert_int_equal(water_chunks_water(depths, points[1], 2), -1);
  assert_int_equal(water_chunks_water(depths, points[1], 1), 1);
}

// Only the links that are given count, not what lies before and behind them in memory.
TEST(links_end_where_they_end)
{
  const int64_t begins[5] = { 0, 1, 2, 3, 4 };
  const char cells[4] = { 1, 0, 1, 1 };
  const water_chunk_link links[3] = { { { 0, 1 } }, { { 2, 3 } }, { { 0, 1 } } };
  unsigned char kinds[4];
  water_chunks_judge(begins, 4, links + 1, 1, cells, kinds);
  const unsigned char expected[4] = { WATER_CHUNK_INSIDE, WATER_CHUNK_LAND, WATER_CHUNK_INSIDE,
    WATER_CHUNK_INSIDE };
  assert_memory_equal(kinds, expected, sizeof kinds);
  water_chunks_judge(begins, 4, links, 1, cells, kinds);
  assert_int_equal(kinds[0], WATER_CHUNK_RIM);
}

// Of three cells in a row the first two chunks alone: neither the points nor the links of the
// third.
TEST(chunks_end_where_they_end)
{
  const int64_t starts[4] = { 0, 3, 6, 9 };
  const int64_t corners[9] = { 0, 1, 2, 2, 3, 4, 4, 5, 6 };
  int64_t begins[4];
  int32_t last[7];
  int32_t seen[3] = { 9, 9, 9 };
  int32_t ends[4] = { 9, 9, 9, 9 };
  int32_t listed[9];
  water_chunk_link links[2];
  assert_int_equal(water_chunks_split(starts, corners, 3, 1, begins), 3);
  assert_int_equal(water_chunks_link(starts, corners, begins, 2, last, 7, seen, links), 1);
  assert_int_equal(seen[2], 9);
  assert_int_equal(water_chunks_list(starts, corners, begins, 2, last, 7, ends, listed), 6);
  assert_int_equal(ends[2], 6);
  assert_int_equal(ends[3], 9);
}

TESTS(chunks_end_where_they_end, large_cells_are_chunks_of_their_own, a_point_at_the_level_is_dry,
  links_end_where_they_end, chunks_join_what_their_cells_join, chunks_know_what_is_beside_them,
  chunks_are_connected_rows_of_cells, chunks_list_their_points)
