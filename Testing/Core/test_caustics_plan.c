// SPDX-License-Identifier: BSD-3-Clause
// test_caustics_plan.c: texture and grid of caustics lie where rays, followed through the world,
// say: from the eye through the surface to the bed, from there back to what lights it.
#include "test_scene.h"

#include "water_caustics.h"
#include "water_caustics_plan.h"

static const double pi = 3.141592653589793;

// An eye over the plane z = 0, its bed and its sun.
typedef struct bath
{
  double eye[3];
  double target[3];
  double up[3];
  double half[2]; // of the picture, at a distance of 1; in parallel: its half sides
  bool is_parallel;
  double depth;
  double sun_deg[2]; // height, turn
  water_caustics_input input;
} bath;

// By the order of the fields above. The fifth and the sixth see the horizon; the sixth lies on its
// side, with the water at the left.
static const bath baths[] = {
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1.2, 0.9 }, false, 3.0, { 50, 25 },
    { 1.333, 0.1, 0.05, { 400, 300 }, 16384, true } },
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 400, 300 }, 16384, false } },
  { { 3, -9, 7 }, { 4, 1, 0 }, { 0, 0, 1 }, { 8, 6 }, true, 20.0, { 60, 120 },
    { 1.4, 0.05, 0.0, { 300, 400 }, 16384, false } },
  { { 0, -6, 9 }, { 2, 0, 0 }, { 0, 0, 1 }, { 0.5, 0.4 }, false, 4.0, { 30, 310 },
    { 1.333, 0.05, 0.05, { 500, 400 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 4 }, { 0, 0, 1 }, { 0.8, 0.6 }, false, 2.0, { 35, 80 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 5 }, { 1, 0, 0 }, { 0.6, 0.8 }, false, 1.0, { 70, 10 },
    { 1.333, 0.05, 0.1, { 600, 800 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 5 }, { -1, 0, 0 }, { 0.6, 0.8 }, false, 1.0, { 70, 100 },
    { 1.333, 0.05, 0.1, { 600, 800 }, 16384, false } },
  // deeper than light comes back from; than four heights of the eye
  { { 0, 0, 20 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.3, 0.4 }, false, 90.0, { 20, 45 },
    { 1.333, 0.15, 0.2, { 90, 120 }, 16384, false } },
  { { 0, 0, 2 }, { 0.3, 0, 0 }, { 0, 1, 0 }, { 0.5, 0.5 }, false, 90.0, { 25, 60 },
    { 1.333, 0.2, 0.0, { 256, 256 }, 16384, false } },
  // a picture and a texture of the smallest sizes
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 1, 1 }, 16384, false } },
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 400, 3 }, 64, false } },
  // a picture so large that sides of 4096 are too small
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 0.1, { 40, 200 },
    { 1.333, 0.1, 0.05, { 9000, 8000 }, 16384, false } },
};

enum
{
  BATHS = sizeof baths / sizeof baths[0]
};

static void sun_of(const bath* of, double sun_dir[3])
{
  const double height = of->sun_deg[0] * pi / 180.0;
  const double turn = of->sun_deg[1] * pi / 180.0;
  sun_dir[0] = cos(height) * cos(turn);
  sun_dir[1] = cos(height) * sin(turn);
  sun_dir[2] = sin(height);
}

static water_plan plan_for(const bath* of)
{
  water_scene scene = lake();
  water_cull_reason reasons[8];
  const double box[4] = { -of->half[0], of->half[0], -of->half[1], of->half[1] };
  see_from(&scene, of->eye, of->target, of->up, box, 1.0, 1000.0);
  if (of->is_parallel)
  {
    ortho_matrix(box, 1.0, 1000.0, scene.eye.view_to_clip);
    scene.eye.parallel = true;
  }
  water_plan plan = plan_of(&scene, reasons);
  plan.bed_depth = of->depth;
  plan.has_sun = true;
  sun_of(of, plan.sun_dir);
  return plan;
}

