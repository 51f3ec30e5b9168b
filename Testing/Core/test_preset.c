// SPDX-License-Identifier: BSD-3-Clause
// test_preset.c: every preset is good input for the rest of the core, and looks like its name.
#include "test_scene.h"

#include "water_optics.h"
#include "water_preset.h"

static water_preset preset_of(const char* name)
{
  water_preset preset;
  assert_int_equal(water_preset_find(name, &preset), WATER_OK);
  assert_string_equal(preset.name, name);
  return preset;
}

static double wave_height(const water_preset* preset)
{
  double height = 0.0;
  double slope = 0.0;
  assert_int_equal(water_sea_moments(&preset->sea, 0.0, 370.0, &height, &slope), WATER_OK);
  return 4.0 * sqrt(height);
}

// The names of the list are all there, each passes every check of the core and states its source.
TEST(presets_are_good_input)
{
  const char* names[] = { "pool", "lake", "clear tropical", "ocean wind 5", "ocean wind 10",
    "ocean wind 15", "turbid river", "mirror floor" };
  assert_int_equal(water_preset_count(), sizeof names / sizeof names[0]);
  assert_null(water_preset_name(water_preset_count()));
  for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i)
  {
    assert_string_equal(water_preset_name(i), names[i]);
    const water_preset preset = preset_of(names[i]);
    size_t bad_index = 0;
    assert_int_equal(water_optics_check(&preset.look), WATER_OK);
    assert_int_equal(water_medium_check(&preset.medium), WATER_OK);
    assert_int_equal(water_sea_check(&preset.sea), WATER_OK);
    assert_int_equal(water_waves_check(preset.waves, preset.wave_count, &bad_index), WATER_OK);
    assert_true(preset.wave_count <= WATER_PRESET_WAVES);
    assert_true(strlen(preset.source) > 10);
  }
}

// Seas of 5, 10 and 15 m/s are 0.62, 2.5 and 5.6 m high (Pierson and Moskowitz, within 5 %); a
// pool's ripples are some millimetres; a lake's waves a few decimetres, a river's less.
TEST(waves_have_the_size_of_their_name)
{
  const char* oceans[3] = { "ocean wind 5", "ocean wind 10", "ocean wind 15" };
  const double heights[3] = { 0.62, 2.48, 5.57 };
  for (int i = 0; i < 3; ++i)
  {
    const water_preset ocean = preset_of(oceans[i]);
    assert_true(ocean.has_sea);
    ASSERT_CLOSE(wave_height(&ocean), heights[i], 0.05 * heights[i]);
  }
  const water_preset lake = preset_of("lake");
  const water_preset river = preset_of("turbid river");
  assert_true(wave_height(&lake) > 0.05 && wave_height(&lake) < 0.2);
  assert_true(wave_height(&river) < 0.04);
  const water_preset pool = preset_of("pool");
  double height = 0.0;
  double slope = 0.0;
  water_waves_rms(pool.waves, pool.wave_count, &height, &slope);
  assert_true(!pool.has_sea && height > 0.0005 && height < 0.003);
  ASSERT_CLOSE(slope, 0.030, 0.0005);
}

// The ripples of a pool come from all sides: the slope along any direction is about the same, and
// no half of the directions is without them. Two or three directions make woven caustics.
TEST(ripples_of_a_pool_come_from_all_sides)
{
  const water_preset pool = preset_of("pool");
  for (int turn = 0; turn < 36; ++turn)
  {
    const double angle = 2.0 * 3.14159265358979 * turn / 36.0;
    double along = 0.0; // slope variance
    double all = 0.0;
    int ahead = 0;
    for (size_t i = 0; i < (size_t)pool.wave_count; ++i)
    {
      const double slope = pool.waves[i].amplitude / pool.waves[i].wavelength;
      const double share = cos(pool.waves[i].direction_rad - angle);
      along += slope * slope * share * share;
      all += slope * slope;
      ahead += share > 0.0;
    }
    assert_true(along > 0.4 * all && along < 0.6 * all);
    assert_true(ahead >= 2);
  }
}

// A pool's bed is seen through 2 m, a tropical lagoon's through 5, a river's not through 3; pools
// and lagoons turn cyan (red goes first), the river keeps green and red over blue; a mirror is a
// mirror.
TEST(water_has_the_clarity_of_its_name)
{
  double left[3];
  const water_preset pool = preset_of("pool");
  water_medium_transmittance(&pool.medium, 2.0, left);
  assert_true(left[0] > 0.4 && left[0] < 0.6 && left[1] > 0.85 && left[2] > 0.95);
  const water_preset lagoon = preset_of("clear tropical");
  water_medium_transmittance(&lagoon.medium, 5.0, left);
  assert_true(left[0] < 0.2 && left[1] > 0.6 && left[2] > 0.8);
  const water_preset river = preset_of("turbid river");
  water_medium_transmittance(&river.medium, 3.0, left);
  assert_true(left[0] < 0.2 && left[1] < 0.2 && left[2] < 0.02);
  // the particles scatter what the type was said to absorb: a metre still takes Jerlov's Kd
  // / 1.0395
  water_medium_transmittance(&river.medium, 1.0, left);
  ASSERT_CLOSE(left[0], exp(-0.76 / 1.0395), 1e-15);
  double colour[3];
  water_medium_inscatter(&river.medium, (double)INFINITY, 0.9, 0.9, 0.16, colour);
  assert_true(colour[0] > 1.5 * colour[2] && colour[1] > colour[0]);
  const water_preset mirror = preset_of("mirror floor");
  assert_true(mirror.look.constant_reflectance && mirror.look.reflectance == 1.0);
  assert_true(!mirror.has_sea && mirror.wave_count == 0);
  assert_true(!pool.look.constant_reflectance);
}

// A clear lake is Jerlov's type IB with particles: they scatter 0.010 / m of what the type was said
// to absorb, and 0.020 / m more.
TEST(the_default_is_a_clear_lake)
{
  water_medium lake;
  water_medium sea;
  double natural[3];
  water_preset_default(&lake, natural);
  water_type_medium(WATER_TYPE_IB, &sea);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(lake.scattering[i] - sea.scattering[i], 0.030, 1e-15);
    ASSERT_CLOSE(lake.absorption[i] - sea.absorption[i], -0.010, 1e-15);
  }
}

// A name that is none, or no name, is refused.
TEST(unknown_names_are_refused)
{
  water_preset preset = preset_of("pool");
  assert_int_equal(water_preset_find("puddle", &preset), WATER_BAD_PRESET);
  assert_int_equal(water_preset_find("", &preset), WATER_BAD_PRESET);
  assert_int_equal(water_preset_find(NULL, &preset), WATER_BAD_PRESET);
  assert_string_equal(preset.name, "pool");
}

TESTS(the_default_is_a_clear_lake, presets_are_good_input, waves_have_the_size_of_their_name,
  ripples_of_a_pool_come_from_all_sides, water_has_the_clarity_of_its_name,
  unknown_names_are_refused)
