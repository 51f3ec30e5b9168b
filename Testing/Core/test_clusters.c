// SPDX-License-Identifier: BSD-3-Clause
// test_clusters.c: large meshes in clusters: what is seen of
// them is kept, in its order, and what is not seen is dropped.
#include "test_mesh.h"

#include "water_clusters.h"
#include "water_math.h"

TEST(only_large_meshes_have_clusters)
{
  assert_int_equal(water_clusters_count(0), 0);
  assert_int_equal(water_clusters_count(WATER_CLUSTER_TRIANGLES * (WATER_CLUSTERS_MIN - 1)), 0);
  assert_int_equal(water_clusters_count(WATER_CLUSTER_TRIANGLES * (WATER_CLUSTERS_MIN - 1) + 1),
    WATER_CLUSTERS_MIN);
}

TEST(indices_out_of_the_points_are_refused)
{
  dice from = dice_seeded(60);
  mesh* const terrain = mesh_made(&from);
  assert_true(water_clusters_bound(&terrain->described));
  terrain->described.point_count = POINTS - 1;
  assert_false(water_clusters_bound(&terrain->described));
  free(terrain);
}

// Of random views: every triangle with a corner that the mirrored camera sees on the kept side, in
// the part of the reflection texture that is looked up, is drawn; the order stays; and it is of
// use.
TEST(what_is_seen_is_kept_in_its_order)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(61);
  mesh* const terrain = mesh_made(&from);
  assert_true(water_clusters_bound(&terrain->described));
  double model_to_world[16] = { 0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 2, 0.5, 0, 0, 0, 1 };
  bool is_drawn[TRIANGLES];
  size_t drawn_sum = 0;
  size_t seen_sum = 0;
  for (int round = 0; round < 60; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    water_clusters_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, at_zero, &view);
    const size_t count =
      selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
    assert_int_equal(count % 3, 0);
    for (size_t i = 0; i < PIECES; ++i) // what is not seen has no distance
    {
      assert_true(terrain->work[i].triangles != 0 || terrain->work[i].distance == 0.0f);
    }
    drawn_sum += count / 3;
    assert_true(is_in_order(terrain, count, is_drawn)); // all that was drawn was found
    for (size_t i = 0; i < TRIANGLES; ++i)
    {
      const uint32_t* triangle = terrain->indices + 3 * i;
      bool is_seen = false;
      for (int j = 0; j < 3 && !is_seen; ++j)
      {
        const float* corner = terrain->points + 3 * triangle[j];
        const double local[3] = { (double)corner[0], (double)corner[1], (double)corner[2] };
        double world[4];
        double clip[4];
        water_mat4_apply_point(model_to_world, local, world);
        double px[2];
        const int* rect = plan.texture_rect_px;
        map_place(&plan, world, clip, px);
        is_seen = clip[2] >= -clip[3] && clip[3] > 0.0 && px[0] >= 0.0 && px[0] <= rect[2] &&
          px[1] >= 0.0 && px[1] <= rect[3] && height_of(&random, world) >= 0.0;
      }
      assert_true(is_drawn[i] || !is_seen);
      seen_sum += is_seen;
    }
  }
  print_message(
    "seen %zu, drawn %zu of %zu triangles\n", seen_sum, drawn_sum, (size_t)60 * TRIANGLES);
  assert_int_in_range(seen_sum, 50000, 60 * TRIANGLES / 2);
  assert_int_in_range(drawn_sum, seen_sum, 5 * seen_sum / 2); // of a hilly mesh seen from close
  free(terrain);
}

// A place at infinity keeps its cluster; doubles give the boxes that floats give.
TEST(points_of_both_kinds_and_without_an_end)
{
  const double huge = (double)INFINITY;
  const double doubles[9] = { 0, 0, 0, 1, 0, 0, huge, 1, 2 };
  const float floats[9] = { 0, 0, 0, 1, 0, 0, (float)huge, 1, 2 };
  const uint32_t indices[3] = { 0, 1, 2 };
  const water_points points[2] = { { NULL, doubles }, { floats, NULL } };
  for (int i = 0; i < 2; ++i)
  {
    double boxes[1][6];
    uint32_t drawn[3];
    water_trend trend;
    water_cluster_work work;
    const water_mesh single = { points[i], 3, indices, 1, boxes };
    memset(&trend, 0, sizeof trend);
    assert_true(water_clusters_bound(&single));
    const double expected[6] = { 0, huge, 0, 1, 0, 2 };
    assert_memory_equal(boxes[0], expected, sizeof expected);
    water_clusters_view nothing;
    memset(&nothing, 0, sizeof nothing);
    nothing.frustum.planes[0][3] = -1.0; // nothing is inside
    water_frustum_prepare(&nothing.frustum);
    assert_int_equal(selected(&nothing, &single, false, &trend, &work, drawn), 3);
    boxes[0][1] = 5.0;
    assert_int_equal(selected(&nothing, &single, false, &trend, &work, drawn), 0);
  }
}

