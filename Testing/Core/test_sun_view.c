// SPDX-License-Identifier: BSD-3-Clause
// test_sun_view.c: the sun view: what lies on one ray to the sun lies in one place of it, the
// highest thing first, and that place is the water's own pixel.
#include "test_scene.h"

#include "water_math.h"
#include "water_sun_view.h"

static const uint32_t visible = WATER_PROP_VISIBLE;

// Sets a sun over a scene's water, not lower than 6 degrees.
static void roll_sun(dice* from, random_scene* random, double to_sun[3])
{
  do
  {
    dice_dir(from, to_sun);
  } while (dot(to_sun, random->normal) < 0.1);
  memcpy(random->scene.sun_dir, to_sun, sizeof random->scene.sun_dir);
  random->scene.has_sun = random->scene.is_from_sun = true;
}

// Is the eye on the side that the normal points to? The sun view is for no other.
static bool is_above(const random_scene* random)
{
  return dot(random->normal, random->scene.plane.normal) > 0.0;
}

// Every point of a ray from the water to the sun is seen at the pixel where the eye sees the water,
// at a depth that tells its height.
TEST(a_ray_to_the_sun_is_one_pixel)
{
  dice from = dice_seeded(71);
  const double center[3] = { 0.0, 0.0, 0.0 };
  water_prop prop = { { 0.0 }, visible, 0.0f };
  int count = 0;
  for (int number = 0; number < 120; ++number)
  {
    random_scene random = scene_rolled(&from, number, center);
    double to_sun[3];
    roll_sun(&from, &random, to_sun);
    for (int i = 0; i < 6; ++i)
    {
      prop.bounds[i] = random.target[i / 2] + (i % 2 ? 1.0 : -1.0);
    }
    random.scene.props = &prop;
    random.scene.prop_count = 1;
    if (!is_above(&random))
    {
      continue;
    }
    water_cull_reason reason;
    const water_plan plan = plan_of(&random.scene, &reason);
    assert_int_equal(plan.decision, WATER_REFLECT);
    for (int i = 0; i < 20; ++i)
    {
      double water[3];
      point_near(&from, &random, 2.0, water);
      const double up = height_of(&random, water);
      const double length = dice_roll(&from, 0.0, 3.0);
      double point[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        water[axis] -= up * random.normal[axis];
        point[axis] = water[axis] + length * to_sun[axis];
      }
      double seen[4];
      double shown[4];
      project(&random.scene.eye, water, 1.0, seen);
      project(&plan.mirrored, point, 1.0, shown);
      ASSERT_CLOSE(shown[0] / shown[3], seen[0] / seen[3], 1e-9);
      ASSERT_CLOSE(shown[1] / shown[3], seen[1] / seen[3], 1e-9);
      const double depth = 1.0 -
        plan.sun_view_depth * (length * dot(to_sun, random.normal) + plan.sun_view_bottom) /
          seen[3];
      ASSERT_CLOSE(0.5 + 0.5 * shown[2] / shown[3], depth, 1e-9);
      ++count;
    }
  }
  assert_true(count > 500);
}

// A lake with a sun in the south, 45 degrees high.
static water_scene lake_in_the_sun(const water_prop* props, size_t count)
{
  water_scene scene = lake();
  scene.sun_dir[1] = -1.0;
  scene.sun_dir[2] = 1.0;
  scene.has_sun = scene.is_from_sun = scene.is_flat = true;
  scene.props = props;
  scene.prop_count = count;
  return scene;
}

// What casts its shadow on water that the eye sees is drawn, wherever it is itself.
TEST(casters_are_drawn_and_nothing_else)
{
  const water_prop props[] = {
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f },
    { { -1.0, 1.0, -41.0, -40.0, 37.0, 45.0 }, visible, 0.0f }, // behind the eye, high up
    { { -1.0, 1.0, -41.0, -40.0, 1.0, 2.0 }, visible, 0.0f },   // its shadow is behind, too
    { { -1.0, 1.0, -1.0, 1.0, -2.0, -1.0 }, visible, 0.0f },    // under the water
    { { 90.0, 91.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f },     // beside the picture
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, 0, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible | WATER_PROP_IS_WATER, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible | WATER_PROP_NO_BOUNDS, 0.0f }, // a skybox
    { { -99.0, 99.0, -99.0, 99.0, -99.0, 99.0 }, visible, 0.0f },                 // a dome
  };
  const bool expected[] = { true, true, false, false, false, false, false, false, false };
  enum
  {
    COUNT = sizeof props / sizeof props[0]
  };
  const water_scene scene = lake_in_the_sun(props, COUNT);
  water_cull_reason reasons[COUNT];
  const water_plan plan = plan_of(&scene, reasons);
  assert_int_equal(plan.decision, WATER_REFLECT);
  for (int i = 0; i < COUNT; ++i)
  {
    assert_int_equal(reasons[i] == WATER_CULL_NONE, expected[i]);
  }
}

