// SPDX-License-Identifier: BSD-3-Clause
// test_mirror.c: the mirrored camera and the clip at the water.
#include "test_scene.h"

#include "water_math.h"
#include "water_mirror.h"
#include "water_plane.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };

// Seen from 5 above a lake, the mirrored camera is 5 below it and looks up at the same spot, its up
// vector mirrored and turned over with it: what the eye's picture has above, its picture has above.
TEST(mirrored_camera_of_a_known_eye)
{
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  const double position[3] = { 0.0, -10.0, -5.0 };
  const double view_dir[3] = { 0.0, 10.0 / sqrt(125.0), 5.0 / sqrt(125.0) };
  const double up[3] = { 0.0, 5.0 / sqrt(125.0), -10.0 / sqrt(125.0) };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(plan.mirrored_position[i], position[i], 1e-14);
    ASSERT_CLOSE(plan.mirrored_focal_point[i], position[i] + view_dir[i], 1e-14);
    ASSERT_CLOSE(plan.mirrored_view_up[i], up[i], 1e-14);
  }
}

// A look-at made of position, focal point and up is the mirrored view: what the host sets in its
// own terms is what the matrices say.
TEST(pose_and_matrix_are_the_same_camera)
{
  dice from = dice_seeded(7);
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double view[16];
    look_at(plan.mirrored_position, plan.mirrored_focal_point, plan.mirrored_view_up, view);
    for (int i = 0; i < 16; ++i)
    {
      ASSERT_CLOSE(view[i], plan.mirrored.world_to_view[i], 1e-12);
    }
    ASSERT_CLOSE(determinant3(plan.mirrored.world_to_view), 1.0, 1e-13);
    assert_int_equal(plan.mirrored.parallel, random.scene.eye.parallel);
  }
}

// A point on the water is seen at the same place by both cameras, x flipped, at the same depth.
TEST(point_on_water_keeps_its_pixel)
{
  dice from = dice_seeded(8);
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double image[3];
    double eye[4];
    double mirrored[4];
    point_near(&from, &random, 5.0, point);
    mirror_image(&random, point, image);
    for (int i = 0; i < 3; ++i)
    {
      point[i] = 0.5 * (point[i] + image[i]); // on the water
    }
    project(&random.scene.eye, point, 1.0, eye);
    project(&plan.mirrored, point, 1.0, mirrored);
    ASSERT_CLOSE(mirrored[0], -eye[0], 1e-12 * 100.0);
    for (int i = 1; i < 4; ++i)
    {
      ASSERT_CLOSE(mirrored[i], eye[i], 1e-12 * 100.0);
    }
  }
}

// Any point is seen by the mirrored camera where the eye sees the point's mirror image, x flipped;
// with coordinates of 5e6 still to a thousandth of a pixel.
TEST(point_above_water_is_seen_as_its_mirror_image)
{
  dice from = dice_seeded(9);
  const double far_away[3] = { 5e6, -4e6, 300.0 };
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, round % 2 ? far_away : nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double image[3];
    double eye[4];
    double mirrored[4];
    point_near(&from, &random, 5.0, point);
    mirror_image(&random, point, image);
    project(&random.scene.eye, image, 1.0, eye);
    project(&plan.mirrored, point, 1.0, mirrored);
    ASSERT_CLOSE(mirrored[0], -eye[0], 1e-6);
    for (int i = 1; i < 4; ++i)
    {
      ASSERT_CLOSE(mirrored[i], eye[i], 1e-6);
    }
  }
}

// Mirrored twice, a camera is itself again.
TEST(mirrored_twice_is_the_eye)
{
  dice from = dice_seeded(10);
  for (int round = 0; round < 300; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    water_plane unit;
    water_camera camera = random.scene.eye;
    assert_int_equal(water_plane_normalise(&random.scene.plane, &unit), WATER_OK);
    water_mirror_camera(&camera, &unit, &camera);
    assert_true(fabs(camera.world_to_view[0] - random.scene.eye.world_to_view[0]) > 1e-9);
    water_mirror_camera(&camera, &unit, &camera);
    for (int i = 0; i < 16; ++i)
    {
      ASSERT_CLOSE(camera.world_to_view[i], random.scene.eye.world_to_view[i], 1e-12);
      assert_true(camera.view_to_clip[i] == random.scene.eye.view_to_clip[i]);
    }
  }
}

