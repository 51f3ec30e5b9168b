// SPDX-License-Identifier: BSD-3-Clause
// test_triangle_cull.c: triangles that change no pixel are dropped, and no other.
//
// The truth is drawn here: every pixel of the reflection texture shows the nearest of the triangles
// over its middle, as a GPU does that has put each corner somewhere within its grid.
#include "test_triangle_cull.h"

#include <stdlib.h>

#include "water_triangle_cull.h"

enum
{
  TRIANGLES = 300,
  ROUNDS = 100
};

// Corners about a place in the view, as floats, farther for larger numbers; every third triangle is
// thin.
static void triangle_rolled(dice* from, int number, float place[3][3])
{
  const double distance = dice_roll(from, 2.0, 4.0) + 36.0 * number / TRIANGLES;
  const double size = distance * dice_roll(from, 0.01, 0.8);
  const double middle[3] = { distance * dice_roll(from, -0.6, 0.6),
    distance * dice_roll(from, -0.5, 0.5), -distance };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double thin = number % 3 == 0 && i == 2 ? 0.02 : 1.0;
      const double step = size * thin * dice_roll(from, -0.5, 0.5);
      place[i][j] =
        (float)(i == 2 && number % 3 == 0 ? (double)place[0][j] + step : middle[j] + step);
    }
  }
}

typedef struct drawn_triangle
{
  double px[3][2]; // from the corner of the drawn part, corners put on the grid
  double depth[3];
  double height_w[3]; // height over w: linear in the picture
} drawn_triangle;

static bool is_drawable(
  const water_triangle_cull_view* view, dice* from, float place[3][3], drawn_triangle* made)
{
  for (int i = 0; i < 3; ++i)
  {
    const double at[3] = { (double)place[i][0], (double)place[i][1], (double)place[i][2] };
    double clip[4];
    apply(view->to_clip, at, 1.0, clip);
    if (clip[3] <= 0.0)
    {
      return false;
    }
    for (int j = 0; j < 2; ++j)
    {
      made->px[i][j] = 0.5 * (1.0 + clip[j] / clip[3]) * view->texture_px[j] - view->rect_px[j] +
        view->grid_px * dice_roll(from, -0.99, 0.99);
    }
    made->depth[i] = clip[2] / clip[3];
    made->height_w[i] = (at[1] + 3.0) / clip[3];
  }
  return true;
}

