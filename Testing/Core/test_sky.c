// SPDX-License-Identifier: BSD-3-Clause
// test_sky.c: what the plan hands the shaders of the sky, the sun's light and the pattern of foam.
#include "test_scene.h"

#include "water_lookup.h"
#include "water_secondary.h"
#include "water_sky.h"

static const water_sky evening = { { 0.9, 0.5, 0.2 }, { 0.1, 0.2, 0.4 }, 0.75,
  WATER_SCREEN_VERTICAL };

static void assert_evening(const water_sky* sky)
{
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(sky->bottom[i], evening.bottom[i], 0.0);
    ASSERT_CLOSE(sky->top[i], evening.top[i], 0.0);
  }
  ASSERT_CLOSE(sky->alpha, evening.alpha, 0.0);
  assert_int_equal(sky->screen, WATER_SCREEN_VERTICAL);
}

// The sky of the scene is that of the plan, of a reflection or an environment, and of other water
// in a mirrored view.
TEST(sky_of_the_scene_reaches_every_plan)
{
  water_scene scene = lake();
  scene.sky = evening;
  const water_plan plan = plan_of(&scene, NULL);
  assert_evening(&plan.sky);
  water_scene other = scene;
  other.plane.offset = -1.0;
  other.surface_bounds[4] = other.surface_bounds[5] = 1.0;
  water_plan secondary;
  assert_int_equal(water_secondary_plan(&other, &plan, &secondary), WATER_OK);
  assert_evening(&secondary.sky);
  scene.has_environment = true;
  const water_plan without = plan_of(&scene, NULL);
  assert_evening(&without.sky);
}

// The sky is known where it ends what is reflected: not behind a skybox, or whatever else has no
// bounds and is drawn.
TEST(sky_is_known_unless_something_endless_is_drawn)
{
  water_prop props[2] = { { { -1.0, 1.0, 2.0, 4.0, 0.0, 3.0 }, WATER_PROP_VISIBLE },
    { { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 }, WATER_PROP_VISIBLE | WATER_PROP_NO_BOUNDS } };
  water_cull_reason reasons[2];
  water_scene scene = lake();
  assert_true(plan_of(&scene, NULL).is_sky_known);
  scene.props = props;
  scene.prop_count = 1;
  assert_true(plan_of(&scene, reasons).is_sky_known);
  scene.prop_count = 2;
  assert_false(plan_of(&scene, reasons).is_sky_known);
  props[1].flags |= WATER_PROP_NOT_REFLECTED;
  assert_true(plan_of(&scene, reasons).is_sky_known);
}

// A skybox shows the sky that the scene describes: it has no top, and hides none of it.
TEST(sky_is_known_behind_a_skybox_that_shows_it)
{
  water_prop props[2] = { { { -1.0, 1.0, 2.0, 4.0, 0.0, 3.0 }, WATER_PROP_VISIBLE },
    { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 },
      WATER_PROP_VISIBLE | WATER_PROP_NO_BOUNDS | WATER_PROP_IS_SKY } };
  water_cull_reason reasons[2];
  water_scene scene = lake();
  scene.props = props;
  scene.prop_count = 2;
  const water_plan plan = plan_of(&scene, reasons);
  assert_true(plan.is_sky_known);
  assert_int_equal(reasons[1], WATER_CULL_NONE);
  ASSERT_CLOSE(plan.reflection_top, 3.0, 1e-12);
  props[1].flags &= ~(uint32_t)WATER_PROP_IS_SKY;
  assert_false(plan_of(&scene, reasons).is_sky_known);
}

