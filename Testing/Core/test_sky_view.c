// SPDX-License-Identifier: BSD-3-Clause
// test_sky_view.c: the sky view: where a dome is seen in it, and what is drawn in it. The truth of
// a ray in a round dome is the point where it meets the sphere.
#include "test_scene.h"

#include "water_mirror.h"
#include "water_sky_view.h"

static const uint32_t visible = WATER_PROP_VISIBLE;
static const double radius = 100.0; // of the dome, about the origin

static water_prop dome_of(double size)
{
  const water_prop dome = { { -size, size, -size, size, -size, size }, visible, 0.0f };
  return dome;
}

static water_scene lake_in_a_dome(const water_prop* props, size_t count)
{
  water_scene scene = lake();
  scene.is_of_sky = scene.has_waves = true;
  scene.slope_rms = 0.05;
  scene.props = props;
  scene.prop_count = count;
  return scene;
}

// How far a ray goes to the sphere.
static double length_in_dome(const double from[3], const double dir[3])
{
  const double ahead = dot(from, dir);
  return sqrt(ahead * ahead - dot(from, from) + radius * radius) - ahead;
}

static void along(const double from[3], const double dir[3], double length, double to[3])
{
  for (int i = 0; i < 3; ++i)
  {
    to[i] = from[i] + length * dir[i];
  }
}

// Distance of the sphere in a direction from the view's place, as its picture has it: through the
// depth, which is a float.
static double seen_distance(const water_plan* plan, const double at[3], const double way[3])
{
  double dir[3] = { way[0], way[1], way[2] };
  normalise(dir);
  double point[3];
  along(at, dir, length_in_dome(at, dir), point);
  double clip[4];
  project(&plan->mirrored, point, 1.0, clip);
  assert_true(is_inside(clip));
  const float depth = (float)(0.5 + 0.5 * clip[2] / clip[3]);
  const double per_w = plan->sky_view_near[0] * (double)depth + plan->sky_view_near[1];
  return 1.0 / (per_w * dot(plan->sky_view_dirs + 6, dir));
}

// A ray from anywhere on the water meets the dome where the spheres of the shader say, within 1 %
// of the radius; and that place is in the view.
static void check_rays(const water_scene* scene, const double eye[3], dice* from)
{
  water_cull_reason reason;
  const water_plan plan = plan_of(scene, &reason);
  assert_int_equal(plan.decision, WATER_REFLECT);
  const double at[3] = { eye[0] + plan.sky_view_at[0], eye[1] + plan.sky_view_at[1],
    plan.sky_view_at[2] };
  for (int count = 0; count < 500; ++count)
  {
    const double water[3] = { dice_roll(from, -30.0, 30.0), dice_roll(from, -10.0, 50.0), 0.0 };
    const double turn = dice_roll(from, -0.8, 0.8);
    double dir[3] = { sin(turn), cos(turn), dice_roll(from, 0.02, 1.5) };
    normalise(dir);
    double met[3];
    along(water, dir, length_in_dome(water, dir), met);
    const double off[3] = { water[0] - at[0], water[1] - at[1], water[2] - at[2] };
    const double ahead = dot(off, dir);
    double way[3] = { dir[0], dir[1], dir[2] };
    for (int sphere = 0; sphere < 3; ++sphere)
    {
      const double far = seen_distance(&plan, at, way);
      along(off, dir, sqrt(ahead * ahead - dot(off, off) + far * far) - ahead, way);
    }
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(at[i] + way[i], met[i], 0.01 * radius);
    }
    double clip[4];
    project(&plan.mirrored, met, 1.0, clip);
    const double to[3] = { met[0] - at[0], met[1] - at[1], met[2] - at[2] };
    ASSERT_CLOSE(dot(plan.sky_view_dirs, to), clip[0], 1e-9 * radius);
    ASSERT_CLOSE(dot(plan.sky_view_dirs + 3, to), clip[1], 1e-9 * radius);
    ASSERT_CLOSE(dot(plan.sky_view_dirs + 6, to), clip[3], 1e-9 * radius);
  }
}