// What light goes aside in calm water, per depth: the tangent of the angle by Snell's law, away
// from where it comes from.
static void snell(const double to_light[3], double index, double way[2])
{
  const double sine = hypot(to_light[0], to_light[1]) / index;
  const double tangent = sine / sqrt(1.0 - sine * sine);
  for (int i = 0; i < 2; ++i)
  {
    way[i] = sine > 0.0 ? -to_light[i] / (index * sine) * tangent : 0.0;
  }
}

// The camera in the world.
typedef struct lens
{
  const bath* of;
  double world_to_view[16]; // rows: right, above, back
} lens;

static lens lens_of(const bath* of)
{
  lens made = { of, { 0.0 } };
  look_at(of->eye, of->target, of->up, made.world_to_view);
  return made;
}

// The ray of a pixel, as long as the picture is away.
static void ray_at(const lens* eye, const double ndc[2], double start[3], double dir[3])
{
  const double* m = eye->world_to_view;
  for (int i = 0; i < 3; ++i)
  {
    const double aside = ndc[0] * eye->of->half[0] * m[i] + ndc[1] * eye->of->half[1] * m[4 + i];
    start[i] = eye->of->eye[i] + (eye->of->is_parallel ? aside : 0.0);
    dir[i] = -m[8 + i] + (eye->of->is_parallel ? 0.0 : aside);
  }
}

// Where the straight ray of a pixel is at a depth, from the point under the eye on.
static void straight_place(const lens* eye, const double ndc[2], double depth, double place[2])
{
  double start[3];
  double dir[3];
  ray_at(eye, ndc, start, dir);
  for (int i = 0; i < 2; ++i)
  {
    place[i] = start[i] + dir[i] * (start[2] + depth) / -dir[2] - eye->of->eye[i];
  }
}

static double widest_turn(const double to_light[3], double index)
{
  double turn[3];
  water_caustics_turn(to_light, index, turn);
  return fmax(turn[0], turn[2]);
}

// What must come out.
typedef struct answer
{
  double depth;
  double middle;
  double pixel;     // of the picture at a distance of 1
  double near_fall; // of a ray, as long as the picture is away: who falls less is too far away
  double way[2];    // of the sun's light
  double light[4];  // in NDC, low x, low y, high x, high y: the texture
  double grid[4];
} answer;

// Takes the bed of a pixel into the box.
static void add_bed(const lens* eye, const answer* known, const double ndc[2], double depth,
  double reach, double box[4])
{
  const bath* of = eye->of;
  double sun_dir[3];
  double start[3];
  double dir[3];
  double way[2];
  double place[2];
  sun_of(of, sun_dir);
  ray_at(eye, ndc, start, dir);
  normalise(dir);
  const double to_eye[3] = { -dir[0], -dir[1], -dir[2] };
  snell(to_eye, of->input.index, way);
  straight_place(eye, ndc, 0.0, place);
  const double sight = 2.5 * of->input.slope_rms *
    fmin(widest_turn(to_eye, of->input.index), widest_turn(sun_dir, of->input.index));
  const double moves = depth * hypot(reach, sight);
  for (int corner = 0; corner < 4; ++corner)
  {
    const double side[2] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0 };
    double at[3] = { 0.0, 0.0, -known->middle };
    for (int i = 0; i < 2; ++i)
    {
      const double bed = of->eye[i] + place[i] + depth * way[i] + side[i] * moves;
      at[i] = bed - depth * known->way[i] + known->middle * known->way[i];
    }
    double view[4];
    apply(eye->world_to_view, at, 1.0, view);
    for (int i = 0; i < 2; ++i)
    {
      const double seen = view[i] / of->half[i] / (of->is_parallel ? 1.0 : fmax(-view[2], 1e-12));
      box[i] = fmin(box[i], fmax(seen, -4.0));
      box[2 + i] = fmax(box[2 + i], fmin(seen, 4.0));
    }
  }
}

