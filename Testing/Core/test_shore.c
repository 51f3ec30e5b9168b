// SPDX-License-Identifier: BSD-3-Clause
// test_shore.c: where a solver's water is, from two of its level, bed and depth, and where it ends.
#include "test_main.h"

#include "water_shore.h"

#include <string.h>

TEST(two_heights_make_the_third)
{
  const double none = (double)NAN;
  const double given[4][3] = { { 3.0, 1.0, none }, { 3.0, none, 2.0 }, { none, 1.0, 2.0 },
    { 3.0, 1.0, 2.0 } };
  for (int i = 0; i < 4; ++i)
  {
    const water_column column = water_shore_column(given[i][0], given[i][1], given[i][2], 0.01);
    assert_true(column.is_wet);
    ASSERT_CLOSE(column.level, 3.0, 0.0);
    ASSERT_CLOSE(column.bed, 1.0, 0.0);
    ASSERT_CLOSE(column.depth, 2.0, 0.0);
  }
}

// Of three heights that do not agree each is kept.
TEST(three_heights_stay_as_they_are)
{
  const water_column column = water_shore_column(3.0, 0.5, 2.0, 0.01);
  ASSERT_CLOSE(column.level, 3.0, 0.0);
  ASSERT_CLOSE(column.bed, 0.5, 0.0);
  ASSERT_CLOSE(column.depth, 2.0, 0.0);
}

TEST(a_level_alone_is_wet)
{
  const water_column column = water_shore_column(3.0, (double)NAN, (double)NAN, 0.01);
  assert_true(column.is_wet);
  assert_true(isinf(column.depth) && column.depth > 0.0);
  assert_true(isinf(column.bed) && column.bed < 0.0);
}

TEST(what_is_shallow_or_no_number_is_dry)
{
  const double none = (double)NAN;
  assert_false(water_shore_column(none, 1.0, 0.01, 0.01).is_wet);
  assert_true(water_shore_column(none, 1.0, 0.011, 0.01).is_wet);
  assert_false(water_shore_column(none, 1.0, -2.0, 0.0).is_wet);
  assert_false(water_shore_column(none, 1.0, 0.0, 0.0).is_wet);
  assert_false(water_shore_column(none, none, none, 0.0).is_wet);
  assert_false(water_shore_column(none, none, 2.0, 0.0).is_wet);
  assert_false(water_shore_column((double)INFINITY, 1.0, none, 0.0).is_wet);
  // the depth says it, not level - bed
  assert_false(water_shore_column(3.0, 1.0, 0.0, 0.01).is_wet);
}

TEST(fill_values_of_files_are_dry)
{
  const double none = (double)NAN;
  const double fills[] = { 9.96921e36, 1e20, -1e20, 1.001e9, -1.001e9 };
  for (size_t i = 0; i < sizeof fills / sizeof fills[0]; ++i)
  {
    const double fill = fills[i];
    assert_false(water_shore_column(fill, none, none, 0.0).is_wet);
    assert_false(water_shore_column(fill, 1.0, none, 0.0).is_wet);
    assert_false(water_shore_column(fill, 1.0, 2.0, 0.0).is_wet);
    assert_false(water_shore_column(3.0, fill, none, 0.0).is_wet);
    assert_false(water_shore_column(3.0, fill, 2.0, 0.0).is_wet);
    assert_false(water_shore_column(none, fill, 2.0, 0.0).is_wet);
    assert_false(water_shore_column(3.0, none, fill, 0.0).is_wet);
    assert_false(water_shore_column(none, 1.0, fill, 0.0).is_wet);
    ASSERT_CLOSE(water_shore_level(none, fill), 0.0, 0.0);
    assert_true(isnan(water_shore_known(fill)));
    assert_true(water_shore_depth(false, 3.0, fill) < 0.0);
    assert_true(water_shore_depth(false, 3.0, fill) > -10.0); // the shore is not at its neighbour
  }
  assert_true(water_shore_column(none, 0.999e9, 1.0, 0.0).is_wet);
  for (double highest = -1e9; highest <= 1e9; highest += 2e9) // is a height itself
  {
    ASSERT_CLOSE(water_shore_known(highest), highest, 0.0);
    assert_true(water_shore_column(highest, none, none, 0.0).is_wet);
    ASSERT_CLOSE(water_shore_level(none, highest), highest, 0.0);
  }
  ASSERT_CLOSE(water_shore_known(-0.999e9), -0.999e9, 0.0);
}

