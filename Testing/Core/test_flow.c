// SPDX-License-Identifier: BSD-3-Clause
// test_flow.c: layers of waves that a current carries.
#include "test_main.h"

#include "water_flow.h"
#include "water_shared.h"

#include <string.h>

// A layer is carried at the current's speed, has no weight where it begins again, and all of it
// half a period later.
TEST(layers_take_turns)
{
  for (int i = -400; i <= 400; ++i)
  {
    const double period = 3.0;
    const double time = 0.0371 * i;
    const water_flow flow = water_flow_at(time, period);
    const water_flow next = water_flow_at(time + 1e-3, period);
    for (int layer = 0; layer < 2; ++layer)
    {
      assert_true(flow.gone[layer] >= 0.0 && flow.gone[layer] < 1.0);
      const double gone = next.gone[layer] - flow.gone[layer];
      ASSERT_CLOSE(gone < 0.0 ? gone + 1.0 : gone, 1e-3 / period, 1e-12);
      const double weight = layer == 0 ? flow.weight : 1.0 - flow.weight;
      ASSERT_CLOSE(weight, 1.0 - fabs(2.0 * flow.gone[layer] - 1.0), 1e-12);
    }
    ASSERT_CLOSE(fabs(flow.gone[1] - flow.gone[0]), 0.5, 1e-12);
  }
  ASSERT_CLOSE(water_flow_at(0.0, 2.0).weight, 0.0, 0.0);
  ASSERT_CLOSE(water_flow_at(1.0, 2.0).weight, 1.0, 0.0);
  ASSERT_CLOSE(water_flow_at(-0.5, 2.0).gone[0], 0.75, 0.0);
  ASSERT_CLOSE(water_flow_at(1.0, 2.0).gone[1], 0.0, 0.0); // it begins again, and is not gone
}

// Late and early times are as good as those about 0.
TEST(any_time_is_in_a_period)
{
  const double times[5] = { 1e15, -1e15, -1e-300, 1e-300, -1e-17 };
  for (int i = 0; i < 5; ++i)
  {
    const water_flow flow = water_flow_at(times[i], 2.5);
    assert_true(flow.gone[0] >= 0.0 && flow.gone[0] < 1.0);
    assert_true(flow.gone[1] >= 0.0 && flow.gone[1] < 1.0);
    assert_true(flow.weight >= 0.0 && flow.weight <= 1.0);
  }
  ASSERT_CLOSE(water_flow_at(1e15, 4.0).gone[0], 0.0, 0.0); // a multiple of it
  ASSERT_CLOSE(water_flow_at(1e15 + 1.0, 4.0).gone[0], 0.25, 0.0);
}

static water_axes axes_of(void)
{
  water_axes axes;
  memset(&axes, 0, sizeof axes);
  axes.x_dir[0] = axes.y_dir[1] = axes.normal[2] = 1.0;
  return axes;
}

// Metres become the scene's unit; the mesh's matrix turns a current, and keeps its speed.
TEST(ways_are_in_the_scenes_unit)
{
  const water_axes axes = axes_of();
  // a quarter turn about z, ten times as large and 50 times as high, elsewhere
  const double turned[16] = { 0, -10, 0, 5, 10, 0, 0, 6, 0, 0, 50, 7, 0, 0, 0, 1 };
  double across[3];
  double down[3];
  water_flow_ways(&axes, turned, 3.0, 0.5, across, down);
  const double expected_across[3] = { 0.0, -6.0, 0.0 };
  const double expected_down[3] = { 6.0, 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(across[i], expected_across[i], 1e-12);
    ASSERT_CLOSE(down[i], expected_down[i], 1e-12);
  }
  const double flat[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1 };
  water_flow_ways(&axes, flat, 3.0, 0.5, across, down);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(across[i], 0.0, 0.0);
    ASSERT_CLOSE(down[i], 0.0, 0.0);
  }
}

