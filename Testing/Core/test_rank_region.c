// SPDX-License-Identifier: BSD-3-Clause
// test_rank_region.c: ranks that divide space divide the surface: each point of it belongs to one.
#include "test_scene.h"

#include "water_lookup.h"
#include "water_plan.h"
#include "water_plane.h"
#include "water_ranks.h"

// The point of a surface in world coordinates; place: from the point under the eye.
static void to_world(
  const water_scene* scene, const water_plan* plan, const double place[3], double point[3])
{
  water_plane unit;
  water_axes axes;
  assert_int_equal(water_plane_normalise(&scene->plane, &unit), WATER_OK);
  water_lookup_axes(&unit, plan->side, scene->plane_origin, &axes);
  for (int i = 0; i < 3; ++i)
  {
    point[i] = axes.origin[i] + (plan->origin_xy[0] + place[0]) * axes.x_dir[i] +
      (plan->origin_xy[1] + place[1]) * axes.y_dir[i] + place[2] * axes.normal[i];
  }
}

static bool lies_inside(
  const water_scene* scene, const water_plan* plan, const double region[6], const double place[3])
{
  water_plane unit;
  double sides[6][4];
  assert_int_equal(water_plane_normalise(&scene->plane, &unit), WATER_OK);
  water_rank_region_sides(&unit, scene->plane_origin, plan, region, sides);
  bool all = true;
  for (int i = 0; i < 6; ++i)
  {
    const double distance =
      sides[i][0] * place[0] + sides[i][1] * place[1] + sides[i][2] * place[2] + sides[i][3];
    all = all && (i % 2 ? distance > 0.0 : distance >= 0.0);
  }
  return all;
}

// Random points of random planes, seen from above and from below, lie in the box in which their
// world coordinates lie.
TEST(a_point_is_in_the_region_that_contains_it)
{
  dice from = dice_seeded(20261128);
  int inside_count = 0;
  for (int number = 0; number < 400; ++number)
  {
    const double center[3] = { dice_roll(&from, -9.0, 9.0), dice_roll(&from, -9.0, 9.0), 3.0 };
    const random_scene random = scene_rolled(&from, number, center);
    water_plan plan;
    if (water_plan_make(&random.scene, &plan, NULL) != WATER_OK || !plan.has_view)
    {
      continue;
    }
    const double place[3] = { dice_roll(&from, -20.0, 20.0), dice_roll(&from, -20.0, 20.0),
      dice_roll(&from, -0.5, 0.5) };
    double point[3];
    to_world(&random.scene, &plan, place, point);
    double region[6];
    bool expected = true;
    for (int i = 0; i < 3; ++i)
    {
      region[2 * i] = point[i] - dice_roll(&from, -0.5, 4.0);
      region[2 * i + 1] = fmax(point[i], region[2 * i]) + dice_roll(&from, 0.01, 4.0);
      expected = expected && region[2 * i] < point[i];
    }
    assert_true(water_rank_region_is_there(region));
    assert_int_equal(lies_inside(&random.scene, &plan, region, place), expected);
    inside_count += expected ? 1 : 0;
  }
  assert_in_range(inside_count, 100, 390);
}

// A point on the border of two regions is in one of them: the upper.
TEST(a_point_on_a_border_is_in_one_region)
{
  const double inf = (double)INFINITY;
  water_scene scene = pool(40.0);
  water_plan plan;
  assert_int_equal(water_plan_make(&scene, &plan, NULL), WATER_OK);
  for (int axis = 0; axis < 2; ++axis)
  {
    const double place[3] = { 1.0, 2.0, 0.0 };
    double point[3];
    to_world(&scene, &plan, place, point);
    double lower[6] = { -inf, inf, -inf, inf, -inf, inf };
    double upper[6] = { -inf, inf, -inf, inf, -inf, inf };
    lower[2 * axis + 1] = upper[2 * axis] = point[axis];
    assert_false(lies_inside(&scene, &plan, lower, place));
    assert_true(lies_inside(&scene, &plan, upper, place));
  }
}

TEST(a_region_has_each_minimum_below_its_maximum)
{
  const double good[6] = { -1.0, 1.0, (double)-INFINITY, 0.0, 2.0, (double)INFINITY };
  assert_true(water_rank_region_is_there(good));
  for (int i = 0; i < 6; ++i)
  {
    double bad[6];
    memcpy(bad, good, sizeof bad);
    bad[i] = (double)NAN;
    assert_false(water_rank_region_is_there(bad));
    bad[i] = i % 2 ? good[i - 1] : good[i + 1];
    assert_false(water_rank_region_is_there(bad));
  }
}

TESTS(a_point_is_in_the_region_that_contains_it, a_point_on_a_border_is_in_one_region,
  a_region_has_each_minimum_below_its_maximum)