// The shore lies where the bed reaches the level, and dry land never comes under water.
TEST(depths_cross_zero_at_the_shore)
{
  ASSERT_CLOSE(water_shore_depth(true, 3.0, 1.0), 2.0, 0.0);
  ASSERT_CLOSE(water_shore_depth(false, 3.0, 4.0), -1.0, 0.0);
  ASSERT_CLOSE(water_shore_depth(false, 3.0, 2.5), -0.5, 0.0); // behind a dyke
  ASSERT_CLOSE(water_shore_depth(true, 3.0, 3.5), -0.5, 0.0);  // a corner of a wet cell
  assert_true(water_shore_depth(true, 3.0, -(double)INFINITY) > 0.0);
  assert_true(water_shore_depth(false, (double)NAN, 3.0) < 0.0);
  assert_true(water_shore_depth(false, 3.0, -(double)INFINITY) < 0.0);
}

// A dry cell whose bed lies below the water beside it is dry as a whole.
TEST(a_dry_cell_with_a_low_bed_is_behind_a_dyke)
{
  const double none = (double)NAN;
  const double far_below = -(double)INFINITY;
  const double levels[] = { 2.0, none, 3.0 }; // mean 2.5: the unknown one does not count
  const double low[] = { 1.0, 4.0, 2.4 };
  const double high[] = { 2.0, 3.0, 2.5 };
  const double half[] = { 2.6, far_below, none };
  assert_true(water_shore_is_dyke(none, levels, low, 3, 0.0));
  assert_false(water_shore_is_dyke(none, levels, high, 3, 0.0)); // just reaches the level
  assert_false(water_shore_is_dyke(none, levels, half, 3, 0.0));
  assert_true(water_shore_is_dyke(none, levels, half + 1, 2, 0.0)); // no bed is known
  assert_true(water_shore_is_dyke(none, levels + 1, high, 1, 0.0)); // no level is
  // a cell has its own bed, whatever those of its corners, and a film of water keeps nothing dry
  assert_false(water_shore_is_dyke(2.6, levels, low, 3, 0.0));
  assert_true(water_shore_is_dyke(2.4, levels, high, 3, 0.0));
  assert_false(water_shore_is_dyke(2.4, levels, high, 3, 0.2));
  assert_false(water_shore_is_dyke(2.4, levels, half + 1, 2, 0.2));
}

static void assert_corner(water_shore_corner corner, size_t from, size_t to, double share)
{
  assert_true(corner.from == from && corner.to == to);
  ASSERT_CLOSE(corner.share, share, 1e-15);
}

// A polygon is cut where its depth is 0 along its edges, which start at their wet end.
TEST(polygons_are_cut_at_the_shore)
{
  water_shore_corner corners[8];
  const double one_wet[3] = { 1.0, -1.0, -3.0 };
  assert_true(water_shore_cut(one_wet, 3, corners) == 3);
  assert_corner(corners[0], 0, 0, 0.0);
  assert_corner(corners[1], 0, 1, 0.5);
  assert_corner(corners[2], 0, 2, 0.25);
  const double one_dry[4] = { -1.0, 1.0, 2.0, 3.0 };
  assert_true(water_shore_cut(one_dry, 4, corners) == 5);
  assert_corner(corners[0], 1, 0, 0.5);
  assert_corner(corners[1], 1, 1, 0.0);
  assert_corner(corners[4], 3, 0, 0.75);
  const double all_wet[3] = { 1.0, 2.0, 3.0 };
  assert_true(water_shore_cut(all_wet, 3, corners) == 3);
  const double all_dry[3] = { -1.0, 0.0, -3.0 };
  assert_true(water_shore_cut(all_dry, 3, corners) == 0);
}

// A corner on the shore stands once, and no polygon is without an area.
TEST(a_corner_on_the_shore_stands_once)
{
  water_shore_corner corners[8];
  const double between[4] = { 1.0, 0.0, 1.0, 1.0 };
  assert_true(water_shore_cut(between, 4, corners) == 4);
  assert_corner(corners[1], 1, 1, 0.0);
  const double first[4] = { 0.0, 1.0, 1.0, 1.0 };
  assert_true(water_shore_cut(first, 4, corners) == 4);
  assert_corner(corners[0], 0, 0, 0.0);
  const double touched[3] = { 1.0, 0.0, 0.0 };
  assert_true(water_shore_cut(touched, 3, corners) == 3);
  const double beside[4] = { 1.0, 0.0, -1.0, 0.0 };
  assert_true(water_shore_cut(beside, 4, corners) == 3);
  assert_corner(corners[0], 0, 0, 0.0);
  assert_corner(corners[1], 1, 1, 0.0);
  assert_corner(corners[2], 3, 3, 0.0);
}