static double edge_of(const double a[2], const double b[2], const double p[2])
{
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// Draws a triangle over what is there, if it is nearer. owners: who is seen; NULL: unknown.
static void draw(const drawn_triangle* of, int number, double* picture, int* owners)
{
  const double area = edge_of(of->px[0], of->px[1], of->px[2]);
  const double low = fmin(of->px[0][1], fmin(of->px[1][1], of->px[2][1]));
  const double high = fmax(of->px[0][1], fmax(of->px[1][1], of->px[2][1]));
  for (int i = 0; i < PIXELS && area != 0.0; ++i)
  {
    const double middle[2] = { i % WIDTH + 0.5, i / WIDTH + 0.5 };
    if (middle[1] < low || middle[1] > high)
    {
      continue;
    }
    double depth = 0.0;
    double height = 0.0;
    double least = 1.0;
    for (int j = 0; j < 3; ++j)
    {
      const double share = edge_of(of->px[(j + 1) % 3], of->px[(j + 2) % 3], middle) / area;
      depth += share * of->depth[j];
      height += share * of->height_w[j];
      least = fmin(least, share);
    }
    if (least >= 0.0 && height >= 0.0 && fabs(depth) <= 1.0)
    {
      if (owners && depth < picture[i])
      {
        owners[i] = number;
      }
      picture[i] = fmin(picture[i], depth);
    }
  }
}

// Half of the cells, in stripes.
static water_visibility stripes(const water_triangle_cull_view* view, uint32_t* counts)
{
  uint8_t cells[PIXELS];
  water_visibility made;
  water_visibility_begin(view->texture_px, view->rect_px, &made);
  for (int i = 0; i < made.size[0] * made.size[1]; ++i)
  {
    cells[i] = (i % made.size[0]) / 6 % 2 == 0;
  }
  made.counts = counts;
  water_visibility_sum(&made, cells);
  return made;
}

// The picture with all triangles and that with those that are kept are the same where it is looked
// up, wherever the corners are put, also within two pixels; most of what cannot be seen is dropped.
// In a band of columns only these count, and others are left alone.
TEST(what_is_dropped_changes_no_pixel)
{
  dice from = dice_seeded(90);
  int kept_sum = 0;
  int seen_sum = 0;
  for (int round = 0; round < ROUNDS; ++round)
  {
    int owners[PIXELS];
    bool is_owner[TRIANGLES] = { false };
    float depths[PIXELS];
    uint32_t counts[PIXELS];
    double all[PIXELS];
    double kept[PIXELS];
    water_triangle_cull_view view = view_made(depths);
    water_visibility seen = stripes(&view, counts);
    view.seen = round % 2 ? &seen : NULL;
    const bool is_coarse = round % 7 == 0;
    view.grid_px = is_coarse ? 2.0 : view.grid_px;
    view.is_solid = round % 5 != 0;
    if (round % 3 == 2)
    {
      view.columns[0] = WIDTH / 4;
      view.columns[1] = 2 * WIDTH / 3;
    }
    water_triangle_cull_begin(view.rect_px, view.seen, depths);
    for (int i = 0; i < PIXELS; ++i)
    {
      all[i] = kept[i] = DBL_MAX;
      owners[i] = -1;
    }
    for (int i = 0; i < TRIANGLES; ++i)
    {
      float place[3][3];
      drawn_triangle drawn;
      triangle_rolled(&from, i, place);
      if (!is_drawable(&view, &from, place, &drawn))
      {
        continue;
      }
      draw(&drawn, i, all, owners);
      if (is_kept(&view, place))
      {
        draw(&drawn, i, kept, NULL);
        kept_sum += view.is_solid && !is_coarse;
      }
    }
    for (int i = 0; i < PIXELS; ++i)
    {
      const int cell[2] = { i % WIDTH / seen.cell_px, i / WIDTH / seen.cell_px };
      if (i % WIDTH < view.columns[0] || i % WIDTH >= view.columns[1])
      {
        assert_true(fabsf(depths[i]) == FLT_MAX); // as it began
      }
      else if (!view.seen || water_visibility_is_open(view.seen, cell[0], cell[1]))
      {
        assert_true(all[i] == kept[i]);
        if (owners[i] >= 0)
        {
          seen_sum += view.is_solid && !is_coarse && !is_owner[owners[i]];
          is_owner[owners[i]] = true;
        }
      }
    }
  }
  print_message("%d triangles kept, %d seen\n", kept_sum, seen_sum);
  assert_int_in_range(kept_sum, seen_sum, 2 * seen_sum);
}

// Of samples none is passed over; of places beside and behind the eye none that is in the picture.
TEST(a_place_in_the_picture_keeps_its_triangle)
{
  dice from = dice_seeded(91);
  int dropped[2] = { 0, 0 };
  for (int round = 0; round < 20000; ++round)
  {
    float place[3][3];
    water_triangle_cull_view view = view_made(NULL);
    const bool is_about_eye = round % 2;
    view.has_samples = true;
    triangle_rolled(&from, round % TRIANGLES, place);
    for (int i = 0; is_about_eye && i < 3; ++i)
    {
      place[i][2] += 15.0F;
    }
    const bool has_place = is_kept(&view, place);
    dropped[is_about_eye] += !has_place;
    for (int i = 0; i < 30 && !has_place; ++i)
    {
      const double shares[2] = { dice_roll(&from, 0.0, 1.0), dice_roll(&from, 0.0, 1.0) };
      double at[3];
      double clip[4];
      for (int j = 0; j < 3; ++j)
      {
        const double a = (double)place[0][j];
        const double b = (double)place[1][j];
        const double c = (double)place[2][j];
        const double side = a + (b - a) * shares[0];
        at[j] = side + (c - side) * shares[1];
      }
      apply(view.to_clip, at, 1.0, clip);
      const double x = 0.5 * (1.0 + clip[0] / clip[3]) * view.texture_px[0] - view.rect_px[0];
      const double y = 0.5 * (1.0 + clip[1] / clip[3]) * view.texture_px[1] - view.rect_px[1];
      assert_false(
        clip[3] > 0.0 && at[1] >= -3.0 && x >= 0.0 && x <= WIDTH && y >= 0.0 && y <= HEIGHT);
    }
  }
  print_message("dropped before the eye %d, about it %d of 10000\n", dropped[0], dropped[1]);
  assert_int_in_range(dropped[0], 500, 9000);
  assert_int_in_range(dropped[1], 500, 9000);
}

// Before anything is drawn all that is looked up is open, and no place beyond is written.
TEST(depths_begin_with_what_is_looked_up)
{
  for (int width = 1; width < 9; ++width)
  {
    for (int height = 1; height < 9; ++height)
    {
      const int rect_px[4] = { 2, 3, width, height };
      const int texture_px[2] = { 20, 20 };
      const size_t count = (size_t)width * (size_t)height;
      float* depths = malloc(count * sizeof *depths);
      uint32_t counts[25];
      uint8_t cells[16];
      water_visibility seen;
      assert_non_null(depths);
      water_visibility_begin(texture_px, rect_px, &seen);
      for (int i = 0; i < seen.size[0] * seen.size[1]; ++i)
      {
        cells[i] = (uint8_t)(i % 3 == 1);
      }
      seen.counts = counts;
      water_visibility_sum(&seen, cells);
      for (int is_known = 0; is_known < 2; ++is_known)
      {
        water_triangle_cull_begin(rect_px, is_known ? &seen : NULL, depths);
        for (int i = 0; i < width * height; ++i)
        {
          const int cell = i / width / seen.cell_px * seen.size[0] + i % width / seen.cell_px;
          assert_true(depths[i] == (!is_known || cells[cell] ? FLT_MAX : -FLT_MAX));
        }
      }
      free(depths);
    }
  }
}

TESTS(what_is_dropped_changes_no_pixel, a_place_in_the_picture_keeps_its_triangle,
  depths_begin_with_what_is_looked_up)
