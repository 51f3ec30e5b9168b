// SPDX-License-Identifier: BSD-3-Clause
// test_heights.c: a level, depth or bed in another unit is found, and no water that there is.
#include "test_heights.h"

enum
{
  COUNT = 400
};

// A coast of 20 places by 20, in metres: land rises to the east; the level is that of the water, or
// the bed of dry places.
typedef struct coast
{
  double level[COUNT];
  double depth[COUNT];
  double bed[COUNT];
} coast;

static coast coast_of(double lowest, double highest, double sea, double wave)
{
  coast made;
  for (int i = 0; i < COUNT; ++i)
  {
    const double x = (i % 20) / 19.0;
    const double y = (i / 20) / 19.0;
    made.bed[i] = lowest + (highest - lowest) * (0.9 * x + 0.1 * x * y);
    const double level = sea + wave * sin(9.0 * x + 5.0 * y);
    made.level[i] = fmax(level, made.bed[i]);
    made.depth[i] = made.level[i] - made.bed[i];
  }
  return made;
}

static void scale(double* values, double factor)
{
  for (int i = 0; i < COUNT; ++i)
  {
    values[i] *= factor;
  }
}

static void assert_fine(const coast* data)
{
  assert_true(
    water_heights_judge(data->level, data->depth, data->bed, COUNT).wrong == WATER_HEIGHT_NONE);
  assert_true(water_heights_judge(data->level, NULL, data->bed, COUNT).wrong == WATER_HEIGHT_NONE);
}

// Deep seas, flat floors, dry basins, high waves, tanks, mountain lakes and rivers.
TEST(no_water_that_there_is_has_a_wrong_unit)
{
  const double waters[][4] = { { -20.0, 5.0, 0.0, 0.5 }, { -5000.0, -4990.0, 0.0, 1.0 },
    { -4000.0, 500.0, 0.0, 30.0 }, { -400.0, 50.0, -430.0, 0.0 }, { 0.0, 30.0, -5.0, 0.0 },
    { 0.0, 0.0, 1.0, 0.1 }, { 0.0, 0.01, 1.0, 0.1 }, { 0.1, 0.11, 1.0, 0.2 },
    { 350.0, 400.0, 384.0, 0.0 }, { 1397.0, 1400.0, 1897.0, 0.0 }, { 10.0, 10.0, 30.0, 0.0 },
    { 100.0, 110.0, 300.0, 0.5 }, { -60.0, 800.0, 12.0, 40.0 }, { -1e-3, 1e-3, 0.0, 1e-4 } };
  for (size_t i = 0; i < sizeof waters / sizeof waters[0]; ++i)
  {
    const coast data = coast_of(waters[i][0], waters[i][1], waters[i][2], waters[i][3]);
    assert_fine(&data);
  }
}

// What marks dry places says nothing, nor do places without numbers.
TEST(marks_of_dry_places_are_no_levels)
{
  const double marks[] = { -9999.0, 1e20, (double)NAN, (double)INFINITY, 0.0 };
  for (size_t i = 0; i < sizeof marks / sizeof marks[0]; ++i)
  {
    coast data = coast_of(-20.0, 5.0, 0.0, 0.5);
    for (int j = 0; j < COUNT; ++j)
    {
      data.level[j] = data.depth[j] > 0.0 ? data.level[j] : marks[i];
    }
    assert_fine(&data);
  }
}

// With all three, the one that is in centimetres, millimetres or feet is found.
TEST(the_height_in_another_unit_is_found)
{
  const double factors[] = { 1000.0, 100.0, 1.0 / 0.3048, 0.3048, 0.01, 0.001 };
  for (size_t i = 0; i < sizeof factors / sizeof factors[0]; ++i)
  {
    for (int which = WATER_HEIGHT_LEVEL; which <= WATER_HEIGHT_BED; ++which)
    {
      coast data = coast_of(320.0, 400.0, 384.0, 0.1);
      scale(which == WATER_HEIGHT_LEVEL ? data.level
          : which == WATER_HEIGHT_DEPTH ? data.depth
                                        : data.bed,
        factors[i]);
      assert_wrong(water_heights_judge(data.level, data.depth, data.bed, COUNT),
        (water_height)which, factors[i]);
    }
  }
}