// The other way around every triangle is where it was from the end, and what came nearer goes away.
TEST(backwards_is_the_order_backwards)
{
  const double center[3] = { 0.0, 0.0, 0.0 };
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  dice from = dice_seeded(62);
  mesh* const terrain = mesh_made(&from);
  uint32_t* const backwards = malloc(sizeof terrain->drawn);
  assert_non_null(backwards);
  assert_true(water_clusters_bound(&terrain->described));
  int steps = 0;
  for (int round = 0; round < 60; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    water_clusters_view view;
    water_trend trends[2];
    memset(trends, 0, sizeof trends);
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, at_zero, &view);
    const size_t count =
      selected(&view, &terrain->described, false, &trends[0], terrain->work, terrain->drawn);
    assert_int_equal(
      count, selected(&view, &terrain->described, true, &trends[1], terrain->work, backwards));
    for (size_t i = 0; i < count; i += 3)
    {
      assert_memory_equal(
        terrain->drawn + i, backwards + count - 3 - i, 3 * sizeof *terrain->drawn);
    }
    assert_int_equal(trends[0].nearer_steps, trends[1].farther_steps);
    assert_int_equal(trends[0].farther_steps, trends[1].nearer_steps);
    steps += trends[0].nearer_steps + trends[0].farther_steps;
  }
  assert_int_in_range(steps, 1000, 60 * PIECES);
  free(backwards);
  free(terrain);
}

// The last cluster has what is left, from none to one less than a cluster, both ways around.
TEST(last_piece_has_what_is_left)
{
  enum
  {
    MOST = 3 * WATER_CLUSTER_TRIANGLES
  };
  water_clusters_view all;
  memset(&all, 0, sizeof all);
  water_frustum_prepare(&all.frustum);
  uint32_t indices[3 * MOST];
  for (uint32_t i = 0; i < 3 * MOST; ++i)
  {
    indices[i] = i;
  }
  for (size_t count = 1; count <= MOST; ++count)
  {
    // exact sizes: a sanitizer sees what is read or written beyond
    const size_t clusters = (count + WATER_CLUSTER_TRIANGLES - 1) / WATER_CLUSTER_TRIANGLES;
    double(*boxes)[6] = calloc(clusters, sizeof *boxes);
    water_cluster_work* work = malloc(clusters * sizeof *work);
    uint32_t* drawn = malloc(3 * count * sizeof *drawn);
    assert_non_null(boxes);
    assert_non_null(work);
    const water_mesh part = { { NULL, NULL }, 0, indices, count, boxes };
    assert_non_null(drawn);
    for (int way = 0; way < 2; ++way)
    {
      water_trend trend;
      memset(&trend, 0, sizeof trend);
      assert_int_equal(selected(&all, &part, way, &trend, work, drawn), 3 * count);
      for (uint32_t i = 0; i < 3 * count; ++i)
      {
        const uint32_t triangle = way ? (uint32_t)count - 1 - i / 3 : i / 3;
        assert_int_equal(drawn[i], 3 * triangle + i % 3);
      }
    }
    free(drawn);
    free(work);
    free(boxes);
  }
}

// A step is counted in a cell of the picture, between the middles of two boxes before the eye, if
// they are not as far as each other. The view is a cube with the eye in its side z = 0.
TEST(steps_are_counted_by_cell_and_distance)
{
  const double planes[6][4] = { { 1, 0, 0, 1 }, { -1, 0, 0, 1 }, { 0, 1, 0, 1 }, { 0, -1, 0, 1 },
    { 0, 0, 1, 0 }, { 0, 0, -1, 9 } };
  const struct
  {
    double middles[3][3];
    int nearer;
    int farther;
  } cases[6] = {
    { { { 0.1, 0.1, 1.0 }, { 0.1, 0.1, 2.0 }, { 0.1, 0.1, 1.5 } }, 1, 1 },
    { { { 0.1, 0.1, 2.0 }, { 0.1, 0.1, 2.0 }, { 0.1, 0.1, 2.0 } }, 0, 0 },
    { { { 0.1, 0.1, 1.0 }, { 0.1, 0.1, 0.0 }, { 0.1, 0.1, 2.0 } }, 0, 1 }, // the second: at the eye
    { { { 0.5, 0.1, 1.0 }, { 0.95, 0.1, 2.0 }, { -0.5, 0.1, 3.0 } }, 0, 0 },
    { { { 0.1, 0.1, 1.0 }, { 0.1, 0.95, 2.0 }, { 0.1, -0.4, 3.0 } }, 0, 0 },
    { { { -0.98, 0.1, 2.0 }, { -1.5, 0.1, 1.0 }, { -0.99, 0.1, 4.0 } }, 1, 1 }, // past the side
  };
  for (int i = 0; i < 6; ++i)
  {
    water_clusters_view view;
    water_trend trend;
    uint32_t indices[9 * WATER_CLUSTER_TRIANGLES] = { 0 };
    uint32_t drawn[9 * WATER_CLUSTER_TRIANGLES];
    double boxes[3][6];
    memset(&view, 0, sizeof view);
    memset(&trend, 0, sizeof trend);
    memcpy(view.frustum.planes, planes, sizeof planes);
    water_frustum_prepare(&view.frustum);
    for (int j = 0; j < 18; ++j)
    {
      boxes[j / 6][j % 6] = cases[i].middles[j / 6][j % 6 / 2] + (j % 2 ? 0.75 : -0.75);
    }
    const size_t count = sizeof indices / sizeof indices[0];
    water_cluster_work work[3];
    const water_mesh three = { { NULL, NULL }, 0, indices, count / 3, boxes };
    assert_int_equal(selected(&view, &three, false, &trend, work, drawn), count);
    assert_int_equal(trend.nearer_steps, cases[i].nearer);
    assert_int_equal(trend.farther_steps, cases[i].farther);
  }
}