// A drawn mesh about the eye that is as high as a dome may be the sky: it is not known then what
// the background hides. Land about the eye is lower, and what is beside it, or not drawn, is no
// dome.
TEST(sky_is_not_known_in_a_dome)
{
  water_prop dome = { { -100.0, 100.0, -100.0, 100.0, -100.0, 100.0 }, WATER_PROP_VISIBLE };
  water_cull_reason reason;
  water_scene scene = lake();
  scene.props = &dome;
  scene.prop_count = 1;
  assert_true(plan_of(&scene, &reason).is_enclosed);
  assert_false(plan_of(&scene, &reason).is_sky_known);
  dome.bounds[5] = 50.0; // half as high as wide to a side
  assert_true(plan_of(&scene, &reason).is_enclosed);
  dome.bounds[5] = 49.0;
  assert_false(plan_of(&scene, &reason).is_enclosed);
  assert_true(plan_of(&scene, &reason).is_sky_known);
  dome.bounds[5] = 100.0;
  for (int i = 0; i < 6; ++i)
  {
    water_prop beside = dome; // the eye is at (0, -10, 5)
    beside.bounds[i] = (i < 2 ? 0.0 : (i < 4 ? -10.0 : 5.0)) + (i % 2 ? -1.0 : 1.0);
    scene.props = &beside;
    assert_false(plan_of(&scene, &reason).is_enclosed);
  }
  scene.props = &dome;
  dome.flags |= WATER_PROP_NOT_REFLECTED;
  assert_false(plan_of(&scene, &reason).is_enclosed);
  dome.flags = WATER_PROP_VISIBLE | WATER_PROP_NO_BOUNDS;
  assert_false(plan_of(&scene, &reason).is_enclosed);
}

// The contrast from which pixels have more rays falls with their number.
TEST(contrast_of_rays)
{
  ASSERT_CLOSE(water_lookup_contrast(4), 0.0625, 0.0);
  ASSERT_CLOSE(water_lookup_contrast(8), 0.03125, 0.0);
  ASSERT_CLOSE(water_lookup_contrast(1), 0.25, 0.0);
  ASSERT_CLOSE(water_lookup_contrast(0), 0.25, 0.0);
}

// A white card that faces the sun shows the light's colour times its intensity; without a sun, or
// with one of no direction, it shows nothing.
TEST(light_of_the_sun_is_its_color_times_its_intensity)
{
  const double diffuse[3] = { 1.0, 0.5, 0.25 };
  const double sun[3] = { 0.0, 3.0, 4.0 };
  water_scene scene = lake();
  memcpy(scene.sun_diffuse, diffuse, sizeof diffuse);
  memcpy(scene.sun_dir, sun, sizeof sun);
  scene.sun_intensity = 3.0;
  scene.has_sun = true;
  const water_plan plan = plan_of(&scene, NULL);
  water_scene dark[2] = { scene, scene };
  dark[0].has_sun = false;
  memset(dark[1].sun_dir, 0, sizeof dark[1].sun_dir);
  const water_plan none[2] = { plan_of(&dark[0], NULL), plan_of(&dark[1], NULL) };
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(plan.sun_color[i], 3.0 * diffuse[i], 1e-15);
    ASSERT_CLOSE(none[0].sun_color[i], 0.0, 0.0);
    ASSERT_CLOSE(none[1].sun_color[i], 0.0, 0.0);
  }
}

// The place in the pattern is that under the eye, but for whole patterns of 2048: far from the
// origin it stays small, and a float holds it.
TEST(pattern_repeats_under_the_eye)
{
  const double places[6] = { 0.0, 12.5, 2048.0, 3000.0, -2100.0, 2048001.25 };
  const double expected[6] = { 0.0, 12.5, 0.0, 952.0, -52.0, 1.25 };
  for (int i = 0; i < 6; ++i)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      water_scene scene = pool(5.0); // the eye is over (0, 0)
      scene.plane_origin[axis] = -places[i];
      const water_plan plan = plan_of(&scene, NULL);
      ASSERT_CLOSE(plan.origin_xy[axis], places[i], 1e-9);
      double pattern[2];
      for (double unit = 0.5; unit < 4.0; unit *= 2.0)
      {
        const double origin[2] = { plan.origin_xy[0] / unit, plan.origin_xy[1] / unit };
        water_lookup_pattern(origin, unit, pattern);
        ASSERT_CLOSE(pattern[axis], expected[i], 1e-9);
        ASSERT_CLOSE(pattern[1 - axis], 0.0, 1e-9);
      }
    }
  }
}

