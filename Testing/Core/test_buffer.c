// SPDX-License-Identifier: BSD-3-Clause
// test_buffer.c: which meshes are shaded once a pixel.
#include "test_main.h"
#include "test_scene.h"

#include "water_buffer.h"
#include "water_lookup.h"

#include <math.h>
#include <string.h>

enum
{
  WIDTH = 800,
  HEIGHT = 600
};

static const double eye_place[3] = { 0.0, -20.0, 10.0 };

// What an eye over a level plane sees of it; no more than a judgement asks for.
static water_plan plan_from(const double eye[3], const double target[3], water_camera* camera)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  const water_axes axes = { .x_dir = { 1, 0, 0 }, .y_dir = { 0, 1, 0 }, .normal = { 0, 0, 1 } };
  memset(camera, 0, sizeof *camera);
  look_at(eye, target, up, camera->world_to_view);
  const double box[4] = { -0.36, 0.36, -0.27, 0.27 };
  frustum_matrix(box, 1.0, 100.0, camera->view_to_clip);
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  plan.has_view = true;
  plan.plane_view[3] = eye[2];
  plan.origin_xy[0] = eye[0];
  plan.origin_xy[1] = eye[1];
  plan.clip_w[2] = 1.0;
  water_lookup_dirs(camera, &axes, plan.dir_to_eye);
  return plan;
}

static water_plan seen_plan(void)
{
  const double target[3] = { 0.0, 0.0, 0.0 };
  water_camera camera;
  return plan_from(eye_place, target, &camera);
}

// A solver's mesh of a million cells, as clear water.
static water_buffer_input input_of(const water_plan* plan)
{
  const water_buffer_input input = { .is_on = true,
    .is_software = true,
    .is_plain_draw = true,
    .features =
      WATER_FEATURE_MESH | WATER_FEATURE_SLOPED | WATER_FEATURE_RAY_TRACED | WATER_FEATURE_MEDIUM,
    .plan = plan,
    .sheet = { -8, 8, -8, 8 },
    .viewport_px = { WIDTH, HEIGHT },
    .samples = 4,
    .triangle_count = 2e6 };
  return input;
}

TEST(small_triangles_are_shaded_once_a_pixel)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input.samples = 0;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input.triangle_count = 20000;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input.triangle_count = 200; // a thousand pixels each
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
  input.triangle_count = 2;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
}

// The shader of water that is not clear is shorter: fewer runs of it are worth less.
TEST(opaque_water_has_a_buffer_for_smaller_triangles)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  input.features &= ~WATER_FEATURE_MEDIUM;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input.triangle_count = 20000;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
}

// What counts is the size in the picture: of a mesh that is mostly out of view, or of one that is
// far away.
TEST(sizes_are_those_in_the_picture)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  input.triangle_count = 20000;
  for (int i = 0; i < 4; ++i)
  {
    input.sheet[i] *= 300.0; // of 20,000 triangles a few are in view
  }
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
  const double behind[4] = { -8, 8, -90, -70 };
  memcpy(input.sheet, behind, sizeof behind);
  input.triangle_count = 2e6;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
  const double speck[4] = { -0.1, 0.1, -0.1, 0.1 };
  memcpy(input.sheet, speck, sizeof speck);
  input.triangle_count = 50; // the passes over the picture take longer than they do
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
}

// A cell of the rectangle that reaches behind the eye is as large as the picture, and no larger.
TEST(cells_may_reach_behind_the_eye)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  // of a middle before the eye and two corners behind it there is one cell
  const double long_sheet[4] = { -120, 136, -346, 294 };
  memcpy(input.sheet, long_sheet, sizeof long_sheet);
  input.triangle_count = 2560; // 10 in a cell
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
  input.triangle_count = 2560e6;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
}

// Each condition has its own answer, and lets no buffer be used.
TEST(all_else_is_drawn_as_it_is)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  input.is_on = false;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_OFF);
  input = input_of(&plan);
  input.is_software = false;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_HARDWARE);
  input = input_of(&plan);
  input.is_plain_draw = false;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_OTHER_DRAW);
  input = input_of(NULL);
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_OTHER_DRAW);
  input = input_of(&plan);
  input.features &= ~WATER_FEATURE_MESH;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_NO_MESH);
  input = input_of(&plan);
  input.triangle_count = 0.0;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_NO_MESH);
  const water_feature_set others[] = { WATER_FEATURE_HULLS, WATER_FEATURE_FLOW, WATER_FEATURE_PORT,
    WATER_FEATURE_OUTPUT };
  for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i)
  {
    input = input_of(&plan);
    input.features |= others[i];
    assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_FEATURE);
  }
  input = input_of(&plan);
  input.features = WATER_FEATURE_MESH;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SHORT_SHADER);
  input = input_of(&plan);
  input.samples = WATER_BUFFER_SAMPLES_MAX + 1;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SIZE);
  input = input_of(&plan);
  input.viewport_px[0] = input.viewport_px[1] = 4000;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SIZE);
}

