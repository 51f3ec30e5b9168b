// SPDX-License-Identifier: BSD-3-Clause
// test_shore_draw.c: when a renderer cuts the shore, and where the numbers at vertices cut it.
#include "test_main.h"

#include "water_shore_draw.h"

#include <float.h>
#include <string.h>

static const water_shore_renderer able = { WATER_SHORE_CUT_AUTOMATIC, false, true, true, true };
static const water_shore_facts exact = { true, 0, 0, 0, 0, 0 };

TEST(gpus_cut_unless_told_otherwise)
{
  water_shore_renderer renderer = able;
  assert_true(water_shore_draw_is_wanted(&renderer));
  renderer.is_software = true;
  assert_false(water_shore_draw_is_wanted(&renderer));
  renderer.setting = WATER_SHORE_CUT_WHILE_DRAWN;
  assert_true(water_shore_draw_is_wanted(&renderer));
  renderer.is_software = false;
  renderer.setting = WATER_SHORE_CUT_IN_FILTER;
  assert_false(water_shore_draw_is_wanted(&renderer));
}

// A wrong driver, another mapper, or a mesh that no filter knows: whatever was set.
TEST(renderers_that_cannot_cut_do_not)
{
  for (int setting = 0; setting < WATER_SHORE_CUT_COUNT; ++setting)
  {
    for (int lack = 0; lack < 3; ++lack)
    {
      water_shore_renderer renderer = able;
      renderer.setting = (water_shore_cut_setting)setting;
      renderer.clips_well = lack != 0;
      renderer.is_plain_draw = lack != 1;
      renderer.is_of_the_mesh = lack != 2;
      assert_false(water_shore_draw_is_wanted(&renderer));
    }
  }
}

TEST(one_cell_that_would_differ_is_enough_for_the_filter)
{
  assert_true(water_shore_draw_is_exact(&exact));
  for (int i = 0; i < 6; ++i)
  {
    water_shore_facts facts = exact;
    facts.has_depths = i != 0;
    facts.dykes = i == 1;
    facts.crossed = i == 2;
    facts.shared = i == 3;
    facts.unplaced = i == 4;
    facts.unknown = i == 5;
    assert_false(water_shore_draw_is_exact(&facts));
  }
}

TEST(the_largest_water_takes_the_whole_mesh_if_most_of_it_is_its_own)
{
  assert_true(water_shore_draw_is_whole(7, 7));
  assert_true(water_shore_draw_is_whole(4, 7));
  assert_false(water_shore_draw_is_whole(3, 6));
  assert_false(water_shore_draw_is_whole(3, 7));
}

// Where a renderer cuts an edge is where the depth is 0 along it.
TEST(edges_are_cut_at_the_depth_of_zero)
{
  const double depths[4] = { 3.0, -1.0, -0.25, 0.75 };
  float distances[4];
  water_shore_distances(depths, 4, distances);
  for (int i = 0; i < 4; i += 2)
  {
    const double cut = (double)distances[i] / ((double)distances[i] - (double)distances[i + 1]);
    ASSERT_CLOSE(depths[i] + cut * (depths[i + 1] - depths[i]), 0.0, 1e-6);
  }
}

// Land has a number below 0, also where its depth is exactly 0 or no number; water one above 0,
// however shallow. The difference of two is finite.
TEST(land_and_water_have_numbers_of_their_own)
{
  const double land[5] = { 0.0, -0.0, -1e-300, (double)-INFINITY, (double)NAN };
  const double water[3] = { 1e-300, 1.0, (double)INFINITY };
  float below[5];
  float above[3];
  water_shore_distances(land, 5, below);
  water_shore_distances(water, 3, above);
  for (int i = 0; i < 5; ++i)
  {
    assert_true(below[i] <= -FLT_MIN);
    for (int j = 0; j < 3; ++j)
    {
      assert_true(above[j] >= FLT_MIN);
      assert_true(isfinite(above[j] - below[i]));
    }
  }
}

// Water where it is, at its level; land, and what is no number, in one place. Bounds grow.
TEST(land_lies_in_one_place)
{
  const double points[12] = { 1, 2, 50, 3, 4, 60, 5, 6, 70, 7, 8, 80 };
  const double levels[4] = { 0.5, 9.0, -1.0, 9.0 };
  const double depths[4] = { 2.0, -1.0, 0.1, (double)NAN };
  const double still[3] = { 1, 2, 5 };
  const double expected[12] = { 1, 2, 5, 1, 2, 5, 5, 6, -10, 1, 2, 5 };
  double places[12];
  double bounds[6] = { 1, 1, 2, 2, 5, 7 };
  water_shore_places(points, levels, depths, 4, 10.0, still, places, bounds);
  assert_memory_equal(places, expected, sizeof places);
  const double grown[6] = { 1, 5, 2, 6, -10, 7 };
  assert_memory_equal(bounds, grown, sizeof bounds);
}

// A point without depth is land, which is drawn at one place.
TEST(points_without_depth_are_land)
{
  const double points[6] = { 1.0, 2.0, 3.0, 4.0, 5.0, 6.0 };
  const double levels[2] = { 7.0, 8.0 };
  const double depths[2] = { 0.0, 1e-300 };
  const double still[3] = { 10.0, 20.0, 30.0 };
  double places[6];
  double bounds[6] = { 10.0, 10.0, 20.0, 20.0, 30.0, 30.0 };
  water_shore_places(points, levels, depths, 2, 2.0, still, places, bounds);
  const double expected[6] = { 10.0, 20.0, 30.0, 4.0, 5.0, 16.0 };
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(places[i], expected[i], 0.0);
  }
}

TESTS(points_without_depth_are_land, gpus_cut_unless_told_otherwise,
  renderers_that_cannot_cut_do_not, one_cell_that_would_differ_is_enough_for_the_filter,
  the_largest_water_takes_the_whole_mesh_if_most_of_it_is_its_own,
  edges_are_cut_at_the_depth_of_zero, land_and_water_have_numbers_of_their_own,
  land_lies_in_one_place)
