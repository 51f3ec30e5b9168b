// SPDX-License-Identifier: BSD-3-Clause
// test_camera.c: the eye taken apart: what is no camera, where the eye is, which way its rays go.
#include "test_scene.h"

#include "water_camera.h"

static const double far_away[3] = { 5e6, -4e6, 300.0 };

static void assert_refused(const water_camera* camera)
{
  water_eye eye;
  memset(&eye, 0, sizeof eye);
  eye.center_view[0] = 7.0;
  assert_int_equal(water_camera_decompose(camera, &eye), WATER_BAD_CAMERA);
  assert_true(eye.center_view[0] == 7.0);
}

// NaN in any of the 32 entries is no camera.
TEST(nan_anywhere_is_refused)
{
  for (int i = 0; i < 16; ++i)
  {
    water_scene scene = lake();
    scene.eye.world_to_view[i] = (double)NAN;
    assert_refused(&scene.eye);
    scene = lake();
    scene.eye.view_to_clip[i] = (double)NAN;
    assert_refused(&scene.eye);
  }
}

// Scaled, sheared, mirrored or projecting views are not rigid; a projection without depth has no
// inverse.
TEST(views_that_are_not_rigid_are_refused)
{
  water_scene scene = lake();
  for (int j = 0; j < 4; ++j)
  {
    scene.eye.world_to_view[4 + j] *= 1.00001; // ten times the tolerance
  }
  assert_refused(&scene.eye);
  scene = lake();
  scene.eye.world_to_view[0] += 0.1 * scene.eye.world_to_view[4];
  scene.eye.world_to_view[1] += 0.1 * scene.eye.world_to_view[5];
  assert_refused(&scene.eye);
  scene = lake();
  for (int j = 0; j < 4; ++j)
  {
    scene.eye.world_to_view[j] *= -1.0;
  }
  assert_refused(&scene.eye);
  scene = lake();
  scene.eye.world_to_view[14] = 1e-3;
  assert_refused(&scene.eye);
  scene = lake();
  scene.eye.world_to_view[15] = 2.0;
  assert_refused(&scene.eye);
  scene = lake();
  memset(scene.eye.view_to_clip + 8, 0, 4 * sizeof(double));
  assert_refused(&scene.eye);
  scene = lake();
  scene.eye.world_to_view[3] = 1e308; // finite, but the eye point is not
  scene.eye.world_to_view[7] = 1e308;
  assert_refused(&scene.eye);
  scene = lake();
  const double skewed[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1 };
  // w = x + 1: the rays are parallel, and yet w is not constant
  memcpy(scene.eye.view_to_clip, skewed, sizeof skewed);
  assert_refused(&scene.eye);
}

// A view made of float directions, and one at 1e7, still are cameras.
TEST(rounded_and_distant_views_pass)
{
  dice from = dice_seeded(5);
  for (int round = 0; round < 300; ++round)
  {
    const double center[3] = { 1e7, -1e7, 1e7 };
    random_scene random = scene_rolled(&from, round, center);
    water_eye eye;
    assert_int_equal(water_camera_decompose(&random.scene.eye, &eye), WATER_OK);
    for (int i = 0; i < 11; ++i)
    {
      random.scene.eye.world_to_view[i] = (double)(float)random.scene.eye.world_to_view[i];
    }
    assert_int_equal(water_camera_decompose(&random.scene.eye, &eye), WATER_OK);
  }
}

// A shear in the projection moves the eye point: clip x and y made from (x + 0.3 w, y) of a camera
// moved 0.3 to the right belong to an eye at x = 0.3.
TEST(eye_point_of_a_sheared_projection_is_found)
{
  water_scene scene = lake();
  double* to_clip = scene.eye.view_to_clip;
  water_eye eye;
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  assert_true(eye.has_center);
  ASSERT_CLOSE(eye.center_view[0], 0.0, 1e-15);
  for (int i = 0; i < 4; ++i) // view_to_clip * translate(-0.3, 0.2, 0.5)
  {
    const double* row = to_clip + 4 * i;
    to_clip[4 * i + 3] += -0.3 * row[0] + 0.2 * row[1] + 0.5 * row[2];
  }
  assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
  ASSERT_CLOSE(eye.center_view[0], 0.3, 1e-14);
  ASSERT_CLOSE(eye.center_view[1], -0.2, 1e-14);
  ASSERT_CLOSE(eye.center_view[2], -0.5, 1e-14);
  // the ray of a point's pixel leads from the eye point to it, and is as long as w is to 1
  const double point[3] = { 1.0, 2.0, -7.0 };
  double clip[4];
  apply(to_clip, point, 1.0, clip);
  for (int i = 0; i < 3; ++i)
  {
    const double* row = eye.ndc_to_dir + 3 * i;
    ASSERT_CLOSE(
      row[0] * clip[0] + row[1] * clip[1] + row[2] * clip[3], point[i] - eye.center_view[i], 1e-13);
  }
}

// A parallel eye looks along -z of view space also where the depth runs backwards.
TEST(parallel_ray_does_not_depend_on_the_sign_of_depth)
{
  const double box[4] = { -1.0, 3.0, -1.0, 1.0 };
  double to_clip[16];
  ortho_matrix(box, 1.0, 10.0, to_clip);
  for (int round = 0; round < 2; ++round)
  {
    water_scene scene = lake();
    water_eye eye;
    to_clip[10] *= -1.0;
    to_clip[11] *= -1.0;
    memcpy(scene.eye.view_to_clip, to_clip, sizeof to_clip);
    assert_int_equal(water_camera_decompose(&scene.eye, &eye), WATER_OK);
    ASSERT_CLOSE(eye.ndc_to_dir[8], -1.0, 1e-15);
    ASSERT_CLOSE(eye.ndc_to_dir[2], 0.0, 1e-15);
  }
}

// The ray of a point's own pixel leads from the eye (parallel: along the view direction) to the
// point, and away from the eye; here for axes that are the world's, 5000 km out.
TEST(ray_of_a_pixel_leads_to_what_it_shows)
{
  dice from = dice_seeded(6);
  const double x_dir[3] = { 1.0, 0.0, 0.0 };
  const double y_dir[3] = { 0.0, 1.0, 0.0 };
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  int inside = 0;
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, far_away);
    water_eye eye;
    double rays[9];
    double point[3];
    double clip[4];
    double ray[3];
    double truth[3];
    assert_int_equal(water_camera_decompose(&random.scene.eye, &eye), WATER_OK);
    assert_int_equal(eye.has_center, !random.is_parallel);
    water_camera_rays(&eye, &level, x_dir, y_dir, rays);
    point_near(&from, &random, 3.0, point);
    project(&random.scene.eye, point, 1.0, clip);
    if (!is_inside(clip))
    {
      continue;
    }
    ++inside;
    for (int i = 0; i < 3; ++i)
    {
      ray[i] = (rays[3 * i] * clip[0] + rays[3 * i + 1] * clip[1]) / clip[3] + rays[3 * i + 2];
      truth[i] = random.is_parallel ? random.view_dir[i] : point[i] - random.eye[i];
    }
    normalise(ray);
    normalise(truth);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(ray[i], truth[i], 1e-8);
    }
  }
  assert_int_in_range(inside, 1500, 3000);
}

TESTS(nan_anywhere_is_refused, views_that_are_not_rigid_are_refused, rounded_and_distant_views_pass,
  eye_point_of_a_sheared_projection_is_found, parallel_ray_does_not_depend_on_the_sign_of_depth,
  ray_of_a_pixel_leads_to_what_it_shows)
