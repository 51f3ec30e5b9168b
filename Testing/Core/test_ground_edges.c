// SPDX-License-Identifier: BSD-3-Clause
// test_ground_edges.c: the ground of a scene far from the origin, and on its own limits.
#include "test_main.h"

#include "water_ground.h"

#include <math.h>

// Far from the origin along both axes, and of different sides, so that no sign or side cancels.
static const double scene[6] = { 300.0, 304.0, 70.0, 72.0, -1.0, 1.0 };
static const water_plane plane = { { 0.0, 0.0, 1.0 }, 0.0 };
static const double near_share = 0.04; // of the scene's diagonal

static water_ground begun(void)
{
  water_ground ground;
  assert_int_equal(water_ground_begin(&plane, scene, &ground), WATER_OK);
  return ground;
}

static water_footprint empty_footprint(void)
{
  water_footprint footprint;
  water_footprint_begin(&footprint);
  return footprint;
}

// The places of the border: four along each side, counter-clockwise from the lowest corner.
static void border_place(int i, double place[2])
{
  const double along = 0.25 * (i % 4);
  const double x[4] = { 300.0 + 4.0 * along, 304.0, 304.0 - 4.0 * along, 300.0 };
  const double y[4] = { 70.0, 70.0 + 2.0 * along, 72.0, 72.0 - 2.0 * along };
  place[0] = x[i / 4];
  place[1] = y[i / 4];
}

// A cell counts for the places of the border that are near it along both axes, and for no others.
TEST(cells_count_for_the_places_near_them)
{
  const double near = near_share * hypot(4.0, 2.0);
  for (int cell = 0; cell < WATER_GROUND_CELLS * WATER_GROUND_CELLS; ++cell)
  {
    const int x = cell % WATER_GROUND_CELLS;
    const int y = cell / WATER_GROUND_CELLS;
    if (x > 8 && x < 55 && y > 8 && y < 55 && cell % 7 > 0)
    {
      continue;
    }
    water_ground ground = begun();
    ASSERT_CLOSE(ground.near, near, 1e-12);
    water_footprint thing = empty_footprint();
    water_footprint_add(x, y, 0.25, &thing);
    water_footprint_add(x, y, 0.5, &thing);
    assert_true(water_ground_add_thing(&thing, NULL, &ground));
    const double middle[2] = { 300.0 + (x + 0.5) / 16.0, 70.0 + (y + 0.5) / 32.0 };
    for (int i = 0; i < WATER_GROUND_PLACES; ++i)
    {
      double place[2];
      border_place(i, place);
      const bool is_near = fabs(place[0] - middle[0]) <= near && fabs(place[1] - middle[1]) <= near;
      assert_true(is_near ? ground.spread[i] == 0.25 : isinf(ground.spread[i]));
    }
  }
}

// A bed covers three quarters of the scene, counting only what lies in the scene, and its top may
// be as high as the water.
TEST(beds_cover_three_quarters)
{
  const struct
  {
    double bounds[6];
    bool is_bed;
  } beds[] = { { { 300.0, 303.0, 70.0, 72.0, -2.0, 0.0 }, true },
    { { 300.0, 302.9, 70.0, 72.0, -2.0, 0.0 }, false },
    { { 302.0, 900.0, 70.0, 72.0, -2.0, 0.0 }, false },
    { { -900.0, 302.0, 70.0, 72.0, -2.0, 0.0 }, false },
    { { 300.0, 304.0, 71.0, 900.0, -2.0, 0.0 }, false },
    { { 300.0, 304.0, -900.0, 71.0, -2.0, 0.0 }, false },
    { { 900.0, 903.0, 900.0, 902.0, -2.0, 0.0 }, false }, // beside the scene along both axes
    { { -900.0, 900.0, -900.0, 900.0, -2.0, 0.0 }, true } };
  for (size_t i = 0; i < sizeof beds / sizeof beds[0]; ++i)
  {
    water_ground ground = begun();
    water_ground_add_bounds(beds[i].bounds, &ground);
    assert_int_equal(water_ground_is_under(&ground, 0.0), beds[i].is_bed);
    assert_false(water_ground_is_under(&ground, -1e-9));
  }
  const double line[6] = { 300.0, 300.0, 70.0, 72.0, -1.0, 1.0 };
  water_ground ground;
  assert_int_equal(water_ground_begin(&plane, line, &ground), WATER_OK);
  water_ground_add_bounds(beds[0].bounds, &ground); // of a scene without an area there is no share
  assert_false(water_ground_is_under(&ground, 0.0));
}

static void fill_rows(water_ground* ground, int first, int end, double height)
{
  for (int y = first; y < end; ++y)
  {
    for (int x = 0; x < WATER_GROUND_CELLS; ++x)
    {
      ground->cell_low[y][x] = height;
    }
  }
}