TEST(eyes_in_the_water_and_parallel_rays_have_no_buffer)
{
  water_plan plan = seen_plan();
  const water_buffer_input input = input_of(&plan);
  plan.is_submerged = true;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SUBMERGED);
  plan.is_submerged = false;
  plan.is_awash = true;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SUBMERGED);
  plan.is_awash = false;
  plan.clip_w[2] = 0.0;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_PARALLEL);
}

// Large triangles are shaded on the pixels that they cover, small ones on a block each; what covers
// no sample is not shaded.
TEST(runs_are_of_blocks)
{
  ASSERT_CLOSE(water_buffer_runs(10.0, 1e8, 1) / (10.0 * 1e8), 1.0, 2e-3);
  ASSERT_CLOSE(water_buffer_runs(1.0, 1.0, 1), 8.0 + 6.0 * sqrt(2.0) + 1.0, 1e-9);
  ASSERT_CLOSE(water_buffer_runs(1e6, 1e-6, 1), 8.0, 0.1);
  ASSERT_CLOSE(water_buffer_runs(1e6, 1e-6, 4), 32.0, 0.4);
  assert_true(water_buffer_runs(4.0, 25.0, 1) > water_buffer_runs(1.0, 100.0, 1));
}

// Pixels of the picture that a cell of 16 x 16 covers, as the camera draws its corners: none if its
// middle is out of view, all if a corner is behind the eye.
static double drawn_area(const water_camera* camera, const double sheet[4], int column, int row)
{
  static const double at[5][2] = { { 0.5, 0.5 }, { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  const double picture = (double)WIDTH * HEIGHT;
  double px[5][2];
  bool is_behind = false;
  for (int i = 0; i < 5; ++i)
  {
    const double point[3] = { sheet[0] + (column + at[i][0]) / 16.0 * (sheet[1] - sheet[0]),
      sheet[2] + (row + at[i][1]) / 16.0 * (sheet[3] - sheet[2]), 0.0 };
    double clip[4];
    project(camera, point, 1.0, clip);
    if (i == 0 && (clip[3] <= 0.0 || fabs(clip[0]) > clip[3] || fabs(clip[1]) > clip[3]))
    {
      return 0.0;
    }
    is_behind = is_behind || clip[3] <= 0.0;
    px[i][0] = 0.5 * WIDTH * clip[0] / clip[3];
    px[i][1] = 0.5 * HEIGHT * clip[1] / clip[3];
  }
  double twice = 0.0;
  for (int i = 1; i <= 4; ++i) // the shoelace formula
  {
    const double* next = px[i % 4 + 1];
    twice += px[i][0] * next[1] - px[i][1] * next[0];
  }
  return is_behind ? picture : fmin(0.5 * fabs(twice), picture);
}

// Runs of the shader for triangles spread evenly over cells of known areas, less what they may be
// without a buffer: so many times the pixels that are covered, and 2 % of the picture.
static double runs_too_many(const double areas[256], const water_buffer_input* input)
{
  const double picture = (double)input->viewport_px[0] * input->viewport_px[1];
  const double pays = input->features & WATER_FEATURE_MEDIUM ? 2.0 : 6.0;
  const double count = input->triangle_count / 256.0;
  double runs = 0.0;
  double covered = 0.0;
  for (int i = 0; i < 256; ++i)
  {
    runs += areas[i] > 0.0 ? water_buffer_runs(count, areas[i] / count, input->samples) : 0.0;
    covered += areas[i];
  }
  return runs - pays * fmin(covered, picture) - 0.02 * picture;
}

// The number of triangles from which on there is a buffer is that of the areas. Returns whether
// there is such a number.
static bool check_number(const double areas[256], water_buffer_input* input)
{
  double few = 1e-3;
  double many = 1e12;
  input->triangle_count = many;
  if (runs_too_many(areas, input) <= 0.0)
  {
    assert_int_equal(water_buffer_judge(input), WATER_BUFFER_LARGE_TRIANGLES);
    return false;
  }
  while (many > few * (1.0 + 1e-9))
  {
    input->triangle_count = sqrt(few * many);
    *(runs_too_many(areas, input) > 0.0 ? &many : &few) = input->triangle_count;
  }
  input->triangle_count = few * (1.0 - 1e-7);
  assert_int_equal(water_buffer_judge(input), WATER_BUFFER_LARGE_TRIANGLES);
  input->triangle_count = many * (1.0 + 1e-7);
  assert_int_equal(water_buffer_judge(input), WATER_BUFFER_IN_USE);
  return true;
}

// From random eyes over rectangles that are seen whole, in part, or reach behind the eye.
TEST(number_of_triangles_that_is_too_many)
{
  dice from = dice_seeded(91);
  int count = 0;
  for (int i = 0; i < 200; ++i)
  {
    const double eye[3] = { dice_roll(&from, -9.0, 9.0), dice_roll(&from, -30.0, -3.0),
      dice_roll(&from, 2.0, 30.0) };
    const double target[3] = { dice_roll(&from, -5.0, 5.0), dice_roll(&from, 0.0, 9.0), 0.0 };
    water_camera camera;
    const water_plan plan = plan_from(eye, target, &camera);
    water_buffer_input input = input_of(&plan);
    const double size = pow(10.0, dice_roll(&from, 0.0, 2.0));
    input.sheet[0] = dice_roll(&from, -1.0, 0.0) * size;
    input.sheet[1] = dice_roll(&from, 0.1, 1.0) * size;
    input.sheet[2] = dice_roll(&from, -1.0, 0.0) * size;
    input.sheet[3] = dice_roll(&from, 0.1, 1.0) * size;
    input.samples = i & 1 ? 4 : 1;
    if (i & 2)
    {
      input.features &= ~WATER_FEATURE_MEDIUM;
    }
    double areas[256];
    for (int cell = 0; cell < 256; ++cell)
    {
      areas[cell] = drawn_area(&camera, input.sheet, cell % 16, cell / 16);
    }
    count += check_number(areas, &input);
  }
  assert_true(count > 100);
}

// Straight down on cells of a quarter, of which nine in each row have their middle in the picture:
// two of them on its edge.
TEST(cells_on_the_edge_of_the_picture_count)
{
  water_plan plan = seen_plan();
  const double straight_down[12] = { 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, -1 };
  memcpy(plan.dir_to_eye, straight_down, sizeof straight_down);
  plan.plane_view[3] = 1.0;
  plan.origin_xy[0] = plan.origin_xy[1] = 0.0;
  water_buffer_input input = input_of(&plan);
  const double sheet[4] = { -1.875, 2.125, -1.875, 2.125 };
  memcpy(input.sheet, sheet, sizeof sheet);
  double areas[256];
  for (int cell = 0; cell < 256; ++cell)
  {
    const bool is_seen = cell % 16 >= 3 && cell % 16 <= 11 && cell / 16 >= 3 && cell / 16 <= 11;
    areas[cell] = is_seen ? WIDTH * HEIGHT / 64.0 : 0.0;
  }
  assert_true(check_number(areas, &input));
}

TEST(sizes_are_possible_up_to_their_limits)
{
  const water_plan plan = seen_plan();
  water_buffer_input input = input_of(&plan);
  input.samples = WATER_BUFFER_SAMPLES_MAX;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input = input_of(&plan);
  input.samples = 1;
  input.triangle_count = 1e9;
  input.viewport_px[0] = input.viewport_px[1] = 4000; // 16 million
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_IN_USE);
  input.viewport_px[0] = 4001;
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_SIZE);
  input.viewport_px[0] = input.viewport_px[1] = 0; // nothing is shaded, and nothing too often
  assert_int_equal(water_buffer_judge(&input), WATER_BUFFER_LARGE_TRIANGLES);
}

TEST(every_use_has_its_text)
{
  for (int i = 0; i < WATER_BUFFER_COUNT; ++i)
  {
    const char* text = water_buffer_text((water_buffer_use)i);
    assert_true(strlen(text) > 10);
    for (int j = 0; j < i; ++j)
    {
      assert_string_not_equal(text, water_buffer_text((water_buffer_use)j));
    }
  }
  assert_string_equal(water_buffer_text(WATER_BUFFER_COUNT), "unknown");
}

TESTS(small_triangles_are_shaded_once_a_pixel, sizes_are_those_in_the_picture,
  opaque_water_has_a_buffer_for_smaller_triangles, cells_may_reach_behind_the_eye,
  all_else_is_drawn_as_it_is, eyes_in_the_water_and_parallel_rays_have_no_buffer,
  runs_are_of_blocks, number_of_triangles_that_is_too_many, cells_on_the_edge_of_the_picture_count,
  sizes_are_possible_up_to_their_limits, every_use_has_its_text)
