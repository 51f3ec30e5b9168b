// SPDX-License-Identifier: BSD-3-Clause
// test_pieces_place.c: large meshes that are far from the origin of the world, or of their own
// coordinates.
#include "test_mesh.h"

// What cancels in single precision, its rounding must know: how far the eye is from the origin of
// what the GPU has, in the mesh's own units, wherever in the world both are.
TEST(rounding_knows_how_far_the_origin_is)
{
  UNUSED;
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
    water_pieces_view view;
    water_pieces_look(&plan, &plain_map, false, model_to_world, origin, &view);
    double world[4];
    apply(model_to_world, origin, 1.0, world);
    const double mirrored_eye[3] = { eye[0], eye[1], 2.0 * shift[2] - eye[2] };
    const double apart[3] = { world[0] - mirrored_eye[0], world[1] - mirrored_eye[1],
      world[2] - mirrored_eye[2] };
    const double distance = unit * sqrt(dot(apart, apart));
    assert_true(view.frustum.reach >= distance && view.frustum.reach <= 1.001 * distance);
  }
}

// As much of a mesh is left out far from the world's origin as at it.
TEST(far_meshes_are_cut_as_near_ones)
{
  UNUSED;
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
    assert_true(water_pieces_bound(&terrain->described));
    const water_pieces_map map = { NULL, depths, 0, 8 };
    water_pieces_view view;
    water_trend trend;
    memset(&trend, 0, sizeof trend);
    water_pieces_look(&plan, &map, true, model_to_world, i == 2 ? at_zero : origin, &view);
    water_triangles_begin(rect, NULL, depths);
    counts[i] =
      water_pieces_select(&view, &terrain->described, false, &trend, terrain->work, terrain->drawn);
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

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(rounding_knows_how_far_the_origin_is),
    RUN(far_meshes_are_cut_as_near_ones),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