// The clip keeps what is on the eye's side of the water, the margin included: in mirrored view
// space its value is the height itself, in window space it has the same sign, for every point in
// front.
TEST(clip_has_the_sign_of_the_height)
{
  dice from = dice_seeded(11);
  int kept = 0;
  int cut = 0;
  for (int round = 0; round < 6000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    random.scene.settings.clip_margin = round % 2 ? 0.25 : 0.0;
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double view[4];
    double clip[4];
    point_near(&from, &random, 2.0, point);
    const double height = height_of(&random, point) + random.scene.settings.clip_margin;
    apply(plan.mirrored.world_to_view, point, 1.0, view);
    const double* plane = plan.clip_plane_view;
    ASSERT_CLOSE(dot(plane, view) + plane[3], height, 1e-12);
    plane = plan.clip_plane_world;
    ASSERT_CLOSE(dot(plane, point) + plane[3], height, 1e-11);
    project(&plan.mirrored, point, 1.0, clip);
    plane = plan.clip_plane_clip;
    ASSERT_CLOSE(dot(plane, clip) + plane[3] * clip[3], height, 1e-11);
    if (clip[3] <= 0.01 || fabs(height) < 1e-9)
    {
      continue;
    }
    const double window[3] = { (0.5 + 0.5 * clip[0] / clip[3]) * plan.texture_px[0],
      (0.5 + 0.5 * clip[1] / clip[3]) * plan.texture_px[1], 0.5 + 0.5 * clip[2] / clip[3] };
    plane = plan.clip_plane_window;
    const double value = dot(plane, window) + plane[3];
    assert_true((value > 0.0) == (height > 0.0));
    kept += height > 0.0;
    cut += height < 0.0;
    double largest = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      largest = fmax(largest, fabs(plane[i]));
    }
    ASSERT_CLOSE(largest, 1.0, 1e-15);
  }
  assert_int_in_range(kept, 2000, 6000);
  assert_int_in_range(cut, 1500, 6000);
}

// With floats, the clip's place is right to a part in 1e5 of the distance however close the near
// plane is: here 0.001, and the far plane 1000. From all four of the clip's coordinates it is not.
TEST(clip_in_floats_is_where_it_should_be)
{
  dice from = dice_seeded(17);
  double most = 0.0;
  double most_of_four = 0.0;
  for (int round = 0; round < 6000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    if (random.scene.eye.parallel)
    {
      continue;
    }
    random.scene.eye.view_to_clip[10] = -1000.001 / 999.999;
    random.scene.eye.view_to_clip[11] = -2.0 / 999.999;
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double clip[4];
    double position[4];
    double constant;
    point_near(&from, &random, 2.0, point);
    project(&plan.mirrored, point, 1.0, clip);
    if (clip[3] <= 0.01)
    {
      continue;
    }
    water_mirror_clip_position(
      plan.mirrored.view_to_clip, plan.clip_plane_clip, position, &constant);
    float height = (float)constant;
    float of_four = 0.0f;
    double size = fabs(constant);
    for (int i = 0; i < 4; ++i)
    {
      height += (float)position[i] * (float)clip[i];
      of_four += (float)plan.clip_plane_clip[i] * (float)clip[i];
      size += fabs(position[i] * clip[i]);
    }
    const double right = height_of(&random, point) + 5e-7 * clip[3]; // what is in the plane is kept
    ASSERT_CLOSE(height, right, 1e-6 * size);
    most = fmax(most, fabs(height - right) / (fabs(constant) + fabs(clip[3])));
    most_of_four = fmax(most_of_four, fabs(of_four - right) / (fabs(constant) + fabs(clip[3])));
  }
  const double whole[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.1, -0.2, 0, 0, -1, 0.5 };
  const double plane[4] = { 0.1, 0.2, 0.3, 0.4 };
  double same[4];
  double constant;
  water_mirror_clip_position(whole, plane, same, &constant); // of no perspective from the eye
  assert_memory_equal(same, plane, sizeof plane);
  assert_true(constant == 0.0);
  printf("error of the clip over the distance: %.2g, from its four coordinates %.2g\n", most,
    most_of_four);
  assert_true(most < 1e-5);
  assert_true(most_of_four > 10.0 * most);
}

// Where nothing reaches out the mirrored projection keeps its depths to the last bit.
TEST(far_plane_stays_without_a_reason)
{
  dice from = dice_seeded(91);
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  for (int round = 0; round < 100; ++round)
  {
    water_scene scene = pool(5.0);
    frustum_matrix(box, 1.0, pow(10.0, dice_roll(&from, 2.0, 6.0)), scene.eye.view_to_clip);
    const water_plan plan = plan_of(&scene, NULL);
    assert_true(plan.depth_scale == 1.0);
    for (int i = 8; i < 12; ++i)
    {
      assert_true(plan.mirrored.view_to_clip[i] == scene.eye.view_to_clip[i]);
    }
  }
}

