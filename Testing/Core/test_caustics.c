// SPDX-License-Identifier: BSD-3-Clause
// test_caustics.c: light under waves goes where Snell's law says, is neither lost nor made, and is
// followed from all of the surface that lights what the eye sees.
#include "test_scene.h"

#include <stdlib.h>

#include "water_caustics.h"
#include "water_caustics_plan.h"
#include "water_medium.h"

static const double pi = 3.141592653589793;

static void sun_at(double height_deg, double turn_deg, double sun_dir[3])
{
  const double height = height_deg * pi / 180.0;
  const double turn = turn_deg * pi / 180.0;
  sun_dir[0] = cos(height) * cos(turn);
  sun_dir[1] = cos(height) * sin(turn);
  sun_dir[2] = sin(height);
}

// The way aside is that of the refracted ray, for any sun and slope.
TEST(way_is_snells)
{
  dice from = dice_seeded(7);
  for (int i = 0; i < 1000; ++i)
  {
    double sun_dir[3];
    sun_at(dice_roll(&from, 10.0, 90.0), dice_roll(&from, 0.0, 360.0), sun_dir);
    const double slope[2] = { dice_roll(&from, -0.15, 0.15), dice_roll(&from, -0.15, 0.15) };
    double normal[3] = { -slope[0], -slope[1], 1.0 };
    normalise(normal);
    const double dir[3] = { -sun_dir[0], -sun_dir[1], -sun_dir[2] };
    double refracted[3];
    double way[2];
    assert_int_equal(water_medium_refract(dir, normal, 1.333, refracted), WATER_OK);
    assert_true(water_caustics_way(sun_dir, slope, 1.333, way));
    ASSERT_CLOSE(way[0], -refracted[0] / refracted[2], 1e-12);
    ASSERT_CLOSE(way[1], -refracted[1] / refracted[2], 1e-12);
  }
}

// A surface that faces away from the sun lets no light in.
TEST(no_light_comes_from_behind)
{
  double sun_dir[3];
  sun_at(20.0, 0.0, sun_dir);
  const double slope[2] = { 3.0, 0.0 };
  double way[2] = { 5.0, 6.0 };
  assert_false(water_caustics_way(sun_dir, slope, 1.333, way));
  ASSERT_CLOSE(way[0], 5.0, 0.0);
}

// Under the zenith a slope g turns light by (1 - 1/n) g.
TEST(turn_is_that_of_small_slopes)
{
  double sun_dir[3];
  double turn[3];
  sun_at(90.0, 0.0, sun_dir);
  water_caustics_turn(sun_dir, 1.333, turn);
  ASSERT_CLOSE(turn[0], 1.0 - 1.0 / 1.333, 1e-6);
  ASSERT_CLOSE(turn[1], 0.0, 1e-9);
  ASSERT_CLOSE(turn[2], 1.0 - 1.0 / 1.333, 1e-6);
}

// Under a slanting sun they turn it by what Snell's law says: the symmetric part of the changes of
// both ways aside with both slopes.
TEST(turn_is_the_change_of_the_refracted_way)
{
  const double step = 1e-4;
  for (int azimuth = 25; azimuth < 360; azimuth += 55)
  {
    double sun_dir[3];
    double turn[3];
    double change[2][2];
    sun_at(40.0, azimuth, sun_dir);
    water_caustics_turn(sun_dir, 1.333, turn);
    const double dir[3] = { -sun_dir[0], -sun_dir[1], -sun_dir[2] };
    for (int axis = 0; axis < 2; ++axis)
    {
      double aside[2][2];
      for (int side = 0; side < 2; ++side)
      {
        double normal[3] = { 0.0, 0.0, 1.0 };
        double refracted[3];
        normal[axis] = side == 0 ? step : -step;
        normalise(normal);
        assert_int_equal(water_medium_refract(dir, normal, 1.333, refracted), WATER_OK);
        aside[side][0] = -refracted[0] / refracted[2];
        aside[side][1] = -refracted[1] / refracted[2];
      }
      change[0][axis] = 0.5 * (aside[1][0] - aside[0][0]) / step;
      change[1][axis] = 0.5 * (aside[1][1] - aside[0][1]) / step;
    }
    ASSERT_CLOSE(turn[0], change[0][0], 1e-6);
    ASSERT_CLOSE(turn[1], 0.5 * (change[0][1] + change[1][0]), 1e-6);
    ASSERT_CLOSE(turn[2], change[1][1], 1e-6);
    assert_true(fabs(turn[1]) > 1e-3);
  }
}

