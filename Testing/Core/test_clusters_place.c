// SPDX-License-Identifier: BSD-3-Clause
// test_clusters_place.c: large meshes that are far from the origin of the world, or of their own
// coordinates, or are looked at in bands of the reflection texture.
#include "test_mesh.h"

#include "water_clusters.h"

// What cancels in single precision, its rounding must know: how far the eye is from the origin of
// what the GPU has, in the mesh's own units, wherever in the world both are.
TEST(rounding_knows_how_far_the_origin_is)
{
  const double units[4] = { 1.0, 1.0, 1000.0, 0.01 };
  const double offset[3] = { 5e5, 4.5e6, 100.0 };
  for (int i = 0; i < 4; ++i)
  {
    double origin[3];
    double shift[3];
    const double unit = units[i];
    double model_to_world[16] = { 0, -1 / unit, 0, 3, 1 / unit, 0, 0, -4, 0, 0, 1 / unit, 12, 0, 0,
      0, 1 };
    for (int j = 0; j < 3; ++j)
    {
      shift[j] = i == 1 ? offset[j] : 0.0;
      model_to_world[4 * j + 3] += shift[j];
      origin[j] = (i == 3 ? 1e5 : 10.0) * (j + 1);
    }
    water_scene scene = lake();
    const double eye[3] = { shift[0], shift[1] - 10.0, shift[2] + 5.0 };
    const double up[3] = { 0.0, 0.0, 1.0 };
    look_at(eye, shift, up, scene.eye.world_to_view);
    scene.plane.offset = -shift[2];
    for (int j = 0; j < 6; ++j)
    {
      scene.surface_bounds[j] += shift[j / 2];
    }
    const water_plan plan = plan_of(&scene, NULL);
    water_clusters_view view;
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, origin, &view);
    double world[4];
    apply(model_to_world, origin, 1.0, world);
    const double mirrored_eye[3] = { eye[0], eye[1], 2.0 * shift[2] - eye[2] };
    const double apart[3] = { world[0] - mirrored_eye[0], world[1] - mirrored_eye[1],
      world[2] - mirrored_eye[2] };
    const double distance = unit * sqrt(dot(apart, apart));
    assert_true(view.frustum.reach >= distance && view.frustum.reach <= 1.001 * distance);
  }
}

// Far from the origins of the world and of the mesh the numbers that cancel in double precision
// count as well, 2^29 times less: the lengths of the view's offset, of the place in the world, and
// of the mesh's own offset, each of another size here.
TEST(rounding_knows_how_far_the_world_is)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (int i = 0; i < 3; ++i)
  {
    const double view = i == 0 ? 4e9 : 0.0; // along x
    const double model = i == 1 ? 4e9 : 0.0;
    const double model_to_world[16] = { 1, 0, 0, model, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    const double origin[3] = { i == 2 ? 4e9 : view - model, 0.0, 0.0 };
    const double target[3] = { view, 0.0, 0.0 };
    const double eye[3] = { view, -10.0, 5.0 };
    water_scene scene = lake();
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.surface_bounds[0] += view;
    scene.surface_bounds[1] += view;
    const water_plan plan = plan_of(&scene, NULL);
    water_clusters_view made;
    water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, origin, &made);
    const double place = model + origin[0];
    const double near = hypot(hypot(place - view, 10.0), 5.0);
    const double lengths = hypot(hypot(view, 10.0), 5.0) + fabs(place) + fabs(model);
    const double expected = near + ldexp(lengths, -29);
    ASSERT_CLOSE(made.frustum.reach, expected, 1e-5);
  }
}