// A prop that ends before the far plane, but closer to it than rounding may be, moves it, too: at
// 999.5 of 1000 it is 1 - 1e-6 deep. One at 998.5, 3e-6 off, does not.
TEST(far_plane_keeps_its_margin)
{
  water_scene scene = pool(5.0); // its mirrored eye is 10 under the water, and looks up
  const double tops[2] = { 989.5, 988.5 };
  for (int i = 0; i < 2; ++i)
  {
    const water_prop prop = { { -0.1, 0.1, -0.1, 0.1, 1.0, tops[i] }, WATER_PROP_VISIBLE };
    water_cull_reason reason;
    scene.props = &prop;
    scene.prop_count = 1;
    const water_plan plan = plan_of(&scene, &reason);
    const double top[3] = { 0.0, 0.0, tops[i] };
    double clip[4];
    project(&plan.mirrored, top, 1.0, clip);
    assert_true(1.0 - clip[2] / clip[3] > 1.9e-6);
    assert_int_equal(plan.depth_scale < 1.0, i == 0);
  }
}

// However far a drawn prop reaches, no point of it that is in front of the mirrored camera lies
// beyond its far plane; picture and near plane stay, and so does everything if nothing reaches out.
TEST(far_plane_moves_behind_the_drawn_props)
{
  dice from = dice_seeded(26);
  int moved = 0;
  for (int round = 0; round < 3000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    const water_plan before = plan_of(&random.scene, NULL);
    const double far_out = round % 4 ? 90.0 : 1e6;
    water_prop props[3];
    water_cull_reason reasons[3];
    for (int number = 0; number < 3; ++number)
    {
      double center[3];
      point_near(&from, &random, far_out, center);
      props[number].flags = WATER_PROP_VISIBLE;
      for (int i = 0; i < 3; ++i)
      {
        props[number].bounds[2 * i] = center[i] - 1.0;
        props[number].bounds[2 * i + 1] = center[i] + dice_roll(&from, 0.0, far_out);
      }
    }
    random.scene.props = props;
    random.scene.prop_count = 3;
    const water_plan plan = plan_of(&random.scene, reasons);
    int reaches_out = 0;
    for (int number = 0; number < 24; ++number)
    {
      const double* bounds = props[number / 8].bounds;
      const double corner[3] = { bounds[number & 1], bounds[2 + ((number >> 1) & 1)],
        bounds[4 + ((number >> 2) & 1)] };
      double old_clip[4];
      double clip[4];
      project(&before.mirrored, corner, 1.0, old_clip);
      project(&plan.mirrored, corner, 1.0, clip);
      assert_true(clip[0] == old_clip[0] && clip[1] == old_clip[1] && clip[3] == old_clip[3]);
      if (fabs(old_clip[2] + old_clip[3]) > 1e-6)
      {
        assert_true((clip[2] > -clip[3]) == (old_clip[2] > -old_clip[3]));
      }
      if (reasons[number / 8] == WATER_CULL_NONE && clip[3] > 0.0)
      {
        assert_true(clip[2] <= clip[3]);
        reaches_out |= old_clip[2] > old_clip[3];
      }
    }
    const size_t size = sizeof before.mirrored.view_to_clip;
    assert_int_equal(
      memcmp(plan.mirrored.view_to_clip, before.mirrored.view_to_clip, size) != 0, reaches_out);
    moved += reaches_out;
    // a skybox has no far end
    for (int number = 0; number < 3; ++number)
    {
      props[number].flags |= WATER_PROP_NO_BOUNDS;
    }
    const water_plan endless = plan_of(&random.scene, reasons);
    assert_memory_equal(endless.mirrored.view_to_clip, before.mirrored.view_to_clip, size);
  }
  assert_int_in_range(moved, 500, 2900);
}

// Widening scales the rows of x and y, each by its own factor, whatever is in them, and no others.
TEST(widening_scales_two_rows)
{
  water_camera camera;
  memset(&camera, 0, sizeof camera);
  for (int i = 0; i < 16; ++i)
  {
    camera.view_to_clip[i] = 1.0;
  }
  const double scale[2] = { 0.5, 0.25 };
  water_mirror_widen(scale, &camera);
  for (int i = 0; i < 16; ++i)
  {
    ASSERT_CLOSE(camera.view_to_clip[i], i < 4 ? 0.5 : (i < 8 ? 0.25 : 1.0), 0.0);
  }
}

// A projection without inverse has no clip plane: refused, output untouched.
TEST(clip_needs_a_projection_with_an_inverse)
{
  const double ahead[4] = { 0.0, 0.0, -1.0, -5.0 }; // view z <= -5
  const double zeros[16] = { 0.0 };
  double clip[4] = { 7.0 };
  assert_int_equal(water_mirror_clip_clip(zeros, ahead, clip), WATER_BAD_CAMERA);
  assert_true(clip[0] == 7.0);
}

TESTS(mirrored_camera_of_a_known_eye, pose_and_matrix_are_the_same_camera,
  point_on_water_keeps_its_pixel, point_above_water_is_seen_as_its_mirror_image,
  mirrored_twice_is_the_eye, clip_has_the_sign_of_the_height, clip_in_floats_is_where_it_should_be,
  far_plane_stays_without_a_reason, far_plane_keeps_its_margin,
  far_plane_moves_behind_the_drawn_props, widening_scales_two_rows,
  clip_needs_a_projection_with_an_inverse)
