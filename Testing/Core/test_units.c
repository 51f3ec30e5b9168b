// SPDX-License-Identifier: BSD-3-Clause
// test_units.c: what a metre is in a scene, by name, by the scene's size, and for its waves.
#include "test_scene.h"

#include "water_units.h"
#include "water_waves.h"

static const double natural[2] = { 100.0, 1000.0 };

TEST(units_have_their_metres)
{
  const char* const names[4] = { "mm", "km", "ft", "mi" };
  const double expected[4] = { 0.001, 1000.0, 0.3048, 1609.344 };
  for (int i = 0; i < 4; ++i)
  {
    double metres = 0.0;
    assert_int_equal(water_units_find(names[i], &metres), WATER_OK);
    ASSERT_CLOSE(metres, expected[i], 1e-15 * expected[i]);
  }
  size_t known = 0;
  for (; water_units_name(known) != NULL; ++known)
  {
    double metres = 0.0;
    assert_int_equal(water_units_find(water_units_name(known), &metres), WATER_OK);
    assert_true(metres > 0.0);
  }
  assert_in_range(known, 4, 100);
}

TEST(other_names_are_refused)
{
  double metres = 7.0;
  assert_int_equal(water_units_find("furlong", &metres), WATER_BAD_UNITS);
  assert_int_equal(water_units_find("", &metres), WATER_BAD_UNITS);
  assert_int_equal(water_units_find(NULL, &metres), WATER_BAD_UNITS);
  ASSERT_CLOSE(metres, 7.0, 0.0);
}

// From a millimetre to a continent a scene counts as one of a natural size.
TEST(scenes_of_all_sizes_count_as_natural)
{
  for (double diagonal = 1e-3; diagonal < 1e8; diagonal *= 10.0)
  {
    const double size = diagonal * water_units_fit(diagonal, natural);
    assert_true(size >= 49.999 && size <= 1000.001);
  }
  ASSERT_CLOSE(water_units_fit(300.0, natural), 1.0, 0.0);
  ASSERT_CLOSE(water_units_fit(1.5, natural), 50.0, 1e-12);
  ASSERT_CLOSE(water_units_fit(1e-30, natural), 1e9, 0.0);
  ASSERT_CLOSE(water_units_fit(1e30, natural), 1e-9, 0.0);
}

// A thing that moves a little in its scene changes no unit.
TEST(units_change_at_powers_of_two_alone)
{
  for (double diagonal = 4.0; diagonal < 7.99; diagonal += 0.1)
  {
    ASSERT_CLOSE(water_units_fit(diagonal, natural), water_units_fit(4.0, natural), 0.0);
  }
  assert_true(water_units_fit(8.1, natural) < water_units_fit(7.9, natural));
}

TEST(scenes_without_a_size_have_metres)
{
  const double sizes[4] = { 0.0, -1.0, (double)NAN, (double)INFINITY };
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_CLOSE(water_units_fit(sizes[i], natural), 1.0, 0.0);
  }
}

TEST(waves_too_short_for_the_scene_are_not_seen)
{
  assert_true(water_units_show_waves(2.6, 1000.0));
  assert_false(water_units_show_waves(2.4, 1000.0));
  assert_true(water_units_show_waves(2.5, 1000.0)); // 400 waves across the scene
  assert_true(water_units_show_waves(0.1, 0.0));
}

TEST(foam_is_deep_enough_for_the_scene)
{
  ASSERT_CLOSE(water_units_show_foam(0.25, 40.0), 0.25, 0.0);
  ASSERT_CLOSE(water_units_show_foam(0.25, 1000.0), 2.5, 1e-12);
  ASSERT_CLOSE(water_units_soften(0.05, 4.0), 0.05, 0.0);
  ASSERT_CLOSE(water_units_soften(0.05, 0.2), 0.02, 1e-15);
  ASSERT_CLOSE(water_units_soften(0.05, 0.0), 0.05, 0.0);
  ASSERT_CLOSE(water_units_soften(0.05, (double)INFINITY), 0.05, 0.0);
  ASSERT_CLOSE(water_units_show_foam(0.25, (double)INFINITY), 0.25, 0.0);
  ASSERT_CLOSE(water_units_show_foam(0.25, (double)NAN), 0.25, 0.0);
}

