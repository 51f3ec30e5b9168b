// SPDX-License-Identifier: BSD-3-Clause
// test_visibility.c: which cells of the reflection texture
// visible water looks up: nothing that has a pixel in one is left out, and what has none is.
#include "test_scene.h"

#include "water_math.h"
#include "water_plan.h"
#include "water_visibility.h"

enum
{
  CELLS = WATER_VISIBILITY_CELLS_MAX,
  CORNERS = 2 * CELLS
};

// A fifth of the cells of a plan's rectangle is looked up, the rest is not.
static void seen_rolled(
  dice* from, const water_plan* plan, uint8_t* cells, uint32_t* counts, water_visibility* seen)
{
  water_visibility_begin(plan->texture_px, plan->texture_rect_px, seen);
  for (int i = 0; i < seen->size[0] * seen->size[1]; ++i)
  {
    cells[i] = dice_roll(from, 0.0, 1.0) < 0.2 ? 255 : 0;
  }
  seen->counts = counts;
  water_visibility_sum(seen, cells);
}

TEST(cells_cover_their_rectangle)
{
  const int texture_px[2] = { 16384, 16384 };
  const int rects[5][4] = { { 3, 4, 1, 16 }, { 0, 0, 17, 32 }, { 5, 5, 512, 512 },
    { 5, 5, 513, 512 }, { 0, 0, 16384, 16384 } };
  const int expected[5][3] = { { 2, 1, 8 }, { 2, 9, 16 }, { 2, 256, 256 }, { 3, 171, 171 },
    { 64, 256, 256 } };
  for (int i = 0; i < 5; ++i)
  {
    water_visibility seen;
    water_visibility_begin(texture_px, rects[i], &seen);
    assert_int_equal(seen.cell_px, expected[i][0]);
    assert_memory_equal(seen.size, expected[i] + 1, sizeof seen.size);
    assert_memory_equal(seen.rect_px, rects[i], sizeof seen.rect_px);
    assert_memory_equal(seen.texture_px, texture_px, sizeof seen.texture_px);
  }
}

// Every count is that of the cells below and to the left, one by one.
TEST(counts_are_sums)
{
  const uint8_t cells[2 * 3] = { 0, 7, 0, 1, 0, 255 };
  const uint32_t expected[12] = { 0, 0, 0, 0, 0, 0, 1, 1, 0, 1, 2, 3 };
  uint32_t counts[12];
  memset(counts, 0xff, sizeof counts);
  water_visibility seen = { { 24, 16 }, { 0, 0, 24, 16 }, 8, { 3, 2 }, counts };
  water_visibility_sum(&seen, cells);
  assert_memory_equal(counts, expected, sizeof expected);
}

// Every cell that is not looked up is in one rectangle, and none that is; the last ones end with
// the reflection texture's rectangle.
TEST(closed_cells_are_rectangles)
{
  const uint8_t cells[3 * 3] = { 0, 0, 0, 1, 0, 1, 0, 1, 0 };
  uint32_t counts[16];
  water_visibility seen = { { 80, 40 }, { 40, 4, 20, 24 }, 8, { 3, 3 }, counts };
  float boxes[6][4];
  const float expected[4][4] = { { 40, 4, 60, 12 }, { 48, 12, 56, 20 }, { 40, 20, 48, 28 },
    { 56, 20, 60, 28 } };
  water_visibility_sum(&seen, cells);
  assert_int_equal(water_visibility_closed(&seen, boxes), 4);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const double px = 0.5 * (1.0 + (double)boxes[i][j]) * seen.texture_px[j % 2];
      assert_true(fabs(px - (double)expected[i][j]) < 1e-4);
    }
  }
}

// Whatever lies to the left of a box, below it, or both, is not in it.
TEST(what_lies_beside_a_box_is_not_in_it)
{
  const double to_clip[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0,
    0.0, 1.0 };
  const double box[6] = { -0.2, 0.2, -0.2, 0.2, 0.0, 0.0 }; // in the middle cell of 3 x 3
  for (int pattern = 0; pattern < 512; ++pattern)
  {
    uint8_t cells[9];
    for (int i = 0; i < 9; ++i)
    {
      cells[i] = (uint8_t)(pattern >> i & 1);
    }
    uint32_t counts[16];
    water_visibility seen = { { 24, 24 }, { 0, 0, 24, 24 }, 8, { 3, 3 }, counts };
    water_visibility_sum(&seen, cells);
    assert_int_equal(water_visibility_meets(&seen, to_clip, box, 0.0), cells[4]);
  }
}

