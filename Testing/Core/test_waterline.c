// SPDX-License-Identifier: BSD-3-Clause
// test_waterline.c: where hulls cut the water, against prisms whose outline is known.
#include "test_scene.h"

#include "water_waterline.h"

enum
{
  SIDES_MAX = 16,
  PIECES_MAX = 4 * SIDES_MAX
};

// The sides of a prism from z = -1 to 2, two triangles each, without lid and bottom.
//
// missing  a triangle that is left out; -1: none
// is_inside_out  its triangles are turned
//
// Returns how many pieces the plane cuts it into.
static size_t prism(const double (*corners)[2], int sides, int missing, bool is_inside_out,
  water_waterline_piece* pieces)
{
  static const double identity[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const water_plane level = { { 0.0, 0.0, 1.0 }, -0.5 };
  const double origin[3] = { 0.0, 0.0, 0.5 };
  double places[2 * SIDES_MAX * 3] = { 0 };
  for (int i = 0; i < 2 * sides; ++i)
  {
    places[3 * i] = corners[i / 2][0];
    places[3 * i + 1] = corners[i / 2][1];
    places[3 * i + 2] = i % 2 == 0 ? -1.0 : 2.0;
  }
  water_waterline_places(identity, &level, origin, places, (size_t)(2 * sides), places);
  size_t count = 0;
  for (int i = 0; i < 2 * sides; ++i)
  {
    const size_t a = (size_t)(2 * (i / 2));
    const size_t b = (a + 2) % (size_t)(2 * sides);
    size_t triangle[3] = { a, i % 2 == 0 ? b : b + 1, i % 2 == 0 ? b + 1 : a + 1 };
    if (is_inside_out)
    {
      const size_t first = triangle[0];
      triangle[0] = triangle[1];
      triangle[1] = first;
    }
    if (i != missing && water_waterline_cut(triangle, places, pieces + count))
    {
      ++count;
    }
  }
  return count;
}

// How often closed pieces go round a place, by the table, as the shader counts.
static int turns_round(const water_waterline_piece* pieces, size_t count, double x, double y)
{
  water_waterline_rows rows;
  static float texels[4 * 512 * 64];
  assert_true(water_waterline_lay(pieces, count, &rows));
  assert_true(rows.longest <= 64);
  water_waterline_fill(pieces, count, &rows, texels);
  const double place[2] = { x - rows.middle[0], y - rows.middle[1] };
  const int axis = rows.axis;
  if (fabs(place[0]) > rows.half[0] || fabs(place[1]) > rows.half[1])
  {
    return 0;
  }
  const int row =
    (int)fmin(0.5 * (place[axis] / rows.half[axis] + 1.0) * rows.count, rows.count - 1.0);
  const float* edges = texels + 4 * rows.longest * (size_t)row;
  int turns = 0;
  for (int i = 1; i <= (int)edges[0]; ++i)
  {
    const double begin = edges[4 * i + axis];
    const double end = edges[4 * i + 2 + axis];
    if ((begin > place[axis]) != (end > place[axis]))
    {
      const double other = edges[4 * i + 1 - axis];
      const double share = (place[axis] - begin) / (end - begin);
      const double meets = other + share * (edges[4 * i + 3 - axis] - other);
      // to the same side whatever the axis: crossings of the other axis turn the other way round
      turns += meets > place[1 - axis] ? (end > begin ? 1 : -1) * (axis == 1 ? 1 : -1) : 0;
    }
  }
  return turns;
}

static const double boat[5][2] = { { -4.0, -1.0 }, { 2.0, -1.0 }, { 5.0, 0.0 }, { 2.0, 1.0 },
  { -4.0, 1.0 } };
static const double hold[5][2] = { { -3.0, -0.8 }, { 1.0, -0.8 }, { 3.0, 0.0 }, { 1.0, 0.8 },
  { -3.0, 0.8 } };
static const double upright[4][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 7.0 }, { 0.0, 7.0 } };

