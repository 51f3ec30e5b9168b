// SPDX-License-Identifier: BSD-3-Clause
// test_rest.c: what a shader is told of the way from a place to the point at rest, and of heights.
#include "test_scene.h"

#include "water_waves.h"

// How far a Gerstner wave of length 2 pi and of so much k A Q is from its places after some of
// Newton's steps that start at the place: the largest miss, in its own moves.
static double missed(double fold, int steps)
{
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double place = 0.001 * i * 6.283185307179586;
    double rest = place;
    for (int step = 0; step < steps; ++step)
    {
      rest -= (rest + fold * cos(rest) - place) / (1.0 - fold * sin(rest));
    }
    largest = fmax(largest, fabs(rest + fold * cos(rest) - place) / fold);
  }
  return largest;
}

// Where no wave moves its points a place is its own rest. A displaced surface has the rest of its
// vertices, and takes one step for its chords. From a place it takes as many steps as find the rest
// to a hundredth of the way for four fifths of the steepness that folds, and no more.
TEST(rest_is_found_by_few_steps)
{
  assert_int_equal(water_waves_rest_steps(false, false), 0);
  assert_int_equal(water_waves_rest_steps(true, false), 1);
  assert_int_equal(water_waves_rest_steps(true, true), 1);
  const int steps = water_waves_rest_steps(false, true);
  assert_true(missed(0.8, steps) < 0.01);
  assert_true(missed(0.8, steps - 1) > 0.01);
}

// A thing is under a displaced surface from a quarter of the waves' height on.
TEST(slack_is_a_quarter_of_the_height)
{
  ASSERT_CLOSE(water_waves_slack(0.0), 0.0, 0.0);
  ASSERT_CLOSE(water_waves_slack(2.0), 0.5, 0.0);
}

TESTS(rest_is_found_by_few_steps, slack_is_a_quarter_of_the_height)
