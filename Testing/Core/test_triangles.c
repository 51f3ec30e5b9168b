// SPDX-License-Identifier: BSD-3-Clause
// test_triangles.c: triangles that change no pixel are dropped, and no other.
//
// The truth is drawn here: every pixel of the map shows the nearest of the triangles over its
// middle, as a GPU does that has put each corner somewhere within its grid.
#include "test_scene.h"

#include <stdlib.h>

#include "water_triangles.h"

enum
{
  WIDTH = 50, // of the drawn part
  HEIGHT = 40,
  PIXELS = WIDTH * HEIGHT,
  TRIANGLES = 300,
  ROUNDS = 100
};

static const double focal = 1.5;
static const double near = 1.0;
static const double far = 100.0;

// An eye at the origin that looks along -z; above -3 in y is kept.
static water_triangles_view view_made(float* depths)
{
  const double by_z = -(far + near) / (far - near);
  const double alone = -2.0 * far * near / (far - near);
  const water_triangles_view made = { .to_clip = { focal, 0, 0, 0, 0, focal, 0, 0, 0, 0, by_z,
                                        alone, 0, 0, -1, 0 },
    .kept = { 0.0, 1.0, 0.0, 3.0 },
    .texture_px = { 64, 48 },
    .rect_px = { 5, 3, WIDTH, HEIGHT },
    .columns = { 0, WIDTH },
    .grid_px = 1.0 / 16.0,
    .depths = depths,
    .is_solid = true };
  return made;
}

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
  const water_triangles_view* view, dice* from, float place[3][3], drawn_triangle* made)
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

static bool is_kept(const water_triangles_view* view, float place[3][3])
{
  static const uint32_t triangle[3] = { 0, 1, 2 };
  const water_points points = { &place[0][0], NULL };
  double box[6] = { DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX };
  water_corner corners[3];
  for (int i = 0; i < 3; ++i)
  {
    water_triangles_project(view, &points, triangle[i], corners + i);
    for (int j = 0; j < 3; ++j)
    {
      box[2 * j] = fmin(box[2 * j], (double)place[i][j]);
      box[2 * j + 1] = fmax(box[2 * j + 1], (double)place[i][j]);
    }
  }
  water_triangles_slack slack;
  water_triangles_allow(view, box, &slack);
  const water_corner* const all[3] = { corners, corners + 1, corners + 2 };
  return water_triangles_add(view, &slack, all);
}

// Half of the cells, in stripes.
static water_seen stripes(const water_triangles_view* view, uint32_t* counts)
{
  uint8_t cells[PIXELS];
  water_seen made;
  water_seen_begin(view->texture_px, view->rect_px, &made);
  for (int i = 0; i < made.size[0] * made.size[1]; ++i)
  {
    cells[i] = (i % made.size[0]) / 6 % 2 == 0;
  }
  made.counts = counts;
  water_seen_sum(&made, cells, 1);
  return made;
}

// The picture with all triangles and that with those that are kept are the same where it is looked
// up, wherever the corners are put; most of what cannot be seen is dropped. In a band of columns
// only these count, and others are left alone.
TEST(what_is_dropped_changes_no_pixel)
{
  UNUSED;
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
    water_triangles_view view = view_made(depths);
    water_seen seen = stripes(&view, counts);
    view.seen = round % 2 ? &seen : NULL;
    view.is_solid = round % 5 != 0;
    if (round % 3 == 2)
    {
      view.columns[0] = WIDTH / 4;
      view.columns[1] = 2 * WIDTH / 3;
    }
    water_triangles_begin(view.rect_px, view.seen, depths);
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
        kept_sum += view.is_solid;
      }
    }
    for (int i = 0; i < PIXELS; ++i)
    {
      const int cell[2] = { i % WIDTH / seen.cell_px, i / WIDTH / seen.cell_px };
      if (i % WIDTH < view.columns[0] || i % WIDTH >= view.columns[1])
      {
        assert_true(fabsf(depths[i]) == FLT_MAX); // as it began
      }
      else if (!view.seen || water_seen_is_open(view.seen, cell[0], cell[1]))
      {
        assert_true(all[i] == kept[i]);
        if (owners[i] >= 0)
        {
          seen_sum += view.is_solid && !is_owner[owners[i]];
          is_owner[owners[i]] = true;
        }
      }
    }
  }
  print_message(
    "%d of %d triangles kept, %d seen\n", kept_sum, ROUNDS * 4 / 5 * TRIANGLES, seen_sum);
  assert_int_in_range(kept_sum, seen_sum, 2 * seen_sum);
}

