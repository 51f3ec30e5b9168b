// SPDX-License-Identifier: BSD-3-Clause
// test_runs_places.c: runs of leaves that are placed by hand: which are joined, which are cut, and
// that groups decide for their leaves.
#include "test_mesh.h"

#include "water_math.h"
#include "water_runs.h"

enum
{
  ROOM = 160,   // for leaves and groups
  WITHIN = 16,  // leaves of a group
  LEAF = 64,    // triangles, of the small leaves
  GUARD = 0xee, // in what nobody may write
};

typedef struct bench
{
  water_runs_mesh mesh;
  double boxes[ROOM][6];
  uint8_t places[ROOM];
  water_run runs[ROOM];
} bench;

// What lies at x > 0 is in the view, and what lies at z > 0 on the kept side.
static void make_view(water_clusters_view* view)
{
  memset(view, 0, sizeof *view);
  view->frustum.planes[0][0] = 1.0;
  view->frustum.planes[5][2] = 1.0;
  water_frustum_prepare(&view->frustum);
}

// k: in the view and kept; t: touches the border of what is kept; c: is cut by it; a: in the air,
// beside the view; o: beside the view and not kept.
static void put(bench* on, size_t leaf, char kind)
{
  const bool is_beside = kind == 'a' || kind == 'o';
  const double low = kind == 't' ? 0.0 : kind == 'c' ? -1.0 : kind == 'o' ? -2.0 : 1.0;
  const double box[6] = { is_beside ? -2.0 : 1.0, is_beside ? -1.0 : 2.0, 0.0, 1.0, low,
    kind == 'o' ? -1.0 : 2.0 };
  memcpy(on->boxes[leaf], box, sizeof box);
}

static void lay(bench* on, const char* kinds, size_t leaf_triangles)
{
  memset(on, GUARD, sizeof *on);
  const size_t count = strlen(kinds);
  on->mesh = (water_runs_mesh){ count * leaf_triangles, leaf_triangles, count,
    (count + WITHIN - 1) / WITHIN, on->boxes };
  for (size_t i = 0; i < count; ++i)
  {
    put(on, i, kinds[i]);
  }
  water_runs_end(&on->mesh);
}

static bool is_guarded(const void* bytes, size_t size)
{
  for (size_t i = 0; i < size; ++i)
  {
    if (((const unsigned char*)bytes)[i] != GUARD)
    {
      return false;
    }
  }
  return true;
}

// Compares the runs with numbers of first leaf, leaves and whether they are cut, three a run.
static void assert_runs(bench* on, const size_t* expected, size_t count)
{
  water_clusters_view view;
  make_view(&view);
  memset(on->runs, 0, sizeof on->runs);
  assert_int_equal(water_runs_select(&view, &on->mesh, on->places, on->runs), count);
  const size_t leaf = on->mesh.leaf_triangles;
  for (size_t i = 0; i < count; ++i)
  {
    assert_int_equal(on->runs[i].first, expected[3 * i] * leaf);
    const size_t end = (expected[3 * i] + expected[3 * i + 1]) * leaf;
    assert_int_equal(on->runs[i].first + on->runs[i].count,
      end < on->mesh.triangle_count ? end : on->mesh.triangle_count);
    assert_int_equal(on->runs[i].is_cut, expected[3 * i + 2]);
  }
  assert_true(is_guarded(on->places + on->mesh.leaf_count, ROOM - on->mesh.leaf_count));
}

typedef struct row
{
  const char* kinds;
  size_t count;
  size_t runs[9];
} row;

// Air may be drawn with the clip off, and everything with it on; so do gaps of 256 triangles, and
// not those of more.
TEST(leaves_that_change_nothing_join_runs)
{
  static const row rows[] = { { "", 0, { 0 } }, { "oaoa", 0, { 0 } }, { "kkkk", 1, { 0, 4, 0 } },
    { "kak", 1, { 0, 3, 0 } }, { "kok", 2, { 0, 1, 0, 2, 1, 0 } }, { "coc", 1, { 0, 3, 1 } },
    { "cac", 1, { 0, 3, 1 } }, { "caoac", 1, { 0, 5, 1 } }, { "kaok", 2, { 0, 1, 0, 3, 1, 0 } },
    { "koak", 2, { 0, 1, 0, 3, 1, 0 } }, { "caaaac", 1, { 0, 6, 1 } },
    { "caaaaac", 2, { 0, 1, 1, 6, 1, 1 } }, { "kaaaak", 1, { 0, 6, 0 } },
    { "kaaaaak", 2, { 0, 1, 0, 6, 1, 0 } }, { "kc", 2, { 0, 1, 0, 1, 1, 1 } },
    { "ack", 2, { 1, 1, 1, 2, 1, 0 } }, { "kokak", 2, { 0, 1, 0, 2, 3, 0 } },
    { "ckoc", 3, { 0, 1, 1, 1, 1, 0, 3, 1, 1 } }, { "kcok", 3, { 0, 1, 0, 1, 1, 1, 3, 1, 0 } },
    { "ooakk", 1, { 3, 2, 0 } } };
  static bench on;
  for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i)
  {
    lay(&on, rows[i].kinds, LEAF);
    assert_runs(&on, rows[i].runs, rows[i].count);
  }
}

// The last leaf has what is left of the triangles.
TEST(last_leaf_may_be_smaller)
{
  static const size_t runs[3] = { 0, 4, 0 };
  static bench on;
  lay(&on, "kkkk", LEAF);
  on.mesh.triangle_count -= 10;
  assert_runs(&on, runs, 1);
  assert_int_equal(on.runs[0].count, 4 * LEAF - 10);
}

