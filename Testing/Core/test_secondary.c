// SPDX-License-Identifier: BSD-3-Clause
// test_secondary.c: other water in a mirrored view: which rays meet it, where it finds the sky or
// the scene, how rough it is, and which planes are other ones.
#include "test_scene.h"

#include "water_math.h"
#include "water_plan.h"
#include "water_plane.h"
#include "water_secondary.h"

enum
{
  SCENES = 300,
  POINTS = 20,
  PHASES = 200000
};

static void assert_near(double value, double expected, double tolerance)
{
  assert_true(fabs(value - expected) <= tolerance);
}

// Another water of a scene: any plane that is not edge-on in the mirrored view.
typedef struct other_water
{
  water_scene scene;
  double normal[3]; // towards the mirrored eye
  double x_dir[3];
  double y_dir[3];
  double eye[3];      // mirrored
  double view_dir[3]; // mirrored
} other_water;

static other_water other_rolled(dice* from, const random_scene* first)
{
  other_water other;
  memset(&other, 0, sizeof other);
  other.scene = first->scene;
  other.scene.props = NULL;
  other.scene.prop_count = 0;
  mirror_image(first, first->eye, other.eye);
  double ahead[3];
  double mirrored_ahead[3];
  for (int i = 0; i < 3; ++i)
  {
    ahead[i] = first->eye[i] + first->view_dir[i];
  }
  mirror_image(first, ahead, mirrored_ahead);
  for (int i = 0; i < 3; ++i)
  {
    other.view_dir[i] = mirrored_ahead[i] - other.eye[i];
  }
  double origin[3];
  double normal[3];
  double height = 0.0;
  do
  {
    point_near(from, first, 4.0, origin);
    dice_dir(from, normal);
    const double arm[3] = { other.eye[0] - origin[0], other.eye[1] - origin[1],
      other.eye[2] - origin[2] };
    height = first->is_parallel ? -dot(normal, other.view_dir) : dot(normal, arm);
  } while (fabs(height) < 0.1);
  memcpy(other.scene.plane.normal, normal, sizeof normal);
  memcpy(other.scene.plane_origin, origin, sizeof origin);
  other.scene.plane.offset = -dot(normal, origin);
  water_plane_axes(normal, other.x_dir, other.y_dir);
  for (int i = 0; i < 3; ++i)
  {
    other.normal[i] = height > 0.0 ? normal[i] : -normal[i];
  }
  return other;
}

static void along_axes(const other_water* other, const double dir[3], double local[3])
{
  local[0] = dot(other->x_dir, dir);
  local[1] = dot(other->y_dir, dir);
  local[2] = dot(other->normal, dir);
}

// Where the mirrored view shows a point of the other water, the shader's ray comes from the
// mirrored eye; and a direction's sky is where the picture's own eye sees that direction.
TEST(rays_are_of_the_mirrored_eye_and_the_sky_is_of_the_pictures)
{
  dice from = dice_seeded(20);
  const double center[3] = { 3.0, -2.0, 1.0 };
  for (int number = 0; number < SCENES; ++number)
  {
    const random_scene first = scene_rolled(&from, number, center);
    const water_plan mirrored = plan_of(&first.scene, NULL);
    const other_water other = other_rolled(&from, &first);
    water_plan plan;
    assert_string_equal(
      water_status_text(water_secondary_plan(&other.scene, &mirrored, &plan)), "no error");
    assert_int_equal(plan.decision, WATER_NO_REFLECT_ENVIRONMENT);
    assert_true(plan.has_view);
    const bool is_above = dot(other.normal, other.scene.plane.normal) > 0.0;
    assert_int_equal(plan.side, is_above ? WATER_ABOVE : WATER_BELOW);
    for (int i = 0; i < POINTS; ++i)
    {
      double point[3];
      for (int j = 0; j < 3; ++j)
      {
        point[j] = other.scene.plane_origin[j];
      }
      const double x = dice_roll(&from, -3.0, 3.0);
      const double y = dice_roll(&from, -3.0, 3.0);
      double expected[3];
      for (int j = 0; j < 3; ++j)
      {
        point[j] += x * other.x_dir[j] + y * other.y_dir[j];
        expected[j] = first.is_parallel ? other.view_dir[j] : point[j] - other.eye[j];
      }
      normalise(expected);
      double clip[4];
      project(&mirrored.mirrored, point, 1.0, clip);
      if (!is_inside(clip))
      {
        continue;
      }
      const double ndc[3] = { clip[0] / clip[3], clip[1] / clip[3], 1.0 };
      double ray[3];
      double local[3];
      for (int j = 0; j < 3; ++j)
      {
        ray[j] = dot(plan.ndc_to_ray + 3 * j, ndc);
      }
      normalise(ray);
      along_axes(&other, expected, local);
      for (int j = 0; j < 3; ++j)
      {
        assert_near(ray[j], local[j], 1e-9);
      }

      double dir[3];
      double seen[4];
      dice_dir(&from, dir);
      along_axes(&other, dir, local);
      project(&first.scene.eye, dir, 0.0, seen);
      for (int j = 0; j < 4; ++j)
      {
        assert_near(dot(plan.dir_to_eye + 3 * j, local), seen[j], 1e-9);
      }
    }
  }
}

