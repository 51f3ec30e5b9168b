// SPDX-License-Identifier: BSD-3-Clause
// test_triangle_cull_edges.c: how far the edges of a triangle move whose corners may be elsewhere:
// which pixels it covers for sure, and which it may cover.
#include "test_triangle_cull.h"

#include "water_triangle_cull.h"

// Draws a triangle at depth 0.5 over nothing, its corners in either order, which may be off by
// (dx, dy). Returns whether it is sure to cover a pixel.
static bool is_sure(
  const double corners[3][2], bool is_turned, const double off_px[2], int x, int y)
{
  float depths[PIXELS];
  double px[3][2];
  for (int i = 0; i < 3; ++i)
  {
    memcpy(px[i], corners[is_turned ? 2 - i : i], sizeof px[i]);
  }
  const water_triangle_cull_slack slack = { { off_px[0], off_px[1], 0.0 }, 0.0 };
  water_triangle_cull_view view = view_made(depths);
  view.grid_px = 0.0;
  water_triangle_cull_begin(view.rect_px, NULL, depths);
  assert_true(is_kept_at(&view, &slack, (const double(*)[2])px, 0.5, 9.0));
  return depths[y * WIDTH + x] < FLT_MAX;
}

// Corners that may be 4 pixels away in x. An upright edge, on the left or on the right, moves by as
// much; only its two ends say how far, wherever the third corner is between their rows.
TEST(an_upright_edge_moves_as_its_ends)
{
  const double off_px[2] = { 4.0, 0.0 };
  for (int i = 0; i < 8; ++i)
  {
    const bool is_near = i & 1;
    const double side = i & 2 ? -1.0 : 1.0;
    const double at = 9.5 - side * (is_near ? 3.9 : 4.07);
    const double corners[3][2] = { { at, 5.0 }, { at + 40.0 * side, 5.0 }, { at, 35.0 } };
    assert_int_equal(is_sure(corners, i & 4, off_px, 9, 15), !is_near);
  }
}

// Of corners that may be 2 pixels away in x, an upright edge of 10 rows that turns about itself
// sweeps more beside its rows: 2.5 pixels are enough for a triangle of 40 columns with its third
// corner 20 rows further on. In its own rows 2 are needed.
TEST(an_edge_turns_about_itself)
{
  const double off_px[2] = { 2.0, 0.0 };
  for (int i = 0; i < 4; ++i)
  {
    const double left = 7.5 - (i & 1 ? 1.9 : 2.6);
    const double corners[3][2] = { { left, 5.0 }, { left, 15.0 }, { left + 40.0, 35.0 } };
    assert_int_equal(is_sure(corners, i & 2, off_px, 7, 10), !(i & 1));
  }
}

// A row half a pixel inside an edge along it, of corners that may be more than that away, is not
// sure to be covered anywhere, in the first column neither.
TEST(a_row_at_an_edge_is_not_sure)
{
  const double off_px[2] = { 0.0, 0.6 };
  const double corners[3][2] = { { -20.0, 10.0 }, { 30.0, 10.0 }, { -20.0, 38.0 } };
  for (int turn = 0; turn < 2; ++turn)
  {
    assert_false(is_sure(corners, turn, off_px, 0, 10));
    assert_true(is_sure(corners, turn, off_px, 0, 12));
  }
}

// Least value of an edge's function at a pixel, of all places that two corners may have: it is
// linear in each, so least where both are as far off as they may be.
static double least_of_edge(const double a[2], const double b[2], const double p[2], double off)
{
  double least = DBL_MAX;
  for (int i = 0; i < 16; ++i)
  {
    const double u[2] = { a[0] - p[0] + (i & 1 ? off : -off), a[1] - p[1] + (i & 2 ? off : -off) };
    const double v[2] = { b[0] - p[0] + (i & 4 ? off : -off), b[1] - p[1] + (i & 8 ? off : -off) };
    least = fmin(least, u[0] * v[1] - u[1] * v[0]);
  }
  return least;
}

// Triangles hide what is behind them only at pixels that they cover wherever their corners are put,
// within 2 pixels, and at three quarters of these, at least.
TEST(what_hides_is_covered_for_sure)
{
  dice from = dice_seeded(92);
  const water_triangle_cull_slack none = { { 0.0, 0.0, 0.0 }, 0.0 };
  int hidden_sum = 0;
  int sure_sum = 0;
  for (int round = 0; round < 100; ++round)
  {
    float depths[PIXELS];
    double px[3][2];
    water_triangle_cull_view view = view_made(depths);
    view.grid_px = 2.0;
    for (int i = 0; i < 6; ++i)
    {
      px[i / 2][i % 2] = dice_roll(&from, -5.0, 5.0 + (i % 2 ? HEIGHT : WIDTH));
    }
    const double area =
      (px[1][0] - px[0][0]) * (px[2][1] - px[0][1]) - (px[1][1] - px[0][1]) * (px[2][0] - px[0][0]);
    water_triangle_cull_begin(view.rect_px, NULL, depths);
    (void)is_kept_at(&view, &none, (const double(*)[2])px, 0.5, 9.0);
    for (int i = 0; i < PIXELS; ++i)
    {
      const double middle[2] = { i % WIDTH + 0.5, i / WIDTH + 0.5 };
      double least = DBL_MAX;
      for (int j = 0; j < 3 && least >= 0.0; ++j)
      {
        const double* a = px[area > 0.0 ? (j + 1) % 3 : (j + 2) % 3];
        const double* b = px[area > 0.0 ? (j + 2) % 3 : (j + 1) % 3];
        least = fmin(least, least_of_edge(a, b, middle, view.grid_px));
      }
      const bool is_hidden = depths[i] < FLT_MAX;
      assert_true(!is_hidden || least >= 0.0);
      hidden_sum += is_hidden;
      sure_sum += least >= 0.0;
    }
  }
  print_message("%d pixels hidden of %d that are sure\n", hidden_sum, sure_sum);
  assert_int_in_range(hidden_sum, 3 * sure_sum / 4, sure_sum);
}

