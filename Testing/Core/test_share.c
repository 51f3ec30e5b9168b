// SPDX-License-Identifier: BSD-3-Clause
// test_share.c: which sheets of water may share a mirrored view.
#include "test_scene.h"

#include "water_share.h"

static const double over[3] = { 1.0, 2.0, 7.0 };
static const double on[3] = { 1.0, 2.0, 5.0 }; // the plane: the plan has such an eye over it
static const double under[3] = { 1.0, 2.0, 3.0 };

// An opaque sheet at height 5.
static water_share sheet(void)
{
  static const int look = 0;
  water_share share;
  memset(&share, 0, sizeof share);
  share.plane.normal[2] = 2.0;
  share.plane.offset = -10.0;
  share.origin[2] = 5.0;
  share.look = &look;
  share.is_opaque = true;
  share.settings.texture_scale = 0.5;
  share.settings.guard_band = 1.1;
  share.settings.clip_margin = 0.25;
  share.settings.prop_px_min = 2.0;
  share.settings.reflectance_error = 0.01;
  share.settings.skips = WATER_MAY_SKIP_ALL;
  share.settings.multi_samples = 4;
  share.settings.color_precision = WATER_COLOR_EIGHT_BIT;
  share.settings.quality = WATER_QUALITY_TARGET_ERROR;
  share.settings.target_error_px = 1.0;
  share.settings.time_budget_ms = 4.0;
  return share;
}

// The answer is the same both ways.
static bool can(const water_share* a, const water_share* b, const double eye[3], bool is_parallel)
{
  const bool answer = water_share_can(a, b, eye, is_parallel);
  assert_int_equal(water_share_can(b, a, eye, is_parallel), answer);
  return answer;
}

// Sheets of one plane share, whatever the length of its normal; sheets of different planes, or of a
// plane that is none, do not.
TEST(sheets_of_one_plane_share)
{
  const water_share one = sheet();
  water_share other = sheet();
  assert_true(can(&one, &other, over, false));
  assert_true(can(&one, &other, under, true));
  other.plane.normal[2] = 1.0;
  other.plane.offset = -5.0;
  assert_true(can(&one, &other, over, false));
  other.plane.offset = -5.000001;
  assert_false(can(&one, &other, over, false));
  other = sheet();
  other.plane.normal[0] = 1e-9;
  assert_false(can(&one, &other, over, false));
  other = sheet();
  other.plane.normal[1] = 1e-9;
  assert_false(can(&one, &other, over, false));
  other = sheet();
  other.plane.normal[2] = -2.0; // turned over
  other.plane.offset = 10.0;
  assert_false(can(&one, &other, over, false));
  memset(&other.plane, 0, sizeof other.plane);
  assert_false(can(&other, &other, over, false));
}

// Each setting, and each thing that a mirrored view depends on, forbids sharing where it differs.
TEST(every_difference_forbids_sharing)
{
  const water_share one = sheet();
  for (int i = 0; i < 15; ++i)
  {
    water_share other = sheet();
    water_settings* set = &other.settings;
    double* const numbers[7] = { &set->texture_scale, &set->guard_band, &set->clip_margin,
      &set->prop_px_min, &set->reflectance_error, &set->target_error_px, &set->time_budget_ms };
    if (i < 7)
    {
      *numbers[i] *= 1.0 + DBL_EPSILON;
    }
    set->skips -= i == 7 ? WATER_MAY_SKIP_HIDDEN : 0u;
    set->multi_samples += i == 8;
    set->color_precision = i == 9 ? WATER_COLOR_HALF_FLOAT : set->color_precision;
    set->quality = i == 10 ? WATER_QUALITY_UPDATE_RATE : set->quality;
    other.has_environment = i == 11;
    other.is_opaque = i != 12;
    other.is_displaced = i == 13;
    set->secondary_reflections = i == 14;
    assert_false(can(&one, &other, over, false));
  }
}

// Waves move with their look and their plane's origin: where any are, both must be the same; calm
// water has neither.
TEST(waves_share_with_the_same_waves)
{
  static const int another_look = 1;
  for (int waves = 0; waves < 4; ++waves)
  {
    for (int difference = -1; difference < 4; ++difference)
    {
      water_share one = sheet();
      water_share other = sheet();
      one.needs_rays = (waves & 1) != 0;
      other.needs_rays = (waves & 2) != 0;
      if (difference == 3)
      {
        other.look = &another_look;
      }
      else if (difference >= 0)
      {
        other.origin[difference] += 1.0;
      }
      assert_int_equal(can(&one, &other, over, false), waves == 0 || difference < 0);
    }
  }
}

// Of clear sheets with the eye under them, nobody knows which one it is in: they do not share, nor
// do clear ones that waves move. A parallel eye is in none.
TEST(eye_may_not_be_in_one_of_two_clear_sheets)
{
  for (int clear = 0; clear < 4; ++clear)
  {
    for (int i = 0; i < 2; ++i)
    {
      const bool is_displaced = i == 1;
      water_share one = sheet();
      water_share other = sheet();
      one.is_clear = (clear & 1) != 0;
      other.is_clear = (clear & 2) != 0;
      one.is_displaced = other.is_displaced = is_displaced;
      assert_int_equal(can(&one, &other, over, false), clear == 0 || !is_displaced);
      assert_int_equal(can(&one, &other, on, false), clear == 0 || !is_displaced);
      assert_int_equal(can(&one, &other, under, false), clear == 0);
      assert_true(can(&one, &other, under, true));
    }
  }
}

TESTS(sheets_of_one_plane_share, every_difference_forbids_sharing, waves_share_with_the_same_waves,
  eye_may_not_be_in_one_of_two_clear_sheets)