TEST(water_that_meets_land_twice_is_split)
{
  const double saddle[4] = { 1.0, -1.0, 1.0, -1.0 };
  const double slope[4] = { 1.0, 1.0, -1.0, -1.0 };
  assert_true(water_shore_is_split(saddle, 4));
  assert_false(water_shore_is_split(slope, 4));
  assert_false(water_shore_is_split(saddle, 3));
  assert_false(water_shore_is_split(saddle, 1));
  const double edge[4] = { 1.0, 0.0, 1.0, -1.0 }; // dry where there is no depth
  const double touched[4] = { 1.0, 1.0, 0.0, 1.0 };
  const double one[4] = { 0.0, 0.0, 0.0, 1.0 };
  const double flat[4] = { 1.0, 0.0, 0.0, -1.0 };
  const double six[6] = { 1.0, 1.0, 1.0, -1.0, -1.0, 1.0 }; // its last corner is beside the first
  assert_false(water_shore_is_split(six, 6));
  assert_false(water_shore_is_split(one, 4));
  assert_false(water_shore_is_split(flat, 4));
  assert_true(water_shore_is_split(edge, 4));
  assert_false(water_shore_is_split(touched, 4));
}

// The shore lies on the line between the wet and the dry end, in all three coordinates.
TEST(the_shore_is_a_share_of_the_way_along_its_edge)
{
  const double wet[3] = { 10.0, -4.0, 2.0 };
  const double dry[3] = { 14.0, -12.0, 3.0 };
  double point[3];
  water_shore_point(wet, dry, 0.25, point);
  ASSERT_CLOSE(point[0], 11.0, 0.0);
  ASSERT_CLOSE(point[1], -6.0, 0.0);
  ASSERT_CLOSE(point[2], 2.25, 0.0);
  water_shore_point(wet, dry, 0.0, point);
  ASSERT_CLOSE(point[2], 2.0, 0.0);
}

// The triangles of a polygon have its area, and its orientation.
TEST(triangles_cover_a_polygon)
{
  const double places[5][2] = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 3.0, 1.0 }, { 2.0, 2.0 },
    { 0.0, 2.0 } };
  double area = 0.0;
  for (size_t i = 0; i < 3; ++i)
  {
    size_t corners[3];
    water_shore_triangle(i, corners);
    const double* a = places[corners[0]];
    const double* b = places[corners[1]];
    const double* c = places[corners[2]];
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    assert_true(twice > 0.0);
    area += 0.5 * twice;
  }
  ASSERT_CLOSE(area, 5.0, 1e-15);
}

// One of each: finite, none, infinite, not given.
TEST(columns_are_those_of_single_points)
{
  enum
  {
    VALUES = 7,
    ROWS = VALUES * VALUES * VALUES
  };
  const double values[VALUES] = { 3.0, 1.0, -2.0, 0.0005, (double)NAN, (double)INFINITY,
    9.96921e36 };
  double given[3][ROWS];
  for (int i = 0; i < ROWS; ++i)
  {
    given[0][i] = values[i % VALUES];
    given[1][i] = values[i / VALUES % VALUES];
    given[2][i] = values[i / VALUES / VALUES];
  }
  for (int has = 1; has < 8; ++has)
  {
    double levels[ROWS];
    double depths[ROWS];
    double beds[ROWS];
    char are_wet[ROWS];
    const water_shore_rows rows = { has & 1 ? given[0] : NULL, has & 2 ? given[1] : NULL,
      has & 4 ? given[2] : NULL, levels, depths, beds, are_wet };
    bool is_odd = false;
    const bool said = water_shore_columns(&rows, ROWS, 0.001);
    for (int i = 0; i < ROWS; ++i)
    {
      const water_column column =
        water_shore_column(has & 1 ? water_shore_given(given[0][i]) : (double)NAN,
          has & 2 ? water_shore_given(given[1][i]) : (double)NAN,
          has & 4 ? water_shore_given(given[2][i]) : (double)NAN, 0.001);
      bool is_known = true; // a place without a value in an array that is there is dry
      for (int k = 0; k < 3; ++k)
      {
        is_known = is_known && (!(has & (1 << k)) || isfinite(given[k][i]));
      }
      assert_true(is_known || !column.is_wet);
      const double level = column.is_wet ? column.level : (double)NAN;
      const double depth = water_shore_depth(column.is_wet, level, column.bed);
      const double kept = water_shore_level(level, column.bed);
      assert_int_equal(are_wet[i], column.is_wet);
      assert_memory_equal(&depths[i], &depth, sizeof depth);
      assert_memory_equal(&levels[i], &kept, sizeof kept);
      assert_memory_equal(&beds[i], &column.bed, sizeof depth);
      is_odd = is_odd || (column.is_wet && !(depth > 0.0));
    }
    assert_int_equal(said, is_odd);
  }
}