TEST(rays_in_a_round_dome)
{
  dice from = dice_seeded(81);
  const water_prop dome = dome_of(radius);
  water_scene scene = lake_in_a_dome(&dome, 1);
  const double eye[3] = { 0.0, -10.0, 0.0 }; // the point under it
  check_rays(&scene, eye, &from);
  const double box[4] = { -5.0, 5.0, -5.0, 5.0 };
  ortho_matrix(box, 0.1, 1000.0, scene.eye.view_to_clip);
  check_rays(&scene, eye, &from);
}

// Only what may be the sky is drawn; without it, without waves, or from below, there is no view.
TEST(what_may_be_the_sky_is_drawn)
{
  const water_prop props[] = {
    { { -1.0, 1.0, -1.0, 1.0, 1.0, 2.0 }, visible, 0.0f },
    dome_of(radius),
    { { -99.0, 99.0, -99.0, 99.0, -9.0, 9.0 }, visible, 0.0f }, // land
    { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, visible | WATER_PROP_NO_BOUNDS, 0.0f },
    { { -radius, radius, -radius, radius, -radius, radius }, 0, 0.0f },
  };
  const bool expected[] = { false, true, false, false, false };
  enum
  {
    COUNT = sizeof props / sizeof props[0]
  };
  water_scene scene = lake_in_a_dome(props, COUNT);
  water_cull_reason reasons[COUNT];
  assert_int_equal(plan_of(&scene, reasons).decision, WATER_REFLECT);
  for (int i = 0; i < COUNT; ++i)
  {
    assert_int_equal(reasons[i] == WATER_CULL_NONE, expected[i]);
  }
  scene.has_waves = false;
  assert_int_equal(plan_of(&scene, reasons).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene.has_waves = true;
  scene.prop_count = 1;
  assert_int_equal(plan_of(&scene, reasons).decision, WATER_NO_REFLECT_OUT_OF_VIEW);
}

// How far all else reaches: heights and depths of the mirrored view end there, and not at the dome.
TEST(the_rest_ends_before_the_dome)
{
  water_prop props[] = { { { -1.0, 1.0, 8.0, 10.0, 0.0, 3.0 }, visible, 0.0f }, dome_of(radius) };
  water_scene scene = lake_in_a_dome(props, 2);
  scene.is_of_sky = false;
  water_cull_reason reasons[2];
  water_plan plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.rest_top, 3.0, 1e-12);
  double depth = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double* bounds = props[0].bounds;
    const double point[3] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
      bounds[4 + (corner >> 2)] };
    double clip[4];
    project(&plan.mirrored, point, 1.0, clip);
    depth = fmax(depth, 0.5 + 0.5 * clip[2] / clip[3]);
  }
  ASSERT_CLOSE(plan.rest_depth, depth, 1e-12);
  assert_true(depth < 0.9999);
  props[0].flags |= WATER_PROP_NO_BOUNDS;
  plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.rest_depth, 1.0, 0.0);
  assert_true(plan.rest_top > DBL_MAX);
}

