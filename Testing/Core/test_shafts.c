// SPDX-License-Identifier: BSD-3-Clause
// test_shafts.c: the light around an eye under water lies over the places that light it, and the
// steps of a view ray share its scattered light, which none of them makes or loses.
#include "test_scene.h"

#include "water_shafts.h"
#include "water_shared.h"

static const water_caustics_input usual = { 1.333, 0.1, 0.05, { 0, 0 }, 16384, true };

// An eye 4 m under the plane; the third axis points down, and so does that of the sun.
static water_plan plan_under(void)
{
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  plan.has_view = plan.has_sun = plan.is_submerged = true;
  plan.side = WATER_BELOW;
  plan.plane_view[3] = 4.0;
  plan.clip_w[2] = -1.0;
  plan.sun_dir[0] = 0.6;
  plan.sun_dir[2] = -0.8;
  return plan;
}

static void place_of(const double map[9], double x, double y, double place[2])
{
  const double at[3] = { x, y, 1.0 };
  place[0] = dot(map, at) / dot(map + 6, at);
  place[1] = dot(map + 3, at) / dot(map + 6, at);
}

// The place that lights the eye is in the middle; the grid is wider than the texture.
TEST(the_light_is_around_the_eye)
{
  const water_plan plan = plan_under();
  water_shafts made;
  assert_true(water_shafts_plan(&plan, &usual, &made));
  const water_caustics* light = &made.light;
  const double aside = 0.6 / 1.333 / sqrt(1.0 - 0.36 / 1.333 / 1.333); // Snell's law
  ASSERT_CLOSE(light->calm_way[0], -aside, 1e-12);
  ASSERT_CLOSE(light->calm_way[1], 0.0, 1e-12);
  double at[2];
  place_of(light->place_to_light, 4.0 * aside, 0.0, at);
  ASSERT_CLOSE(at[0], 0.5 * light->texture_px[0], 1e-9);
  ASSERT_CLOSE(at[1], 0.5 * light->texture_px[1], 1e-9);
  ASSERT_CLOSE(made.eye_depth, 4.0, 0.0);
  ASSERT_CLOSE(light->depth, 4.0, 0.0);
  ASSERT_CLOSE(light->sun_dir[2], 0.8, 0.0);
  ASSERT_CLOSE(light->index, 1.333, 0.0);
  assert_true(light->is_level && light->is_added && made.steps > 0);
  for (int i = 0; i < 9; ++i)
  {
    const double x = 3.0 * (i % 3 - 1);
    const double y = 5.0 * (i / 3 - 1);
    place_of(light->place_to_light, x, y, at);
    ASSERT_CLOSE(
      at[0], light->texture_px[0] * (made.place_to_uv[0] * x + made.place_to_uv[1]), 1e-9);
    ASSERT_CLOSE(
      at[1], light->texture_px[1] * (made.place_to_uv[0] * y + made.place_to_uv[2]), 1e-9);
  }
  // waves of 2.5 times their slope bring light from beyond the texture
  const double beyond = 4.0 * 2.5 * 0.1 * fmax(light->turn[0], light->turn[2]);
  for (int i = 0; i < 4; ++i)
  {
    double corner[2];
    place_of(light->grid_to_source, i % 2, i / 2, corner);
    place_of(light->place_to_light, corner[0], corner[1], at);
    for (int k = 0; k < 2; ++k)
    {
      const double texels = beyond * made.place_to_uv[0] * light->texture_px[k];
      const bool is_high = k == 0 ? i % 2 : i / 2;
      ASSERT_CLOSE(at[k], is_high ? light->texture_px[k] + texels : -texels, 1e-6);
    }
  }
}

