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
  double places[2 * SIDES_MAX * 3];
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

TESTS(what_a_waterline_goes_round_is_inside, a_hold_between_thick_walls_is_inside,
  a_side_that_is_missing_is_an_open_hull, what_the_water_does_not_meet_is_not_cut,
  wrong_places_are_found)