// Corners that may be 4 pixels away in x, or in y, take a slope along by as much: a pixel beyond it
// by less may show the triangle, one beyond it by more does not.
TEST(a_slope_moves_as_far_as_its_corners)
{
  // x + y = 44 within the picture, and three pixels beyond it in x or y: by 3, 4.2 and 3.9
  const double low[3][2] = { { 4.0, 4.0 }, { 40.0, 4.0 }, { 4.0, 40.0 } };
  const int pixels[3][2] = { { 23, 23 }, { 24, 23 }, { 24, 23 } };
  const double shifts[3] = { 4.0, 3.9, 4.1 };
  for (int i = 0; i < 3; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      float depths[PIXELS];
      water_triangle_cull_slack slack = { { 0.0, 0.0, 0.0 }, 0.0 };
      water_triangle_cull_view view = view_made(depths);
      view.grid_px = 0.0;
      slack.clip[axis] = shifts[i];
      for (int j = 0; j < PIXELS; ++j)
      {
        depths[j] = -FLT_MAX; // something is nearer
      }
      depths[pixels[i][1] * WIDTH + pixels[i][0]] = FLT_MAX;
      assert_int_equal(is_kept_at(&view, &slack, low, 0.5, 9.0), i != 1);
    }
  }
}

// An edge so nearly along a row that corners 2 pixels away may meet it farther off than any number:
// the triangle, under the picture, is drawn for the one pixel that is open, 1.5 over its edge.
TEST(an_edge_may_move_out_of_all_numbers)
{
  for (int i = 0; i < 4; ++i)
  {
    float depths[PIXELS];
    const double rise = i / 2 ? -3e-307 : 3e-307;
    const double px[3][2] = { { i % 2 ? 45.0 : 5.0, 0.0 }, { i % 2 ? 5.0 : 45.0, rise },
      { 20.0, -30.0 } };
    const water_triangle_cull_slack slack = { { 0.0, 2.0, 0.0 }, 0.0 };
    const water_triangle_cull_view view = view_made(depths);
    for (int j = 0; j < PIXELS; ++j)
    {
      depths[j] = -FLT_MAX;
    }
    depths[WIDTH + 20] = FLT_MAX;
    assert_true(is_kept_at(&view, &slack, px, 0.5, 9.0));
  }
}

// Edges that run along a row but for their last bit, as those of flat meshes before a level camera
// do, meet it further off than integers go; and so far off that no number says where.
TEST(edges_along_a_row_end_where_the_picture_ends)
{
  const water_triangle_cull_slack none = { { 0.0, 0.0, 0.0 }, 0.0 };
  const double rises[6] = { 0.0, 1e-9, 1e-13, 1e-15, 1e-300, DBL_TRUE_MIN };
  const double inside[3][2] = { { 20.0, 12.0 }, { 22.0, 12.0 }, { 20.0, 14.0 } };
  for (int i = 0; i < 6 * 2 * 2 * 2; ++i)
  {
    float depths[PIXELS];
    const double rise = i / 24 ? -rises[i % 6] : rises[i % 6];
    const bool is_top = i / 6 % 2;
    const bool is_turned = i / 12 % 2;
    // the middle of the row is inside, but nearer to the edge than a corner may be put elsewhere
    const double along = is_top ? 34.55 : rise < 1e-200 && rise > -1e-200 ? 0.0 : 4.45;
    const double px[3][2] = { { is_turned ? 45.0 : 5.0, along },
      { is_turned ? 5.0 : 45.0, along + rise }, { 20.0, is_top ? 5.0 : 34.0 } };
    const water_triangle_cull_view view = view_made(depths);
    water_triangle_cull_begin(view.rect_px, NULL, depths);
    assert_true(is_kept_at(&view, &none, px, 0.5, 9.0));
    for (int x = 0; x < WIDTH && along > 1.0; ++x)
    {
      assert_true(depths[(is_top ? 34 : 4) * WIDTH + x] == FLT_MAX); // not surely covered
    }
    const bool is_kept_inside = is_kept_at(&view, &none, inside, 0.6, 9.0);
    assert_true(!is_kept_inside || fabs(rise) < 1e-200);
  }
}

TESTS(an_upright_edge_moves_as_its_ends, an_edge_turns_about_itself, a_row_at_an_edge_is_not_sure,
  what_hides_is_covered_for_sure, a_slope_moves_as_far_as_its_corners,
  an_edge_may_move_out_of_all_numbers, edges_along_a_row_end_where_the_picture_ends)
