// SPDX-License-Identifier: BSD-3-Clause
// test_runs.c: large meshes on a GPU: what is seen of them is in a run, once, the cut of the plane
// is on where it must be, and what is not seen is left out.
#include "test_mesh.h"

#include "water_math.h"
#include "water_runs.h"

enum
{
  COPIES = 2, // of the mesh of 28,800 triangles: one alone is too small
  ALL = COPIES * TRIANGLES,
  BOXES = ALL / WATER_RUNS_LEAF_MIN + ALL / WATER_RUNS_LEAF_MIN / WATER_RUNS_GROUP + 2
};

typedef struct large
{
  water_runs_mesh described;
  double boxes[BOXES][6];
  uint8_t places[BOXES];
  water_run runs[BOXES];
  unsigned char times[ALL]; // that a triangle is drawn
  bool is_cut[ALL];
} large;

// The mesh once more after itself.
static large* large_made(const mesh* terrain)
{
  large* made = malloc(sizeof *made);
  assert_non_null(made);
  const size_t count = water_runs_shape(ALL, &made->described);
  assert_int_in_range(count, 1, BOXES);
  made->described.boxes = made->boxes;
  water_runs_begin(&made->described);
  for (size_t copy = COPIES; copy-- > 0;) // in any order, in parts of any size
  {
    const size_t half = TRIANGLES / 2 + 7;
    assert_true(water_runs_add(&made->described, copy * TRIANGLES, terrain->indices, half,
      &terrain->described.points, POINTS));
    assert_true(water_runs_add(&made->described, copy * TRIANGLES + half,
      terrain->indices + 3 * half, TRIANGLES - half, &terrain->described.points, POINTS));
  }
  water_runs_end(&made->described);
  return made;
}

// Counts how often each triangle is drawn. Returns how many draws of one there are.
static size_t count_drawn(large* of, size_t run_count)
{
  size_t drawn = 0;
  memset(of->times, 0, sizeof of->times);
  for (size_t i = 0; i < run_count; ++i)
  {
    assert_true(of->runs[i].count > 0 && of->runs[i].first + of->runs[i].count <= ALL);
    for (size_t j = of->runs[i].first; j < of->runs[i].first + of->runs[i].count; ++j)
    {
      ++of->times[j];
      of->is_cut[j] = of->runs[i].is_cut;
      ++drawn;
    }
  }
  return drawn;
}

// In the mesh's order, and the clip is turned off no more often than is worth it.
static void check_order(const large* of, size_t run_count)
{
  size_t stretches = 0;
  for (size_t i = 1; i < run_count; ++i)
  {
    assert_true(of->runs[i - 1].first + of->runs[i - 1].count <= of->runs[i].first);
    stretches += of->runs[i - 1].is_cut && !of->runs[i].is_cut;
  }
  assert_in_range(stretches, 0, WATER_RUNS_STRETCHES);
}

TEST(only_large_meshes_have_runs)
{
  water_runs_mesh shape;
  assert_int_equal(water_runs_shape(0, &shape), 0);
  assert_int_equal(water_runs_shape(WATER_RUNS_MESH_MIN - 1, &shape), 0);
  assert_int_equal(water_runs_shape(WATER_RUNS_MESH_MIN, &shape),
    WATER_RUNS_MESH_MIN / WATER_RUNS_LEAF_MIN * (WATER_RUNS_GROUP + 1) / WATER_RUNS_GROUP);
  assert_int_equal(shape.leaf_triangles, WATER_RUNS_LEAF_MIN);
  (void)water_runs_shape(18000000, &shape); // leaves grow, so that there are not too many
  assert_int_equal(shape.leaf_triangles, 275);
  assert_int_in_range(shape.leaf_count, WATER_RUNS_LEAVES_MAX - 300, WATER_RUNS_LEAVES_MAX);
}

TEST(indices_of_other_points_are_refused)
{
  dice from = dice_seeded(70);
  mesh* const terrain = mesh_made(&from);
  large* const twice = large_made(terrain);
  assert_false(water_runs_add(
    &twice->described, 0, terrain->indices, TRIANGLES, &terrain->described.points, POINTS - 1));
  free(twice);
  free(terrain);
}