// A box of the mesh is inside the view if all of it is, outside if none is; what hides in what is
// looked up keeps boxes in it from being known.
TEST(boxes_have_their_places_in_a_view)
{
  const double huge = (double)INFINITY;
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double boxes[6][6] = { { -0.1, 0.1, -0.1, 0.1, 0.5, 0.7 }, // over the middle of the lake
    { -0.1, 0.1, -0.1, 0.1, -0.5, 0.5 },                           // across the water
    { -0.1, 0.1, -30.0, -20.0, 0.5, 0.7 },                         // behind the eye
    { -0.1, 0.1, -0.1, 0.1, 0.5, huge }, { huge, -huge, huge, -huge, huge, -huge },
    { -0.1, 0.1, -0.1, 0.1, -0.7, -0.5 } }; // under the water
  const water_box_place expected[6] = { WATER_BOX_INSIDE, WATER_BOX_ACROSS, WATER_BOX_OUTSIDE,
    WATER_BOX_ACROSS, WATER_BOX_OUTSIDE, WATER_BOX_OUTSIDE };
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  water_visibility seen;
  water_visibility_begin(plan.texture_px, plan.texture_rect_px, &seen);
  const size_t cells = (size_t)seen.size[0] * (size_t)seen.size[1];
  uint8_t* const open = malloc(cells);
  seen.counts =
    malloc((cells + (size_t)seen.size[0] + (size_t)seen.size[1] + 1) * sizeof(uint32_t));
  assert_non_null(open);
  assert_non_null(seen.counts);
  memset(open, 1, cells);
  water_visibility_sum(&seen, open);
  const water_clusters_target target = { &seen, NULL, 0, 8 };
  water_clusters_view whole;
  water_clusters_view part;
  water_clusters_view_make(&plan, &plain_map, 0, 1, false, model_to_world, at_zero, &whole);
  water_clusters_view_make(&plan, &target, 0, 1, false, model_to_world, at_zero, &part);
  for (int i = 0; i < 6; ++i)
  {
    assert_int_equal(water_clusters_place(&whole, boxes[i]), expected[i]);
    assert_int_equal(water_clusters_place(&part, boxes[i]),
      expected[i] == WATER_BOX_OUTSIDE ? WATER_BOX_OUTSIDE : WATER_BOX_ACROSS);
  }
  free(seen.counts);
  free(open);
}