// Layers in one place are one; independent ones, with half the weight each, have half the variance.
TEST(the_variance_is_kept)
{
  ASSERT_CLOSE(water_shared_flow_gain(0.5, 0.0, 0.3), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_flow_gain(1.0, 9.0, 0.3), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_flow_gain(0.0, 9.0, 0.3), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_flow_gain(0.5, 9.0, 0.3), sqrt(2.0), 1e-12);
  ASSERT_CLOSE(water_shared_flow_gain(0.25, 9.0, 0.3), 1.0 / hypot(0.25, 0.75), 1e-12);
  const double near = water_shared_flow_gain(0.5, 0.3, 0.3);
  ASSERT_CLOSE(near * near * 0.5 * (1.0 + exp(-1.0)), 1.0, 1e-12);
  ASSERT_CLOSE(water_flow_likeness(4.0), 0.5, 0.0);
  assert_true(water_flow_likeness(0.0) > 1e20);
}

// A band of waves, too: one layer has all, two in one place are one, and far ones are independent;
// between them the gain is that of waves whose wave numbers are spread evenly in their logarithm.
TEST(the_variance_of_a_band_is_kept)
{
  ASSERT_CLOSE(water_shared_flow_band_gain(0.5, 0.0, 0.2, 4.0), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_flow_band_gain(1.0, 9.0, 0.2, 4.0), 1.0, 0.0);
  ASSERT_CLOSE(water_shared_flow_band_gain(0.5, 9e4, 0.2, 4.0), sqrt(2.0), 1e-6);
  for (double apart = 0.05; apart < 50.0; apart *= 2.0)
  {
    double likeness = 0.0;
    const int steps = 4000;
    for (int i = 0; i < steps; ++i)
    {
      const double far = apart / 1.1 * 0.2 * pow(4.0 / 0.2, (i + 0.5) / steps);
      likeness += 1.0 / (1.0 + far * far) / steps;
    }
    const double gain = water_shared_flow_band_gain(0.3, apart, 0.2, 4.0);
    ASSERT_CLOSE(gain * gain * (0.09 + 0.49 + 0.42 * likeness), 1.0, 1e-5);
  }
}

// What solvers fill dry places with is no velocity.
TEST(velocities_that_no_water_has_count_as_0)
{
  ASSERT_CLOSE(water_flow_component(-3.5), -3.5, 0.0);
  ASSERT_CLOSE(water_flow_component(WATER_FLOW_SPEED_MAX), WATER_FLOW_SPEED_MAX, 0.0);
  const double none[] = { NAN, INFINITY, -INFINITY, 9.96921e36, -1e20, 1.001e4 };
  for (size_t i = 0; i < sizeof none / sizeof none[0]; ++i)
  {
    ASSERT_CLOSE(water_flow_component(none[i]), 0.0, 0.0);
  }
}

// A mesh that its matrix makes flat, or larger than numbers go, has no current.
TEST(meshes_without_a_size_have_no_current)
{
  const water_axes axes = axes_of();
  for (int i = 0; i < 2; ++i)
  {
    const double size = i == 0 ? 0.0 : 1e200;
    const double matrix[16] = { size, 0.0, 0.0, 0.0, 0.0, size, 0.0, 0.0, 0.0, 0.0, size, 0.0, 0.0,
      0.0, 0.0, 1.0 };
    double across[3] = { 7.0, 7.0, 7.0 };
    double down[3] = { 7.0, 7.0, 7.0 };
    water_flow_ways(&axes, matrix, 4.0, 1.0, across, down);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_CLOSE(across[k], 0.0, 0.0);
      ASSERT_CLOSE(down[k], 0.0, 0.0);
    }
  }
}

// A matrix that flattens a mesh upright leaves no area for a current.
TEST(flattened_meshes_have_no_current)
{
  const water_axes axes = axes_of();
  const double matrix[16] = { 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double across[3];
  double down[3];
  water_flow_ways(&axes, matrix, 4.0, 1.0, across, down);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(across[i], 0.0, 0.0);
    ASSERT_CLOSE(down[i], 0.0, 0.0);
  }
}

TESTS(flattened_meshes_have_no_current, meshes_without_a_size_have_no_current,
  velocities_that_no_water_has_count_as_0, layers_take_turns, any_time_is_in_a_period,
  ways_are_in_the_scenes_unit, the_variance_is_kept, the_variance_of_a_band_is_kept)