// A camera that looks straight up is a rigid view, too.
TEST(straight_up)
{
  const double at[3] = { 1.0, 2.0, 3.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double above[3] = { 1.0, 2.0, 53.0 };
  water_camera camera;
  water_sky_view_camera(at, up, up, radius, &camera);
  ASSERT_CLOSE(determinant3(camera.world_to_view), 1.0, 1e-12);
  double clip[4];
  project(&camera, above, 1.0, clip);
  ASSERT_CLOSE(clip[0] / clip[3], 0.0, 1e-12);
  ASSERT_CLOSE(clip[1] / clip[3], 0.0, 1e-12);
  ASSERT_CLOSE(clip[3], 50.0, 1e-12);
}

static void check_ndc(const water_camera* camera, const double point[3], int axis, double expected)
{
  double clip[4];
  project(camera, point, 1.0, clip);
  ASSERT_CLOSE(clip[axis] / clip[3], expected, 1e-9);
}

// The view is 140 degrees wide (a tangent of 2.75 to each side and up), begins 3 degrees (0.05)
// under the horizon, and shows distances from a thousandth of the farthest on.
TEST(the_view_ends_where_its_rays_do)
{
  const double at[3] = { 3.0, -4.0, 5.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double rises[] = { 0.0, 0.3, 1.0, 1.4, -0.2 }; // of the direction, in radians
  for (size_t i = 0; i < sizeof rises / sizeof *rises; ++i)
  {
    const double turn = 0.5 + 1.3 * (double)i;
    const double ahead[3] = { cos(rises[i]) * sin(turn), cos(rises[i]) * cos(turn), sin(rises[i]) };
    const double right[3] = { cos(turn), -sin(turn), 0.0 };
    double above[3];
    cross(right, ahead, above);
    water_camera camera;
    water_sky_view_camera(at, ahead, up, 250.0, &camera);
    const double bottom = fmin(tan(fmax(rises[i], 0.0)) + 0.05, 2.75);
    for (int end = 0; end < 2; ++end)
    {
      const double length = end ? 250.0 : 0.25;
      double point[3];
      along(at, ahead, length, point);
      check_ndc(&camera, point, 2, end ? 1.0 : -1.0);
      double corner[3];
      along(point, right, length * (end ? 2.75 : -2.75), corner);
      check_ndc(&camera, corner, 0, end ? 1.0 : -1.0);
      along(point, above, length * (end ? 2.75 : -bottom), corner);
      check_ndc(&camera, corner, 1, end ? 1.0 : -1.0);
    }
  }
}

TEST(straight_up_from_any_plane)
{
  const double at[3] = { 1.0, 2.0, 3.0 };
  const double normals[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0.8, 0.0, 0.6 } };
  for (int i = 0; i < 3; ++i)
  {
    water_camera camera;
    water_sky_view_camera(at, normals[i], normals[i], radius, &camera);
    ASSERT_CLOSE(determinant3(camera.world_to_view), 1.0, 1e-12);
    ASSERT_CLOSE(dot(camera.world_to_view + 8, normals[i]), -1.0, 1e-12);
  }
}

// What is not the sky is looked at, wherever it is in the list.
TEST(the_rest_is_all_of_it)
{
  const water_prop props[] = { dome_of(radius),
    { { -1.0, 1.0, 8.0, 10.0, 0.0, 3.0 }, visible, 0.0f },
    { { 4.0, 6.0, 30.0, 55.0, -2.0, 20.0 }, visible, 0.0f }, dome_of(2.0 * radius) };
  water_scene scene = lake_in_a_dome(props, 4);
  scene.is_of_sky = false;
  water_cull_reason reasons[4];
  const water_plan plan = plan_of(&scene, reasons);
  ASSERT_CLOSE(plan.rest_top, 20.0, 1e-12);
  const double farthest[3] = { 6.0, 55.0, 20.0 }; // the mirrored camera looks ahead and up
  double clip[4];
  project(&plan.mirrored, farthest, 1.0, clip);
  ASSERT_CLOSE(plan.rest_depth, 0.5 + 0.5 * clip[2] / clip[3], 1e-12);

  // the last but one of a list in the middle of others has no bounds
  water_prop list[8];
  for (int i = 0; i < 8; ++i)
  {
    list[i] = props[i % 4];
  }
  list[6].flags |= WATER_PROP_NO_BOUNDS;
  scene.props = list + 4;
  ASSERT_CLOSE(plan_of(&scene, reasons).rest_depth, 1.0, 0.0);
}

// NDC of the middle of what a box around flat water covers of the picture.
static void middle_of(const water_scene* scene, double middle[2])
{
  double box[4] = { DBL_MAX, DBL_MAX, -DBL_MAX, -DBL_MAX };
  for (int corner = 0; corner < 4; ++corner)
  {
    const double point[3] = { scene->surface_bounds[corner & 1],
      scene->surface_bounds[2 + (corner >> 1)], 0.0 };
    double clip[4];
    project(&scene->eye, point, 1.0, clip);
    assert_true(clip[3] > 0.0);
    for (int i = 0; i < 2; ++i)
    {
      box[i] = fmin(box[i], clip[i] / clip[3]);
      box[2 + i] = fmax(box[2 + i], clip[i] / clip[3]);
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    middle[i] = 0.5 * (fmax(box[i], -1.0) + fmin(box[2 + i], 1.0));
  }
}

// The view looks along the reflected ray of the water's middle in the picture, from the point under
// the eye, or of parallel rays, from where that ray meets the water. It shows all of the sky, with
// a margin of 1 %, and so much of it under the plane.
static void check_place(const water_scene* scene, const water_prop* dome)
{
  water_cull_reason reason;
  const water_plan plan = plan_of(scene, &reason);
  assert_int_equal(plan.decision, WATER_REFLECT);
  double middle[2];
  middle_of(scene, middle);
  const double* view = scene->eye.world_to_view;
  const double* clip = scene->eye.view_to_clip;
  double ahead[3];
  double at[3] = { 0.0, -10.0, 0.0 };
  double start[3] = { 0.0, -10.0, 5.0 };
  for (int i = 0; i < 3; ++i)
  {
    const double across = middle[0] / clip[0] * view[i] + middle[1] / clip[5] * view[4 + i];
    ahead[i] = -view[8 + i] + (scene->eye.parallel ? 0.0 : across);
    start[i] += across;
  }
  if (scene->eye.parallel)
  {
    along(start, ahead, -start[2] / ahead[2], at);
  }
  ahead[2] = -ahead[2];
  normalise(ahead);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const double away[3] = { dome->bounds[corner & 1] - at[0],
      dome->bounds[2 + (corner >> 1 & 1)] - at[1], dome->bounds[4 + (corner >> 2)] - at[2] };
    farthest = fmax(farthest, sqrt(dot(away, away)));
  }
  double end[3];
  along(at, ahead, 1.01 * farthest, end);
  check_ndc(&plan.mirrored, end, 2, 1.0);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(plan.mirrored_position[i], at[i], 1e-9);
    ASSERT_CLOSE(-plan.mirrored.world_to_view[8 + i], ahead[i], 1e-9);
  }
  ASSERT_CLOSE(plan.clip_plane_world[3], 0.01 * 1.01 * farthest, 1e-9);
}

