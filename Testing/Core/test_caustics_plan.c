// SPDX-License-Identifier: BSD-3-Clause
// test_caustics_plan.c: texture and grid of caustics lie where rays, followed through the world,
// say: from the eye through the surface to the bed, from there back to what lights it.
#include "test_baths.h"

static water_caustics made_for(const bath* of)
{
  const water_plan plan = plan_for(of);
  water_caustics made;
  assert_true(water_caustics_plan(&plan, &of->input, &made));
  return made;
}

// Light is followed down to where it no longer comes back from, and the texture lies where pixels
// are as much smaller than those of the surface as they are larger than those of the deepest bed.
TEST(depths_are_those_of_light_that_comes_back)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const answer known = answer_for(&eye);
    const water_caustics made = made_for(&baths[i]);
    ASSERT_CLOSE(made.depth, known.depth, 1e-12 * known.depth);
    ASSERT_CLOSE(made.middle, known.middle, 1e-9);
    ASSERT_CLOSE(made.calm_way[0], known.way[0], 1e-12);
    ASSERT_CLOSE(made.calm_way[1], known.way[1], 1e-12);
    ASSERT_CLOSE(made.index, baths[i].input.index, 0.0);
    assert_int_equal(made.is_added, baths[i].input.is_software);
  }
}

// The texture covers what lights the bed of the picture, with texels as large as pixels.
TEST(texture_lies_where_traced_rays_come_from)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const answer known = answer_for(&eye);
    const water_caustics made = made_for(&baths[i]);
    const int* px = baths[i].input.viewport_px;
    const double sides[2] = { known.light[2] - known.light[0], known.light[3] - known.light[1] };
    // twice as fine as the picture, whose NDC are 2 wide, but of no more than 5.2 texels a pixel
    const double shrunk = fmin(1.0, sqrt(5.2 / (sides[0] * sides[1])));
    const double limit = fmin(baths[i].input.max_texture_px, 4096.0);
    for (int axis = 0; axis < 2; ++axis)
    {
      const double wanted = fmin(fmax(sides[axis] * px[axis] * shrunk, 2.0), limit);
      assert_true(made.texture_px[axis] > wanted - 1e-6 && made.texture_px[axis] < wanted + 1.001);
      const double* texel = made.texel_of_ndc;
      ASSERT_CLOSE(texel[axis] * known.light[axis] + texel[2 + axis], 0.0, 1e-6);
      ASSERT_CLOSE(
        texel[axis] * known.light[2 + axis] + texel[2 + axis], (double)made.texture_px[axis], 1e-6);
    }
  }
}

// The bed's depths take 64 texels along the longer side of the picture, as many as its shape leaves
// along the other one, and at least 2.
TEST(bed_has_the_shape_of_the_picture)
{
  static const int expected[BATHS][2] = { { 64, 48 }, { 64, 48 }, { 48, 64 }, { 64, 52 },
    { 64, 48 }, { 48, 64 }, { 48, 64 }, { 48, 64 }, { 64, 64 }, { 64, 64 }, { 64, 2 }, { 64, 57 },
    { 64, 64 }, { 64, 48 }, { 64, 48 }, { 64, 48 }, { 64, 48 } };
  for (int i = 0; i < BATHS; ++i)
  {
    const water_caustics made = made_for(&baths[i]);
    assert_int_equal(made.bed_px[0], expected[i][0]);
    assert_int_equal(made.bed_px[1], expected[i][1]);
  }
}

// The grid covers what lights the texture, slopes included: its points come from where a straight
// ray to the middle depth finds light that came down in calm water.
TEST(grid_lies_where_light_enters)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const answer known = answer_for(&eye);
    const water_caustics made = made_for(&baths[i]);
    for (int point = 0; point < 9; ++point)
    {
      const double grid[3] = { 0.5 * (point % 3), 0.5 * (point / 3), 1.0 };
      const double ndc[2] = { known.grid[0] + grid[0] * (known.grid[2] - known.grid[0]),
        known.grid[1] + grid[1] * (known.grid[3] - known.grid[1]) };
      const double* m = made.grid_to_source;
      const double w = dot(m + 6, grid);
      // what is behind the horizon has a w without a place
      assert_int_equal(w > 0.0, fall_at(&eye, ndc) > 0.0);
      double place[2];
      straight_place(&eye, ndc, known.middle, place);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double source = place[axis] - known.middle * known.way[axis];
        ASSERT_CLOSE(dot(m + 3 * axis, grid) / w, source, 1e-6 * fmax(1.0, fabs(source)));
      }
    }
  }
}