// Thirteen places with a surface are enough, and twelve are not; six empty lines are no gap, and
// seven are one.
TEST(thirteen_places_and_six_lines)
{
  for (int count = 12; count <= 13; ++count)
  {
    water_ground ground = begun();
    fill_rows(&ground, 0, WATER_GROUND_CELLS, 0.0);
    for (int i = 0; i < count; ++i)
    {
      ground.spread[i] = 0.0;
    }
    assert_int_equal(water_ground_is_under(&ground, 0.0), count == 13);
    fill_rows(&ground, 20, 26, (double)INFINITY);
    assert_int_equal(water_ground_is_under(&ground, 0.0), count == 13);
    fill_rows(&ground, 26, 27, (double)INFINITY);
    assert_false(water_ground_is_under(&ground, 0.0));
  }
  water_ground steep = begun(); // heights in a cell may differ by 0.15 of the scene's diagonal
  fill_rows(&steep, 0, WATER_GROUND_CELLS, 0.0);
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    steep.spread[i] = 0.15 / near_share * steep.near;
  }
  assert_true(water_ground_is_under(&steep, 0.0));
  steep.spread[0] = steep.spread[1] = steep.spread[2] = steep.spread[3] = 0.7;
  assert_false(water_ground_is_under(&steep, 0.0));
  water_ground ground = begun(); // blocks count from the level with water over them on
  fill_rows(&ground, 0, WATER_GROUND_CELLS, 0.0);
  for (int i = 0; i < WATER_GROUND_PLACES; ++i)
  {
    ground.has_block[i] = true;
  }
  ground.block_from = 0.5;
  assert_true(water_ground_is_under(&ground, 0.5));
  assert_false(water_ground_is_under(&ground, 0.499));
}

// A bed is flat if three quarters of at least sixteen cells under water are within a tenth of the
// deepest. Cells at the level are not under water.
TEST(flat_beds_on_their_limits)
{
  for (int under = 15; under <= 16; ++under)
  {
    water_ground ground = begun();
    fill_rows(&ground, 0, WATER_GROUND_CELLS, 0.0); // at the level
    for (int i = 0; i < under; ++i)
    {
      ground.cell_low[0][i] = i < 12 ? -9.0 : -1.0;
    }
    ground.cell_low[0][0] = -10.0;
    assert_int_equal(water_ground_is_flat(&ground, 0.0), under == 16);
    ground.cell_low[0][1] = -8.9;
    assert_false(water_ground_is_flat(&ground, 0.0));
  }
}

// Without a relief a corner is dry if all cells within two of it are; the scene's border has fewer.
TEST(corners_see_two_cells_each_way)
{
  for (int row = 0; row < WATER_GROUND_CELLS; row += 9)
  {
    water_ground rows = begun();
    water_ground columns = begun();
    fill_rows(&rows, 0, WATER_GROUND_CELLS, 5.0);
    fill_rows(&columns, 0, WATER_GROUND_CELLS, 5.0);
    fill_rows(&rows, row, row + 1, 1.0);
    for (int y = 0; y < WATER_GROUND_CELLS; ++y)
    {
      columns.cell_low[y][row] = 1.0;
    }
    for (int i = 0; i < WATER_GROUND_CELLS; ++i)
    {
      double parts[24];
      const bool is_wet = i - row <= 2 && row - i <= 2;
      assert_int_equal(water_ground_wet(&rows, 2.0, 30, i, parts) > 0, is_wet);
      assert_int_equal(water_ground_wet(&columns, 2.0, i, 30, parts) > 0, is_wet);
    }
  }
}

// Corners exactly at the level are wet, whatever the level: drawn cell by cell, and in blocks.
TEST(corners_at_the_level_are_wet)
{
  for (int k = 0; k < 2; ++k)
  {
    const double at = k == 0 ? 0.0 : 3.0;
    water_ground ground = begun();
    for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
    {
      ground.corner_low[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS] = at;
    }
    double parts[24];
    assert_int_equal(water_ground_wet(&ground, at, 5, 6, parts), 1);
    ASSERT_CLOSE(parts[0], 300.0 + 5.0 / 16.0, 1e-12);
    ASSERT_CLOSE(parts[6], 300.0 + 6.0 / 16.0, 1e-12);
    ASSERT_CLOSE(parts[7], 70.0 + 7.0 / 32.0, 1e-12);
    ASSERT_CLOSE(parts[8], at, 0.0);
    assert_int_equal(water_ground_wet(&ground, at - 1e-9, 5, 6, parts), 0);
    water_blocks blocks;
    assert_false(water_ground_find_blocks(&ground, at, &blocks));
    assert_int_equal(blocks.cell[6][5], WATER_CELL_WHOLE);
    assert_true(water_ground_find_blocks(&ground, at - 1e-9, &blocks));
    assert_int_equal(blocks.cell[6][5], WATER_CELL_NONE);
  }
}

