// SPDX-License-Identifier: BSD-3-Clause
// test_volume_planes.c: which points of the reflection
// texture are in the box of a volume, and over the water.
#include "test_scene.h"

#include "water_math.h"
#include "water_plan.h"
#include "water_volume_planes.h"

enum
{
  POINTS = 20000
};

static const double box[6] = { -3.0, 2.0, -1.0, 7.0, -2.0, 4.0 };
static const double identity[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
  0.0, 0.0, 0.0, 1.0 };

// half as high, a quarter turn about z, and elsewhere; and the way back
static const double placed[16] = { 0.0, -1.0, 0.0, 2.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.5, 1.5, 0.0,
  0.0, 0.0, 1.0 };
static const double placed_back[16] = { 0.0, 1.0, 0.0, -1.0, -1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 2.0,
  -3.0, 0.0, 0.0, 0.0, 1.0 };

static void assert_sides_tell(
  const water_plan* plan, const double box_to_world[16], const double world_to_box[16])
{
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  assert_int_equal(water_volume_planes_make(plan, box, box_to_world, sides), WATER_OK);
  dice from = dice_seeded(1);
  int inside = 0;
  for (int i = 0; i < POINTS; ++i)
  {
    const double point[3] = { dice_roll(&from, -6.0, 6.0), dice_roll(&from, -4.0, 10.0),
      dice_roll(&from, -4.0, 8.0) };
    double ndc[4];
    project(&plan->mirrored, point, 1.0, ndc);
    if (!is_inside(ndc))
    {
      continue;
    }
    for (int j = 0; j < 4; ++j)
    {
      ndc[j] /= ndc[3];
    }
    double own[4];
    const double in_world[4] = { point[0], point[1], point[2], 1.0 };
    water_mat4_apply(world_to_box, in_world, own);
    const double over[WATER_VOLUME_PLANES_COUNT] = { own[0] - box[0], box[1] - own[0],
      own[1] - box[2], box[3] - own[1], own[2] - box[4], box[5] - own[2], point[2] };
    int held = 0;
    for (int side = 0; side < WATER_VOLUME_PLANES_COUNT; ++side)
    {
      const double* plane = sides[side];
      const double value = plane[0] * ndc[0] + plane[1] * ndc[1] + plane[2] * ndc[2] + plane[3];
      assert_true(fabs(over[side]) < 1e-6 || (value > 0.0) == (over[side] > 0.0));
      held += value > 0.0;
    }
    inside += held == WATER_VOLUME_PLANES_COUNT;
  }
  assert_true(inside > POINTS / 100);
}

TEST(sides_hold_what_is_in_the_box_and_over_the_water)
{
  water_scene scene = lake();
  water_plan plan = plan_of(&scene, NULL);
  assert_sides_tell(&plan, identity, identity);
  assert_sides_tell(&plan, placed, placed_back);
  const double window[4] = { -12.0, 12.0, -9.0, 9.0 };
  ortho_matrix(window, 1.0, 1000.0, scene.eye.view_to_clip);
  scene.eye.parallel = true;
  plan = plan_of(&scene, NULL);
  assert_sides_tell(&plan, identity, identity);
  assert_sides_tell(&plan, placed, placed_back);
}

// A plan that keeps both sides has no plane between them: every point is on its kept side.
TEST(a_plane_that_is_none_has_no_side)
{
  const water_scene scene = lake();
  water_plan plan = plan_of(&scene, NULL);
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  memset(plan.clip_plane_clip, 0, sizeof plan.clip_plane_clip);
  assert_int_equal(water_volume_planes_make(&plan, box, identity, sides), WATER_OK);
  for (int i = 0; i < 4; ++i)
  {
    assert_true(sides[WATER_VOLUME_PLANES_COUNT - 1][i] == 0.0);
  }
}

TEST(sides_fit_single_precision)
{
  const water_scene scene = lake();
  const double bounds[6] = { -3e7, 2e7, -1e7, 7e7, -2e7, 4e7 };
  water_plan plan = plan_of(&scene, NULL);
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  assert_int_equal(water_volume_planes_make(&plan, bounds, identity, sides), WATER_OK);
  for (int i = 0; i < WATER_VOLUME_PLANES_COUNT; ++i)
  {
    double largest = 0.0;
    for (int j = 0; j < 4; ++j)
    {
      largest = fmax(largest, fabs(sides[i][j]));
    }
    assert_true(largest == 1.0);
  }
}

TEST(bounds_that_are_none_are_refused)
{
  const water_scene scene = lake();
  water_plan plan = plan_of(&scene, NULL);
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  const double wrong[4] = { NAN, INFINITY, -INFINITY, 3.0 }; // and one over its maximum
  for (int i = 0; i < 4; ++i)
  {
    double bounds[6];
    memcpy(bounds, box, sizeof bounds);
    bounds[0] = wrong[i];
    assert_int_equal(
      water_volume_planes_make(&plan, bounds, identity, sides), WATER_BAD_PROP_BOUNDS);
  }
}

// One that is scaled to a sheet, as an actor's scale may do it.
TEST(box_without_an_inverse_is_refused)
{
  const water_scene scene = lake();
  water_plan plan = plan_of(&scene, NULL);
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  double flat[16];
  memcpy(flat, identity, sizeof flat);
  flat[10] = 0.0;
  assert_int_equal(water_volume_planes_make(&plan, box, flat, sides), WATER_BAD_CAMERA);
}

TEST(camera_without_an_inverse_is_refused)
{
  const water_scene scene = lake();
  water_plan plan = plan_of(&scene, NULL);
  double sides[WATER_VOLUME_PLANES_COUNT][4];
  memset(plan.mirrored.view_to_clip, 0, sizeof plan.mirrored.view_to_clip);
  assert_int_equal(water_volume_planes_make(&plan, box, identity, sides), WATER_BAD_CAMERA);
}

TESTS(sides_hold_what_is_in_the_box_and_over_the_water, a_plane_that_is_none_has_no_side,
  sides_fit_single_precision, bounds_that_are_none_are_refused, box_without_an_inverse_is_refused,
  camera_without_an_inverse_is_refused)