// Of random boxes in random views: one with a point in a cell that is looked up is kept, and most
// others are not.
TEST(what_is_seen_is_kept)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(70);
  static uint8_t cells[CELLS];
  static uint32_t counts[CORNERS];
  int kept = 0;
  int seen_count = 0;
  for (int round = 0; round < 3000; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    random.scene.viewport_px[0] = 640;
    random.scene.viewport_px[1] = 480;
    const water_plan plan = plan_of(&random.scene, NULL);
    water_visibility seen;
    seen_rolled(&from, &plan, cells, counts, &seen);
    water_prop prop = { { 0.0 }, WATER_PROP_VISIBLE, 0.0f };
    double middle[3];
    point_near(&from, &random, 10.0, middle);
    for (int i = 0; i < 3; ++i)
    {
      const double half = dice_roll(&from, 0.0, 0.3);
      prop.bounds[2 * i] = middle[i] - half;
      prop.bounds[2 * i + 1] = middle[i] + half;
    }
    water_cull_reason reason = WATER_CULL_NONE;
    water_visibility_cull(&seen, &plan.mirrored, &prop, 1, WATER_MAY_SKIP_ALL, &reason);
    assert_true(reason == WATER_CULL_NONE || reason == WATER_CULL_OUT_OF_WATER);
    bool is_seen = false;
    for (int number = 0; number < 64 && !is_seen; ++number)
    {
      double point[3];
      double clip[4];
      double px[2];
      const int* rect = plan.texture_rect_px;
      box_point(prop.bounds, number, point);
      map_place(&plan, point, clip, px);
      const int column = (int)floor(px[0] / seen.cell_px);
      const int row = (int)floor(px[1] / seen.cell_px);
      is_seen = clip[3] > 0.0 && px[0] >= 0.0 && px[0] < rect[2] && px[1] >= 0.0 &&
        px[1] < rect[3] && cells[row * seen.size[0] + column] != 0;
    }
    assert_true(reason == WATER_CULL_NONE || !is_seen);
    seen_count += is_seen;
    kept += reason == WATER_CULL_NONE;
  }
  print_message("seen %d, kept %d of 3000 boxes\n", seen_count, kept);
  assert_int_in_range(seen_count, 150, 2000);
  assert_int_in_range(kept, seen_count, 2400);
}