// The sun's disc spreads as rays of it do, refracted one by one.
TEST(spread_is_that_of_rays_of_the_disc)
{
  static const double heights[3] = { 90.0, 50.0, 20.0 };
  const double flat[2] = { 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    double sun_dir[3];
    double side[3] = { 0.0, 0.0, 0.0 };
    double up[3];
    double spread[3];
    double sum[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
    sun_at(heights[i], 30.0, sun_dir);
    side[0] = -sin(30.0 * pi / 180.0);
    side[1] = cos(30.0 * pi / 180.0);
    cross(sun_dir, side, up);
    water_caustics_sun_spread(sun_dir, 1.333, spread);
    const int rings = 100;
    const int count = rings * rings;
    for (int k = 0; k < count; ++k)
    {
      const double radius = tan(0.2665 * pi / 180.0) * sqrt((k + 0.5) / count);
      const double angle = 2.399963 * k; // the golden angle: an even disc
      double ray[3];
      double way[2];
      for (int axis = 0; axis < 3; ++axis)
      {
        ray[axis] = sun_dir[axis] + radius * (cos(angle) * side[axis] + sin(angle) * up[axis]);
      }
      normalise(ray);
      assert_true(water_caustics_way(ray, flat, 1.333, way));
      sum[0] += way[0] / count;
      sum[1] += way[1] / count;
      sum[2] += way[0] * way[0] / count;
      sum[3] += way[0] * way[1] / count;
      sum[4] += way[1] * way[1] / count;
    }
    ASSERT_CLOSE(spread[0], sum[2] - sum[0] * sum[0], 0.01 * (spread[0] + spread[2]));
    ASSERT_CLOSE(spread[1], sum[3] - sum[0] * sum[1], 0.01 * (spread[0] + spread[2]));
    ASSERT_CLOSE(spread[2], sum[4] - sum[1] * sum[1], 0.01 * (spread[0] + spread[2]));
  }
}

// What a photon brings is what it gives to the texels, wherever it is and whatever its shape.
TEST(adding_keeps_the_light)
{
  enum
  {
    SIDE = 64
  };
  const int texture_px[2] = { SIDE, SIDE };
  dice from = dice_seeded(11);
  double sum_all = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    float light[SIDE * SIDE] = { 0.0f };
    const double first = dice_roll(&from, 0.4, 6.0);
    const double second = dice_roll(&from, 0.4, 6.0);
    const double angle = dice_roll(&from, 0.0, 3.0);
    const double c = cos(angle);
    const double s = sin(angle);
    const double xx = c * c * first + s * s * second; // covariance
    const double xy = c * s * (first - second);
    const double yy = s * s * first + c * c * second;
    const double determinant = first * second;
    const float place[4] = { (float)dice_roll(&from, 20.0, 44.0),
      (float)dice_roll(&from, 20.0, 44.0), (float)(0.4 / (pi * sqrt(determinant))), 0.0f };
    const float shape[4] = { (float)(yy / (10.0 * determinant)),
      (float)(-xy / (10.0 * determinant)), (float)(xx / (10.0 * determinant)), 0.0f };
    double sum = 0.0;
    double moment = 0.0;
    water_caustics_add(place, shape, 1, texture_px, light);
    for (int k = 0; k < SIDE * SIDE; ++k)
    {
      const double dx = k % SIDE + 0.5 - (double)place[0];
      sum += (double)light[k];
      moment += (double)light[k] * dx * dx;
    }
    ASSERT_CLOSE(sum, 1.0, 0.15);
    ASSERT_CLOSE(moment, xx, 0.1 * xx + 0.06);
    sum_all += sum / 200.0;
  }
  ASSERT_CLOSE(sum_all, 1.0, 0.01);
}

