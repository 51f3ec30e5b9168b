// SPDX-License-Identifier: BSD-3-Clause
// test_sky_view.c: the sky view: where a dome is seen in it, and what is drawn in it. The truth of
// a ray in a round dome is the point where it meets the sphere.
#include "test_scene.h"

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

TESTS(
  rays_in_a_round_dome, what_may_be_the_sky_is_drawn, the_rest_ends_before_the_dome, straight_up)