// As much of a mesh is left out far from the world's origin as at it.
TEST(far_meshes_are_cut_as_near_ones)
{
  const double far[3] = { 500000.0, 4500000.0, 128.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  dice from = dice_seeded(66);
  mesh* const terrain = mesh_made(&from);
  double* const doubles = malloc(sizeof *doubles * 3 * POINTS);
  assert_non_null(doubles);
  const float* const floats = terrain->described.points.floats;
  size_t counts[3];
  for (int i = 0; i < 3; ++i)
  {
    double origin[3] = { 0.0, 0.0, 0.0 };
    const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    water_scene scene = lake();
    double eye[3] = { 0.0, -60.0, 1.0 };
    const double wide[6] = { -60.0, 60.0, -60.0, 60.0, 0.0, 0.0 };
    memcpy(scene.surface_bounds, wide, sizeof wide);
    for (int j = 0; j < 3 && i > 0; ++j)
    {
      origin[j] = far[j];
      eye[j] += far[j];
      scene.surface_bounds[2 * j] += far[j];
      scene.surface_bounds[2 * j + 1] += far[j];
    }
    look_at(eye, origin, up, scene.eye.world_to_view);
    scene.plane.offset = -origin[2];
    scene.is_software = true;
    const water_plan plan = plan_of(&scene, NULL);
    const int* rect = plan.texture_rect_px;
    float* depths = malloc((size_t)rect[2] * (size_t)rect[3] * sizeof *depths);
    assert_non_null(depths);
    for (int j = 0; j < 3 * POINTS; ++j)
    {
      doubles[j] = (double)floats[j] + origin[j % 3];
    }
    terrain->described.points = (water_points){ NULL, doubles };
    assert_true(water_clusters_bound(&terrain->described));
    const water_clusters_target target = { NULL, depths, 0, 8 };
    water_clusters_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_clusters_view_make(
      &plan, &target, 0, 1, true, model_to_world, i == 2 ? at_zero : origin, &view);
    water_triangle_cull_begin(rect, NULL, depths);
    counts[i] = selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
    free(depths);
  }
  print_message("near %zu, far %zu, as single precision has it there %zu of %d triangles\n",
    counts[0] / 3, counts[1] / 3, counts[2] / 3, TRIANGLES);
  assert_true(counts[0] > 0 && (double)counts[0] < 0.8 * (double)counts[2]);
  // they differ where a millionth of a pixel decides
  assert_true(fabs((double)counts[1] / (double)counts[0] - 1.0) < 0.01);
  free(doubles);
  free(terrain);
}

TEST(bands_are_for_cores_and_large_meshes)
{
  const size_t enough = (size_t)WATER_CLUSTER_TRIANGLES * WATER_BAND_CLUSTERS;
  assert_int_equal(water_clusters_bands(true, 3 * enough, 8), 3);
  assert_int_equal(water_clusters_bands(true, 3 * enough - WATER_CLUSTER_TRIANGLES, 8), 2);
  assert_int_equal(water_clusters_bands(true, 3 * enough, 2), 2);
  assert_int_equal(water_clusters_bands(true, 100 * enough, 64), WATER_CLUSTERS_BANDS_MAX);
  assert_int_equal(water_clusters_bands(true, 100 * enough, 0), 1);
  assert_int_equal(water_clusters_bands(true, 100 * enough, 1), 1);
  assert_int_equal(water_clusters_bands(true, 10, 64), 1);
  assert_int_equal(water_clusters_bands(false, 100 * enough, 64), 1);
}

// Bands share the work: what is drawn into the reflection texture is marked in the bands that it is
// in, and hardly anything else.
TEST(bands_mark_what_is_in_them)
{
  enum
  {
    BANDS = 3
  };
  const double center[3] = { 0.0, 0.0, 0.0 };
  const double model_to_world[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  dice from = dice_seeded(67);
  mesh* const terrain = mesh_made(&from);
  water_cluster_work* const works = malloc(BANDS * PIECES * sizeof *works);
  assert_non_null(works);
  assert_true(water_clusters_bound(&terrain->described));
  size_t whole = 0;
  size_t all = 0;
  size_t fine = 0;
  size_t each = 0;
  for (int round = 0; round < 60; ++round)
  {
    random_scene random = scene_rolled(&from, round, center);
    random.scene.is_software = round % 2;
    const water_plan plan = plan_of(&random.scene, NULL);
    const int* rect = plan.texture_rect_px;
    float* depths = malloc((size_t)rect[2] * (size_t)rect[3] * sizeof *depths);
    assert_non_null(depths);
    const water_clusters_target target = { NULL, depths, 0, 8 };
    water_clusters_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_triangle_cull_begin(rect, NULL, depths);
    water_clusters_view_make(&plan, &target, 0, 1, true, model_to_world, at_zero, &view);
    whole += selected(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
    water_triangle_cull_begin(rect, NULL, depths);
    int end = 0;
    for (int band = 0; band < BANDS; ++band)
    {
      water_cluster_work* work = works + (size_t)band * PIECES;
      memset(&trend, 0, sizeof trend);
      water_clusters_view_make(&plan, &target, band, BANDS, true, model_to_world, at_zero, &view);
      assert_int_equal(view.triangles.columns[0], end); // one after the other
      end = view.triangles.columns[1];
      water_clusters_mark(&view, &terrain->described, false, &trend, work);
      const size_t count = water_clusters_copy(&terrain->described, false, work, 1, terrain->drawn);
      each += round % 2 ? count : 0;
    }
    assert_int_equal(end, rect[2]);
    const size_t count =
      water_clusters_copy(&terrain->described, false, works, BANDS, terrain->drawn);
    all += count;
    fine += round % 2 ? count : 0;
    assert_true(is_in_order(terrain, count, NULL));
    free(depths);
  }
  print_message("%zu triangles, in bands %zu; one by one %zu, %zu with those in several\n",
    whole / 3, all / 3, fine / 3, each / 3);
  assert_true(fabs((double)all / (double)whole - 1.0) < 0.02);
  assert_true((double)each < 1.15 * (double)fine);
  free(works);
  free(terrain);
}

// Of a half-space that leans along all axes, a box is kept if its lowest corner is: its low x, high
// y and low z, at 2 - 2 + 4 - 3 = 1 over the plane. Each of the three alone can take it under.
TEST(lowest_corner_decides_what_is_kept)
{
  static const double kept[4] = { 1.0, -2.0, 2.0, -3.0 };
  static const double box[6] = { 2.0, 9.0, -1.0, 1.0, 2.0, 5.0 };
  static const int ends[3] = { 0, 3, 4 };
  static const double moved[3] = { 0.5, 2.0, 1.0 };
  water_clusters_view view;
  memset(&view, 0, sizeof view);
  memcpy(view.frustum.planes[5], kept, sizeof kept);
  assert_true(water_clusters_is_kept(&view, box));
  for (int i = 0; i < 3; ++i)
  {
    double lower[6];
    memcpy(lower, box, sizeof lower);
    lower[ends[i]] = moved[i];
    assert_false(water_clusters_is_kept(&view, lower));
  }
  view.frustum.planes[5][3] = -4.5;
  assert_false(water_clusters_is_kept(&view, box));
}

TESTS(lowest_corner_decides_what_is_kept, rounding_knows_how_far_the_world_is,
  boxes_have_their_places_in_a_view, rounding_knows_how_far_the_origin_is,
  far_meshes_are_cut_as_near_ones, bands_are_for_cores_and_large_meshes, bands_mark_what_is_in_them)