// Photons of a list give what each gives, with its own place and shape.
TEST(several_photons_add_up)
{
  const int texture_px[2] = { 4, 4 };
  const float places[12] = { 1.0f, 1.0f, 1.0f, 0.0f, 3.0f, 1.5f, 2.0f, 0.0f, 2.0f, 3.0f, 0.5f,
    0.0f };
  const float shapes[12] = { 0.5f, 0.1f, 0.25f, 0.0f, 1.0f, 0.0f, 0.5f, 0.0f, 0.125f, -0.0625f,
    0.5f, 0.0f };
  float together[16] = { 0.0f };
  float alone[16] = { 0.0f };
  water_caustics_add(places, shapes, 3, texture_px, together);
  for (int i = 0; i < 3; ++i)
  {
    water_caustics_add(places + 4 * i, shapes + 4 * i, 1, texture_px, alone);
  }
  assert_memory_equal(together, alone, sizeof alone);
  assert_true(alone[0] > 0.1f && alone[10] > 0.1f);
}

// Photons beyond the texture's border give it what reaches in, and write nowhere else.
TEST(photons_outside_stay_outside)
{
  const int texture_px[2] = { 4, 3 };
  float light[3 * 4 + 8] = { 0.0f };
  const float shape[4] = { 0.1f, 0.0f, 0.1f, 0.0f };
  static const float places[8][4] = { { -10.0f, 1.0f, 1.0f, 0.0f }, { 1.0f, 30.0f, 1.0f, 0.0f },
    { -1e6f, -1e6f, 1.0f, 0.0f }, { 1e30f, 0.0f, 1.0f, 0.0f }, { -1.0f, 1.5f, 1.0f, 0.0f },
    { 2.0f, 1.5f, 0.0f, 0.0f }, { 2.0f, 1.5f, -1.0f, 0.0f }, { NAN, 1.5f, 1.0f, 0.0f } };
  for (int i = 0; i < 8; ++i)
  {
    water_caustics_add(places[i], shape, 1, texture_px, light + 4);
  }
  for (int i = 0; i < 4; ++i)
  {
    ASSERT_CLOSE((double)light[i], 0.0, 0.0);
    ASSERT_CLOSE((double)light[16 + i], 0.0, 0.0);
  }
  assert_true(light[4 + 4] > 0.3f); // the left texel of the middle row
  ASSERT_CLOSE((double)light[4 + 7], 0.0, 0.0);
}

static water_plan plan_over_bed(water_scene* scene, water_cull_reason* reasons)
{
  water_plan plan = plan_of(scene, reasons);
  plan.bed_depth = 3.0;
  plan.has_sun = true;
  sun_at(50.0, 25.0, plan.sun_dir);
  return plan;
}

static const water_caustics_input usual = { 1.333, 0.1, 0.05, { 400, 300 }, 16384, true };

// A place on the plane comes to where the eye sees it, and to where its light lies at the middle
// depth.
static void check_places(water_scene scene)
{
  water_cull_reason reasons[8];
  const water_plan plan = plan_over_bed(&scene, reasons);
  water_caustics made;
  assert_true(water_caustics_plan(&plan, &usual, &made));
  for (int i = 0; i < 9; ++i)
  {
    const double ndc[3] = { 0.3 * (i % 3 - 1), 0.2 * (i / 3) - 0.7, 1.0 };
    const double w = dot(plan.ndc_to_plane + 6, ndc);
    const double place[3] = { dot(plan.ndc_to_plane, ndc) / w, dot(plan.ndc_to_plane + 3, ndc) / w,
      1.0 };
    const double* m = made.place_to_clip;
    const double clip_w = dot(m + 6, place);
    ASSERT_CLOSE(dot(m, place) / clip_w, ndc[0], 1e-9);
    ASSERT_CLOSE(dot(m + 3, place) / clip_w, ndc[1], 1e-9);
    // a light's way on to the middle depth
    const double at[3] = { place[0] + made.middle * made.calm_way[0],
      place[1] + made.middle * made.calm_way[1], 1.0 };
    const double seen_w = dot(m + 6, at) - made.middle * made.rise_clip[2];
    const double light_w = dot(made.place_to_light + 6, place);
    for (int axis = 0; axis < 2; ++axis)
    {
      const double seen = (dot(m + 3 * axis, at) - made.middle * made.rise_clip[axis]) / seen_w;
      ASSERT_CLOSE(dot(made.place_to_light + 3 * axis, place) / light_w,
        made.texel_of_ndc[axis] * seen + made.texel_of_ndc[2 + axis], 1e-6);
    }
  }
}