// A thing of which no relief is known makes the corners of its cells unknown.
TEST(things_without_a_relief_hide_corners)
{
  static water_relief relief;
  water_relief_begin(&relief);
  for (int i = 0; i < WATER_RELIEF_CORNERS * WATER_RELIEF_CORNERS; ++i)
  {
    relief.height[i / WATER_RELIEF_CORNERS][i % WATER_RELIEF_CORNERS] = 5.0;
  }
  for (int i = 0; i < WATER_FOOTPRINT_CELLS * WATER_FOOTPRINT_CELLS; ++i)
  {
    relief.below[i / WATER_FOOTPRINT_CELLS][i % WATER_FOOTPRINT_CELLS] = 0.0;
  }
  water_ground ground = begun();
  water_footprint thing = empty_footprint();
  water_footprint_add(10, 20, 5.0, &thing);
  assert_true(water_ground_add_thing(&thing, &relief, &ground));
  ASSERT_CLOSE(ground.corner_low[20][10], 5.0, 0.0);
  ASSERT_CLOSE(ground.corner_low[21][11], 5.0, 0.0);
  assert_true(water_ground_add_thing(&thing, NULL, &ground));
  assert_true(ground.corner_low[20][10] < 0.0 && isinf(ground.corner_low[20][10]));
}

// A block is a column by all of its rows and columns, and by its whole sides.
TEST(columns_are_judged_as_a_whole)
{
  for (int kind = 0; kind < 5; ++kind)
  {
    water_footprint thing = empty_footprint();
    // the shorter side is 10 cells of 1/32: 0.3125, and a column is over 0.15625 high
    const double top = kind == 3 ? 0.14 : (kind == 4 ? 0.15625 : 6.0);
    for (int i = 0; i < 100; ++i)
    {
      const int x = 10 + i % 10;
      const int y = 10 + i / 10;
      const bool is_low = (kind == 1 && y == 19) || (kind == 2 && x == 19);
      water_footprint_add(x, y, 0.0, &thing);
      water_footprint_add(x, y, is_low ? 0.6 * top : top, &thing);
    }
    assert_int_equal(water_footprint_shape_of(&thing), WATER_FOOTPRINT_BLOCK);
    water_ground ground = begun();
    assert_int_equal(water_ground_add_thing(&thing, NULL, &ground), kind > 0);
  }
}

// Samples of a triangle: two sides in cells, wherever the scene is.
TEST(samples_are_two_sides_in_cells)
{
  water_ground ground = begun();
  ground.spread[0] = ground.near + 1e-6; // no side of the scene
  double corners[3][3] = { { 301.0, 71.0, -50.0 }, { 302.0, 71.0, 0.0 }, { 301.0, 71.5, 50.0 } };
  assert_int_equal(water_ground_across(&ground, corners), 16);
  corners[1][1] = 71.75;
  assert_int_equal(water_ground_across(&ground, corners), 40);
  const double line[6] = { 300.0, 304.0, 70.0, 70.0, -1.0, 1.0 };
  assert_int_equal(water_ground_begin(&plane, line, &ground), WATER_OK);
  assert_int_equal(water_ground_across(&ground, corners), 16); // of a side without a length: 1
}

// A cell whose middle is exactly as far away as that counts, along either axis.
TEST(a_cell_at_the_limit_is_near)
{
  for (int axis = 0; axis < 2; ++axis)
  {
    // cells of 1 along the axis; 0.04 of the diagonal is 4.5, as far as the middle of the fifth
    double bounds[6] = { 0.0, 64.0, 0.0, 64.0, -1.0, 1.0 };
    bounds[3 - 2 * axis] = sqrt(112.5 * 112.5 - 64.0 * 64.0);
    water_ground ground;
    assert_int_equal(water_ground_begin(&plane, bounds, &ground), WATER_OK);
    ASSERT_CLOSE(ground.near, 4.5, 0.0);
    for (int far = 4; far <= 5; ++far)
    {
      water_ground lit = ground;
      water_footprint thing = empty_footprint();
      water_footprint_add(axis == 0 ? far : 0, axis == 0 ? 0 : far, 0.5, &thing);
      assert_true(water_ground_add_thing(&thing, NULL, &lit));
      assert_int_equal(isfinite(lit.spread[0]), far == 4);
    }
    // as far from its side as from the nearest place of that side
    water_ground lit = ground;
    water_footprint thing = empty_footprint();
    water_footprint_add(axis == 0 ? 4 : 16, axis == 0 ? 48 : 4, 0.5, &thing);
    assert_true(water_ground_add_thing(&thing, NULL, &lit));
    assert_true(isfinite(lit.spread[axis == 0 ? 13 : 1]));
  }
}

TESTS(a_cell_at_the_limit_is_near, cells_count_for_the_places_near_them, beds_cover_three_quarters,
  thirteen_places_and_six_lines, flat_beds_on_their_limits, corners_see_two_cells_each_way,
  corners_at_the_level_are_wet, things_without_a_relief_hide_corners, columns_are_judged_as_a_whole,
  samples_are_two_sides_in_cells)
