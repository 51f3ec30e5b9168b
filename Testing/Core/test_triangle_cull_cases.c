// SPDX-License-Identifier: BSD-3-Clause
// test_triangle_cull_cases.c: where single triangles begin
// and cease to be dropped: between the middles of pixels, behind others, at the ends of the view,
// under the water, by rounding.
#include "test_triangle_cull.h"

#include "water_triangle_cull.h"

// A triangle from its corners in pixels of the drawn part, at one distance.
static void triangle_at(
  const water_triangle_cull_view* view, const double px[3][2], double distance, float place[3][3])
{
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      const double ndc = 2.0 * (px[i][j] + view->rect_px[j]) / view->texture_px[j] - 1.0;
      place[i][j] = (float)(ndc * distance / focal);
    }
    place[i][2] = (float)-distance;
  }
}

// Between the middles of pixels there is nothing but samples, and the grid may move a corner there.
TEST(a_pixel_is_its_middle_within_the_grid)
{
  const double sliver[3][2] = { { 10.62, 10.0 }, { 11.38, 20.0 }, { 10.62, 30.0 } };
  float place[3][3];
  water_triangle_cull_view view = view_made(NULL);
  triangle_at(&view, sliver, 10.0, place);
  assert_false(is_kept(&view, place));
  view.grid_px = 1.0 / 8.0;
  assert_true(is_kept(&view, place));
  view.grid_px = 1.0 / 16.0;
  view.has_samples = true;
  assert_true(is_kept(&view, place));
}

// What is drawn hides what is behind it, at the pixels it is sure to cover, if it is solid and cut
// by nothing.
TEST(what_is_sure_to_be_drawn_hides)
{
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const double small[3][2] = { { 10.0, 20.0 }, { 14.0, 20.0 }, { 10.0, 24.0 } };
  const double at_edge[3][2] = { { 10.0, 4.0 }, { 14.0, 4.0 }, { 10.0, 8.0 } };
  const struct
  {
    const double (*px)[2];
    double distance; // of the large one: 10
    bool is_solid;
    double low; // of what is kept
    bool is_kept;
  } cases[7] = {
    { small, 20.0, true, -30.0, false }, { small, 10.01, true, -30.0, false },
    { small, 10.0, true, -30.0, true }, { small, 5.0, true, -30.0, true },
    { at_edge, 20.0, true, -30.0, true }, { small, 20.0, false, -30.0, true },
    { small, 20.0, true, -2.5, true }, // the water cuts the large one
  };
  for (int i = 0; i < 7; ++i)
  {
    float depths[PIXELS];
    float place[3][3];
    water_triangle_cull_view view = view_made(depths);
    view.is_solid = cases[i].is_solid;
    view.kept[3] = -cases[i].low;
    water_triangle_cull_begin(view.rect_px, NULL, depths);
    triangle_at(&view, large, 10.0, place);
    assert_true(is_kept(&view, place));
    triangle_at(&view, cases[i].px, cases[i].distance, place);
    assert_int_equal(is_kept(&view, place), cases[i].is_kept);
    view.has_samples = true; // of whose pixels the middle says nothing
    assert_true(is_kept(&view, place));
  }
}

// Ends of the view cut what reaches over them: it hides nothing.
TEST(what_the_view_cuts_hides_nothing)
{
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const double small[3][2] = { { 10.0, 10.0 }, { 14.0, 10.0 }, { 10.0, 14.0 } };
  const double distances[4] = { 0.9, 1.1, 99.0, 101.0 };
  for (int i = 0; i < 4; ++i)
  {
    float depths[PIXELS];
    float place[3][3];
    water_triangle_cull_view view = view_made(depths);
    view.kept[3] = 1000.0;
    water_triangle_cull_begin(view.rect_px, NULL, depths);
    triangle_at(&view, large, distances[i], place);
    assert_true(is_kept(&view, place));
    triangle_at(&view, small, distances[i] + 0.5, place);
    assert_int_equal(is_kept(&view, place), i == 0 || i == 3);
  }
}

// A number that is none keeps its triangle.
TEST(no_number_is_kept)
{
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  float place[3][3];
  const water_triangle_cull_view view = view_made(NULL);
  triangle_at(&view, large, 10.0, place);
  place[1][1] = NAN;
  assert_true(is_kept(&view, place));
}