// The mirror image of a point at the other water, and the first one's, its eye's too.
static void image_at(const other_water* other, const double point[3], double image[3])
{
  const double arm[3] = { point[0] - other->scene.plane_origin[0],
    point[1] - other->scene.plane_origin[1], point[2] - other->scene.plane_origin[2] };
  const double twice = 2.0 * dot(other->normal, arm);
  for (int i = 0; i < 3; ++i)
  {
    image[i] = point[i] - twice * other->normal[i];
  }
}

// A secondary view shows a point where the mirrored view would show its image at the other water,
// turned left to right; headlights and the sky are where the picture's own eye has them.
TEST(secondary_view_is_mirrored_at_both_planes)
{
  dice from = dice_seeded(23);
  const double center[3] = { 3.0, -2.0, 1.0 };
  int seen_count = 0;
  for (int number = 0; number < SCENES; ++number)
  {
    const random_scene first = scene_rolled(&from, number, center);
    const water_plan mirrored = plan_of(&first.scene, NULL);
    other_water other = other_rolled(&from, &first);
    const bool is_rough = number % 2 == 1;
    other.scene.settings.guard_band = 1.2;
    water_secondary_view(&mirrored, &first.scene.eye, is_rough, &other.scene);
    other.scene.viewport_rect_px = NULL;
    water_plan plan;
    assert_int_equal(water_plan_make(&other.scene, &plan, NULL), WATER_OK);
    if (plan.decision != WATER_REFLECT)
    {
      assert_int_equal(plan.decision, WATER_NO_REFLECT_OUT_OF_VIEW);
      continue;
    }
    assert_near(determinant3(plan.mirrored.world_to_view), 1.0, 1e-12);
    assert_true(is_rough ? plan.reflection_scale[0] < 0.9 : plan.reflection_scale[0] == 1.0);
    for (int i = 0; i < POINTS; ++i)
    {
      double point[3];
      double image[3];
      double truth[4];
      double shown[4];
      point_near(&from, &first, 6.0, point);
      image_at(&other, point, image);
      project(&mirrored.mirrored, image, 1.0, truth);
      project(&plan.mirrored, point, 1.0, shown);
      if (!is_inside(truth))
      {
        continue;
      }
      ++seen_count;
      assert_near(shown[0] / shown[3], -plan.reflection_scale[0] * truth[0] / truth[3], 1e-9);
      assert_near(shown[1] / shown[3], plan.reflection_scale[1] * truth[1] / truth[3], 1e-9);

      double dir[3]; // that the secondary view shows at the point
      double away[4];
      double sky[4];
      for (int j = 0; j < 3; ++j)
      {
        dir[j] = first.is_parallel ? -plan.mirrored.world_to_view[8 + j]
                                   : point[j] - plan.mirrored_position[j];
      }
      project(&plan.mirrored, dir, 0.0, away);
      project(&first.scene.eye, dir, 0.0, sky);
      const double w = first.is_parallel ? 1.0 : away[3];
      const double place[3] = { first.is_parallel ? 0.3 : away[0] / w,
        first.is_parallel ? -0.2 : away[1] / w, 1.0 };
      assert_near(w * dot(plan.reflection_ndc_to_eye, place), sky[0], 1e-8);
      assert_near(w * dot(plan.reflection_ndc_to_eye + 3, place), sky[1], 1e-8);
      assert_near(w * dot(plan.reflection_ndc_to_eye + 6, place), sky[3], 1e-8);
    }
    double dir[4];
    double place[4];
    double local[3];
    double to_eye[4];
    apply(plan.mirrored.world_to_view, first.view_dir, 0.0, dir);
    apply(plan.mirrored.world_to_view, first.eye, 1.0, place);
    along_axes(&other, first.view_dir, local);
    project(&first.scene.eye, first.view_dir, 0.0, to_eye);
    for (int i = 0; i < 3; ++i)
    {
      assert_near(plan.headlight_dir[i], dir[i], 1e-12);
      assert_near(plan.headlight_position[i], place[i], 1e-9);
    }
    for (int i = 0; i < 4; ++i)
    {
      assert_near(dot(plan.dir_to_eye + 3 * i, local), to_eye[i], 1e-9);
    }
  }
  assert_in_range(seen_count, 300, SCENES * POINTS);
}