// Levels are apart if they differ by more than a film, and by more than floats round them.
TEST(levels_of_two_waters_are_apart)
{
  assert_true(water_shore_are_apart(2.0, 2.1, 0.05));
  assert_true(water_shore_are_apart(2.1, 2.0, 0.05));
  assert_false(water_shore_are_apart(2.0, 2.04, 0.05));
  assert_false(water_shore_are_apart(2.0, 2.0, 0.0));
  assert_false(water_shore_are_apart(1e6, 1e6 + 0.1, 0.001));
  assert_true(water_shore_are_apart(-1e6, -1e6 + 1.0, 0.001));
  assert_false(water_shore_are_apart((double)NAN, 2.0, 0.0));
}

// A river that falls by a film from place to place is no water of two lakes.
TEST(lakes_differ_by_more_than_films_around_a_place)
{
  assert_true(water_shore_are_of_lakes(2.0, 2.21, 0.05));
  assert_false(water_shore_are_of_lakes(2.0, 2.19, 0.05));
  assert_false(water_shore_are_of_lakes(2.19, 2.0, 0.05));
}

TEST(lakes_are_level_at_most_of_the_shore)
{
  assert_true(water_shore_are_lakes(5, 2));
  assert_false(water_shore_are_lakes(4, 2));
  assert_true(water_shore_are_lakes(0, 0)); // ponds of one place each
  assert_false(water_shore_are_lakes(0, 1));
}

// Half of the way, if the divide's bed is as high over the level as the water is deep; at the
// divide itself, if its bed is at the level.
TEST(a_lake_ends_at_its_level_before_a_divide)
{
  ASSERT_CLOSE(water_shore_before_divide(1.0, 5.0, 6.0), 0.5, 1e-15);
  ASSERT_CLOSE(water_shore_before_divide(3.0, 5.0, 6.0), 0.75, 1e-15);
  ASSERT_CLOSE(water_shore_before_divide(3.0, 5.0, 5.0), 1.0, 0.0);
  ASSERT_CLOSE(water_shore_before_divide(1.0, 5.0, (double)NAN), 0.5, 1e-15);
}

TEST(land_has_the_level_of_its_bed)
{
  ASSERT_CLOSE(water_shore_level(2.0, 5.0), 2.0, 0.0);
  ASSERT_CLOSE(water_shore_level((double)NAN, 5.0), 5.0, 0.0);
  ASSERT_CLOSE(water_shore_level((double)NAN, -(double)INFINITY), 0.0, 0.0);
}

// A wet point whose level is its bed has no water by these two.
TEST(a_level_at_the_bed_is_no_water)
{
  const double level[1] = { 3.0 };
  const double beds[2] = { 3.0, 2.999 };
  const double depth[1] = { 2.0 };
  for (int i = 0; i < 2; ++i)
  {
    double found[3];
    char is_wet;
    const water_shore_rows rows = { level, beds + i, depth, found, found + 1, found + 2, &is_wet };
    assert_int_equal(water_shore_columns(&rows, 1, 0.0), i == 0);
    assert_true(is_wet);
  }
}

TESTS(a_level_at_the_bed_is_no_water, three_heights_stay_as_they_are,
  the_shore_is_a_share_of_the_way_along_its_edge, triangles_cover_a_polygon,
  two_heights_make_the_third, a_level_alone_is_wet, what_is_shallow_or_no_number_is_dry,
  fill_values_of_files_are_dry, depths_cross_zero_at_the_shore, polygons_are_cut_at_the_shore,
  a_dry_cell_with_a_low_bed_is_behind_a_dyke, a_corner_on_the_shore_stands_once,
  water_that_meets_land_twice_is_split, columns_are_those_of_single_points,
  land_has_the_level_of_its_bed, levels_of_two_waters_are_apart,
  lakes_differ_by_more_than_films_around_a_place, lakes_are_level_at_most_of_the_shore,
  a_lake_ends_at_its_level_before_a_divide)