// In millimetres waves are 1000 times as high and as long, and as steep; a place has their phase.
TEST(scaled_waves_have_the_same_slopes)
{
  const water_wave wave = { 0.1, 3.0, 0.5, 0.25, 0.0 };
  water_wave_term terms[2];
  size_t bad = 0;
  for (int i = 0; i < 2; ++i)
  {
    assert_int_equal(water_waves_at(&wave, 1, (double)INFINITY, 2.0, terms + i, &bad), WATER_OK);
  }
  water_waves_scale(1000.0, terms + 1, 1);
  for (double x = -2.0; x < 2.0; x += 0.37)
  {
    double rest[2];
    water_wave_point metres;
    water_wave_point millimetres;
    assert_int_equal(water_waves_find(terms, 1, x, 0.5 * x, rest, &metres), WATER_OK);
    assert_int_equal(
      water_waves_find(terms + 1, 1, 1000.0 * x, 500.0 * x, rest, &millimetres), WATER_OK);
    ASSERT_CLOSE(millimetres.displacement[2], 1000.0 * metres.displacement[2], 1e-9);
    ASSERT_CLOSE(millimetres.slope[0], metres.slope[0], 1e-12);
    ASSERT_CLOSE(millimetres.slope[1], metres.slope[1], 1e-12);
  }
}

// The deepest bed counts as natural, or four times as deep in a map; one that there is not changes
// nothing. The floor of a tank counts as a sixth as deep, and objects in open water as a third.
TEST(beds_count_as_deep_as_is_natural)
{
  const double extinction[3] = { 0.3, 0.1, 0.05 };
  const double depths[6] = { 10.0, 60.0, 90.0, 6000.0, 0.0, 1e-9 };
  const double diagonals[6] = { 1000.0, 300.0, 600.0, 1000.0, 1000.0, 1000.0 };
  const double times[6] = { 12.0, 0.5, 2.5 / 3.0, 1.0 / 64.0, 1.0, 16.0 };
  const double open_times[6] = { 1.0, 1.0 / 6.0, 1.0 / 9.0, 1.0 / 64.0, 1.0, 16.0 };
  const double flat_times[6] = { 0.5, 1.0 / 12.0, 1.0 / 18.0, 1.0 / 64.0, 1.0, 16.0 };
  for (int i = 0; i < 6; ++i)
  {
    double dimmed[3];
    water_units_dim(extinction, depths[i], diagonals[i], 30.0, WATER_UNITS_BED_UNEVEN, dimmed);
    ASSERT_CLOSE(dimmed[0], 0.3 * times[i], 1e-12);
    ASSERT_CLOSE(dimmed[2], 0.05 * times[i], 1e-12);
    water_units_dim(extinction, depths[i], diagonals[i], 30.0, WATER_UNITS_BED_FLAT, dimmed);
    ASSERT_CLOSE(dimmed[0], 0.3 * flat_times[i], 1e-12);
    water_units_dim(extinction, depths[i], diagonals[i], 30.0, WATER_UNITS_BED_NONE, dimmed);
    ASSERT_CLOSE(dimmed[0], 0.3 * open_times[i], 1e-12);
    water_units_dim(extinction, depths[i], diagonals[i], 0.0, WATER_UNITS_BED_FLAT, dimmed);
    ASSERT_CLOSE(dimmed[1], 0.1, 0.0);
  }
}

TESTS(beds_count_as_deep_as_is_natural, units_have_their_metres, other_names_are_refused,
  scenes_of_all_sizes_count_as_natural, units_change_at_powers_of_two_alone,
  scenes_without_a_size_have_metres, waves_too_short_for_the_scene_are_not_seen,
  foam_is_deep_enough_for_the_scene, scaled_waves_have_the_same_slopes)
