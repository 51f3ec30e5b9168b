// SPDX-License-Identifier: BSD-3-Clause
// test_shading.c: what the shaders are given: texture matrix, plane and normal in clip
// space, view rays in the plane's axes, headlight, where the sky is found, and how the masks round.
#include "test_scene.h"

#include "water_mirror.h"
#include "water_plan.h"
#include "water_plane.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };

// A point on the water looks up its own pixel, x flipped; the middle of the picture, here where the
// lake's eye looks, is the middle of the reflection texture.
TEST(texture_of_a_point_on_water_is_its_own_pixel)
{
  const water_scene known = lake();
  const water_plan plan_known = plan_of(&known, NULL);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  double place[4];
  double world_to_texture[16];
  water_mirror_texture_matrix(&plan_known.mirrored, world_to_texture);
  apply(world_to_texture, origin, 1.0, place);
  ASSERT_CLOSE(place[0] / place[3], 0.5, 1e-14);
  ASSERT_CLOSE(place[1] / place[3], 0.5, 1e-14);

  dice from = dice_seeded(13);
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double image[3];
    double clip[4];
    point_near(&from, &random, 2.0, point);
    mirror_image(&random, point, image);
    for (int i = 0; i < 3; ++i)
    {
      point[i] = 0.5 * (point[i] + image[i]);
    }
    project(&random.scene.eye, point, 1.0, clip);
    water_mirror_texture_matrix(&plan.mirrored, world_to_texture);
    apply(world_to_texture, point, 1.0, place);
    if (is_inside(clip))
    {
      ASSERT_CLOSE(place[0] / place[3], 0.5 - 0.5 * clip[0] / clip[3], 1e-11);
      ASSERT_CLOSE(place[1] / place[3], 0.5 + 0.5 * clip[1] / clip[3], 1e-11);
      ASSERT_CLOSE(place[2] / place[3], 0.5 + 0.5 * clip[2] / clip[3], 1e-11);
    }
  }
}

// In view space and in clip space of the eye, the plane's value of a point is its height towards
// the eye; subtracting twice the height times the normal gives the point's mirror image.
TEST(plane_and_normal_of_the_eye_mirror_a_point)
{
  dice from = dice_seeded(15);
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double point[3];
    double image[3];
    double view[4];
    double clip[4];
    double truth[4];
    point_near(&from, &random, 5.0, point);
    mirror_image(&random, point, image);
    const double height = height_of(&random, point);
    apply(random.scene.eye.world_to_view, point, 1.0, view);
    ASSERT_CLOSE(dot(plan.plane_view, view) + plan.plane_view[3], height, 1e-12);
    project(&random.scene.eye, point, 1.0, clip);
    project(&random.scene.eye, image, 1.0, truth);
    const double in_clip = dot(plan.plane_clip, clip) + plan.plane_clip[3] * clip[3];
    ASSERT_CLOSE(in_clip, height, 1e-11);
    for (int i = 0; i < 4; ++i)
    {
      ASSERT_CLOSE(clip[i] - 2.0 * height * plan.normal_clip[i], truth[i], 1e-11);
    }
  }
}

// The ray of a pixel, in the plane's own axes: straight down on a level sheet it is (0, 0, -1);
// from any eye it leads to the point the pixel shows, falling towards the water.
TEST(ray_in_the_planes_axes)
{
  dice from = dice_seeded(16);
  int below = 0;
  for (int round = 0; round < 3000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    const double length = sqrt(dot(random.scene.plane.normal, random.scene.plane.normal));
    double own[3]; // the normal as the user turned it: the axes do not turn with the eye's side
    double x_dir[3];
    double y_dir[3];
    double clip[4];
    double ray[3];
    double truth[3];
    double sight[3];
    for (int i = 0; i < 3; ++i)
    {
      own[i] = random.scene.plane.normal[i] / length;
    }
    water_plane_axes(own, x_dir, y_dir); // its own truth is in test_plane.c
    project(&random.scene.eye, random.target, 1.0, clip);
    for (int i = 0; i < 3; ++i)
    {
      sight[i] = random.is_parallel ? random.view_dir[i] : random.target[i] - random.eye[i];
      ray[i] = (plan.ndc_to_ray[3 * i] * clip[0] + plan.ndc_to_ray[3 * i + 1] * clip[1]) / clip[3] +
        plan.ndc_to_ray[3 * i + 2];
    }
    truth[0] = dot(sight, x_dir);
    truth[1] = dot(sight, y_dir);
    truth[2] = dot(sight, random.normal);
    normalise(ray);
    normalise(truth);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(ray[i], truth[i], 1e-12);
    }
    assert_true(ray[2] < 0.0);
    assert_int_equal(plan.side, dot(own, random.normal) > 0.0 ? WATER_ABOVE : WATER_BELOW);
    below += plan.side == WATER_BELOW;
  }
  assert_int_in_range(below, 1000, 2000);
}

