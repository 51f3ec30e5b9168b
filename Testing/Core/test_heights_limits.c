// SPDX-License-Identifier: BSD-3-Clause
// test_heights_limits.c: from which numbers on heights are in another unit: each limit, just below
// it and just above.
#include "test_heights.h"

// Levels tell of another unit if they are over the land by more than three times its relief.
TEST(three_reliefs_over_the_land_tell_nothing)
{
  double level[40];
  double bed[40];
  for (int over = 0; over < 2; ++over)
  {
    for (int i = 0; i < 40; ++i)
    {
      bed[i] = i % 2 == 0 ? 400.0 : 700.0;
      level[i] = 700.0 + 3.0 * 300.0 + over; // feet of 488 m
    }
    assert_wrong(water_heights_judge(level, NULL, bed, 40),
      over ? WATER_HEIGHT_LEVEL : WATER_HEIGHT_NONE, over ? 1.0 / 0.3048 : 0.0);
  }
}

// A sea whose level is the same everywhere: heights under a thousandth of it, in its unit, are no
// evidence, as in other water.
TEST(an_even_level_has_a_size)
{
  double level[12];
  double depth[12];
  double bed[12];
  for (int i = 0; i < 12; ++i)
  {
    level[i] = 1000.0;
    depth[i] = 5.0;
    bed[i] = i < 10 ? 5.0 : -4.995;
  }
  assert_wrong(water_heights_judge(level, depth, bed, 12), WATER_HEIGHT_LEVEL, 100.0);
}

// A height may be off by two thousandths of what it should be, and no more.
TEST(two_thousandths_are_rounding)
{
  for (int off = 0; off < 2; ++off)
  {
    double level[10];
    double depth[10];
    double bed[10];
    for (int i = 0; i < 10; ++i)
    {
      level[i] = off ? 1002.001 : 1002.0;
      depth[i] = bed[i] = 5.0;
    }
    assert_wrong(water_heights_judge(level, depth, bed, 10),
      off ? WATER_HEIGHT_NONE : WATER_HEIGHT_LEVEL, off ? 0.0 : 100.0);
  }
}

// An explanation holds for more than nine tenths of the places.
TEST(nine_tenths_are_too_few)
{
  for (int fits = 18; fits <= 19; ++fits)
  {
    double level[20];
    double depth[20];
    double bed[20];
    for (int i = 0; i < 20; ++i)
    {
      depth[i] = bed[i] = 5.0;
      level[i] = i < fits ? 1000.0 : 333.0;
    }
    assert_wrong(water_heights_judge(level, depth, bed, 20),
      fits == 18 ? WATER_HEIGHT_NONE : WATER_HEIGHT_LEVEL, fits == 18 ? 0.0 : 100.0);
  }
}

// Dry land counts where it is over a hundredth of the largest height, if it is a tenth of all
// places and its relief is over a twentieth of it.
TEST(limits_of_dry_land_are_exact)
{
  double level[101];
  double bed[101];
  for (int i = 0; i < 101; ++i) // ten dry places in centimetres, and sea
  {
    bed[i] = i < 10 ? 20.0 + i : -1000.0;
    level[i] = i < 10 ? 100.0 * bed[i] : 0.0;
  }
  assert_wrong(water_heights_judge(level, NULL, bed, 100), WATER_HEIGHT_LEVEL, 100.0);
  assert_wrong(water_heights_judge(level, NULL, bed, 101), WATER_HEIGHT_NONE, 0.0);
  bed[0] = 10.0; // a hundredth
  level[0] = 1000.0;
  assert_wrong(water_heights_judge(level, NULL, bed, 100), WATER_HEIGHT_NONE, 0.0);
  bed[0] = 10.01;
  level[0] = 1001.0;
  assert_wrong(water_heights_judge(level, NULL, bed, 100), WATER_HEIGHT_LEVEL, 100.0);
  for (int i = 0; i < 20; ++i) // land of little relief, and sea
  {
    bed[i] = i < 5 ? 100.0 : (i < 10 ? 95.0 : -1000.0);
    level[i] = i < 10 ? 100.0 * bed[i] : 0.0;
  }
  assert_wrong(water_heights_judge(level, NULL, bed, 20), WATER_HEIGHT_NONE, 0.0);
  bed[9] = 94.9;
  level[9] = 9490.0;
  assert_wrong(water_heights_judge(level, NULL, bed, 20), WATER_HEIGHT_LEVEL, 100.0);
}

// Levels are far under the land if they are under twice its relief below its lowest place.
TEST(two_reliefs_under_the_land_tell_nothing)
{
  for (int deep = 0; deep < 2; ++deep)
  {
    double level[20];
    double bed[20];
    for (int i = 0; i < 20; ++i)
    {
      bed[i] = i % 2 == 0 ? 0.0 : -10.0;
      level[i] = i < 9 ? -100.0 - 3.0 * i : 0.0;
    }
    level[9] = deep ? -30.01 : -30.0;
    assert_int_equal(water_heights_judge(level, NULL, bed, 20).wrong,
      deep ? WATER_HEIGHT_LEVEL : WATER_HEIGHT_NONE);
  }
}

// Land is high if its lowest place is higher than its relief; a level in another unit may be at its
// lowest and at its highest place.
TEST(limits_of_high_land_are_exact)
{
  double level[40];
  double bed[40];
  for (int relief = 399; relief <= 400; ++relief)
  {
    for (int i = 0; i < 40; ++i)
    {
      bed[i] = i % 2 == 0 ? 400.0 : 400.0 + relief;
      level[i] = 2100.0; // feet of 640 m
    }
    assert_wrong(water_heights_judge(level, NULL, bed, 40),
      relief == 399 ? WATER_HEIGHT_LEVEL : WATER_HEIGHT_NONE, relief == 399 ? 1.0 / 0.3048 : 0.0);
  }
  for (int i = 0; i < 40; ++i)
  {
    bed[i] = i % 2 == 0 ? 300.0 : 400.0;
    level[i] = i % 2 == 0 ? 40000.0 : 30000.0;
  }
  assert_wrong(water_heights_judge(level, NULL, bed, 40), WATER_HEIGHT_LEVEL, 100.0);
}

// Depth and bed balance each other at ten wet places or more, and an even depth balances no even
// bed.
TEST(ten_wet_places_balance)
{
  double depth[10];
  double bed[10];
  for (int i = 0; i < 10; ++i)
  {
    bed[i] = -1.0 * i;
    depth[i] = 100.0 * (1.0 - bed[i]);
  }
  assert_wrong(water_heights_judge(NULL, depth, bed, 10), WATER_HEIGHT_DEPTH, 100.0);
  assert_wrong(water_heights_judge(NULL, depth, bed, 9), WATER_HEIGHT_NONE, 0.0);
  for (int i = 0; i < 10; ++i)
  {
    bed[i] = 1.0;
    depth[i] = 5.0;
  }
  assert_wrong(water_heights_judge(NULL, depth, bed, 10), WATER_HEIGHT_NONE, 0.0);
}

TESTS(three_reliefs_over_the_land_tell_nothing, an_even_level_has_a_size,
  two_thousandths_are_rounding, nine_tenths_are_too_few, limits_of_dry_land_are_exact,
  two_reliefs_under_the_land_tell_nothing, limits_of_high_land_are_exact, ten_wet_places_balance)