// The slack is 16 units in the last place of the sizes summed, by hand.
TEST(slack_grows_with_the_numbers)
{
  const double box[6] = { -8.0, 4.0, 1.0, 2.0, -100.0, -50.0 };
  const double unit = 16.0 * 1.1920928955078125e-07;
  water_triangle_cull_view view = view_made(NULL);
  water_triangle_cull_slack slack;
  view.reach = 7.0;
  view.kept[0] = -0.5;
  view.kept[2] = 0.25;
  water_triangle_cull_allow(&view, box, &slack);
  const double w = 100.0;
  ASSERT_CLOSE(slack.clip[0], unit * 32.0 * (8.0 * focal + w), 1e-12);
  ASSERT_CLOSE(slack.clip[1], unit * 24.0 * (2.0 * focal + w), 1e-12);
  ASSERT_CLOSE(slack.clip[2], unit * (101.0 / 99.0 * 100.0 + 200.0 / 99.0 + w), 1e-12);
  ASSERT_CLOSE(slack.height, unit * (34.0 + 1.75 * 7.0), 1e-15);
}

// The slack counts on the side of caution, of what hides and of what is hidden.
TEST(slack_is_on_the_side_of_caution)
{
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const double upright[3][2] = { { 5.0, 5.0 }, { 5.0, 35.0 }, { 45.0, 35.0 } };
  const double inside[3][2] = { { 12.0, 12.0 }, { 14.0, 12.0 }, { 12.0, 14.0 } };
  const double column[3][2] = { { 5.3, 15.3 }, { 5.7, 15.4 }, { 5.4, 15.7 } };
  const double row[3][2] = { { 15.3, 5.3 }, { 15.7, 5.4 }, { 15.4, 5.7 } };
  const double slope[3][2] = { { 24.3, 19.3 }, { 24.7, 19.4 }, { 24.4, 19.7 } };
  const double under[3][2] = { { 15.3, 34.3 }, { 15.7, 34.4 }, { 15.4, 34.7 } };
  const double corner[3][2] = { { 24.3, 20.3 }, { 24.7, 20.4 }, { 24.4, 20.7 } };
  const struct
  {
    const double (*front)[2];
    double depth;
    double height;
    water_triangle_cull_slack slack;
    const double (*back)[2];
    double back_depth;
    double back_slack;
    bool is_hidden;
  } cases[19] = {
    // 0.5 + slack against 0.6 - slack
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.049 }, 0.0 }, inside, 0.6, 0.049, true },
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.051 }, 0.0 }, inside, 0.6, 0.051, false },
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.09 }, 0.0 }, inside, 0.6, 0.0, true },
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.11 }, 0.0 }, inside, 0.6, 0.0, false },
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.0 }, 0.0 }, inside, 0.6, 0.09, true },
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.0 }, 0.0 }, inside, 0.6, 0.11, false },
    // the ends of the view
    { large, 0.9, 9.0, { { 0.0, 0.0, 0.09 }, 0.0 }, inside, 3.0, 0.0, true },
    { large, 0.9, 9.0, { { 0.0, 0.0, 0.11 }, 0.0 }, inside, 3.0, 0.0, false },
    { large, -0.9, 9.0, { { 0.0, 0.0, 0.09 }, 0.0 }, inside, 3.0, 0.0, true },
    { large, -0.9, 9.0, { { 0.0, 0.0, 0.11 }, 0.0 }, inside, 3.0, 0.0, false },
    // the water
    { large, 0.5, 1.0, { { 0.0, 0.0, 0.0 }, 0.9 }, inside, 0.9, 0.0, true },
    { large, 0.5, 1.0, { { 0.0, 0.0, 0.0 }, 1.1 }, inside, 0.9, 0.0, false },
    // the middle of a pixel half a pixel from an upright edge, from a level one
    { large, 0.5, 9.0, { { 0.42, 0.0, 0.0 }, 0.0 }, column, 0.9, 0.0, true },
    { large, 0.5, 9.0, { { 0.45, 0.0, 0.0 }, 0.0 }, column, 0.9, 0.0, false },
    { large, 0.5, 9.0, { { 0.0, 0.42, 0.0 }, 0.0 }, row, 0.9, 0.0, true },
    { large, 0.5, 9.0, { { 0.0, 0.45, 0.0 }, 0.0 }, row, 0.9, 0.0, false },
    { upright, 0.5, 9.0, { { 0.0, 0.42, 0.0 }, 0.0 }, under, 0.9, 0.0, true },
    { upright, 0.5, 9.0, { { 0.0, 0.45, 0.0 }, 0.0 }, under, 0.9, 0.0, false },
    // the slope passes (24.5, 20.375)
    { large, 0.5, 9.0, { { 0.0, 0.0, 0.0 }, 0.0 }, slope, 0.9, 0.0, true },
  };
  for (int i = 0; i < 19; ++i)
  {
    for (int turn = 0; turn < 2; ++turn) // both ways around
    {
      float depths[PIXELS];
      const water_triangle_cull_view view = view_made(depths);
      const water_triangle_cull_slack back = { { 0.0, 0.0, cases[i].back_slack }, 0.0 };
      double front[3][2];
      for (int j = 0; j < 3; ++j)
      {
        memcpy(front[j], cases[i].front[turn ? 2 - j : j], sizeof front[j]);
      }
      water_triangle_cull_begin(view.rect_px, NULL, depths);
      assert_true(is_kept_at(
        &view, &cases[i].slack, (const double(*)[2])front, cases[i].depth, cases[i].height));
      assert_int_equal(
        is_kept_at(&view, &back, cases[i].back, cases[i].back_depth, 9.0), !cases[i].is_hidden);
      // beyond the slope nothing is hidden
      assert_true(
        is_kept_at(&view, &back, corner, cases[i].back_depth, 9.0) || cases[i].front == upright);
    }
  }
}