static size_t closed(
  const double (*corners)[2], int sides, bool is_inside_out, water_waterline_piece* pieces)
{
  water_waterline_end ends[2 * PIECES_MAX];
  size_t open = 0;
  const size_t count = prism(corners, sides, -1, is_inside_out, pieces);
  assert_int_equal(count, 2 * sides);
  assert_true(water_waterline_close(pieces, count, ends, &open));
  return count;
}

// A place in the outline is inside, whichever way the triangles are turned.
TEST(what_a_waterline_goes_round_is_inside)
{
  for (int turned = 0; turned < 2; ++turned)
  {
    water_waterline_piece pieces[PIECES_MAX];
    size_t count = closed(boat, 5, turned != 0, pieces);
    assert_int_equal(turns_round(pieces, count, 0.3, 0.2), 1);
    assert_int_equal(turns_round(pieces, count, 4.9, 0.02), 1);
    assert_int_equal(turns_round(pieces, count, 4.9, 0.04), 0); // beside the bow
    assert_int_equal(turns_round(pieces, count, -4.01, 0.0), 0);
    assert_int_equal(turns_round(pieces, count, 0.0, 1.01), 0);
    count = closed(upright, 4, turned != 0, pieces);
    assert_int_equal(turns_round(pieces, count, 0.5, 6.9), 1);
    assert_int_equal(turns_round(pieces, count, 1.1, 6.9), 0);
  }
}

// A hold between thick walls is inside, as often as walls go round it; so are two hulls that
// overlap.
TEST(a_hold_between_thick_walls_is_inside)
{
  water_waterline_piece pieces[2 * PIECES_MAX];
  size_t count = closed(boat, 5, false, pieces);
  count += closed(hold, 5, true, pieces + count);
  assert_int_equal(turns_round(pieces, count, 0.0, 0.0), 2);
  assert_int_equal(turns_round(pieces, count, 0.0, 0.9), 1);
  assert_int_equal(turns_round(pieces, count, 0.0, 1.1), 0);
}

// A side that is not there is an open hull, and the piece beside the gap is named.
TEST(a_side_that_is_missing_is_an_open_hull)
{
  water_waterline_piece pieces[PIECES_MAX];
  water_waterline_end ends[2 * PIECES_MAX];
  for (int missing = 0; missing < 10; ++missing)
  {
    const size_t count = prism(boat, 5, missing, false, pieces);
    size_t open = 99;
    assert_int_equal(count, 9);
    assert_false(water_waterline_close(pieces, count, ends, &open));
    assert_true(open < count);
  }
}

// What lies over the water, or under it, is not cut, and nothing has no rows.
TEST(what_the_water_does_not_meet_is_not_cut)
{
  const size_t corners[3] = { 0, 1, 2 };
  const double over[9] = { 0, 0, 0, 1, 0, 1, 0, 1, 2 };
  const double under[9] = { 0, 0, -1, 1, 0, -1e-300, 0, 1, -2 };
  water_waterline_piece piece;
  water_waterline_rows rows;
  assert_false(water_waterline_cut(corners, over, &piece));
  assert_false(water_waterline_cut(corners, under, &piece));
  assert_false(water_waterline_lay(NULL, 0, &rows));
}

// Numbers that are not finite, or too large for a table of all.
TEST(wrong_places_are_found)
{
  double places[9] = { 0, 1e12, -1e12, 1, 2, 3, 4, 5, 6 };
  assert_int_equal(water_waterline_find_wrong(places, 3), 3);
  assert_int_equal(water_waterline_find_wrong(places, 0), 0);
  const double wrong[4] = { NAN, INFINITY, -INFINITY, -1.1e12 };
  for (int i = 0; i < 36; ++i)
  {
    const double kept = places[i % 9];
    places[i % 9] = wrong[i / 9];
    assert_int_equal(water_waterline_find_wrong(places, 3), i % 9 / 3);
    places[i % 9] = kept;
  }
}

