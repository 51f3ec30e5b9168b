// SPDX-License-Identifier: BSD-3-Clause
// test_clusters_fine.c: large meshes in clusters whose
// triangles are looked at one by one, or that lie in cells of the reflection texture that nothing
// looks up.
#include "test_mesh.h"

#include "water_clusters.h"

// Triangles one by one: some of those of the clusters, in their order; the same from either end,
// because it is the near clusters that hide the far ones; and fewer than half of the clusters'.
TEST(triangles_are_looked_at_one_by_one)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  dice from = dice_seeded(64);
  mesh* const terrain = mesh_made(&from);
  uint32_t* const fine[2] = { malloc(sizeof terrain->drawn), malloc(sizeof terrain->drawn) };
  assert_non_null(fine[0]);
  assert_non_null(fine[1]);
  assert_true(water_clusters_bound(&terrain->described));
  size_t sums[2] = { 0, 0 };
  for (int round = 0; round < 60; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    random.scene.is_software = true;
    const water_plan plan = plan_of(&random.scene, NULL);
    const int* rect = plan.texture_rect_px;
    float* depths = malloc((size_t)rect[2] * (size_t)rect[3] * sizeof *depths);
    assert_non_null(depths);
    const water_clusters_target target = { NULL, depths, 0, 8 };
    water_clusters_view view;
    water_trend trend;
    size_t counts[2];
    water_clusters_view_make(&plan, &target, 0, 1, true, model_to_world, at_zero, &view);
    for (int i = 0; i < 2; ++i)
    {
      memset(&trend, 0, sizeof trend);
      water_triangle_cull_begin(rect, NULL, depths);
      counts[i] = selected(&view, &terrain->described, i, &trend, terrain->work, fine[i]);
    }
    view.is_fine = false;
    const size_t count =
      selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
    size_t at = 0;
    for (size_t i = 0; i < count && at < counts[0]; i += 3)
    {
      at += memcmp(terrain->drawn + i, fine[0] + at, 3 * sizeof *fine[0]) == 0 ? 3 : 0;
    }
    assert_int_equal(at, counts[0]);
    assert_int_equal(counts[0], counts[1]);
    for (size_t i = 0; i < counts[0]; i += 3)
    {
      assert_memory_equal(fine[0] + i, fine[1] + counts[0] - 3 - i, 3 * sizeof *fine[0]);
    }
    sums[0] += counts[0];
    sums[1] += count;
    free(depths);
  }
  print_message("%zu of %zu triangles\n", sums[0] / 3, sums[1] / 3);
  assert_int_in_range(sums[0], 1000, 8 * sums[1] / 25);
  free(fine[0]);
  free(fine[1]);
  free(terrain);
}

// Two corners of a triangle may take each other's place among those that were projected last: it
// stays, and the others go, here under the water.
TEST(corners_that_take_each_others_place_keep_their_triangle)
{
  enum
  {
    MANY = 600,
    COUNT = 4
  };
  const uint32_t indices[3 * COUNT] = { 0, 256, 1, 3, 1, 257, 512, 2, 0, 0, 1, 2 };
  float places[3 * MANY];
  for (int i = 0; i < 3 * MANY; ++i)
  {
    places[i] = (float)(i % 7);
  }
  double boxes[1][6];
  uint32_t drawn[3 * COUNT];
  water_cluster_work work;
  water_trend trend;
  water_clusters_view view;
  memset(&view, 0, sizeof view);
  memset(&trend, 0, sizeof trend);
  water_frustum_prepare(&view.frustum);
  view.is_fine = true;
  view.triangles.to_clip[15] = 1.0;
  view.triangles.kept[3] = -1.0;
  const water_mesh single = { { places, NULL }, MANY, indices, COUNT, boxes };
  assert_true(water_clusters_bound(&single));
  assert_int_equal(selected(&view, &single, false, &trend, &work, drawn), 9);
  assert_memory_equal(drawn, indices, 9 * sizeof *drawn);
}

// Clusters in cells that nothing looks up are left out: none is drawn if all are closed, and with
// all of them open as many as without cells.
TEST(clusters_in_closed_cells_are_left_out)
{
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  dice from = dice_seeded(65);
  mesh* const terrain = mesh_made(&from);
  uint8_t* const cells = calloc(WATER_VISIBILITY_CELLS_MAX, 1);
  uint32_t* const sums = malloc(2 * WATER_VISIBILITY_CELLS_MAX * sizeof *sums);
  assert_non_null(cells);
  assert_non_null(sums);
  assert_true(water_clusters_bound(&terrain->described));
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  size_t counts[3];
  for (int i = 0; i < 3; ++i)
  {
    water_visibility seen;
    water_visibility_begin(plan.texture_px, plan.texture_rect_px, &seen);
    memset(cells, i, WATER_VISIBILITY_CELLS_MAX);
    seen.counts = sums;
    water_visibility_sum(&seen, cells);
    const water_clusters_target target = { i < 2 ? &seen : NULL, NULL, 0, 8 };
    water_clusters_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_clusters_view_make(&plan, &target, 0, 1, false, model_to_world, at_zero, &view);
    counts[i] = selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
  }
  assert_int_in_range(counts[2], 1000, 3 * TRIANGLES);
  assert_int_in_range(counts[0], 0, counts[2] / 2); // those about the eye stay
  assert_int_in_range(counts[1], counts[2] / 2, counts[2]);
  free(sums);
  free(cells);
  free(terrain);
}

TESTS(triangles_are_looked_at_one_by_one, corners_that_take_each_others_place_keep_their_triangle,
  clusters_in_closed_cells_are_left_out)
