// SPDX-License-Identifier: BSD-3-Clause
// test_foam_measure.c: what data say of foam.
#include "test_main.h"

#include "water_foam_measure.h"
#include "water_shared.h"

#include <string.h>

static double cover_of(water_foam_measure measure, double value)
{
  double ends[2];
  water_foam_measure_ends(measure, ends);
  return water_shared_foam_of_measure(water_foam_measure_value(measure, value), ends[0], ends[1]);
}

// A cover is itself, from none to all.
TEST(a_cover_is_the_cover)
{
  for (int i = 0; i <= 100; ++i)
  {
    ASSERT_CLOSE(cover_of(WATER_FOAM_COVER, 0.01 * i), 0.01 * i, 1e-15);
  }
}

// Foam begins and is everywhere where the sources say: a flow as fast as its waves has none, a jump
// behind one at 1.7 a roller (Chow 1959); waves break at 0.78 of the depth (McCowan 1894), on a
// slope of 1 in 20 at 1.56 / (1 + exp(-19.5 / 20)) of it (Weggel 1972).
TEST(foam_begins_where_the_sources_say)
{
  const double weggel = 1.56 / (1.0 + exp(-19.5 / 20.0));
  const struct
  {
    water_foam_measure measure;
    double first;
    double last;
  } cases[2] = { { WATER_FOAM_FROUDE_NUMBER, 1.0, 1.7 },
    { WATER_FOAM_BREAKING_INDEX, 0.78, weggel } };
  for (int i = 0; i < 2; ++i)
  {
    const double wide = cases[i].last - cases[i].first;
    ASSERT_CLOSE(cover_of(cases[i].measure, 0.0), 0.0, 0.0);
    ASSERT_CLOSE(cover_of(cases[i].measure, cases[i].first), 0.0, 0.0);
    ASSERT_CLOSE(cover_of(cases[i].measure, cases[i].first + 0.25 * wide), 0.25, 0.02);
    ASSERT_CLOSE(cover_of(cases[i].measure, cases[i].first + 0.5 * wide), 0.5, 0.02);
    assert_true(cover_of(cases[i].measure, cases[i].last + 0.02 * wide) >= 1.0);
    ASSERT_CLOSE(cover_of(cases[i].measure, 1e30), 1.0, 0.0);
  }
}

// What no value of a measure can be counts as none, but a cover over 1 is all.
TEST(values_that_are_no_measure_count_as_0)
{
  for (int i = 0; i < WATER_FOAM_MEASURE_COUNT; ++i)
  {
    const water_foam_measure measure = (water_foam_measure)i;
    const double none[4] = { -0.1, -INFINITY, INFINITY, NAN };
    for (int j = 0; j < 4; ++j)
    {
      ASSERT_CLOSE(water_foam_measure_value(measure, none[j]), 0.0, 0.0);
    }
    ASSERT_CLOSE(water_foam_measure_value(measure, 0.4), 0.4, 0.0);
  }
  ASSERT_CLOSE(water_foam_measure_value(WATER_FOAM_COVER, 3.0), 1.0, 0.0);
  ASSERT_CLOSE(
    water_foam_measure_value(WATER_FOAM_COVER, 1.0 + 1e-7), 1.0 + 1e-7, 0.0); // a rounding
  ASSERT_CLOSE(water_foam_measure_value(WATER_FOAM_COVER, 1.0 + 1e-6), 1.0 + 1e-6, 0.0);
  ASSERT_CLOSE(water_foam_measure_value(WATER_FOAM_COVER, 1.0 + 2e-6), 1.0, 0.0);
  ASSERT_CLOSE(water_foam_measure_value(WATER_FOAM_FROUDE_NUMBER, 3.0), 3.0, 0.0);
}

// What is none of the measures has the ends of a cover.
TEST(other_measures_are_covers)
{
  double cover[2];
  water_foam_measure_ends(WATER_FOAM_COVER, cover);
  const int others[2] = { WATER_FOAM_MEASURE_COUNT, -1 };
  for (int i = 0; i < 2; ++i)
  {
    double ends[2] = { 7.0, 7.0 };
    water_foam_measure_ends((water_foam_measure)others[i], ends);
    ASSERT_CLOSE(ends[0], cover[0], 0.0);
    ASSERT_CLOSE(ends[1], cover[1], 0.0);
  }
}

// Each measure has a name of its own, which finds it.
TEST(names_find_their_measures)
{
  for (int i = 0; i < WATER_FOAM_MEASURE_COUNT; ++i)
  {
    const water_foam_measure measure = (water_foam_measure)i;
    assert_int_equal(water_foam_measure_of(water_foam_measure_text(measure)), measure);
  }
  assert_int_equal(water_foam_measure_of("Froude"), WATER_FOAM_MEASURE_COUNT);
  assert_int_equal(water_foam_measure_of(NULL), WATER_FOAM_MEASURE_COUNT);
  assert_string_equal(water_foam_measure_text((water_foam_measure)-1), "unknown measure");
  assert_string_equal(water_foam_measure_text(WATER_FOAM_MEASURE_COUNT), "unknown measure");
  double ends[2];
  water_foam_measure_ends((water_foam_measure)7, ends); // as of a cover
  ASSERT_CLOSE(ends[0], 0.0, 0.0);
  ASSERT_CLOSE(ends[1], 1.0, 0.0);
}

TESTS(other_measures_are_covers, a_cover_is_the_cover, foam_begins_where_the_sources_say,
  values_that_are_no_measure_count_as_0, names_find_their_measures)
