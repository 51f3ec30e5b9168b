// SPDX-License-Identifier: BSD-3-Clause
// test_status.c: every code has a text of its own, and no number is without one.
#include "test_scene.h"

#include "water_medium.h"

typedef const char* (*text_function)(int);

static const char* status_text(int number)
{
  return water_status_text((water_status)number);
}

static const char* fate_text(int number)
{
  return water_cull_reason_text((water_cull_reason)number);
}

static const char* decision_text(int number)
{
  return water_decision_text((water_decision)number);
}

static const char* type_text(int number)
{
  return water_type_text((water_type)number);
}

static void assert_texts(text_function text, int count)
{
  for (int i = 0; i < count; ++i)
  {
    assert_non_null(text(i));
    assert_true(strlen(text(i)) > 0);
    for (int j = 0; j < i; ++j)
    {
      assert_string_not_equal(text(i), text(j));
    }
  }
  assert_non_null(strstr(text(count), "unknown"));
  assert_non_null(strstr(text(-1), "unknown"));
  assert_non_null(strstr(text(1000000), "unknown"));
}

// No two codes share a text; a number that is no code is "unknown", never NULL.
TEST(texts_are_distinct_and_never_null)
{
  assert_texts(status_text, WATER_STATUS_COUNT);
  assert_texts(fate_text, WATER_CULL_REASON_COUNT);
  assert_texts(decision_text, WATER_DECISION_COUNT);
  assert_texts(type_text, WATER_TYPE_COUNT);
}

// A text belongs to its code: three known ones of each list, the last included.
TEST(texts_belong_to_their_codes)
{
  assert_string_equal(water_status_text(WATER_OK), "no error");
  assert_non_null(strstr(water_status_text(WATER_BAD_INDEX), "IndexOfRefraction"));
  assert_non_null(strstr(water_status_text(WATER_BAD_PROP_BOUNDS), "every prop"));
  assert_non_null(strstr(water_status_text(WATER_WAVES_FOLD), "fold"));
  assert_non_null(strstr(water_status_text(WATER_BAD_FETCH), "Fetch"));
  assert_non_null(strstr(water_status_text(WATER_BAD_PRESET), "preset"));
  assert_string_equal(water_cull_reason_text(WATER_CULL_NONE), "drawn");
  assert_string_equal(water_cull_reason_text(WATER_CULL_WATER), "water itself");
  assert_non_null(strstr(water_cull_reason_text(WATER_CULL_OUT_OF_VIEW), "out of"));
  assert_string_equal(water_decision_text(WATER_REFLECT), "rendered");
  assert_non_null(strstr(water_decision_text(WATER_NO_REFLECT_EDGE_ON), "edge-on"));
  assert_non_null(strstr(water_decision_text(WATER_NO_REFLECT_NO_REFLECTANCE), "nothing"));
}

TESTS(texts_are_distinct_and_never_null, texts_belong_to_their_codes)