// A mesh whose rows lie one behind the other goes away from an eye at its first row and comes
// nearer to one at its last; so do its columns, within every row.
TEST(the_trend_says_which_end_is_near)
{
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  dice from = dice_seeded(63);
  mesh* const terrain = mesh_made(&from);
  assert_true(water_clusters_bound(&terrain->described));
  for (int side = 0; side < 4; ++side)
  {
    water_scene scene = lake();
    double eye[3] = { 0.0, 0.0, 6.0 };
    const double target[3] = { 0.0, 0.0, 0.0 };
    const double wide[6] = { -60.0, 60.0, -60.0, 60.0, 0.0, 0.0 };
    eye[side / 2] = side % 2 ? 60.0 : -60.0;
    look_at(eye, target, up, scene.eye.world_to_view);
    memcpy(scene.surface_bounds, wide, sizeof wide);
    const water_plan plan = plan_of(&scene, NULL);
    water_clusters_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, at_zero, &view);
    (void)selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
    const int away = side % 2 ? trend.nearer_steps : trend.farther_steps;
    const int back = side % 2 ? trend.farther_steps : trend.nearer_steps;
    assert_int_in_range(away, 200, PIECES);
    assert_int_in_range(back, 0, away - 1);
  }
  free(terrain);
}

// What a view tells the triangles.
TEST(the_map_is_handed_on)
{
  const double moved[16] = { 0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 2, 0.5, 0, 0, 0, 1 };
  const double place[3] = { 3.0, -2.0, 1.5 };
  water_scene scene = lake();
  float depths[1];
  const water_visibility seen = { { 0, 0 } };
  for (int i = 0; i < 2; ++i)
  {
    scene.is_software = i;
    const water_plan plan = plan_of(&scene, NULL);
    const water_clusters_target target = { i ? &seen : NULL, i ? depths : NULL, i ? 2 : 1,
      4 + 4 * i };
    water_clusters_view view;
    water_clusters_view_make(&plan, &target, 0, 1, i, moved, at_zero, &view);
    assert_int_equal(view.is_fine, i);
    assert_int_equal(view.triangles.has_samples, i);
    assert_int_equal(view.triangles.is_solid, i);
    assert_ptr_equal(view.triangles.seen, target.seen);
    assert_ptr_equal(view.triangles.depths, target.depths);
    assert_true(view.triangles.grid_px == (i ? 1.0 / 256.0 : 1.0 / 16.0));
    assert_memory_equal(view.triangles.rect_px, plan.texture_rect_px, sizeof plan.texture_rect_px);
    assert_memory_equal(view.triangles.texture_px, plan.texture_px, sizeof plan.texture_px);
    assert_true(view.triangles.reach == view.frustum.reach);
    double world[4];
    double expected[4];
    double clip[4];
    double view_place[4];
    apply(moved, place, 1.0, world);
    project(&plan.mirrored, world, 1.0, expected);
    apply(view.triangles.to_clip, place, 1.0, clip);
    apply(plan.mirrored.world_to_view, world, 1.0, view_place);
    for (int j = 0; j < 4; ++j)
    {
      ASSERT_CLOSE(clip[j], expected[j], 1e-9);
    }
    ASSERT_CLOSE(dot(view.triangles.kept, place) + view.triangles.kept[3],
      dot(plan.clip_plane_view, view_place) + plan.clip_plane_view[3], 1e-9);
  }
}

TESTS(only_large_meshes_have_clusters, indices_out_of_the_points_are_refused,
  what_is_seen_is_kept_in_its_order, points_of_both_kinds_and_without_an_end,
  backwards_is_the_order_backwards, last_piece_has_what_is_left,
  steps_are_counted_by_cell_and_distance, the_trend_says_which_end_is_near, the_map_is_handed_on)