// Places are from the origin, along the plane's axes, after the mesh's own matrix.
TEST(places_are_in_the_planes_own_axes)
{
  const double moved[16] = { 2, 0, 0, 10, 0, 2, 0, 20, 0, 0, 2, 30, 0, 0, 0, 1 };
  const water_plane level = { { 0.0, 0.0, 1.0 }, -5.0 };
  const double origin[3] = { 1.0, 3.0, 5.0 };
  const double points[6] = { 0.0, 0.0, 0.0, 1.0, 2.0, 4.0 };
  const double expected[6] = { 9.0, 17.0, 25.0, 11.0, 21.0, 33.0 };
  double places[6];
  water_waterline_places(moved, &level, origin, points, 2, places);
  for (int i = 0; i < 6; ++i)
  {
    ASSERT_CLOSE(places[i], expected[i], 1e-12);
  }
}

// Waves reach what is no further from the plane than their height, over it and under it.
TEST(places_near_the_waves_are_found)
{
  const double places[15] = { 0, 0, 1.0, 5, 5, 1.01, 0, 0, -1.0, 9, 9, -1.01, 0, 0, 0 };
  size_t near[5];
  assert_int_equal(water_waterline_near(places, 5, 1.0, near), 3);
  assert_int_equal(near[0], 0);
  assert_int_equal(near[1], 2);
  assert_int_equal(near[2], 4);
  assert_int_equal(water_waterline_near(places, 5, 0.0, near), 1);
  assert_int_equal(near[0], 4);
}

// A corner at the height 0 counts as over the water.
TEST(a_corner_on_the_water_is_over_it)
{
  const size_t corners[3] = { 0, 1, 2 };
  const double hanging[9] = { 3, 4, 0, 1, 0, -1, 0, 1, -2 };
  const double standing[9] = { 3, 4, 0, 1, 0, 0, 0, 1, -2 };
  water_waterline_piece piece;
  for (size_t first = 0; first < 3; ++first)
  {
    const size_t turned[3] = { corners[first], corners[(first + 1) % 3], corners[(first + 2) % 3] };
    assert_true(water_waterline_cut(turned, hanging, &piece));
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(piece.ends[i / 2][i % 2], 3.0 + i % 2, 1e-15);
    }
    assert_true(water_waterline_cut(turned, standing, &piece));
  }
}

// Of three pieces that meet at one edge of the mesh, the last has no other end to join.
TEST(the_last_of_three_at_an_edge_is_open)
{
  enum
  {
    LOOSE = 40
  };
  for (size_t third = 0; third < LOOSE; ++third)
  {
    water_waterline_piece pieces[LOOSE] = { { { { 0 } }, { { 0 } }, { 0 }, false } };
    water_waterline_end ends[2 * LOOSE];
    size_t open = LOOSE;
    for (size_t i = 0; i < LOOSE; ++i) // pieces in a ring, their edges in no order
    {
      for (size_t end = 0; end < 2; ++end)
      {
        pieces[i].edges[end][0] = 1 + 17 * ((i + end) % LOOSE) % LOOSE;
        pieces[i].edges[end][1] = 100 + pieces[i].edges[end][0] % 3;
      }
    }
    assert_true(water_waterline_close(pieces, LOOSE, ends, &open));
    pieces[third].edges[0][0] = 0; // a place of its own, the lowest
    assert_false(water_waterline_close(pieces, LOOSE, ends, &open));
    assert_int_equal(open, third);
  }
  water_waterline_piece fork[3] = { { { { 0 } }, { { 0 } }, { 0 }, false } };
  water_waterline_end ends[6];
  size_t open = 9;
  for (size_t i = 0; i < 3; ++i)
  {
    fork[i].edges[1][0] = 5; // all three
    fork[i].edges[0][0] = 6 + i;
  }
  assert_false(water_waterline_close(fork, 3, ends, &open));
  assert_int_equal(open, 2);
}