// The same lake for an eye without perspective.
static water_scene lake_in_parallel(void)
{
  water_scene scene = lake();
  const double box[4] = { -8.0, 8.0, -6.0, 6.0 };
  ortho_matrix(box, 1.0, 1000.0, scene.eye.view_to_clip);
  scene.eye.parallel = true;
  return scene;
}

TEST(places_come_to_their_texels)
{
  check_places(lake());
  check_places(lake_in_parallel());
}

// To an eye without perspective all pixels are equally near, and the middle depth is half of the
// bed's.
TEST(parallel_eyes_have_caustics_everywhere)
{
  water_scene scene = lake_in_parallel();
  water_cull_reason reasons[8];
  water_plan plan = plan_over_bed(&scene, reasons);
  water_caustics made;
  assert_true(water_caustics_plan(&plan, &usual, &made));
  ASSERT_CLOSE(made.depth, 3.0, 1e-12);
  ASSERT_CLOSE(made.middle, 1.5, 1e-12);
  ASSERT_CLOSE(made.near[0], 0.0, 0.0);
  ASSERT_CLOSE(made.near[1], 0.0, 0.0);
  assert_true(made.near[2] > 1.0);
  plan.bed_depth = INFINITY; // and the water is clear without an end
  water_caustics_input clear = usual;
  clear.extinction = 0.0;
  assert_false(water_caustics_plan(&plan, &clear, &made));
}

// The grid reaches beyond the texture of light on all sides, for waves bring light from there.
TEST(grid_covers_the_texture)
{
  water_scene scene = lake();
  water_cull_reason reasons[8];
  water_plan plan = plan_over_bed(&scene, reasons);
  plan.bed_depth = 0.3; // of a deep one the border of places cuts both
  water_caustics made;
  water_caustics_input steep = usual;
  steep.slope_rms = 0.3;
  assert_true(water_caustics_plan(&plan, &steep, &made));
  double low[2] = { 1e9, 1e9 };
  double high[2] = { -1e9, -1e9 };
  for (int i = 0; i < 4; ++i)
  {
    const double grid[3] = { i & 1, i >> 1, 1.0 };
    const double* m = made.grid_to_source;
    const double w = dot(m + 6, grid);
    assert_true(w > 0.0);
    const double place[3] = { dot(m, grid) / w, dot(m + 3, grid) / w, 1.0 };
    for (int axis = 0; axis < 2; ++axis)
    {
      const double texel =
        dot(made.place_to_light + 3 * axis, place) / dot(made.place_to_light + 6, place);
      low[axis] = fmin(low[axis], texel);
      high[axis] = fmax(high[axis], texel);
    }
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    assert_true(low[axis] < 1e-6); // at the shore light goes straight through
    assert_true(high[axis] > made.texture_px[axis]);
    assert_true(made.count[axis] >= 2 && made.count[axis] <= 4096);
  }
  assert_true(low[0] < -1.0);
  assert_true(high[0] > made.texture_px[0] + 1.0);
}