// Without a sun over the water, or anything over it, there is no view.
TEST(without_sun_or_casters_there_is_no_view)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  const water_prop bed = { { -1.0, 1.0, -1.0, 1.0, -2.0, -1.0 }, visible, 0.0f };
  water_cull_reason reason;
  water_scene scene = lake_in_the_sun(&post, 1);
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_REFLECT);
  scene.has_sun = false;
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene.has_sun = true;
  scene.sun_dir[2] = -1.0;
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene = lake_in_the_sun(&bed, 1);
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
}

// The camera is a rigid view, and things in the picture are before its near plane.
TEST(nothing_that_casts_a_shadow_is_cut)
{
  const water_prop tower = { { -1.0, 1.0, -1.0, 1.0, 0.0, 500.0 }, visible, 0.0f };
  const water_scene scene = lake_in_the_sun(&tower, 1);
  water_cull_reason reason;
  const water_plan plan = plan_of(&scene, &reason);
  ASSERT_CLOSE(determinant3(plan.mirrored.world_to_view), 1.0, 1e-12);
  for (int i = 0; i <= 8; ++i)
  {
    const double height = 0.01 + i; // of what casts a shadow into the picture
    const double point[3] = { 0.0, -height, height };
    double clip[4];
    project(&plan.mirrored, point, 1.0, clip);
    assert_true(is_inside(clip));
  }
}

// The sun's view of water under an eye that looks along the axes of the world: it has an up
// direction of its own wherever the sun is, and looks down along its rays.
TEST(the_camera_looks_along_the_rays)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  const double suns[][3] = { { 0.0, 0.0, 1.0 }, { 1.0, 0.1, 0.2 }, { 0.1, 1.0, 0.2 },
    { 0.1, 0.2, 1.0 }, { 0.2, 0.1, 1.0 }, { 1.0, 0.2, 0.1 } };
  for (size_t i = 0; i < sizeof suns / sizeof suns[0]; ++i)
  {
    water_scene scene = lake_in_the_sun(&post, 1);
    memcpy(scene.sun_dir, suns[i], sizeof suns[i]);
    scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_PROPS;
    water_cull_reason reason;
    const water_plan plan = plan_of(&scene, &reason);
    assert_int_equal(plan.decision, WATER_REFLECT);
    const double* view = plan.mirrored.world_to_view;
    double to_sun[3] = { suns[i][0], suns[i][1], suns[i][2] };
    normalise(to_sun);
    for (int row = 0; row < 3; ++row)
    {
      ASSERT_CLOSE(dot(view + 4 * row, view + 4 * row), 1.0, 1e-12);
      ASSERT_CLOSE(dot(view + 4 * row, to_sun), row == 2 ? 1.0 : 0.0, 1e-12);
    }
    double clip[4]; // of a point 100 m away from the sun: in front of the camera
    const double point[3] = { -100.0 * to_sun[0], -100.0 * to_sun[1], -100.0 * to_sun[2] };
    double seen[4];
    apply(view, point, 1.0, seen);
    assert_true(seen[2] < 0.0);
    project(&plan.mirrored, point, 1.0, clip);
    assert_true(isfinite(clip[3]));
  }
}

// The view is the eye's picture, and not flipped as a mirrored one: it is drawn where the water is.
TEST(drawn_where_the_water_is)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  const double left[4] = { -0.9, -0.5, -0.4, 0.2 };
  water_scene scene = lake_in_the_sun(&post, 1);
  scene.is_flat = true;
  scene.settings.skips |= WATER_MAY_SKIP_PIXELS;
  water_cull_reason reason = WATER_CULL_NONE;
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  assert_int_equal(water_sun_view_plan(&scene, &scene.plane, 0.0, left, &plan, &reason), WATER_OK);
  double drawn[4];
  water_rect_to_ndc(plan.texture_rect_px, plan.texture_px, drawn);
  for (int i = 0; i < 2; ++i)
  {
    assert_true(drawn[i] <= left[i] && drawn[i] > left[i] - 0.03);
    assert_true(drawn[2 + i] >= left[2 + i] && drawn[2 + i] < left[2 + i] + 0.03);
  }
}