// The deepest of what is shown: an invisible prop, the water, a skybox and an empty one do not
// count, nor does what is over the plane. From below the plane the scene is on the other side.
TEST(bed_is_as_deep_as_the_deepest_thing_that_is_shown)
{
  const uint32_t shown = WATER_PROP_VISIBLE;
  const water_prop props[6] = {
    { { -1.0, 1.0, -1.0, 1.0, -3.0, 1.0 }, shown, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, -5.0, 1.0 }, 0, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, -6.0, 1.0 }, shown | WATER_PROP_IS_WATER, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, -7.0, 1.0 }, shown | WATER_PROP_NO_BOUNDS, 0.0f },
    { { 1.0, -1.0, 1.0, -1.0, -8.0, -9.0 }, shown, 0.0f },
    { { -1.0, 1.0, -1.0, 1.0, 2.0, 4.0 }, shown, 0.0f },
  };
  const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
  const water_plane turned = { { 0.0, 0.0, -1.0 }, 0.0 };
  ASSERT_CLOSE(water_lookup_bottom(&level, props, 6), 3.0, 1e-12);
  ASSERT_CLOSE(water_lookup_bottom(&turned, props, 6), 4.0, 1e-12);
  // of a plane across all axes, the corner (1, 5, -4): (2 - 5 - 8) / 3 + 0.5
  const water_plane slanted = { { 2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0 }, 0.5 };
  const water_prop aside = { { 1.0, 2.0, 3.0, 5.0, -4.0, -1.0 }, shown, 0.0f };
  ASSERT_CLOSE(water_lookup_bottom(&slanted, &aside, 1), 19.0 / 6.0, 1e-12);
  const water_prop wall = { { 1.0, 1.0, -1.0, 1.0, -2.5, 1.0 }, shown, 0.0f };
  ASSERT_CLOSE(water_lookup_bottom(&level, &wall, 1), 2.5, 1e-12); // without a thickness
  ASSERT_CLOSE(water_lookup_bottom(&level, props + 5, 1), 0.0, 0.0);
  ASSERT_CLOSE(water_lookup_bottom(&level, props, 0), 0.0, 0.0);
}

// Water with a picture of its own looks that up, other water the scene's sky; only a sky of one
// colour, without a floor, is one.
TEST(sky_of_water_is_its_own_first)
{
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  assert_true(water_sky_of(&plan, true) == &plan.environment_map);
  assert_true(water_sky_of(&plan, false) == &plan.sky_map);
  plan.sky_map.kind = WATER_SKY_SCREEN;
  plan.sky.screen = WATER_SCREEN_COLOR;
  assert_true(water_sky_is_one_color(&plan, false));
  assert_false(water_sky_is_one_color(&plan, true));
  plan.sky_floor.is_there = true;
  assert_false(water_sky_is_one_color(&plan, false));
  plan.sky_floor.is_there = false;
  plan.sky.screen = WATER_SCREEN_VERTICAL;
  assert_false(water_sky_is_one_color(&plan, false));
  plan.sky.screen = WATER_SCREEN_COLOR;
  plan.sky_map.kind = WATER_SKY_MAP;
  assert_false(water_sky_is_one_color(&plan, false));
}

// Floors need a normal, a direction and a scale that are usable.
TEST(floors_need_usable_numbers)
{
  const double plane[4] = { 0.0, 0.0, 2.0, 4.0 };
  const double right[3] = { 1.0, 0.0, 0.0 };
  const double scale[2] = { 3.0, 3.0 };
  water_sky_floor floor;
  water_sky_floor_make(plane, right, scale, &floor);
  assert_true(floor.is_there);
  const double bad_planes[3][4] = { { 0.0, 0.0, 0.0, 1.0 }, { 0.0, INFINITY, 0.0, 1.0 },
    { 0.0, 0.0, 1.0, NAN } };
  for (int i = 0; i < 3; ++i)
  {
    water_sky_floor_make(bad_planes[i], right, scale, &floor);
    assert_false(floor.is_there);
  }
  const double bad_right[3] = { NAN, 0.0, 0.0 };
  water_sky_floor_make(plane, bad_right, scale, &floor);
  assert_false(floor.is_there);
  const double bad_scales[3][2] = { { 0.0, 1.0 }, { 1.0, 0.0 }, { 1.0, INFINITY } };
  for (int i = 0; i < 3; ++i)
  {
    water_sky_floor_make(plane, right, bad_scales[i], &floor);
    assert_false(floor.is_there);
  }
}