// Solvers write the bed as the level of dry land, and so it is in the level's unit.
TEST(dry_land_tells_the_unit_of_the_level)
{
  coast data = coast_of(-20.0, 15.0, 0.3, 0.1);
  scale(data.level, 100.0);
  assert_wrong(water_heights_judge(data.level, NULL, data.bed, COUNT), WATER_HEIGHT_LEVEL, 100.0);
}

// Levels of a sea in centimetres lie far under a bed in metres, where no water is.
TEST(levels_under_all_land_are_in_another_unit)
{
  coast data = coast_of(-20.0, 5.0, 0.0, 0.0);
  for (int i = 0; i < COUNT; ++i)
  {
    data.level[i] = 150.0 * sin(0.1 * i);
  }
  assert_wrong(water_heights_judge(data.level, NULL, data.bed, COUNT), WATER_HEIGHT_LEVEL, 0.0);
}

// A lake in feet drowns land in metres.
TEST(a_lake_in_feet_is_found)
{
  coast data = coast_of(350.0, 400.0, 384.0, 0.0);
  for (int i = 0; i < COUNT; ++i)
  {
    data.level[i] = 384.0 / 0.3048;
  }
  assert_wrong(
    water_heights_judge(data.level, NULL, data.bed, COUNT), WATER_HEIGHT_LEVEL, 1.0 / 0.3048);
}

TEST(depth_and_bed_in_two_units_are_found)
{
  static const double units[] = { 1000.0, 100.0, 1.0 / 0.3048, 0.3048, 0.01, 0.001 };
  for (size_t i = 0; i < sizeof units / sizeof units[0]; ++i)
  {
    coast data = coast_of(300.0, 330.0, 312.0, 0.2);
    scale(data.depth, units[i]);
    assert_wrong(
      water_heights_judge(NULL, data.depth, data.bed, COUNT), WATER_HEIGHT_DEPTH, units[i]);
  }
}

// Calm water, high waves, a flat tank, and a film of water on a slope.
TEST(depth_and_bed_of_one_unit_are_fine)
{
  static const double waters[][4] = { { 300.0, 330.0, 312.0, 0.0 }, { -20.0, 5.0, 0.0, 4.0 },
    { 0.0, 1e-6, 1.0, 0.4 }, { -5000.0, -4990.0, 0.0, 1.0 } };
  for (size_t i = 0; i < sizeof waters / sizeof waters[0]; ++i)
  {
    const coast data = coast_of(waters[i][0], waters[i][1], waters[i][2], waters[i][3]);
    assert_true(water_heights_judge(NULL, data.depth, data.bed, COUNT).wrong == WATER_HEIGHT_NONE);
  }
  coast film = coast_of(0.0, 100.0, 0.0, 0.0);
  for (int i = 0; i < COUNT; ++i)
  {
    film.depth[i] = 0.01 + 0.002 * sin(0.7 * i);
  }
  assert_true(water_heights_judge(NULL, film.depth, film.bed, COUNT).wrong == WATER_HEIGHT_NONE);
}

TEST(two_heights_are_needed)
{
  const coast data = coast_of(-20.0, 5.0, 0.0, 0.5);
  assert_true(water_heights_judge(data.level, data.depth, NULL, COUNT).wrong == WATER_HEIGHT_NONE);
  assert_true(water_heights_judge(NULL, data.depth, data.bed, COUNT).wrong == WATER_HEIGHT_NONE);
  assert_true(water_heights_judge(data.level, data.depth, data.bed, 0).wrong == WATER_HEIGHT_NONE);
  assert_true(water_heights_judge(data.level, NULL, data.bed, 0).wrong == WATER_HEIGHT_NONE);
}