// What is under the water goes if it is so by more than the slack.
TEST(under_the_water_by_more_than_the_slack)
{
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const water_triangle_cull_view view = view_made(NULL);
  const water_triangle_cull_slack slack = { { 0.0, 0.0, 0.0 }, 0.9 };
  assert_false(is_kept_at(&view, &slack, large, 0.5, -1.0));
  assert_true(is_kept_at(&view, &slack, large, 0.5, -0.8));
}

// Of a triangle with corners on both sides of the eye: it goes if all of it is beyond one side of
// the picture, by more than the slack.
TEST(corners_behind_the_eye_are_beyond_a_side_or_not)
{
  const water_triangle_cull_view view = view_made(NULL);
  const double ws[3] = { 4.0, 2.0, -1.0 };
  const water_triangle_cull_slack slack = { { 0.01, 0.02, 0.0 }, 0.0 };
  const double beyond[3] = { -1.5, -0.5, 0.5 }; // of the slack, of the one that is least beyond
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 9; ++i)
    {
      water_corner corners[3];
      memset(corners, 0, sizeof corners);
      for (int j = 0; j < 3; ++j)
      {
        const int axis = side % 2;
        const double size = view.texture_px[axis];
        const double far_side = view.rect_px[axis] + (side < 2 ? 0 : view.rect_px[2 + axis]);
        const double inwards = j == i % 3 ? beyond[i / 3] * slack.clip[axis] : -1.0;
        // 0.5 (w + x) size - far_side w = inwards, or its opposite
        const double x = 2.0 * ((side < 2 ? inwards : -inwards) + far_side * ws[j]) / size - ws[j];
        corners[j].clip[axis] = x;
        corners[j].clip[3] = ws[j];
        corners[j].w_inverse = 1.0 / ws[j];
      }
      const water_corner* const all[3] = { corners, corners + 1, corners + 2 };
      assert_int_equal(water_triangle_cull_add(&view, &slack, all), i >= 3);
    }
  }
  water_corner corners[3];
  memset(corners, 0, sizeof corners);
  corners[0].clip[0] = NAN;
  const water_corner* const all[3] = { corners, corners, corners };
  assert_true(water_triangle_cull_add(&view, &slack, all)); // a number that is none
}

TESTS(a_pixel_is_its_middle_within_the_grid, what_is_sure_to_be_drawn_hides,
  what_the_view_cuts_hides_nothing, no_number_is_kept, slack_grows_with_the_numbers,
  slack_is_on_the_side_of_caution, under_the_water_by_more_than_the_slack,
  corners_behind_the_eye_are_beyond_a_side_or_not)