// What the mirrored view does not show of the other water, its secondary view is not drawn for.
TEST(secondary_view_is_of_what_the_mirrored_view_shows)
{
  water_scene scene = lake();
  const water_plan mirrored = plan_of(&scene, NULL);
  const water_camera eye = scene.eye;
  scene = lake();
  scene.plane.offset = -8.0; // over the lake and its eye: its underside is seen
  const double shelf[6] = { -2.0, 2.0, -2.0, 2.0, 8.0, 8.0 };
  memcpy(scene.surface_bounds, shelf, sizeof shelf);
  scene.has_waves = scene.is_hidden = scene.has_scene_depth = true;
  scene.wave_height_max = scene.surface_height = 0.5;
  scene.settings.texture_scale = 0.5;
  scene.settings.quality = WATER_QUALITY_TIME_BUDGET;
  water_secondary_view(&mirrored, &eye, false, &scene);
  assert_false(scene.has_waves || scene.is_hidden || scene.has_scene_depth);
  assert_true(scene.wave_height_max == 0.0 && scene.surface_height == 0.0);
  assert_int_equal(scene.settings.quality, WATER_QUALITY_FIXED);
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  assert_int_equal(plan.decision, WATER_REFLECT);
  assert_int_equal(plan.side, WATER_BELOW);
  assert_memory_equal(plan.texture_px, mirrored.texture_px, sizeof plan.texture_px);

  const int all[4] = { plan.texture_rect_px[0], plan.texture_rect_px[1], plan.texture_rect_px[2],
    plan.texture_rect_px[3] };
  const int half[4] = { 0, 0, 400, 600 }; // in the texture, turned, the other half
  scene.viewport_rect_px = half;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  assert_int_equal(plan.decision, WATER_REFLECT);
  assert_int_equal(plan.texture_rect_px[0], 398);
  assert_int_equal(plan.texture_rect_px[0] + plan.texture_rect_px[2], all[0] + all[2]);
  assert_int_equal(plan.texture_rect_px[1], all[1]);
  const int none[4] = { 0, 0, 800, 2 };
  scene.viewport_rect_px = none;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  assert_int_equal(plan.decision, WATER_NO_REFLECT_OUT_OF_VIEW);
  scene.settings.skips &= ~(unsigned)WATER_MAY_SKIP_UNSEEN;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  assert_int_equal(plan.decision, WATER_REFLECT);

  water_camera broken = eye;
  broken.world_to_view[0] = 2.0;
  scene.picture_eye = &broken;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_BAD_CAMERA);
}

// What is wrong with the other water is said, and there is no view.
TEST(faults_leave_no_view)
{
  water_scene scene = lake();
  const water_plan mirrored = plan_of(&scene, NULL);
  water_plan plan;
  scene.plane.normal[2] = 0.0;
  assert_int_equal(water_secondary_plan(&scene, &mirrored, &plan), WATER_BAD_PLANE);
  assert_false(plan.has_view);
  scene = lake();
  scene.plane.offset = 5.0; // at the height of the mirrored eye: seen from over it
  assert_int_equal(water_secondary_plan(&scene, &mirrored, &plan), WATER_OK);
  assert_true(plan.has_view);
}