// Of 128 leaves a stretch of one is less than a 64th of the mesh, and that of two is not, in one
// run or in two.
TEST(short_stretches_are_drawn_with_the_clip)
{
  static const char* const starts[3] = { "ckoooooc", "ckkooooc", "ckokoooc" };
  static const size_t expected[3][12] = { { 0, 1, 1, 1, 1, 1, 7, 1, 1 },
    { 0, 1, 1, 1, 2, 0, 7, 1, 1 }, { 0, 1, 1, 1, 1, 0, 3, 1, 0, 7, 1, 1 } };
  static const size_t counts[3] = { 3, 3, 4 };
  static bench on;
  for (int i = 0; i < 3; ++i)
  {
    char kinds[129];
    memset(kinds, 'o', sizeof kinds);
    kinds[128] = '\0';
    memcpy(kinds, starts[i], strlen(starts[i]));
    lay(&on, kinds, LEAF);
    assert_runs(&on, expected[i], counts[i]);
  }
}

// A group in view and kept is drawn, one out of view is not, and nobody looks at their leaves: one
// that was moved elsewhere makes no difference.
TEST(groups_decide_for_their_leaves)
{
  static const size_t inside[3] = { 0, 16, 0 };
  static const size_t touching[6] = { 0, 1, 1, 1, 15, 0 };
  static const size_t apart[6] = { 0, 16, 0, 32, 16, 0 };
  static bench on;
  lay(&on, "kkkkkkkkkkkkkkkk", 1);
  put(&on, 3, 'o');
  assert_runs(&on, inside, 1);
  lay(&on, "tkkkkkkkkkkkkkkk", 1); // its place holds for all leaves, but not what is kept
  assert_runs(&on, touching, 2);
  put(&on, 3, 'a');
  assert_runs(&on, touching, 2);
  lay(&on, "kkkkkkkkkkkkkkkkookkkkkkkkkkkkkkkkkkkkkkkkkkkkkk", 1);
  for (size_t i = 16; i < 32; ++i)
  {
    put(&on, i, 'o');
  }
  water_runs_end(&on.mesh);
  for (size_t i = 16; i < 32; ++i)
  {
    put(&on, i, 'a'); // would join what is around it
  }
  assert_runs(&on, apart, 2);
}

// In a group that is in view in part, each leaf is asked.
TEST(leaves_of_divided_groups_are_asked)
{
  static const size_t kept[3] = { 1, 14, 0 };
  static const size_t last[6] = { 0, 14, 0, 17, 2, 0 };
  static bench on;
  lay(&on, "akkkkkkkkkkkkkka", 1);
  assert_runs(&on, kept, 1);
  lay(&on, "kkkkkkkkkkkkkkooakko", 1); // the last group has four leaves
  assert_runs(&on, last, 2);
}

// Boxes of groups hold their own leaves, and nothing else is written.
TEST(groups_hold_their_own_leaves)
{
  static bench on;
  memset(&on, GUARD, sizeof on);
  on.mesh = (water_runs_mesh){ 20, 1, 20, 2, on.boxes };
  for (int i = 0; i < 20; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      on.boxes[i][2 * axis] = i + axis;
      on.boxes[i][2 * axis + 1] = i + axis + 0.5;
    }
  }
  water_runs_end(&on.mesh);
  for (int axis = 0; axis < 3; ++axis)
  {
    ASSERT_CLOSE(on.boxes[20][2 * axis], axis, 0.0);
    ASSERT_CLOSE(on.boxes[20][2 * axis + 1], axis + 15.5, 0.0);
    ASSERT_CLOSE(on.boxes[21][2 * axis], axis + 16.0, 0.0);
    ASSERT_CLOSE(on.boxes[21][2 * axis + 1], axis + 19.5, 0.0);
  }
  assert_true(is_guarded(on.boxes[22], sizeof on.boxes - 22 * sizeof on.boxes[0]));
}

// All boxes are emptied, those of the groups, too, and a part of the triangles is all that is
// added.
TEST(boxes_begin_empty_and_hold_what_is_added)
{
  static const float points[9] = { 1, 2, 3, 4, 0, 5, 90, 90, 90 };
  static const uint32_t indices[9] = { 0, 1, 0, 1, 1, 1, 2, 2, 2 };
  static const double both[6] = { 1, 4, 0, 2, 3, 5 };
  static const double second[6] = { 4, 4, 0, 0, 5, 5 };
  static bench on;
  memset(&on, GUARD, sizeof on);
  on.mesh = (water_runs_mesh){ 20, 1, 20, 2, on.boxes };
  water_runs_begin(&on.mesh);
  for (int i = 0; i < 22; ++i)
  {
    assert_true(on.boxes[i][0] > on.boxes[i][1]);
  }
  assert_true(is_guarded(on.boxes[22], sizeof on.boxes[0]));
  const water_points given = { points, NULL };
  assert_true(water_runs_add(&on.mesh, 4, indices, 2, &given, 3)); // of three
  assert_memory_equal(on.boxes[4], both, sizeof both);
  assert_memory_equal(on.boxes[5], second, sizeof second);
  assert_true(on.boxes[3][0] > on.boxes[3][1] && on.boxes[6][0] > on.boxes[6][1]);
}

TESTS(leaves_that_change_nothing_join_runs, last_leaf_may_be_smaller,
  short_stretches_are_drawn_with_the_clip, groups_decide_for_their_leaves,
  leaves_of_divided_groups_are_asked, groups_hold_their_own_leaves,
  boxes_begin_empty_and_hold_what_is_added)