// Calm water, which has no rays, gets samples where waves would have more than a few rays.
TEST(calm_water_has_samples_for_many_rays)
{
  assert_int_equal(water_lookup_calm_samples(1), 0);
  assert_int_equal(water_lookup_calm_samples(4), 0);
  assert_int_equal(water_lookup_calm_samples(5), 4);
}

// A direction needs a finite length; a picture of the surroundings whose up and right are parallel,
// or have none, has the world's axes.
TEST(directions_need_a_length)
{
  water_axes axes;
  memset(&axes, 0, sizeof axes);
  axes.x_dir[0] = axes.y_dir[1] = axes.normal[2] = 1.0;
  const double bad[3][3] = { { 0.0, 0.0, 0.0 }, { INFINITY, 0.0, 0.0 }, { 0.0, NAN, 0.0 } };
  const double right[3] = { 2.0, 0.0, 0.0 };
  double local[3] = { 7.0, 7.0, 7.0 };
  for (int i = 0; i < 3; ++i)
  {
    double rows[9];
    assert_false(water_lookup_local(&axes, bad[i], local));
    ASSERT_CLOSE(local[0], 7.0, 0.0);
    water_lookup_environment(&axes, bad[i], right, rows);
    for (int k = 0; k < 9; ++k)
    {
      ASSERT_CLOSE(rows[k], k % 4 == 0 ? 1.0 : 0.0, 0.0);
    }
  }
  assert_true(water_lookup_local(&axes, right, local));
  ASSERT_CLOSE(local[0], 1.0, 0.0);
}

// An eye on a face of a box is not in it, on whichever of the six.
TEST(an_eye_on_a_face_is_not_in_a_dome)
{
  water_prop dome = { { -20.0, 20.0, -20.0, 20.0, -10.0, 20.0 }, WATER_PROP_VISIBLE };
  water_cull_reason reason;
  water_scene scene = pool(5.0); // from (0, 0, 10)
  scene.props = &dome;
  scene.prop_count = 1;
  assert_true(plan_of(&scene, &reason).is_enclosed);
  for (int i = 0; i < 5; ++i)
  {
    water_prop beside = dome;
    beside.bounds[i] = i == 4 ? 10.0 : 0.0;
    scene.props = &beside;
    assert_false(plan_of(&scene, &reason).is_enclosed);
  }
  const water_prop low = { { -10.0, 10.0, -10.0, 10.0, -5.0, 10.0 }, WATER_PROP_VISIBLE };
  scene.props = &low;
  assert_false(plan_of(&scene, &reason).is_enclosed);
}

// A dome is at least half as high as it is wide along its widest axis, whichever that is.
TEST(domes_are_measured_along_their_widest_axis)
{
  water_cull_reason reason;
  water_scene scene = pool(5.0); // from (0, 0, 10)
  scene.prop_count = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    water_prop wide = { { -15.0, 15.0, -15.0, 15.0, -15.0, 15.0 }, WATER_PROP_VISIBLE };
    scene.props = &wide;
    assert_true(plan_of(&scene, &reason).is_enclosed);
    wide.bounds[2 * axis] = -100.0;
    assert_false(plan_of(&scene, &reason).is_enclosed);
  }
}

TESTS(an_eye_on_a_face_is_not_in_a_dome, domes_are_measured_along_their_widest_axis,
  directions_need_a_length, sky_of_water_is_its_own_first, floors_need_usable_numbers,
  calm_water_has_samples_for_many_rays, sky_of_the_scene_reaches_every_plan,
  sky_is_known_unless_something_endless_is_drawn, sky_is_known_behind_a_skybox_that_shows_it,
  sky_is_not_known_in_a_dome, contrast_of_rays, light_of_the_sun_is_its_color_times_its_intensity,
  pattern_repeats_under_the_eye, bed_is_as_deep_as_the_deepest_thing_that_is_shown)