// Points are 1.36 a pixel, along a side, or one and a half standard deviations of the sun's disc
// apart.
TEST(points_are_as_dense_as_the_sun_is_sharp)
{
  int blurred_count = 0;
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const answer known = answer_for(&eye);
    const water_caustics made = made_for(&baths[i]);
    const double pixel =
      known.pixel * (baths[i].is_parallel ? 1.0 : baths[i].eye[2] + known.middle);
    double sun_dir[3];
    double spread[3];
    sun_of(&baths[i], sun_dir);
    water_caustics_sun_spread(sun_dir, baths[i].input.index, spread);
    const double apart = 1.5 * known.depth * sqrt(fmin(spread[0], spread[2])) / pixel;
    blurred_count += apart > 1.0;
    const double limit = fmin(baths[i].input.max_texture_px, 4096.0);
    for (int axis = 0; axis < 2; ++axis)
    {
      // in texels, of which a pixel has 2 along a side
      const double side = (known.grid[2 + axis] - known.grid[axis]) * made.texel_of_ndc[axis];
      const double wanted = fmin(fmax(side * 0.5 * 1.36 / fmax(apart, 1.0), 2.0), limit);
      assert_true(made.count[axis] > wanted - 1e-6 && made.count[axis] < wanted + 1.001);
    }
  }
  assert_int_in_range(blurred_count, 2, BATHS - 2); // both happen
}

// A pixel of 3 depths, seen along the longest ray of the picture, is too wide for caustics.
TEST(pixels_are_near_up_to_three_depths)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const answer known = answer_for(&eye);
    const water_caustics made = made_for(&baths[i]);
    for (int point = 0; point < 9; ++point)
    {
      const double ndc[3] = { point % 3 - 1, point / 3 - 1, 1.0 };
      const double near = baths[i].is_parallel ? 2.0 : fall_at(&eye, ndc) / known.near_fall;
      ASSERT_CLOSE(dot(made.near, ndc), near, 1e-9 * fmax(1.0, fabs(near)));
    }
  }
}

// What a height adds in the eye's clip space is what the camera's matrix adds for a way up.
TEST(heights_rise_in_the_picture)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const lens eye = lens_of(&baths[i]);
    const water_caustics made = made_for(&baths[i]);
    const double up[3] = { 0.0, 0.0, 1.0 };
    double view[4];
    apply(eye.world_to_view, up, 0.0, view);
    ASSERT_CLOSE(made.rise_clip[0], view[0] / baths[i].half[0], 1e-12);
    ASSERT_CLOSE(made.rise_clip[1], view[1] / baths[i].half[1], 1e-12);
    ASSERT_CLOSE(made.rise_clip[2], baths[i].is_parallel ? 0.0 : -view[2], 1e-12);
  }
}

// (x, y, w) and a multiple of it are the same place, also where that turns the sign of w.
TEST(map_to_the_plane_may_have_any_scale)
{
  for (int i = 0; i < BATHS; ++i)
  {
    const water_caustics expected = made_for(&baths[i]);
    for (int sign = -1; sign <= 1; sign += 2)
    {
      water_plan plan = plan_for(&baths[i]);
      for (int j = 0; j < 9; ++j)
      {
        plan.ndc_to_plane[j] *= 2.0 * sign; // exact
      }
      water_caustics made;
      assert_true(water_caustics_plan(&plan, &baths[i].input, &made));
      assert_memory_equal(made.texture_px, expected.texture_px, sizeof made.texture_px);
      assert_memory_equal(made.count, expected.count, sizeof made.count);
      for (int j = 0; j < 9; ++j)
      {
        ASSERT_CLOSE(made.place_to_clip[j], expected.place_to_clip[j], 0.0);
        ASSERT_CLOSE(made.grid_to_source[j], 2.0 * expected.grid_to_source[j], 0.0);
        ASSERT_CLOSE(made.near[j / 3], expected.near[j / 3], 0.0);
      }
    }
  }
}

