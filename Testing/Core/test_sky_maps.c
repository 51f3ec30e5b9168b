// SPDX-License-Identifier: BSD-3-Clause
// test_sky_maps.c: pictures of the sky and floors: which direction, or point, finds which texel,
// and which files a shader needs for them.
#include "test_scene.h"

#include "water_features.h"
#include "water_plane.h"
#include "water_sky.h"

static const double same[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };

static double row_of(const double row[4], double x, double y, double z)
{
  return row[0] * x + row[1] * y + row[2] * z + row[3];
}

// Without a skybox the sky is the screen's, with the colours as they are.
TEST(no_map_is_the_screen)
{
  water_sky_map map;
  water_sky_map_none(&map);
  assert_int_equal(map.kind, WATER_SKY_SCREEN);
  ASSERT_CLOSE(map.exponent, 1.0, 0.0);
  ASSERT_CLOSE(map.level, 0.0, 0.0);
}

// Of a picture the horizon is at half of its height, and the zenith at its top; of two over each
// other the left eye has the upper one.
TEST(heights_of_pictures)
{
  water_sky_map map;
  water_sky_map_sphere(same, &map);
  assert_int_equal(map.kind, WATER_SKY_MAP);
  ASSERT_CLOSE(map.latitude[1], 0.5, 0.0);
  ASSERT_CLOSE(0.5 * map.latitude[0] + map.latitude[1], 1.0, 0.0);
  water_sky_map_stereo(same, true, &map);
  assert_int_equal(map.kind, WATER_SKY_MAP);
  ASSERT_CLOSE(0.5 * map.latitude[0] + map.latitude[1], 1.0, 0.0);
  ASSERT_CLOSE(-0.5 * map.latitude[0] + map.latitude[1], 0.5, 0.0);
  water_sky_map_stereo(same, false, &map);
  ASSERT_CLOSE(0.5 * map.latitude[0] + map.latitude[1], 0.5, 0.0);
}

// A later VTK's cube is looked up from its inside.
TEST(cubes_are_turned_by_later_versions)
{
  water_sky_map map;
  for (int is_turned = 0; is_turned < 2; ++is_turned)
  {
    water_sky_map_cube(same, is_turned != 0, &map);
    assert_int_equal(map.kind, WATER_SKY_CUBE);
    for (int i = 0; i < 9; ++i)
    {
      ASSERT_CLOSE(map.to_map[i], i == 8 && is_turned ? -1.0 : same[i], 0.0);
    }
  }
}

// On a floor up is its normal, whatever its length, and the third axis is to the right.
TEST(pictures_on_a_floor)
{
  const double plane[4] = { 0.0, 0.0, 4.0, 7.0 };
  const double right[3] = { 2.0, 0.0, 0.0 };
  const double expected[9] = { 0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0 };
  const double none[4] = { 0.0, 0.0, 0.0, 1.0 };
  double rotation[9];
  water_sky_rotation_on_floor(plane, right, rotation);
  for (int i = 0; i < 9; ++i)
  {
    ASSERT_CLOSE(rotation[i], expected[i], 1e-15);
  }
  water_sky_rotation_on_floor(none, right, rotation);
  ASSERT_CLOSE(rotation[4], 0.0, 0.0);
}

// The floor z = -2 with its texture repeated every 4 along x and every 8 along y.
TEST(floors_have_places)
{
  const double plane[4] = { 0.0, 0.0, 3.0, 6.0 };
  const double right[3] = { 1.0, 0.0, 0.0 };
  const double scale[2] = { 4.0, 8.0 };
  water_sky_floor floor;
  water_sky_floor_make(plane, right, scale, &floor);
  assert_true(floor.is_there);
  ASSERT_CLOSE(row_of(floor.height, 5.0, 6.0, 1.0), 3.0, 1e-15);
  ASSERT_CLOSE(row_of(floor.u, 4.0, 9.0, -2.0), 1.0, 1e-15);
  ASSERT_CLOSE(row_of(floor.v, 4.0, 8.0, -2.0), 1.0, 1e-15);
  ASSERT_CLOSE(row_of(floor.u, 0.0, 0.0, -2.0), 0.0, 1e-15);
  const double tilted[4] = { 3.0, 0.0, 4.0, 10.0 }; // its foot of the origin is (-1.2, 0, -1.6)
  const double along[3] = { 0.8, 0.0, -0.6 };
  const double one[2] = { 1.0, 1.0 };
  water_sky_floor_make(tilted, along, one, &floor);
  ASSERT_CLOSE(row_of(floor.height, -1.2, 5.0, -1.6), 0.0, 1e-15);
  ASSERT_CLOSE(row_of(floor.u, -1.2, 5.0, -1.6), 0.0, 1e-15);
  ASSERT_CLOSE(row_of(floor.v, -1.2, 5.0, -1.6), 5.0, 1e-15);
}

// A floor without a normal, a length of its texture or numbers is none.
TEST(bad_floors_are_none)
{
  const double right[3] = { 1.0, 0.0, 0.0 };
  const double good[4] = { 0.0, 0.0, 1.0, 0.0 };
  const double flat[4] = { 0.0, 0.0, 0.0, 1.0 };
  const double wrong[4] = { 0.0, 0.0, 1.0, (double)NAN };
  const double one[2] = { 1.0, 1.0 };
  const double none[2] = { 1.0, 0.0 };
  water_sky_floor floor;
  water_sky_floor_make(flat, right, one, &floor);
  assert_false(floor.is_there);
  water_sky_floor_make(wrong, right, one, &floor);
  assert_false(floor.is_there);
  water_sky_floor_make(good, right, none, &floor);
  assert_false(floor.is_there);
}