// Loops go round counter-clockwise, whatever their shape and place.
TEST(loops_are_counter_clockwise)
{
  static const double shapes[3][3][2] = { { { 100, 50 }, { 101, 49 }, { 102, 51 } },
    { { 101, -49 }, { 102, -51 }, { 100, -50 } }, { { -99, 51 }, { -98, 53 }, { -97, 49 } } };
  for (int i = 0; i < 12; ++i)
  {
    double corners[3][2];
    for (int j = 0; j < 3; ++j)
    {
      corners[j][0] = shapes[i % 3][(j + i / 6) % 3][0];
      corners[j][1] = shapes[i % 3][(j + i / 6) % 3][1];
    }
    water_waterline_piece pieces[PIECES_MAX];
    const size_t count = closed((const double(*)[2])corners, 3, i / 3 % 2 == 1, pieces);
    double twice = 0.0;
    for (size_t j = 0; j < count; ++j)
    {
      const double* from = pieces[j].ends[0];
      const double* to = pieces[j].ends[1];
      twice += from[0] * to[1] - from[1] * to[0];
    }
    const double known = fabs((corners[1][0] - corners[0][0]) * (corners[2][1] - corners[0][1]) -
      (corners[1][1] - corners[0][1]) * (corners[2][0] - corners[0][0]));
    ASSERT_CLOSE(twice, known, 1e-9);
  }
}

static water_waterline_piece piece_of(double x, double y, double to_x, double to_y)
{
  const water_waterline_piece piece = { { { x, y }, { to_x, to_y } }, { { 0 } }, { 0 }, false };
  return piece;
}

// A piece is in the rows that it passes, and in those beside it that are nearer than a hundredth of
// a row.
TEST(a_piece_is_in_its_rows_and_those_it_nearly_touches)
{
  const double ends[4][2] = { { -0.995, -0.5 }, { -0.5, -0.005 }, { -0.9, -0.1 }, { -2.0, 2.0 } };
  const int rows_of[4][2] = { { 0, 1 }, { 1, 2 }, { 1, 1 }, { 0, 3 } };
  for (int axis = 0; axis < 2; ++axis)
  {
    const double wide = 1.5; // of the other axis
    water_waterline_piece pieces[4];
    for (int i = 0; i < 4; ++i)
    {
      pieces[i] = axis == 0 ? piece_of(ends[i][0], -wide, ends[i][1], wide)
                            : piece_of(-wide, ends[i][1], wide, ends[i][0]);
    }
    for (int i = 0; i < 4; ++i)
    {
      water_waterline_piece both[4] = { pieces[i], pieces[3], pieces[3], pieces[3] };
      water_waterline_rows rows;
      float texels[4 * 4 * 5 + 4];
      texels[80] = 7.0f; // after the table
      assert_true(water_waterline_lay(both, 4, &rows));
      assert_int_equal(rows.axis, axis);
      assert_int_equal(rows.count, 4);
      assert_int_equal(rows.longest, 5);
      water_waterline_fill(both, 4, &rows, texels);
      for (int row = 0; row < 4; ++row)
      {
        const bool is_in = row >= rows_of[i][0] && row <= rows_of[i][1];
        assert_int_equal((int)texels[20 * row], is_in ? 4 : 3);
      }
      ASSERT_CLOSE(texels[80], 7.0, 0.0);
    }
  }
}