// Of samples none is passed over; of places beside and behind the eye none that is in the picture.
TEST(a_place_in_the_picture_keeps_its_triangle)
{
  UNUSED;
  dice from = dice_seeded(91);
  int dropped[2] = { 0, 0 };
  for (int round = 0; round < 20000; ++round)
  {
    float place[3][3];
    water_triangles_view view = view_made(NULL);
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

// A triangle from its corners in pixels of the drawn part, at one distance.
static void triangle_at(
  const water_triangles_view* view, const double px[3][2], double distance, float place[3][3])
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
  UNUSED;
  const double sliver[3][2] = { { 10.62, 10.0 }, { 11.38, 20.0 }, { 10.62, 30.0 } };
  float place[3][3];
  water_triangles_view view = view_made(NULL);
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
  UNUSED;
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
    water_triangles_view view = view_made(depths);
    view.is_solid = cases[i].is_solid;
    view.kept[3] = -cases[i].low;
    water_triangles_begin(view.rect_px, NULL, depths);
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
  UNUSED;
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const double small[3][2] = { { 10.0, 10.0 }, { 14.0, 10.0 }, { 10.0, 14.0 } };
  const double distances[4] = { 0.9, 1.1, 99.0, 101.0 };
  for (int i = 0; i < 4; ++i)
  {
    float depths[PIXELS];
    float place[3][3];
    water_triangles_view view = view_made(depths);
    view.kept[3] = 1000.0;
    water_triangles_begin(view.rect_px, NULL, depths);
    triangle_at(&view, large, distances[i], place);
    assert_true(is_kept(&view, place));
    triangle_at(&view, small, distances[i] + 0.5, place);
    assert_int_equal(is_kept(&view, place), i == 0 || i == 3);
  }
}

// A number that is none keeps its triangle.
TEST(no_number_is_kept)
{
  UNUSED;
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  float place[3][3];
  const water_triangles_view view = view_made(NULL);
  triangle_at(&view, large, 10.0, place);
  place[1][1] = NAN;
  assert_true(is_kept(&view, place));
}

// The slack is 16 units in the last place of the sizes summed, by hand.
TEST(slack_grows_with_the_numbers)
{
  UNUSED;
  const double box[6] = { -8.0, 4.0, 1.0, 2.0, -100.0, -50.0 };
  const double unit = 16.0 * 1.1920928955078125e-07;
  water_triangles_view view = view_made(NULL);
  water_triangles_slack slack;
  view.reach = 7.0;
  view.kept[0] = -0.5;
  view.kept[2] = 0.25;
  water_triangles_allow(&view, box, &slack);
  const double w = 100.0;
  ASSERT_CLOSE(slack.clip[0], unit * 32.0 * (8.0 * focal + w), 1e-12);
  ASSERT_CLOSE(slack.clip[1], unit * 24.0 * (2.0 * focal + w), 1e-12);
  ASSERT_CLOSE(slack.clip[2], unit * (101.0 / 99.0 * 100.0 + 200.0 / 99.0 + w), 1e-12);
  ASSERT_CLOSE(slack.height, unit * (34.0 + 1.75 * 7.0), 1e-15);
}

// A triangle on the map, all of it at one depth and height and at w = 1.
static bool is_kept_at(const water_triangles_view* view, const water_triangles_slack* slack,
  const double px[3][2], double depth, double height)
{
  water_corner corners[3];
  for (int i = 0; i < 3; ++i)
  {
    const water_corner made = { { 0.0, 0.0, depth, 1.0 }, 1.0, { px[i][0], px[i][1] }, depth,
      height };
    corners[i] = made;
  }
  const water_corner* const all[3] = { corners, corners + 1, corners + 2 };
  return water_triangles_add(view, slack, all);
}

// Edges that run along a row but for their last bit, as those of flat meshes before a level camera
// do, meet it further off than integers go; and so far off that no number says where.
TEST(edges_along_a_row_end_where_the_picture_ends)
{
  UNUSED;
  const water_triangles_slack none = { { 0.0, 0.0, 0.0 }, 0.0 };
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
    const water_triangles_view view = view_made(depths);
    water_triangles_begin(view.rect_px, NULL, depths);
    assert_true(is_kept_at(&view, &none, px, 0.5, 9.0));
    for (int x = 0; x < WIDTH && along > 1.0; ++x)
    {
      assert_true(depths[(is_top ? 34 : 4) * WIDTH + x] == FLT_MAX); // not surely covered
    }
    const bool is_kept_inside = is_kept_at(&view, &none, inside, 0.6, 9.0);
    assert_true(!is_kept_inside || fabs(rise) < 1e-200);
  }
}