TEST(the_view_is_about_the_water_in_the_picture)
{
  const water_prop dome = { { -60.0, 140.0, -90.0, 110.0, -80.0, 120.0 }, visible, 0.0f };
  const water_prop other = { { -140.0, 60.0, -110.0, 90.0, -120.0, 80.0 }, visible, 0.0f };
  for (int i = 0; i < 8; ++i)
  {
    const water_prop* own = i & 4 ? &other : &dome;
    water_scene scene = lake_in_a_dome(own, 1);
    const double small[6] = { 2.0, 4.0, -2.0, 5.0, 0.0, 0.0 };
    const double wide[6] = { -3.0, 90.0, -6.0, 40.0, 0.0, 0.0 }; // out of the picture
    memcpy(scene.surface_bounds, i & 1 ? wide : small, sizeof small);
    if (i & 2)
    {
      const double box[4] = { -5.0, 5.0, -5.0, 5.0 };
      ortho_matrix(box, 0.1, 1000.0, scene.eye.view_to_clip);
      scene.eye.parallel = true;
    }
    check_place(&scene, own);
  }
}

// Under waves, the view begins lower by their height.
TEST(the_view_reaches_under_the_troughs)
{
  const water_prop dome = dome_of(radius);
  water_scene scene = lake_in_a_dome(&dome, 1);
  scene.surface_bounds[4] = -2.0;
  scene.wave_height_max = 0.25;
  water_cull_reason reason;
  const water_plan plan = plan_of(&scene, &reason);
  const double* at = plan.mirrored_position;
  const double far = 1.01 * sqrt(radius * radius * 2.0 + pow(radius + fabs(at[1]), 2.0));
  ASSERT_CLOSE(plan.clip_plane_world[3], 0.01 * far + 0.25, 1e-9);
  for (int i = 0; i < 2; ++i) // in its picture, too: on both sides of the clip
  {
    const double point[3] = { 5.0, 80.0, (i ? -0.99 : -1.01) * plan.clip_plane_world[3] };
    double clip[4];
    project(&plan.mirrored, point, 1.0, clip);
    const double window[3] = { (0.5 + 0.5 * clip[0] / clip[3]) * plan.texture_px[0],
      (0.5 + 0.5 * clip[1] / clip[3]) * plan.texture_px[1], 0.5 + 0.5 * clip[2] / clip[3] };
    const double* plane = plan.clip_plane_window;
    assert_true((dot(plane, window) + plane[3] > 0.0) == (i == 1));
  }
}