// The plan has them for directions and points of the plane's own axes: the same places.
TEST(plan_turns_them_to_the_plane)
{
  const double plane[4] = { 0.2, -0.3, 1.0, 5.0 };
  const double right[3] = { 1.0, 0.1, 0.4 };
  const double scale[2] = { 2.0, 3.0 };
  water_scene scene = lake();
  scene.plane_origin[0] = 3.0; // beside the eye's foot along both axes
  scene.plane_origin[1] = -4.0;
  water_axes axes;
  water_sky_map_sphere(same, &scene.sky.map);
  water_sky_floor_make(plane, right, scale, &scene.sky.floor);
  const water_plan plan = plan_of(&scene, NULL);
  water_plane unit;
  assert_int_equal(water_plane_normalise(&scene.plane, &unit), WATER_OK);
  water_lookup_axes(&unit, plan.side, scene.plane_origin, &axes);
  const double local[3] = { 0.3, 0.5, 0.7 };
  double world[3];
  double point[3];
  for (int i = 0; i < 3; ++i)
  {
    world[i] = local[0] * axes.x_dir[i] + local[1] * axes.y_dir[i] + local[2] * axes.normal[i];
    point[i] = world[i] + axes.origin[i] + plan.origin_xy[0] * axes.x_dir[i] +
      plan.origin_xy[1] * axes.y_dir[i];
  }
  for (int i = 0; i < 3; ++i)
  {
    const double* row = plan.sky_map.to_map + 3 * i;
    ASSERT_CLOSE(row[0] * local[0] + row[1] * local[1] + row[2] * local[2], world[i], 1e-12);
  }
  ASSERT_CLOSE(row_of(plan.sky_floor.height, local[0], local[1], local[2]),
    row_of(scene.sky.floor.height, point[0], point[1], point[2]), 1e-12);
  ASSERT_CLOSE(row_of(plan.sky_floor.u, local[0], local[1], local[2]),
    row_of(scene.sky.floor.u, point[0], point[1], point[2]), 1e-12);
  ASSERT_CLOSE(row_of(plan.sky_floor.v, local[0], local[1], local[2]),
    row_of(scene.sky.floor.v, point[0], point[1], point[2]), 1e-12);
}

// A shader has a sky where rays leave the picture, or an eye looks up from under water: calm water
// seen from above is shaded as without one.
TEST(shaders_have_a_sky_where_they_need_it)
{
  const water_feature_set rays = WATER_FEATURE_RAY_TRACED;
  const water_feature_set body = WATER_FEATURE_MEDIUM;
  water_sky sky;
  memset(&sky, 0, sizeof sky);
  water_sky_map_none(&sky.map);
  assert_int_equal(water_sky_features(rays, false, false, &sky), rays);
  assert_int_equal(water_sky_features(rays, true, false, &sky), rays | WATER_FEATURE_SKY_MAP);
  sky.screen = WATER_SCREEN_VERTICAL;
  assert_int_equal(water_sky_features(rays, false, false, &sky), rays | WATER_FEATURE_SKY_SCREEN);
  sky.map.kind = WATER_SKY_MAP;
  assert_int_equal(water_sky_features(rays, false, false, &sky), rays | WATER_FEATURE_SKY_MAP);
  sky.map.kind = WATER_SKY_CUBE;
  sky.floor.is_there = true;
  const water_feature_set seen = WATER_FEATURE_SKY_CUBE | WATER_FEATURE_SKY_FLOOR;
  assert_int_equal(water_sky_features(rays, false, false, &sky), rays | seen);
  assert_int_equal(water_sky_features(rays, true, false, &sky), rays | WATER_FEATURE_SKY_MAP);
  assert_int_equal(water_sky_features(WATER_FEATURE_ENVIRONMENT, false, false, &sky),
    WATER_FEATURE_ENVIRONMENT | seen);
  assert_int_equal(water_sky_features(body, false, false, &sky), body);
  assert_int_equal(water_sky_features(0, false, true, &sky), 0);
  assert_int_equal(water_sky_features(body, false, true, &sky), body | seen);
}

// A background of one colour is the only sky that looks the same in all directions.
TEST(one_color_is_told)
{
  water_plan plan;
  memset(&plan, 0, sizeof plan);
  assert_true(water_sky_is_one_color(&plan, false));
  assert_false(water_sky_is_one_color(&plan, true));
  plan.sky.screen = WATER_SCREEN_VERTICAL;
  assert_false(water_sky_is_one_color(&plan, false));
  plan.sky.screen = WATER_SCREEN_COLOR;
  plan.sky_floor.is_there = true;
  assert_false(water_sky_is_one_color(&plan, false));
  plan.sky_floor.is_there = false;
  plan.sky_map.kind = WATER_SKY_CUBE;
  assert_false(water_sky_is_one_color(&plan, false));
}

TESTS(no_map_is_the_screen, heights_of_pictures, cubes_are_turned_by_later_versions,
  pictures_on_a_floor, floors_have_places, bad_floors_are_none, plan_turns_them_to_the_plane,
  shaders_have_a_sky_where_they_need_it, one_color_is_told)