// The slack counts on the side of caution, of what hides and of what is hidden.
TEST(slack_is_on_the_side_of_caution)
{
  UNUSED;
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
    water_triangles_slack slack;
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
      const water_triangles_view view = view_made(depths);
      const water_triangles_slack back = { { 0.0, 0.0, cases[i].back_slack }, 0.0 };
      double front[3][2];
      for (int j = 0; j < 3; ++j)
      {
        memcpy(front[j], cases[i].front[turn ? 2 - j : j], sizeof front[j]);
      }
      water_triangles_begin(view.rect_px, NULL, depths);
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
  UNUSED;
  const double large[3][2] = { { 5.0, 5.0 }, { 45.0, 5.0 }, { 5.0, 35.0 } };
  const water_triangles_view view = view_made(NULL);
  const water_triangles_slack slack = { { 0.0, 0.0, 0.0 }, 0.9 };
  assert_false(is_kept_at(&view, &slack, large, 0.5, -1.0));
  assert_true(is_kept_at(&view, &slack, large, 0.5, -0.8));
}

// Of a triangle with corners on both sides of the eye: it goes if all of it is beyond one side of
// the picture, by more than the slack.
TEST(corners_behind_the_eye_are_beyond_a_side_or_not)
{
  UNUSED;
  const water_triangles_view view = view_made(NULL);
  const double ws[3] = { 4.0, 2.0, -1.0 };
  const water_triangles_slack slack = { { 0.01, 0.02, 0.0 }, 0.0 };
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
      assert_int_equal(water_triangles_add(&view, &slack, all), i >= 3);
    }
  }
  water_corner corners[3];
  memset(corners, 0, sizeof corners);
  corners[0].clip[0] = NAN;
  const water_corner* const all[3] = { corners, corners, corners };
  assert_true(water_triangles_add(&view, &slack, all)); // a number that is none
}

// Before anything is drawn all that is looked up is open, and no place beyond is written.
TEST(depths_begin_with_what_is_looked_up)
{
  UNUSED;
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
      water_seen seen;
      assert_non_null(depths);
      water_seen_begin(texture_px, rect_px, &seen);
      for (int i = 0; i < seen.size[0] * seen.size[1]; ++i)
      {
        cells[i] = (uint8_t)(i % 3 == 1);
      }
      seen.counts = counts;
      water_seen_sum(&seen, cells, 1);
      for (int is_known = 0; is_known < 2; ++is_known)
      {
        water_triangles_begin(rect_px, is_known ? &seen : NULL, depths);
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

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(what_is_dropped_changes_no_pixel),
    RUN(a_place_in_the_picture_keeps_its_triangle),
    RUN(a_pixel_is_its_middle_within_the_grid),
    RUN(what_is_sure_to_be_drawn_hides),
    RUN(what_the_view_cuts_hides_nothing),
    RUN(no_number_is_kept),
    RUN(slack_grows_with_the_numbers),
    RUN(edges_along_a_row_end_where_the_picture_ends),
    RUN(slack_is_on_the_side_of_caution),
    RUN(under_the_water_by_more_than_the_slack),
    RUN(corners_behind_the_eye_are_beyond_a_side_or_not),
    RUN(depths_begin_with_what_is_looked_up),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