static double fall_at(const lens* eye, const double ndc[2])
{
  double start[3];
  double dir[3];
  ray_at(eye, ndc, start, dir);
  return -dir[2];
}

// The bed of the picture's four sides, each in four steps, as far as its pixels are near.
static void find_bed(const lens* eye, const answer* known, double reach, double box[4])
{
  box[0] = box[1] = (double)INFINITY;
  box[2] = box[3] = -(double)INFINITY;
  for (int side = 0; side < 4; ++side)
  {
    const double fixed = side % 2 ? 1.0 : -1.0;
    double ends[2] = { -1.0, 1.0 };
    double ndc[2] = { fixed, fixed };
    const int along = side / 2;
    bool is_near[2];
    for (int k = 0; k < 2; ++k)
    {
      ndc[along] = ends[k];
      is_near[k] = fall_at(eye, ndc) >= known->near_fall;
    }
    if (!is_near[0] && !is_near[1])
    {
      continue;
    }
    if (is_near[0] != is_near[1]) // halve until the border is found
    {
      double near = is_near[0] ? -1.0 : 1.0;
      double far = -near;
      for (int step = 0; step < 60; ++step)
      {
        ndc[along] = 0.5 * (near + far);
        *(fall_at(eye, ndc) >= known->near_fall ? &near : &far) = ndc[along];
      }
      ends[is_near[0] ? 1 : 0] = near;
    }
    for (int step = 0; step <= 4; ++step)
    {
      ndc[along] = ends[0] + 0.25 * step * (ends[1] - ends[0]);
      add_bed(eye, known, ndc, 0.0, reach, box);
      add_bed(eye, known, ndc, known->depth, reach, box);
    }
  }
}

static answer answer_for(const lens* eye)
{
  const bath* of = eye->of;
  const double height = of->eye[2];
  answer known = { .depth = of->depth };
  double sun_dir[3];
  sun_of(of, sun_dir);
  snell(sun_dir, of->input.index, known.way);
  if (of->input.extinction > 0.0) // on both ways together a 256th of the light is left
  {
    known.depth = fmin(known.depth, 0.5 * log(256.0) / of->input.extinction);
  }
  known.depth = of->is_parallel ? known.depth : fmin(known.depth, 4.0 * height);
  known.middle =
    of->is_parallel ? 0.5 * known.depth : sqrt(height * (height + known.depth)) - height;
  known.pixel = 2.0 * of->half[1] / of->input.viewport_px[1];
  if (!of->is_parallel)
  {
    // a pixel is three depths wide, in the direction of the longest ray
    double longest = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double ndc[2] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0 };
      double start[3];
      double dir[3];
      ray_at(eye, ndc, start, dir);
      longest = fmax(longest, hypot(dir[0], dir[1]));
    }
    known.near_fall = height * longest / sqrt(3.0 * known.depth * height / known.pixel);
  }
  find_bed(eye, &known, 0.0, known.light);
  find_bed(
    eye, &known, 2.5 * of->input.slope_rms * widest_turn(sun_dir, of->input.index), known.grid);
  return known;
}

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
    const double limit = baths[i].input.max_texture_px < 4096 ? 64.0 : 4096.0;
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
    { 64, 48 }, { 48, 64 }, { 48, 64 }, { 48, 64 }, { 64, 64 }, { 64, 64 }, { 64, 2 }, { 64, 57 } };
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
    const double limit = baths[i].input.max_texture_px < 4096 ? 64.0 : 4096.0;
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

TESTS(depths_are_those_of_light_that_comes_back, texture_lies_where_traced_rays_come_from,
  bed_has_the_shape_of_the_picture, grid_lies_where_light_enters,
  points_are_as_dense_as_the_sun_is_sharp, pixels_are_near_up_to_three_depths,
  heights_rise_in_the_picture, map_to_the_plane_may_have_any_scale,
  bed_at_the_surface_has_no_caustics)