// In turbid water the square ends where a tenth of the light is left, in clear water ten eye's
// depths away; the texture is no larger than the GPU's limit.
TEST(the_square_ends_where_nothing_is_seen)
{
  const water_plan plan = plan_under();
  water_shafts made;
  water_caustics_input input = usual;
  input.extinction = 1.0;
  assert_true(water_shafts_plan(&plan, &input, &made));
  ASSERT_CLOSE(0.5 / made.place_to_uv[0], log(10.0), 1e-12);
  input.extinction = 1e-3;
  input.max_texture_px = 64;
  assert_true(water_shafts_plan(&plan, &input, &made));
  ASSERT_CLOSE(0.5 / made.place_to_uv[0], 40.0, 1e-12);
  assert_int_equal(made.light.texture_px[0], 64);
  assert_true(made.fade[0] < made.fade[1] && made.fade[1] <= 0.25);
}

// Nothing is planned without a sun over the surface, for an eye that is not under it, for parallel
// rays, and in water without extinction.
TEST(no_shafts_without_sun_eye_in_water_or_scattering)
{
  const water_plan right = plan_under();
  water_shafts made;
  water_plan plan = right;
  plan.has_sun = false;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan = right;
  plan.sun_dir[2] = 0.8;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan = right;
  plan.is_submerged = false;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan = right;
  plan.has_view = false;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan = right;
  plan.clip_w[2] = 0.0;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan = right;
  plan.plane_view[3] = 0.0;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan.plane_view[3] = INFINITY;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  plan.plane_view[3] = -4.0;
  assert_false(water_shafts_plan(&plan, &usual, &made));
  water_caustics_input input = usual;
  input.extinction = 0.0;
  assert_false(water_shafts_plan(&right, &input, &made));
  assert_true(water_shafts_plan(&right, &usual, &made));
}

// An eye deep in turbid water sees little, and the waves light it from far around: the points are
// few enough, or there are no shafts.
TEST(the_points_are_never_too_many)
{
  const water_plan plan = plan_under();
  int planned = 0;
  for (double extinction = 1e-3; extinction < 1e305; extinction *= 3.0)
  {
    water_caustics_input input = usual;
    input.extinction = extinction;
    input.slope_rms = 0.3;
    water_shafts made;
    if (water_shafts_plan(&plan, &input, &made))
    {
      ++planned;
      assert_in_range(made.light.count[0], 2, 1024);
      assert_in_range(made.light.count[1], 2, 1024);
    }
    else
    {
      assert_true(extinction > 0.5);
    }
  }
  assert_in_range(planned, 6, 100);
}

// Steeper waves need more points, up to 1024 of them along a side.
TEST(all_of_the_points_may_be_used)
{
  const water_plan plan = plan_under();
  int most = 0;
  for (int i = 0; i < 4000; ++i)
  {
    water_caustics_input input = usual;
    input.slope_rms = 0.01 * i;
    water_shafts made;
    if (water_shafts_plan(&plan, &input, &made))
    {
      most = made.light.count[0] > most ? made.light.count[0] : most;
    }
  }
  assert_int_equal(most, 1024);
}

// The steps scatter the same light each, and all of them what the whole way does.
TEST(steps_share_the_scattered_light)
{
  static const double ways[3] = { 0.01, 7.0, 1e9 };
  for (int i = 0; i < 3; ++i)
  {
    double from = 0.0;
    double sum = 0.0;
    const double all = 1.0 - exp(-0.2 * ways[i]);
    for (int k = 1; k <= 10; ++k)
    {
      const double to = water_shared_scattered_at(0.2, ways[i], k / 10.0);
      assert_true(to > from && to <= ways[i]);
      ASSERT_CLOSE(water_shared_scattered(0.2, from, to), all / 10.0, 1e-9);
      sum += water_shared_scattered(0.2, from, to);
      from = to;
    }
    ASSERT_CLOSE(sum, all, 1e-9);
  }
}

TESTS(all_of_the_points_may_be_used, the_points_are_never_too_many, the_light_is_around_the_eye,
  the_square_ends_where_nothing_is_seen, no_shafts_without_sun_eye_in_water_or_scattering,
  steps_share_the_scattered_light)
