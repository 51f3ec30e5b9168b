// SPDX-License-Identifier: BSD-3-Clause
// test_samples.c: how fine a picture of samples is, and which sample each of its pixels has.
#include "test_main.h"

#include "water_samples.h"

#include <math.h>

// At least as many finer pixels as samples; no picture is larger than a texture can be.
TEST(there_are_finer_pixels_for_all_samples_that_fit)
{
  const struct
  {
    int samples;
    int size_px[2];
    int max_texture_px;
    int side;
  } cases[] = { { 0, { 200, 150 }, 16384, 1 }, { 1, { 200, 150 }, 16384, 1 },
    { 2, { 200, 150 }, 16384, 2 }, { 4, { 200, 150 }, 16384, 2 }, { 5, { 200, 150 }, 16384, 3 },
    { 8, { 200, 150 }, 16384, 3 }, { 16, { 200, 150 }, 16384, 4 }, { 32, { 200, 150 }, 16384, 4 },
    { 16, { 4096, 9 }, 16384, 4 }, { 16, { 4097, 9 }, 16384, 3 }, { 16, { 9, 5462 }, 16384, 2 },
    { 16, { 8193, 9 }, 16384, 1 }, { 16, { 16384, 9 }, 16384, 1 }, { 4, { 20, 9 }, 0, 1 } };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    assert_int_equal(
      water_samples_side(cases[i].samples, cases[i].size_px, cases[i].max_texture_px),
      cases[i].side);
  }
}

// Four samples in the places that drivers share have a quarter of the pixel each.
TEST(each_of_four_samples_has_its_quarter)
{
  const float places[4][2] = { { -2.0f / 16, -6.0f / 16 }, { 6.0f / 16, -2.0f / 16 },
    { -6.0f / 16, 2.0f / 16 }, { 2.0f / 16, 6.0f / 16 } };
  int numbers[4];
  water_samples_nearest(places, 4, 2, numbers);
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(numbers[i], i);
  }
}

// No sample is nearer to the middle of a finer pixel than the one that it has.
TEST(no_other_sample_is_nearer)
{
  // the usual eight, which drivers share
  const float places[8][2] = { { 0.0625f, -0.1875f }, { -0.0625f, 0.1875f }, { 0.3125f, 0.0625f },
    { -0.1875f, -0.3125f }, { -0.3125f, 0.3125f }, { -0.4375f, -0.0625f }, { 0.1875f, 0.4375f },
    { 0.4375f, -0.4375f } };
  int numbers[9];
  water_samples_nearest(places, 8, 3, numbers);
  for (int fine = 0; fine < 9; ++fine)
  {
    const double x = (fine % 3 - 1) / 3.0;
    const double y = (fine / 3 - 1) / 3.0;
    const int number = numbers[fine];
    assert_in_range(number, 0, 7);
    for (int i = 0; i < 8; ++i)
    {
      assert_true(hypot(places[number][0] - x, places[number][1] - y) <=
        hypot(places[i][0] - x, places[i][1] - y) + 1e-12);
    }
  }
}

TEST(one_sample_is_in_all_of_them)
{
  const float place[1][2] = { { 0.0f, 0.0f } };
  int numbers[4] = { 7, 7, 7, 7 };
  water_samples_nearest(place, 1, 2, numbers);
  for (int i = 0; i < 4; ++i)
  {
    assert_int_equal(numbers[i], 0);
  }
}

// Of samples that are as near the first is taken.
TEST(the_first_of_equal_samples_is_taken)
{
  const float places[3][2] = { { 0.25f, 0.0f }, { -0.25f, 0.0f }, { 0.0f, 0.25f } };
  int number = 7;
  water_samples_nearest(places, 3, 1, &number);
  assert_int_equal(number, 0);
}

TESTS(the_first_of_equal_samples_is_taken, there_are_finer_pixels_for_all_samples_that_fit,
  each_of_four_samples_has_its_quarter, no_other_sample_is_nearer, one_sample_is_in_all_of_them)