// The variances are the means of the products of slopes over all phases.
TEST(slopes_are_those_of_the_waves)
{
  const water_wave waves[3] = { { 0.1, 3.0, 0.3, 0.0, 0.0 }, { 0.05, 1.3, -1.1, 0.0, 0.0 },
    { 0.02, 0.4, 2.0, 0.0, 0.0 } };
  const double sea[2] = { 0.02, 0.005 }; // along and across 30 degrees
  const double given[2] = { 0.01, 0.002 };
  double sum[3] = { 0.0, 0.0, 0.0 };
  dice from = dice_seeded(21);
  for (int i = 0; i < PHASES; ++i)
  {
    double slope[2] = { 0.0, 0.0 };
    for (int j = 0; j < 3; ++j)
    {
      const double k = 2.0 * acos(-1.0) / waves[j].wavelength;
      const double steep = waves[j].amplitude * k * cos(dice_roll(&from, 0.0, 2.0 * acos(-1.0)));
      slope[0] += steep * cos(waves[j].direction_rad);
      slope[1] += steep * sin(waves[j].direction_rad);
    }
    sum[0] += slope[0] * slope[0] / PHASES;
    sum[1] += slope[1] * slope[1] / PHASES;
    sum[2] += slope[0] * slope[1] / PHASES;
  }
  double covariance[3];
  water_secondary_slopes(
    waves, 3, sea, acos(0.0) / 3.0, given, acos(0.0), covariance); // given: along y first
  assert_near(covariance[0], sum[0] + 0.75 * sea[0] + 0.25 * sea[1] + given[1], 1e-3);
  assert_near(covariance[1], sum[1] + 0.25 * sea[0] + 0.75 * sea[1] + given[0], 1e-3);
  assert_near(covariance[2], sum[2] + sqrt(0.1875) * (sea[0] - sea[1]), 1e-3);
  assert_true(sum[0] > 0.01 && sum[1] > 0.01); // the tolerance is fine
}

// A plane given through other points of it, or turned round, is the same; one beside it is not.
TEST(the_same_plane_is_known)
{
  dice from = dice_seeded(22);
  for (int number = 0; number < SCENES; ++number)
  {
    const double reach = pow(10.0, dice_roll(&from, -2.0, 7.0));
    water_plane planes[2];
    double normal[3];
    double point[3];
    dice_dir(&from, normal);
    for (int i = 0; i < 3; ++i)
    {
      point[i] = dice_roll(&from, -0.5, 0.5) * reach;
    }
    double x_dir[3];
    double y_dir[3];
    water_plane_axes(normal, x_dir, y_dir);
    for (int i = 0; i < 2; ++i)
    {
      const double x = dice_roll(&from, -0.2, 0.2) * reach;
      const double y = dice_roll(&from, -0.2, 0.2) * reach;
      const double scale = dice_roll(&from, 0.1, 10.0) * (i ? -1.0 : 1.0);
      double origin[3];
      water_plane given;
      for (int j = 0; j < 3; ++j)
      {
        origin[j] = point[j] + x * x_dir[j] + y * y_dir[j];
        given.normal[j] = scale * normal[j];
      }
      given.offset = -dot(given.normal, origin);
      assert_int_equal(water_plane_normalise(&given, planes + i), WATER_OK);
    }
    assert_true(water_plane_is_same(planes, planes + 1, reach));
    planes[1].offset += 1e-10 * reach;
    assert_false(water_plane_is_same(planes, planes + 1, reach));
    planes[1].offset -= 1e-10 * reach;
    planes[1].normal[number % 3] += 1e-9;
    assert_false(water_plane_is_same(planes, planes + 1, reach));
  }
}

TESTS(rays_are_of_the_mirrored_eye_and_the_sky_is_of_the_pictures,
  secondary_view_is_mirrored_at_both_planes, secondary_view_is_of_what_the_mirrored_view_shows,
  faults_leave_no_view, slopes_are_those_of_the_waves, the_same_plane_is_known)
