// SPDX-License-Identifier: BSD-3-Clause
// test_settings.c: what the user's settings of samples and colours come to in the plan.
#include "test_scene.h"

// The window's samples are taken over, eight at most; a number of the user's own is taken as it is,
// if the GPU has as many.
// One sample a pixel is none. Waves have none of the window's, calm water of a high quality at
// least four.
TEST(samples_are_the_windows_or_the_users)
{
  const struct
  {
    int wanted;
    int window;
    int samples;
  } cases[] = { { -1, 0, 0 }, { -1, 1, 0 }, { -1, 2, 2 }, { -1, 8, 8 }, { -1, 9, 8 }, { -1, 32, 8 },
    { 0, 8, 0 }, { 1, 8, 0 }, { 2, 8, 2 }, { 4, 0, 4 }, { 16, 4, 16 } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_scene scene = lake();
    scene.settings.multi_samples = cases[i].wanted;
    scene.window_samples = cases[i].window;
    assert_int_equal(plan_of(&scene, NULL).samples, cases[i].samples);
    scene.has_waves = true; // rays sample edges themselves
    assert_int_equal(plan_of(&scene, NULL).samples, cases[i].wanted < 0 ? 0 : cases[i].samples);
    scene.has_waves = false;
    scene.calm_samples_min = 4;
    const int least = cases[i].wanted < 0 && cases[i].samples < 4 ? 4 : cases[i].samples;
    assert_int_equal(plan_of(&scene, NULL).samples, least);
  }
}

TEST(samples_are_as_many_as_the_gpu_has)
{
  water_scene scene = lake();
  scene.settings.multi_samples = 16;
  scene.max_samples = 4;
  assert_int_equal(plan_of(&scene, NULL).samples, 4);
  scene.max_samples = 0;
  assert_int_equal(plan_of(&scene, NULL).samples, 0);
}

// Colours are half floats where the user says so, or leaves it open and the picture may be tone
// mapped.
TEST(half_floats_are_for_tone_mapping)
{
  const struct
  {
    water_color_precision wanted;
    bool may_tone_map;
    bool is_half_float;
  } cases[] = { { WATER_COLOR_AUTOMATIC, false, false }, { WATER_COLOR_AUTOMATIC, true, true },
    { WATER_COLOR_EIGHT_BIT, false, false }, { WATER_COLOR_EIGHT_BIT, true, false },
    { WATER_COLOR_HALF_FLOAT, false, true }, { WATER_COLOR_HALF_FLOAT, true, true } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    water_scene scene = lake();
    scene.settings.color_precision = cases[i].wanted;
    scene.may_tone_map = cases[i].may_tone_map;
    assert_int_equal(plan_of(&scene, NULL).is_half_float, cases[i].is_half_float);
  }
}

TESTS(samples_are_the_windows_or_the_users, samples_are_as_many_as_the_gpu_has,
  half_floats_are_for_tone_mapping)