// What cannot be planned is said.
TEST(faults_are_named)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  const double box[4] = { -1.0, -1.0, 1.0, 1.0 };
  const water_scene right = lake_in_the_sun(&post, 1);
  water_cull_reason reason = WATER_CULL_NONE;
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  water_scene scene = right;
  scene.max_texture_px = 799; // less than the picture is wide
  assert_int_equal(
    water_sun_view_plan(&scene, &scene.plane, 0.0, box, &plan, &reason), WATER_TEXTURE_TOO_LARGE);
  scene = right;
  memset(scene.eye.world_to_view, 0, sizeof scene.eye.world_to_view);
  assert_int_equal(
    water_sun_view_plan(&scene, &scene.plane, 0.0, box, &plan, &reason), WATER_BAD_CAMERA);
}

// The camera is a hundred times as far away as what casts shadows is high, the eye included. What
// lies on one ray to the sun is one pixel of the eye; the highest caster at the nearest water is in
// the middle between that water's depth and the near plane. A sun lower than 0.06 degrees counts as
// that high.
TEST(the_view_of_known_casters)
{
  const water_scene scene = lake();
  const double eye[3] = { 0.0, -10.0, 5.0 };
  double view_to_world[16] = { 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      view_to_world[4 * i + j] = scene.eye.world_to_view[4 * j + i];
    }
    view_to_world[4 * i + 3] = eye[i];
  }
  view_to_world[15] = 1.0;
  const double suns[][3] = { { 0.0, 0.6, 0.8 }, { -0.48, 0.36, 0.8 }, { 1.0, 0.0, 1e-4 },
    { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  for (size_t i = 0; i < sizeof suns / sizeof suns[0]; ++i)
  {
    const water_plane plane = { { 0.0, 0.0, 1.0 }, i & 1 ? -8.0 : 0.0 }; // over the eye, or under
    const double level = -plane.offset;
    water_camera camera;
    double depth = 0.0;
    double to_sun[3] = { suns[i][0], suns[i][1], suns[i][2] };
    normalise(to_sun);
    water_sun_view_camera(
      &scene.eye, view_to_world, &plane, to_sun, 0.5, 7.0, 3.0, &camera, &depth);
    ASSERT_CLOSE(depth * 7.5, 0.5 * 3.0, 1e-12);
    double at[4];
    apply(camera.world_to_view, eye, 1.0, at);
    ASSERT_CLOSE(at[0], 0.0, 1e-9);
    ASSERT_CLOSE(at[1], 0.0, 1e-9);
    ASSERT_CLOSE(at[2], -100.0 * (fabs(5.0 - level) + 7.5), 1e-9);
    ASSERT_CLOSE(determinant3(camera.world_to_view), 1.0, 1e-12);
    const double sine = fmax(to_sun[2], 1e-3);
    const double water[3] = { 1.0, 2.0, level };
    double seen[4];
    project(&scene.eye, water, 1.0, seen);
    const double height = 4.0;
    const double point[3] = { water[0] + height / sine * to_sun[0],
      water[1] + height / sine * to_sun[1], level + height };
    const double laid[3] = { water[0], water[1], point[2] - height / sine * to_sun[2] };
    double shown[4];
    project(&scene.eye, laid, 1.0, seen);
    project(&camera, point, 1.0, shown);
    ASSERT_CLOSE(shown[0] / shown[3], seen[0] / seen[3], 1e-6);
    ASSERT_CLOSE(shown[1] / shown[3], seen[1] / seen[3], 1e-6);
    ASSERT_CLOSE(shown[2] / shown[3], 1.0 - 2.0 * depth * (height + 0.5) / seen[3], 1e-6);
  }
}

// The nearest water counts that the picture shows: the end of a lake, the picture's lower end, or a
// corner of it.
TEST(the_nearest_water_is_that_in_the_picture)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  water_cull_reason reason;
  water_scene scene = lake_in_the_sun(&post, 1);
  const double starts[2] = { 0.0, -10.0 }; // a ray 45 degrees under the view meets y = -8.33
  const double nearest[2] = { sqrt(125.0), sqrt(125.0) / 3.0 };
  for (int i = 0; i < 2; ++i)
  {
    scene.surface_bounds[2] = starts[i];
    const water_plan plan = plan_of(&scene, &reason);
    assert_int_equal(plan.decision, WATER_REFLECT);
    ASSERT_CLOSE(plan.sun_view_depth * 2.0, 0.5 * nearest[i], 1e-9);
  }
  dice from = dice_seeded(73);
  const double center[3] = { 0.0, 0.0, 0.0 };
  water_prop prop = { { 0.0 }, visible, 0.0f };
  int count = 0;
  for (int number = 0; number < 150; ++number)
  {
    random_scene random = scene_rolled(&from, number, center);
    double to_sun[3];
    roll_sun(&from, &random, to_sun);
    double top = 0.0;
    for (int i = 0; i < 6; ++i)
    {
      prop.bounds[i] = random.target[i / 2] + (i % 2 ? 1.0 : -1.0);
      random.scene.surface_bounds[i] += i % 2 ? 300.0 : -300.0; // over all of the picture
    }
    if (!is_above(&random) || random.is_parallel)
    {
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      top += fabs(random.normal[i]); // of a cube about the target
    }
    random.scene.props = &prop;
    random.scene.prop_count = 1;
    random.scene.wave_height_max = 0.25;
    const water_plan plan = plan_of(&random.scene, &reason);
    ASSERT_CLOSE(plan.sun_view_bottom, 0.25, 1e-12);
    const double* to_clip = random.scene.eye.view_to_clip;
    const double* rows = random.scene.eye.world_to_view;
    double per_w = 0.0; // of rays of length 1 along the view, in the picture's corners
    for (int i = 0; i < 4; ++i)
    {
      const double ray[3] = { ((i & 1 ? 1.0 : -1.0) + to_clip[2]) / to_clip[0],
        ((i & 2 ? 1.0 : -1.0) + to_clip[6]) / to_clip[5], -1.0 };
      double down = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        down -= random.normal[k] * (ray[0] * rows[k] + ray[1] * rows[4 + k] + ray[2] * rows[8 + k]);
      }
      per_w = fmax(per_w, down / height_of(&random, random.eye));
    }
    ASSERT_CLOSE(plan.sun_view_depth * (0.25 + top) * per_w, 0.5, 1e-6);
    ++count;
  }
  assert_true(count > 30);
}