// From straight above, sight is turned by a quarter of the slopes, and light under a low sun by
// about as much as they are: the texture is no wider than sight reaches, and the grid as wide as
// both.
TEST(the_texture_is_as_wide_as_sight)
{
  water_scene scene = lake();
  water_cull_reason reasons[8];
  const double eye[3] = { 0.0, 0.0, 20.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  look_at(eye, target, up, scene.eye.world_to_view);
  water_plan plan = plan_over_bed(&scene, reasons);
  sun_at(25.0, 25.0, plan.sun_dir);
  double sides[2]; // of the texture in places, without slopes and with them
  for (int i = 0; i < 2; ++i)
  {
    water_caustics_input input = usual;
    input.slope_rms = i == 0 ? 0.0 : 0.05;
    water_caustics made;
    assert_true(water_caustics_plan(&plan, &input, &made));
    const double turn = 2.5 * input.slope_rms * fmax(made.turn[0], made.turn[2]);
    assert_true(i == 0 || turn > 3.0 * 2.5 * input.slope_rms * 0.25);
    sides[i] = made.texture_px[0] / made.place_to_light[0] * made.place_to_light[8];
  }
  const double sight = 2.0 * 2.5 * 0.05 * 0.25 * 3.0; // to both sides, at the bed's depth
  assert_true(sides[1] - sides[0] > 0.9 * sight && sides[1] - sides[0] < 1.6 * sight);
}

// Nothing is planned without a sun, without a bed, or for an eye under water.
TEST(no_caustics_without_sun_bed_or_eye_above)
{
  water_scene scene = lake();
  water_cull_reason reasons[8];
  const water_plan right = plan_over_bed(&scene, reasons);
  water_caustics made;
  water_plan plan = right;
  plan.has_sun = false;
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  plan.bed_depth = 0.0;
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  plan.is_submerged = true;
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  plan.side = WATER_BELOW;
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  plan.has_view = false;
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  memset(plan.ndc_to_plane, 0, sizeof plan.ndc_to_plane);
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  sun_at(0.0, 0.0, plan.sun_dir); // on the horizon
  assert_false(water_caustics_plan(&plan, &usual, &made));
  plan = right;
  plan.bed_depth = 1e-6; // narrower than any pixel
  assert_false(water_caustics_plan(&plan, &usual, &made));
  for (int i = 0; i < 2; ++i)
  {
    water_caustics_input nowhere = usual;
    nowhere.viewport_px[i] = 0;
    assert_false(water_caustics_plan(&right, &nowhere, &made));
  }
  assert_true(water_caustics_plan(&right, &usual, &made));
  plan = right;
  plan.bed_depth = INFINITY; // the water itself ends what is seen
  assert_true(water_caustics_plan(&plan, &usual, &made));
  assert_true(made.depth < 100.0);
}

// Light from under the horizon leads nowhere, and light along it is not turned by slopes.
TEST(light_from_under_the_horizon_leads_nowhere)
{
  double sun_dir[3];
  double turn[3] = { 7.0, 7.0, 7.0 };
  double way[2] = { 5.0, 6.0 };
  const double towards[2] = { -3.0, 0.0 };
  sun_at(-30.0, 0.0, sun_dir);
  assert_false(water_caustics_way(sun_dir, towards, 1.333, way));
  ASSERT_CLOSE(way[0], 5.0, 0.0);
  water_caustics_turn(sun_dir, 1.333, turn);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(turn[i], 0.0, 0.0);
  }
}

// A photon whose ellipse has no area gives nothing.
TEST(photons_without_an_area_give_nothing)
{
  const int texture_px[2] = { 4, 4 };
  const float place[4] = { 2.0f, 2.0f, 1.0f, 0.0f };
  const float shapes[4][4] = { { 0.0f, 0.0f, 0.0f, 0.0f }, { 1.0f, 2.0f, 1.0f, 0.0f },
    { 0.1f, NAN, 0.1f, 0.0f }, { 0.125f, 0.125f, 0.125f, 0.0f } }; // the last: a line
  float light[16] = { 0.0f };
  for (int i = 0; i < 4; ++i)
  {
    water_caustics_add(place, shapes[i], 1, texture_px, light);
  }
  for (int i = 0; i < 16; ++i)
  {
    ASSERT_CLOSE((double)light[i], 0.0, 0.0);
  }
}

// Pixels whose rays go up look at no bed: the texture is not laid for them.
TEST(pixels_that_look_up_need_no_light)
{
  water_scene scene = lake_in_parallel();
  water_cull_reason reasons[8];
  water_plan plan = plan_over_bed(&scene, reasons);
  water_caustics all;
  water_caustics half;
  assert_true(water_caustics_plan(&plan, &usual, &all));
  plan.ndc_to_ray[7] = -4.0 * plan.ndc_to_ray[8]; // those above a quarter of the picture look up
  assert_true(water_caustics_plan(&plan, &usual, &half));
  assert_true(half.texture_px[0] * half.texture_px[1] < all.texture_px[0] * all.texture_px[1]);
}