// Without the skip, without bounds, about the eye: drawn. Wide points reach into the next cell.
TEST(what_cannot_be_told_is_drawn)
{
  water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  static uint8_t cells[CELLS];
  static uint32_t counts[CORNERS];
  water_visibility seen = { { 800, 600 }, { 0, 0, 800, 600 }, 8, { 100, 75 }, counts };
  water_visibility_sum(&seen, cells);
  water_prop props[3] = { { { -1, 1, 4, 5, 1, 2 }, WATER_PROP_VISIBLE, 0.0f },
    { { 0, 0, 0, 0, 0, (double)NAN }, WATER_PROP_VISIBLE, 0.0f },
    { { -20, 20, -20, 20, -20, 20 }, WATER_PROP_VISIBLE, 0.0f } };
  water_cull_reason reasons[3] = { WATER_CULL_NONE, WATER_CULL_NONE, WATER_CULL_NONE };
  water_visibility_cull(
    &seen, &plan.mirrored, props, 3, WATER_MAY_SKIP_ALL & ~(unsigned)WATER_MAY_SKIP_PROPS, reasons);
  assert_int_equal(reasons[0], WATER_CULL_NONE);
  water_visibility_cull(&seen, &plan.mirrored, props, 3, WATER_MAY_SKIP_ALL, reasons);
  assert_int_equal(reasons[0], WATER_CULL_OUT_OF_WATER);
  assert_int_equal(reasons[1], WATER_CULL_NONE);
  assert_int_equal(reasons[2], WATER_CULL_NONE);

  // a dot in the middle of the picture, and the cell that begins 32 pixels beside it
  const double to_clip[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double dot[6] = { 0, 0, 0, 0, 0, 0 };
  cells[36 * 100 + 54] = 1; // from (432, 288)
  water_visibility_sum(&seen, cells);
  assert_false(water_visibility_meets(&seen, to_clip, dot, 30.0));
  assert_true(water_visibility_meets(&seen, to_clip, dot, 32.0));
  // beside the picture
  const double beside[6] = { 1.5, 2.0, 0, 0, 0, 0 };
  assert_false(water_visibility_meets(&seen, to_clip, beside, 0.0));
}

// A dot in the middle of its cell meets the one that is looked up, two cells away on any side, when
// it reaches as far, 12 pixels, a quarter being granted; the picture begins beside the reflection
// texture.
TEST(reach_is_the_same_on_each_side)
{
  const double to_clip[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const int steps[4][2] = { { -2, 0 }, { 2, 0 }, { 0, -2 }, { 0, 2 } };
  uint32_t counts[21 * 11];
  water_visibility seen = { { 320, 200 }, { 100, 60, 160, 80 }, 8, { 20, 10 }, counts };
  const double x_px = 100.0 + 8.0 * 7 + 4.0; // the cell (7, 5)
  const double y_px = 60.0 + 8.0 * 5 + 4.0;
  const double x = 2.0 * x_px / 320.0 - 1.0;
  const double y = 2.0 * y_px / 200.0 - 1.0;
  const double dot[6] = { x, x, y, y, 0.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    uint8_t cells[20 * 10] = { 0 };
    cells[(5 + steps[i][1]) * 20 + 7 + steps[i][0]] = 1;
    water_visibility_sum(&seen, cells);
    assert_false(water_visibility_meets(&seen, to_clip, dot, 0.0));
    assert_false(water_visibility_meets(&seen, to_clip, dot, 11.7));
    assert_true(water_visibility_meets(&seen, to_clip, dot, 11.8));
    assert_true(water_visibility_meets(&seen, to_clip, dot, 1e6));
  }
}

// The pixels of a cell are its own where reflection texture and picture have the same; where the
// picture has twice as many a cell has 16, and a pixel and a half beside them lie between its
// texels and others.
TEST(pixels_of_a_cell_are_counted)
{
  const int texture_px[2] = { 100, 60 };
  const int rect_px[4] = { 10, 20, 40, 30 };
  for (int ratio = 1; ratio <= 2; ++ratio)
  {
    const int viewport_px[2] = { 100 * ratio, 60 * ratio };
    const double filter = ratio == 1 ? 0.0 : 1.5;
    water_visibility_walk walk;
    water_visibility_walk_of(texture_px, rect_px, viewport_px, 8, &walk);
    for (int i = 0; i < 2; ++i)
    {
      ASSERT_CLOSE(walk.first[i], ratio * rect_px[i] - filter, 1e-12);
      ASSERT_CLOSE(walk.step[i], 8.0 * ratio, 1e-12);
      ASSERT_CLOSE(walk.pixel[i], 2.0 / viewport_px[i], 1e-15);
      assert_int_equal(walk.size[i], ratio == 1 ? 8 : 20); // 19, from between two pixels on
    }
  }
}

// Every pixel of the picture asks for the texels around its place in the reflection texture; the
// cells of all of them must go through it.
TEST(cells_go_through_all_that_look_them_up)
{
  dice from = dice_seeded(71);
  for (int round = 0; round < 2000; ++round)
  {
    const int picture = (int)dice_roll(&from, 20.0, 300.0);
    const int map = round % 4 ? (int)dice_roll(&from, picture / 4.0, 2.0 * picture) : picture;
    const int corner = (int)dice_roll(&from, 0.0, map / 2.0);
    const int texture_px[2] = { map, map };
    const int viewport_px[2] = { picture, picture };
    const int rect_px[4] = { corner, corner, map - corner, map - corner };
    water_visibility_walk walk;
    const int cell_px = 2 + round % 7;
    water_visibility_walk_of(texture_px, rect_px, viewport_px, cell_px, &walk);
    for (int pixel = 0; pixel < picture; ++pixel)
    {
      const double place = (pixel + 0.5) * map / picture - 0.5; // in texels' middles
      for (int side = 0; side < (map == picture ? 1 : 2); ++side)
      {
        const int texel = (int)floor(place + 1e-9) + side;
        const int cell = (texel - corner) / cell_px;
        const int begin = (int)floor(walk.first[0] + walk.step[0] * cell);
        assert_true(
          texel < corner || texel >= map || (pixel >= begin && pixel < begin + walk.size[0]));
      }
    }
    assert_int_in_range(walk.size[1], 1, (int)(walk.step[1] + 2.0 * picture / map + 5.0));
  }
}

// Every cell is open if one of the pixels that its walk names lies under the plane, asked one by
// one.
TEST(depths_tell_which_cells_are_open)
{
  enum
  {
    WIDTH = 46,
    HEIGHT = 34,
    MOST = 4 * WIDTH * HEIGHT
  };
  dice from = dice_seeded(58);
  const int viewport_px[2] = { WIDTH, HEIGHT };
  int counts[2] = { 0, 0 };
  for (int round = 0; round < 400; ++round)
  {
    const double scale = 0.25 * (1 + round % 8);
    const int texture_px[2] = { (int)ceil(scale * WIDTH), (int)ceil(scale * HEIGHT) };
    int rect_px[4];
    for (int i = 0; i < 2; ++i)
    {
      rect_px[i] = (int)dice_roll(&from, 0.0, texture_px[i]);
      rect_px[2 + i] = 1 + (int)dice_roll(&from, 0.0, texture_px[i] - rect_px[i]);
    }
    water_visibility seen;
    water_visibility_walk walk;
    uint8_t cells[MOST];
    int32_t work[WIDTH];
    float depths[WIDTH * HEIGHT];
    int rows[2];
    water_visibility_begin(texture_px, rect_px, &seen);
    water_visibility_walk_of(texture_px, rect_px, viewport_px, seen.cell_px, &walk);
    const double plane[4] = { dice_roll(&from, -1, 1), dice_roll(&from, -1, 1),
      dice_roll(&from, -1, 1), dice_roll(&from, -1, 1) };
    const double rounding = dice_roll(&from, 0.0, 0.5);
    for (int i = 0; i < WIDTH * HEIGHT; ++i)
    {
      depths[i] = (float)dice_roll(&from, 0.0, 1.0);
    }
    water_visibility_rows(&seen, viewport_px, rows);
    assert_int_in_range(rows[0], 0, HEIGHT - 1);
    assert_int_in_range(rows[1], 1, HEIGHT - rows[0]);
    water_visibility_mark(
      &seen, viewport_px, false, plane, rounding, rows, depths + WIDTH * rows[0], work, cells);
    int used[2] = { HEIGHT, -1 };
    for (int i = 0; i < seen.size[0] * seen.size[1]; ++i)
    {
      bool is_open = false;
      bool is_sure = true;
      for (int j = 0; j < walk.size[0] * walk.size[1]; ++j)
      {
        const int cell[2] = { i % seen.size[0], i / seen.size[0] };
        const int step[2] = { j % walk.size[0], j / walk.size[0] };
        int px[2];
        double ndc[2];
        for (int k = 0; k < 2; ++k)
        {
          const int at = (int)floor(walk.first[k] + walk.step[k] * cell[k]) + step[k];
          px[k] = at < 0 ? 0 : at >= viewport_px[k] ? viewport_px[k] - 1 : at;
          ndc[k] = 2.0 * (px[k] + 0.5) / viewport_px[k] - 1.0;
        }
        used[0] = px[1] < used[0] ? px[1] : used[0];
        used[1] = px[1] > used[1] ? px[1] : used[1];
        const double depth = (double)depths[WIDTH * px[1] + WIDTH - 1 - px[0]];
        const double height =
          -plane[0] * ndc[0] + plane[1] * ndc[1] + plane[2] * (2.0 * depth - 1.0) + plane[3];
        is_sure = is_sure && fabs(height - rounding) > 1e-5;
        is_open = is_open || height <= rounding;
      }
      if (is_sure)
      {
        assert_int_equal(cells[i] != 0, is_open);
        ++counts[is_open];
      }
    }
    assert_int_equal(rows[0], used[0]);
    assert_int_equal(rows[1], used[1] - used[0] + 1);
  }
  print_message("%d closed, %d open\n", counts[0], counts[1]);
  assert_int_in_range(counts[0], 2000, 1000000);
  assert_int_in_range(counts[1], 5000, 1000000);
}

// A rectangle of pixels has what one of its cells has.
TEST(pixels_have_what_their_cells_have)
{
  const int texture_px[2] = { 100, 80 };
  const int rect_px[4] = { 7, 5, 61, 43 };
  dice from = dice_seeded(59);
  uint8_t cells[31 * 22];
  uint32_t counts[32 * 23];
  water_visibility seen;
  for (int round = 0; round < 3000; ++round)
  {
    water_visibility_begin(texture_px, rect_px, &seen);
    seen.counts = counts;
    for (int i = 0; i < seen.size[0] * seen.size[1]; ++i)
    {
      cells[i] = dice_roll(&from, 0.0, 1.0) < 0.02;
    }
    water_visibility_sum(&seen, cells);
    int first[2];
    int last[2];
    for (int i = 0; i < 2; ++i)
    {
      first[i] = (int)dice_roll(&from, 0.0, rect_px[2 + i]);
      last[i] = first[i] + (int)dice_roll(&from, 0.0, fmin(8.0, rect_px[2 + i] - first[i]));
    }
    bool has = false;
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const bool is_open = cells[y / seen.cell_px * seen.size[0] + x / seen.cell_px] != 0;
        assert_int_equal(
          water_visibility_is_open(&seen, x / seen.cell_px, y / seen.cell_px), is_open);
        has = has || is_open;
      }
    }
    assert_int_equal(water_visibility_has(&seen, first, last), has);
  }
}

TESTS(cells_cover_their_rectangle, counts_are_sums, closed_cells_are_rectangles,
  what_lies_beside_a_box_is_not_in_it, what_is_seen_is_kept, what_cannot_be_told_is_drawn,
  reach_is_the_same_on_each_side, pixels_of_a_cell_are_counted,
  cells_go_through_all_that_look_them_up, depths_tell_which_cells_are_open,
  pixels_have_what_their_cells_have)