// Of calm water only its part of the picture is drawn; waves may look elsewhere.
TEST(the_rectangle_is_that_of_calm_water)
{
  const water_prop post = { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f };
  water_scene scene = lake_in_the_sun(&post, 1);
  const double small[6] = { -1.0, 1.0, -3.0, 3.0, 0.0, 0.0 };
  memcpy(scene.surface_bounds, small, sizeof small);
  water_cull_reason reason;
  for (int i = 0; i < 3; ++i)
  {
    scene.is_flat = i != 1;
    scene.settings.skips = i == 2 ? 0 : WATER_MAY_SKIP_ALL;
    const water_plan plan = plan_of(&scene, &reason);
    assert_int_equal(plan.texture_px[0], 800);
    assert_int_equal(plan.texture_px[1], 600);
    assert_int_equal(plan.texture_rect_px[2] == 800 && plan.texture_rect_px[3] == 600, i > 0);
    assert_true(plan.headlight_dir[0] == 0.0 && plan.headlight_dir[1] == 0.0);
    assert_true(plan.headlight_dir[2] == -1.0); // ahead; no light is seen in depths
    if (i == 0) // from x = -1 to 1 at y = -3: w = (7 * 10 + 25) / 125^0.5
    {
      const double half = 400.0 / (95.0 / sqrt(125.0)) / (4.0 / 3.0);
      assert_int_in_range(plan.texture_rect_px[2], (int)(2.0 * half), (int)(2.0 * half) + 8);
    }
  }
}

// A caster whose shadow falls out of the picture makes no view; with the skip of props off, it
// does.
TEST(shadows_out_of_the_picture_need_no_view)
{
  const water_prop behind = { { -1.0, 1.0, -41.0, -40.0, 1.0, 2.0 }, visible, 0.0f };
  water_scene scene = lake_in_the_sun(&behind, 1);
  water_cull_reason reason;
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_PROPS;
  assert_int_equal(plan_of(&scene, &reason).decision, WATER_REFLECT);
}

TESTS(the_view_of_known_casters, the_nearest_water_is_that_in_the_picture,
  the_rectangle_is_that_of_calm_water, shadows_out_of_the_picture_need_no_view,
  a_ray_to_the_sun_is_one_pixel, the_camera_looks_along_the_rays, drawn_where_the_water_is,
  faults_are_named, casters_are_drawn_and_nothing_else, without_sun_or_casters_there_is_no_view,
  nothing_that_casts_a_shadow_is_cut)