// There are no more rows than a table has, and none of what has no width or no end.
TEST(rows_are_few_and_need_an_area)
{
  static water_waterline_piece many[600];
  water_waterline_rows rows;
  for (int i = 0; i < 600; ++i)
  {
    many[i] = piece_of(i, 0.0, i + 1.0, 1.0);
  }
  assert_true(water_waterline_lay(many, 600, &rows));
  assert_int_equal(rows.count, 512);
  assert_true(water_waterline_lay(many, 3, &rows));
  assert_int_equal(rows.count, 3);
  ASSERT_CLOSE(rows.middle[0], 1.5, 0.0);
  const water_waterline_piece square = piece_of(0.0, 0.0, 1.0, 1.0);
  assert_true(water_waterline_lay(&square, 1, &rows));
  assert_int_equal(rows.axis, 0);
  const water_waterline_piece thin[4] = { piece_of(0.0, 0.0, 1.0, 0.0),
    piece_of(0.0, 0.0, 0.0, 1.0), piece_of(0.0, 0.0, (double)INFINITY, 1.0),
    piece_of(0.0, 0.0, 1.0, (double)INFINITY) };
  for (int i = 0; i < 4; ++i)
  {
    assert_false(water_waterline_lay(thin + i, 1, &rows));
  }
}

// A loop that encloses nothing, to a place and back, is as its first piece goes.
TEST(loops_without_an_area_are_not_turned)
{
  water_waterline_piece pieces[2] = { { { { 3.0, 4.0 }, { 5.0, 4.0 } }, { { 1, 2 }, { 3, 4 } },
                                        { 0 }, false },
    { { { 3.0, 4.0 }, { 5.0, 4.0 } }, { { 1, 2 }, { 3, 4 } }, { 0 }, false } };
  water_waterline_end ends[4];
  size_t open = 9;
  assert_true(water_waterline_close(pieces, 2, ends, &open));
  for (int i = 0; i < 2; ++i)
  {
    ASSERT_CLOSE(pieces[i].ends[0][0], i == 0 ? 3.0 : 5.0, 0.0);
    ASSERT_CLOSE(pieces[i].ends[1][0], i == 0 ? 5.0 : 3.0, 0.0);
  }
}

// Whichever way each piece goes at first, all go round the loop counter-clockwise.
TEST(pieces_of_a_loop_go_one_way)
{
  static const double places[5][2] = { { 0.0, 0.0 }, { 2.0, 0.0 }, { 3.0, 1.5 }, { 2.0, 3.0 },
    { 0.0, 3.0 } };
  for (int round = 0; round < 3 * 64; ++round)
  {
    const int sides = 3 + round / 64;
    const int turned = round % 64;
    water_waterline_piece pieces[5];
    water_waterline_end ends[10];
    size_t open = 9;
    for (int i = 0; i < sides; ++i)
    {
      const water_waterline_piece none = { { { 0 } }, { { 0 } }, { 0 }, false };
      pieces[i] = none;
      for (int end = 0; end < 2; ++end)
      {
        const int corner = (i + (end ^ (turned >> i & 1))) % sides;
        const int place = turned < 32 ? corner : sides - 1 - corner;
        memcpy(pieces[i].ends[end], places[place], sizeof places[0]);
        pieces[i].edges[end][0] = (size_t)corner;
        pieces[i].edges[end][1] = (size_t)corner + 10;
      }
    }
    assert_true(water_waterline_close(pieces, (size_t)sides, ends, &open));
    for (int i = 0; i < sides; ++i)
    {
      const double* from = pieces[i].ends[0];
      const double* to = pieces[i].ends[1];
      // about a place within all of them
      assert_true((from[0] - 1.5) * (to[1] - 0.5) - (from[1] - 0.5) * (to[0] - 1.5) > 0.0);
    }
  }
}

TESTS(pieces_of_a_loop_go_one_way, loops_without_an_area_are_not_turned,
  places_are_in_the_planes_own_axes, places_near_the_waves_are_found,
  a_corner_on_the_water_is_over_it, the_last_of_three_at_an_edge_is_open,
  loops_are_counter_clockwise, a_piece_is_in_its_rows_and_those_it_nearly_touches,
  rows_are_few_and_need_an_area, what_a_waterline_goes_round_is_inside,
  a_hold_between_thick_walls_is_inside, a_side_that_is_missing_is_an_open_hull,
  what_the_water_does_not_meet_is_not_cut, wrong_places_are_found)