// A slanting photon gives each texel the cube of 1 less the square of its distance, by its own
// shape, up to the texture's border.
TEST(a_photon_gives_by_its_shape)
{
  const int texture_px[2] = { 4, 4 };
  const float place[4] = { 2.0f, 2.0f, 2.0f, 0.0f };
  const float shape[4] = { 0.125f, 0.0625f, 0.25f, 0.0f };
  float light[16] = { 0.0f };
  water_caustics_add(place, shape, 1, texture_px, light);
  for (int i = 0; i < 16; ++i)
  {
    const double dx = i % 4 - 1.5;
    const double dy = i / 4 - 1.5;
    const double within = fmax(1.0 - 0.125 * dx * dx - 0.125 * dx * dy - 0.25 * dy * dy, 0.0);
    ASSERT_CLOSE((double)light[i], 2.0 * within * within * within, 1e-6);
  }
}

// Light that runs along the water after its refraction reaches no bed.
TEST(light_that_stays_level_reaches_no_bed)
{
  const double level[3] = { 1.0, 0.0, 0.0 };
  const double slope[2] = { -0.75, 0.0 }; // towards the light; an index of 1 bends nothing
  double way[2] = { 5.0, 5.0 };
  assert_false(water_caustics_way(level, slope, 1.0, way));
  ASSERT_CLOSE(way[0], 5.0, 0.0);
}

// An eye just as high as its dome port is wide sees the bed as any other eye; under that height,
// along straight rays, and its light is followed deeper.
TEST(a_port_that_touches_the_water_is_not_in_it)
{
  water_scene scene = pool(30.0); // from 10 over the water
  water_cull_reason reasons[8];
  water_plan plan = plan_over_bed(&scene, reasons);
  plan.bed_depth = 1000.0;
  water_caustics_input input = usual;
  input.extinction = 1e-9;
  double depths[3];
  for (int i = 0; i < 3; ++i)
  {
    input.port_radius = 9.0 + i;
    water_caustics made;
    assert_true(water_caustics_plan(&plan, &input, &made));
    depths[i] = made.depth;
  }
  ASSERT_CLOSE(depths[1], depths[0], 0.0);
  ASSERT_CLOSE(depths[2], 1000.0, 0.0);
  assert_true(depths[1] < 1000.0);
}

// Photons beside a texture of one texel write nowhere else.
TEST(a_texture_may_have_one_texel)
{
  const int texture_px[2] = { 1, 1 };
  const float shape[4] = { 0.25f, 0.0f, 0.25f, 0.0f };
  float* light = calloc(1, sizeof *light); // sanitizers see who writes on
  assert_non_null(light);
  for (int i = 0; i < 9; ++i)
  {
    const float place[4] = { 10.5f * (float)(i % 3 - 1) + 0.5f, 10.5f * (float)(i / 3 - 1) + 0.5f,
      1.0f, 0.0f };
    water_caustics_add(place, shape, 1, texture_px, light);
  }
  ASSERT_CLOSE((double)*light, 1.0, 1e-6);
  free(light);
}

TESTS(turn_is_the_change_of_the_refracted_way, several_photons_add_up,
  a_port_that_touches_the_water_is_not_in_it, a_texture_may_have_one_texel,
  a_photon_gives_by_its_shape, light_that_stays_level_reaches_no_bed,
  light_from_under_the_horizon_leads_nowhere, photons_without_an_area_give_nothing,
  pixels_that_look_up_need_no_light, parallel_eyes_have_caustics_everywhere, way_is_snells,
  no_light_comes_from_behind, turn_is_that_of_small_slopes, spread_is_that_of_rays_of_the_disc,
  adding_keeps_the_light, photons_outside_stay_outside, places_come_to_their_texels,
  grid_covers_the_texture, the_texture_is_as_wide_as_sight,
  no_caustics_without_sun_bed_or_eye_above)