// Of random views: every triangle with a corner on the kept side that the mirrored camera sees is
// drawn exactly once, and cut if a corner of it is not on the kept side.
TEST(what_is_seen_is_in_one_run)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(71);
  mesh* const terrain = mesh_made(&from);
  large* const twice = large_made(terrain);
  double model_to_world[16] = { 0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 2, 0.5, 0, 0, 0, 1 };
  size_t drawn_sum = 0;
  size_t seen_sum = 0;
  size_t uncut_sum = 0;
  for (int round = 0; round < 60; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    water_clusters_view view;
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, at_zero, &view);
    const size_t count = water_runs_select(&view, &twice->described, twice->places, twice->runs);
    drawn_sum += count_drawn(twice, count);
    check_order(twice, count);
    for (size_t i = 0; i < ALL; ++i)
    {
      bool is_seen = false;
      bool is_below = false;
      for (int j = 0; j < 3; ++j)
      {
        const float* corner =
          terrain->points + 3 * terrain->indices[3 * (i % TRIANGLES) + (size_t)j];
        const double local[3] = { (double)corner[0], (double)corner[1], (double)corner[2] };
        double world[4];
        double clip[4];
        double px[2];
        water_mat4_apply_point(model_to_world, local, world);
        const int* rect = plan.texture_rect_px;
        map_place(&plan, world, clip, px);
        is_below = is_below || height_of(&random, world) < 0.0;
        is_seen = is_seen ||
          (clip[2] >= -clip[3] && clip[3] > 0.0 && px[0] >= 0.0 && px[0] <= rect[2] &&
            px[1] >= 0.0 && px[1] <= rect[3] && height_of(&random, world) >= 0.0);
      }
      assert_true(twice->times[i] <= 1);
      assert_true(twice->times[i] == 1 || !is_seen);
      assert_true(!twice->times[i] || twice->is_cut[i] || !is_below);
      seen_sum += is_seen;
      uncut_sum += twice->times[i] && !twice->is_cut[i];
    }
  }
  print_message("seen %zu, drawn %zu, of these not cut %zu, of %zu triangles\n", seen_sum,
    drawn_sum, uncut_sum, (size_t)60 * ALL);
  assert_int_in_range(seen_sum, 100000, 60 * ALL / 2);
  assert_int_in_range(drawn_sum, seen_sum, 60 * ALL * 2 / 3);
  assert_true(uncut_sum > 0);
  free(twice);
  free(terrain);
}

// Leaves without a number are left out, and those with a place at infinity drawn, and cut.
TEST(places_that_are_no_numbers)
{
  dice from = dice_seeded(72);
  mesh* const terrain = mesh_made(&from);
  large* const twice = large_made(terrain);
  water_clusters_view nothing;
  memset(&nothing, 0, sizeof nothing);
  nothing.frustum.planes[0][3] = -1.0; // nothing is inside
  water_frustum_prepare(&nothing.frustum);
  assert_int_equal(water_runs_select(&nothing, &twice->described, twice->places, twice->runs), 0);
  twice->boxes[40][1] = (double)INFINITY;
  water_runs_end(&twice->described);
  assert_int_equal(water_runs_select(&nothing, &twice->described, twice->places, twice->runs), 1);
  assert_int_equal(twice->runs[0].first, (size_t)40 * WATER_RUNS_LEAF_MIN);
  assert_int_equal(twice->runs[0].count, WATER_RUNS_LEAF_MIN);
  assert_true(twice->runs[0].is_cut);
  nothing.frustum.planes[0][3] = 1.0; // all is inside
  nothing.frustum.planes[5][3] = 1.0;
  water_bounds_begin(twice->boxes[41]);
  const size_t count = water_runs_select(&nothing, &twice->described, twice->places, twice->runs);
  (void)count_drawn(twice, count);
  assert_int_equal(twice->times[(size_t)41 * WATER_RUNS_LEAF_MIN], 0);
  free(twice);
  free(terrain);
}

TESTS(only_large_meshes_have_runs, indices_of_other_points_are_refused, what_is_seen_is_in_one_run,
  places_that_are_no_numbers)