// The view is a square, as long as the longer side of the picture.
TEST(the_picture_of_the_sky_is_a_square)
{
  const water_prop dome = dome_of(radius);
  water_scene scene = lake_in_a_dome(&dome, 1);
  water_cull_reason reason;
  for (int i = 0; i < 2; ++i)
  {
    scene.viewport_px[i] = 600;
    scene.viewport_px[1 - i] = 800;
    const water_plan plan = plan_of(&scene, &reason);
    const int whole[4] = { 0, 0, 800, 800 };
    assert_memory_equal(plan.texture_px, whole + 2, sizeof plan.texture_px);
    assert_memory_equal(plan.texture_rect_px, whole, sizeof whole);
  }
  scene.max_texture_px = 799;
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, &reason), WATER_TEXTURE_TOO_LARGE);
}

TEST(a_camera_of_no_numbers_is_refused)
{
  const water_prop dome = dome_of(radius);
  water_scene scene = lake_in_a_dome(&dome, 1);
  water_cull_reason reason;
  water_plan plan = plan_of(&scene, &reason);
  const water_plane plane = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double nowhere[3] = { 0.0, 0.0, 0.0 };
  const double box[4] = { -1.0, -1.0, 1.0, 1.0 };
  water_axes axes;
  water_lookup_axes(&plane, WATER_ABOVE, nowhere, &axes);
  scene.eye.world_to_view[0] = (double)NAN;
  assert_int_equal(
    water_sky_view_plan(&scene, &plane, &axes, 0.0, box, &plan, &reason), WATER_BAD_CAMERA);
}

// With a camera of the picture of its own, the light at the camera is there, and so is the ray of
// each place of the view.
TEST(the_picture_may_have_another_camera)
{
  const water_prop dome = dome_of(radius);
  water_scene scene = lake_in_a_dome(&dome, 1);
  water_camera other = scene.eye;
  const double eye[3] = { 3.0, -7.0, 6.0 };
  const double target[3] = { -2.0, 5.0, 1.0 };
  const double up[3] = { 0.1, 0.0, 1.0 };
  look_at(eye, target, up, other.world_to_view);
  dice from = dice_seeded(83);
  for (int i = 0; i < 2; ++i)
  {
    scene.picture_eye = i ? &other : NULL;
    const water_camera* picture = i ? &other : &scene.eye;
    water_cull_reason reason;
    const water_plan plan = plan_of(&scene, &reason);
    const double* rows = picture->world_to_view;
    double expected[4];
    const double ahead[3] = { -rows[8], -rows[9], -rows[10] };
    apply(plan.mirrored.world_to_view, ahead, 0.0, expected);
    const double lake_eye[3] = { 0.0, -10.0, 5.0 };
    double place[4];
    apply(plan.mirrored.world_to_view, i ? eye : lake_eye, 1.0, place);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_CLOSE(plan.headlight_dir[k], expected[k], 1e-12);
      ASSERT_CLOSE(plan.headlight_position[k], place[k], 1e-12);
    }
    for (int count = 0; count < 20; ++count)
    {
      double dir[3];
      dice_dir(&from, dir);
      double own[4]; // of a point infinitely far away
      double seen[4];
      project(&plan.mirrored, dir, 0.0, own);
      project(picture, dir, 0.0, seen);
      const double ndc[3] = { own[0] / own[3], own[1] / own[3], 1.0 };
      const double scale = own[3];
      ASSERT_CLOSE(dot(plan.reflection_ndc_to_eye, ndc) * scale, seen[0], 1e-12);
      ASSERT_CLOSE(dot(plan.reflection_ndc_to_eye + 3, ndc) * scale, seen[1], 1e-12);
      ASSERT_CLOSE(dot(plan.reflection_ndc_to_eye + 6, ndc) * scale, seen[3], 1e-12);
    }
  }
}

TESTS(a_camera_of_no_numbers_is_refused, the_view_ends_where_its_rays_do,
  straight_up_from_any_plane, the_rest_is_all_of_it, the_view_is_about_the_water_in_the_picture,
  the_view_reaches_under_the_troughs, the_picture_of_the_sky_is_a_square,
  the_picture_may_have_another_camera, rays_in_a_round_dome, what_may_be_the_sky_is_drawn,
  the_rest_ends_before_the_dome, straight_up)