// One level for all places, dry ones too, as terrains have it.
TEST(dry_places_tell_nothing_of_the_depth)
{
  const double factors[] = { 1000.0, 100.0, 0.01 };
  for (int k = 0; k < 3; ++k)
  {
    coast data = coast_of(236.0, 1076.0, 384.0, 0.0);
    for (int i = 0; i < COUNT; ++i)
    {
      data.level[i] = 384.0;
    }
    assert_true(
      water_heights_judge(data.level, data.depth, data.bed, COUNT).wrong == WATER_HEIGHT_NONE);
    scale(data.depth, factors[k]);
    assert_wrong(
      water_heights_judge(data.level, data.depth, data.bed, COUNT), WATER_HEIGHT_DEPTH, factors[k]);
    scale(data.depth, 1.0 / factors[k]);
    scale(data.level, factors[k]);
    assert_wrong(
      water_heights_judge(data.level, data.depth, data.bed, COUNT), WATER_HEIGHT_LEVEL, factors[k]);
  }
}

// Calm water at 0 is at 0 in each unit; the level of the dry places around it is not.
TEST(dry_places_tell_the_unit_of_a_level_of_0)
{
  coast data = coast_of(-20.0, 15.0, 0.0, 0.0);
  scale(data.level, 100.0);
  assert_wrong(
    water_heights_judge(data.level, data.depth, data.bed, COUNT), WATER_HEIGHT_LEVEL, 100.0);
}

// Fewer than ten places are no evidence, of the sum, of dry land or of deep levels.
TEST(nine_places_are_too_few)
{
  for (int few = 9; few <= 10; ++few)
  {
    const bool is_told = few == 10;
    coast data = coast_of(320.0, 400.0, 310.0, 0.0); // all dry
    for (int i = 0; i < few; ++i)
    {
      data.depth[i] = 100.0 * (2.0 + 0.1 * i);
      data.level[i] = data.bed[i] + 0.01 * data.depth[i];
    }
    water_heights_verdict verdict = water_heights_judge(data.level, data.depth, data.bed, COUNT);
    assert_true((verdict.wrong == WATER_HEIGHT_DEPTH) == is_told);
    // dry land in centimetres, and a sea
    double level[20];
    double bed[20];
    for (int i = 0; i < 20; ++i)
    {
      bed[i] = i < few ? 2.0 + i : -9.0 - i;
      level[i] = i < few ? 100.0 * bed[i] : 0.0;
    }
    verdict = water_heights_judge(level, NULL, bed, 20);
    assert_true((verdict.wrong == WATER_HEIGHT_LEVEL) == is_told);
    // levels far under the lowest bed
    for (int i = 0; i < 20; ++i)
    {
      bed[i] = -0.5 * i;
      level[i] = i < few ? -100.0 - 3.0 * i : 0.0;
    }
    verdict = water_heights_judge(level, NULL, bed, 20);
    assert_true((verdict.wrong == WATER_HEIGHT_LEVEL) == is_told);
  }
}

// Land whose heights hardly differ fits a calm level by chance; land with relief does not.
TEST(flat_land_tells_nothing)
{
  const double reliefs[2] = { 0.04, 0.06 };
  for (int k = 0; k < 2; ++k)
  {
    double level[40];
    double bed[40];
    for (int i = 0; i < 40; ++i)
    {
      const bool is_land = i < 20;
      bed[i] = is_land ? 10.0 * (1.0 - reliefs[k] * i / 19.0) : -20.0;
      level[i] = is_land ? 100.0 * bed[i] : 0.0;
    }
    const water_heights_verdict verdict = water_heights_judge(level, NULL, bed, 40);
    assert_true((verdict.wrong == WATER_HEIGHT_LEVEL) == (k == 1));
  }
}

// A flat tank with waves about its bed: a bed without relief is no measure of how far that is.
TEST(a_flat_tank_has_no_wrong_unit)
{
  double level[40];
  double bed[40];
  for (int i = 0; i < 40; ++i)
  {
    bed[i] = 0.0;
    level[i] = 0.1 * sin(0.5 * i);
  }
  assert_int_equal(water_heights_judge(level, NULL, bed, 40).wrong, WATER_HEIGHT_NONE);
}