// To a bed of no depth no light has a way to go, however near the pixels are.
TEST(bed_at_the_surface_has_no_caustics)
{
  bath none = baths[1];
  none.depth = 0.0;
  const water_plan plan = plan_for(&none);
  water_caustics made;
  assert_false(water_caustics_plan(&plan, &none.input, &made));
}

// Where an eye sees the bed of a depth along a straight ray of a pixel, in texels of the light.
static void straight_texel(const lens* eye, const water_caustics* made, const double ndc[2],
  double depth, const double way[2], double texel[2])
{
  double place[3] = { 0.0, 0.0, 1.0 };
  straight_place(eye, ndc, depth, place);
  for (int i = 0; i < 2; ++i)
  {
    place[i] -= depth * way[i];
  }
  const double w = dot(made->place_to_light + 6, place);
  assert_true(w > 0.0);
  texel[0] = dot(made->place_to_light, place) / w;
  texel[1] = dot(made->place_to_light + 3, place) / w;
}

// A dome port that reaches into the water shows the bed along straight rays, however close the eye
// is to the surface: light is followed as deep as without an eye, and the texture has what lights
// beds of eight radii, of ten and of forty.
TEST(port_sees_the_bed_along_straight_rays)
{
  static const bath split = { { 1, 2, 0.05 }, { 1, 12, -2 }, { 0, 0, 1 }, { 0.8, 0.6 }, false, 13.0,
    { 50, 100 }, { 1.333, 0.05, 0.05, { 400, 300 }, 16384, true, 0.3 } };
  const lens eye = lens_of(&split);
  const answer known = answer_for(&eye);
  const water_caustics made = made_for(&split);
  ASSERT_CLOSE(made.depth, 13.0, 0.0);
  ASSERT_CLOSE(made.middle, 3.0, 1e-12);
  ASSERT_CLOSE(made.search[0], 3.0, 1e-12);
  ASSERT_CLOSE(made.search[1], 3.0, 1e-12);
  static const double depths[3] = { 2.4, 3.0, 12.0 };
  for (int i = 0; i < 27; ++i)
  {
    const double ndc[2] = { i % 3 - 1, -0.4 * (i / 3 % 3) - 0.2 };
    double texel[2];
    straight_texel(&eye, &made, ndc, depths[i / 9], known.way, texel);
    for (int axis = 0; axis < 2; ++axis)
    {
      assert_true(texel[axis] >= -1e-6 && texel[axis] <= made.texture_px[axis] + 1e-6);
      if (depths[i / 9] == 3.0) // the middle is seen where it is
      {
        ASSERT_CLOSE(
          texel[axis], made.texel_of_ndc[axis] * ndc[axis] + made.texel_of_ndc[2 + axis], 1e-6);
      }
    }
  }
  // up to pixels of three depths, which are twice as far as without a port, where light is followed
  // to four heights of the eye
  const double low[3] = { -1.0, -1.0, 1.0 };
  ASSERT_CLOSE(dot(made.near, low), fall_at(&eye, low) / (2.0 * known.near_fall), 1e-9);
}

// A port that does not reach into the water changes nothing.
TEST(port_over_the_water_is_none)
{
  for (int i = 0; i < BATHS; ++i)
  {
    bath over = baths[i];
    over.input.port_radius = 0.99 * over.eye[2];
    const water_caustics expected = made_for(&baths[i]);
    const water_caustics made = made_for(&over);
    assert_memory_equal(&made, &expected, sizeof made);
    ASSERT_CLOSE(made.search[0], made.depth, 0.0);
    ASSERT_CLOSE(made.search[1], 0.0, 0.0);
  }
}

TESTS(depths_are_those_of_light_that_comes_back, texture_lies_where_traced_rays_come_from,
  bed_has_the_shape_of_the_picture, grid_lies_where_light_enters,
  points_are_as_dense_as_the_sun_is_sharp, pixels_are_near_up_to_three_depths,
  heights_rise_in_the_picture, map_to_the_plane_may_have_any_scale,
  bed_at_the_surface_has_no_caustics, port_sees_the_bed_along_straight_rays,
  port_over_the_water_is_none)