// The eye's view direction, turned by the mirrored view; an eye that looks straight down has its
// light come from behind the mirrored camera's back: it looks up, the light goes down, along +z.
TEST(headlight_stays_with_the_eye)
{
  water_scene down = lake();
  const double eye[3] = { 0.0, 0.0, 5.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  look_at(eye, target, up, down.eye.world_to_view);
  const water_plan plan_down = plan_of(&down, NULL);
  ASSERT_CLOSE(plan_down.headlight_dir[0], 0.0, 1e-15);
  ASSERT_CLOSE(plan_down.headlight_dir[1], 0.0, 1e-15);
  ASSERT_CLOSE(plan_down.headlight_dir[2], 1.0, 1e-15);
  ASSERT_CLOSE(plan_down.headlight_position[0], 0.0, 1e-14);
  ASSERT_CLOSE(plan_down.headlight_position[1], 0.0, 1e-14);
  ASSERT_CLOSE(plan_down.headlight_position[2], -10.0, 1e-14);

  dice from = dice_seeded(17);
  for (int round = 0; round < 600; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    double truth[4];
    apply(plan.mirrored.world_to_view, random.view_dir, 0.0, truth);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(plan.headlight_dir[i], truth[i], 1e-12);
    }
  }
}

// A direction from the mirrored camera has its vanishing point in the reflection texture at (x, y);
// the eye's clip coordinates of the same direction are what the matrix makes of (x, y, 1), up to a
// positive factor.
TEST(sky_of_the_map_is_found_on_the_eyes_screen)
{
  dice from = dice_seeded(18);
  int inside = 0;
  int behind = 0;
  for (int round = 0; round < 6000; ++round)
  {
    const random_scene random = scene_rolled(&from, round, nearby);
    const water_plan plan = plan_of(&random.scene, NULL);
    const double twice = 2.0 * dot(random.view_dir, random.normal);
    double dir[3]; // of the mirrored view, and for perspective anything around it
    double place[4];
    double truth[4];
    double found[3];
    dice_dir(&from, dir);
    for (int i = 0; i < 3; ++i)
    {
      dir[i] =
        (random.is_parallel ? 0.0 : 0.8 * dir[i]) + random.view_dir[i] - twice * random.normal[i];
    }
    project(&plan.mirrored, dir, 0.0, place);
    project(&random.scene.eye, dir, 0.0, truth);
    if (!random.is_parallel && fmax(fabs(place[0]), fabs(place[1])) > place[3])
    {
      continue;
    }
    const double x = random.is_parallel ? 0.7 : place[0] / place[3];
    const double y = random.is_parallel ? -0.4 : place[1] / place[3];
    for (int i = 0; i < 3; ++i)
    {
      const double* row = plan.reflection_ndc_to_eye + 3 * i;
      found[i] = row[0] * x + row[1] * y + row[2];
    }
    const double factor = random.is_parallel ? 1.0 : place[3]; // the matrix takes directions of w 1
    ASSERT_CLOSE(found[0] * factor, truth[0], 1e-11);
    ASSERT_CLOSE(found[1] * factor, truth[1], 1e-11);
    ASSERT_CLOSE(found[2] * factor, truth[3], 1e-11);
    ++inside;
    behind += truth[3] < 0.0;
  }
  assert_int_in_range(inside, 2500, 6000);
  assert_int_in_range(behind, 300, 6000);
}

// What the cells and the shader are told of a point: its w, and how far its height may be off.
TEST(view_tells_w_and_rounding)
{
  const water_scene scene = lake();
  const water_plan plan = plan_of(&scene, NULL);
  const double point[3] = { 1.0, 2.0, 3.0 };
  double clip[4];
  project(&scene.eye, point, 1.0, clip);
  double w = 0.0;
  double size = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    w += plan.clip_w[i] * clip[i];
    size += fabs(plan.plane_clip[i]);
  }
  ASSERT_CLOSE(w, 1.0, 1e-12);
  ASSERT_CLOSE(plan.height_rounding, 16.0 * (double)FLT_EPSILON * size, 1e-15 * size);
}

TESTS(texture_of_a_point_on_water_is_its_own_pixel, plane_and_normal_of_the_eye_mirror_a_point,
  ray_in_the_planes_axes, headlight_stays_with_the_eye, sky_of_the_map_is_found_on_the_eyes_screen,
  view_tells_w_and_rounding)