// Depths next to none fit any unit, and neither hide nor make a mistake.
TEST(films_of_water_are_no_evidence)
{
  double level[120];
  double depth[120];
  double bed[120];
  for (int i = 0; i < 120; ++i)
  {
    const double right = i < 20 ? 1.0 + 0.01 * i : 1e-7;
    bed[i] = 10.0;
    level[i] = bed[i] + right;
    depth[i] = i < 20 ? 100.0 * right : right;
  }
  const water_heights_verdict verdict = water_heights_judge(level, depth, bed, 120);
  assert_true(verdict.wrong == WATER_HEIGHT_DEPTH);
  ASSERT_CLOSE(verdict.factor, 100.0, 1e-12);
}

// A level that is a round multiple of a flat bed's height is one by chance.
TEST(a_flat_bed_at_a_hundredth_of_the_level_is_right)
{
  double level[40];
  double bed[40];
  for (int i = 0; i < 40; ++i)
  {
    bed[i] = 10.0;
    level[i] = 1000.0;
  }
  assert_int_equal(water_heights_judge(level, NULL, bed, 40).wrong, WATER_HEIGHT_NONE);
}

// Levels far under all land mean something if they are more than a twentieth of all.
TEST(a_twentieth_under_the_land_tells_nothing)
{
  double level[200];
  double bed[200];
  for (int i = 0; i < 200; ++i)
  {
    bed[i] = 0.05 * i;
    level[i] = i < 10 ? -100.0 - 3.0 * i : bed[i];
  }
  assert_int_equal(water_heights_judge(level, NULL, bed, 200).wrong, WATER_HEIGHT_NONE);
  assert_int_equal(water_heights_judge(level, NULL, bed, 199).wrong, WATER_HEIGHT_LEVEL);
}

// A depth is evidence if it is over a thousandth of the largest one; at a thousandth it is none.
TEST(a_thousandth_of_the_depth_is_no_evidence)
{
  const double shallow[2] = { 1.0, 1.01 };
  for (int k = 0; k < 2; ++k)
  {
    double level[60];
    double depth[60];
    double bed[60];
    for (int i = 0; i < 60; ++i)
    {
      const double right = i < 9 ? 1000.0 : shallow[k];
      bed[i] = 10.0;
      level[i] = bed[i] + right;
      depth[i] = 1000.0 * right;
    }
    const water_heights_verdict verdict = water_heights_judge(level, depth, bed, 60);
    assert_int_equal(verdict.wrong, k == 0 ? WATER_HEIGHT_NONE : WATER_HEIGHT_DEPTH);
  }
}

// Places without a value change no verdict, whichever height they lack and whichever are given.
TEST(places_without_values_tell_nothing)
{
  for (int lacking = 0; lacking < 6; ++lacking)
  {
    const double none = lacking % 2 == 0 ? (double)NAN : (double)INFINITY;
    coast all = coast_of(320.0, 400.0, 384.0, 0.1);
    coast land = coast_of(-20.0, 15.0, 0.3, 0.1);
    coast deep = coast_of(-20.0, 5.0, 0.0, 0.0);
    coast tank = coast_of(300.0, 330.0, 312.0, 0.2);
    scale(all.depth, 100.0);
    scale(land.level, 100.0);
    scale(tank.depth, 1000.0);
    coast* data[4] = { &all, &land, &deep, &tank };
    for (int i = 0; i < COUNT; ++i)
    {
      deep.level[i] = 150.0 * sin(0.1 * i);
      for (int k = 0; k < 4 && i % 7 == 3; ++k)
      {
        (lacking / 2 == 0      ? data[k]->level
            : lacking / 2 == 1 ? data[k]->depth
                               : data[k]->bed)[i] = none;
      }
    }
    assert_wrong(
      water_heights_judge(all.level, all.depth, all.bed, COUNT), WATER_HEIGHT_DEPTH, 100.0);
    assert_wrong(water_heights_judge(land.level, NULL, land.bed, COUNT), WATER_HEIGHT_LEVEL, 100.0);
    assert_wrong(water_heights_judge(deep.level, NULL, deep.bed, COUNT), WATER_HEIGHT_LEVEL, 0.0);
    assert_wrong(
      water_heights_judge(NULL, tank.depth, tank.bed, COUNT), WATER_HEIGHT_DEPTH, 1000.0);
  }
  coast empty = coast_of(-20.0, 15.0, 0.3, 0.1);
  scale(empty.level, (double)NAN);
  assert_true(water_heights_judge(empty.level, NULL, empty.bed, COUNT).wrong == WATER_HEIGHT_NONE);
  empty = coast_of(300.0, 330.0, 312.0, 0.2); // high land, without any level
  scale(empty.level, (double)NAN);
  assert_true(water_heights_judge(empty.level, NULL, empty.bed, COUNT).wrong == WATER_HEIGHT_NONE);
  empty = coast_of(-20.0, 15.0, 0.3, 0.1);
  scale(empty.bed, (double)NAN);
  assert_true(water_heights_judge(empty.level, NULL, empty.bed, COUNT).wrong == WATER_HEIGHT_NONE);
}

TEST(three_heights_must_agree_where_it_is_wet)
{
  coast fine = coast_of(320.0, 400.0, 384.0, 0.1);
  water_heights_sum sum = water_heights_compare(fine.level, fine.depth, fine.bed, COUNT, 1e-3);
  assert_true(sum.is_wrong == 0 && sum.off < 1e-9 && sum.deepest > 50.0);
  for (int i = 0; i < COUNT; ++i)
  {
    fine.level[i] += fine.depth[i] > 0.0 ? 0.4 : 9.0; // dry places do not count
  }
  sum = water_heights_compare(fine.level, fine.depth, fine.bed, COUNT, 1e-3);
  assert_true(sum.is_wrong == 0 && fabs(sum.off - 0.4) < 1e-9);
  for (int i = 0; i < COUNT; ++i)
  {
    fine.bed[i] = i % 7 == 3 ? (double)NAN : fine.bed[i] - 2.0;
  }
  sum = water_heights_compare(fine.level, fine.depth, fine.bed, COUNT, 1e-3);
  assert_true(sum.is_wrong == 1 && fabs(sum.off - 2.4) < 1e-9);
}

TEST(heights_of_dry_land_agree)
{
  const double land[2] = { 3.0, 4.0 };
  const double none[2] = { 0.0, 0.0 };
  assert_false(water_heights_compare(land, none, land, 2, 0.0).is_wrong);
  const double film[2] = { 0.01, 0.01 };
  assert_true(
    water_heights_compare(land, film, none, 2, 0.01).off == 0.0); // as deep as a dry place
}

TEST(depths_that_are_negative_have_the_wrong_sign)
{
  assert_true(water_heights_are_negative(-5.0, -1e-9, 1.0));
  assert_true(water_heights_are_negative(-5.0, 0.0, 1.0));
  assert_true(water_heights_are_negative(-5.0, -5.0, 1.0));
  assert_false(water_heights_are_negative(-1.0, 0.0, 1.0)); // of a dry step
  assert_false(water_heights_are_negative(0.0, 0.0, 0.0));
  assert_false(water_heights_are_negative(-5.0, 1e-9, 0.0));
  assert_false(water_heights_are_negative(1.0, -1.0, 0.0)); // there are none
}

TESTS(heights_of_dry_land_agree, a_flat_bed_at_a_hundredth_of_the_level_is_right,
  a_twentieth_under_the_land_tells_nothing, depths_that_are_negative_have_the_wrong_sign,
  three_heights_must_agree_where_it_is_wet, places_without_values_tell_nothing,
  nine_places_are_too_few, flat_land_tells_nothing, films_of_water_are_no_evidence,
  a_thousandth_of_the_depth_is_no_evidence, dry_places_tell_the_unit_of_a_level_of_0,
  dry_places_tell_nothing_of_the_depth, no_water_that_there_is_has_a_wrong_unit,
  marks_of_dry_places_are_no_levels, the_height_in_another_unit_is_found,
  a_flat_tank_has_no_wrong_unit, dry_land_tells_the_unit_of_the_level,
  levels_under_all_land_are_in_another_unit, a_lake_in_feet_is_found,
  depth_and_bed_in_two_units_are_found, depth_and_bed_of_one_unit_are_fine, two_heights_are_needed)
