// SPDX-License-Identifier: BSD-3-Clause
// test_flatness.c: meshes of the user's in the water's plane, near it, and high over it; and what
// an eye sees of that.
#include "test_scene.h"

#include "water_flatness.h"

static const double identity[16] = { 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
  0.0, 0.0, 0.0, 1.0 };

enum
{
  POINTS = 100
};

// Points about a place of a plane, 20 to each side, and their bounds.
typedef struct mesh
{
  water_plane unit;
  double middle[3]; // of the plane
  double axes[2][3];
  double points[POINTS][3];
  double bounds[6];
} mesh;

static mesh mesh_rolled(dice* from, double distance)
{
  mesh made;
  double up[3];
  dice_dir(from, made.unit.normal);
  dice_dir(from, made.middle);
  dice_dir(from, up);
  cross(up, made.unit.normal, made.axes[0]);
  normalise(made.axes[0]);
  cross(made.unit.normal, made.axes[0], made.axes[1]);
  for (int i = 0; i < 3; ++i)
  {
    made.middle[i] *= distance;
  }
  made.unit.offset = -dot(made.unit.normal, made.middle);
  return made;
}

static void lay(dice* from, double height, bool is_single, mesh* laid)
{
  for (int i = 0; i < POINTS; ++i)
  {
    const double across[2] = { dice_roll(from, -20.0, 20.0), dice_roll(from, -20.0, 20.0) };
    for (int j = 0; j < 3; ++j)
    {
      const double place = laid->middle[j] + across[0] * laid->axes[0][j] +
        across[1] * laid->axes[1][j] + (i == POINTS / 2 ? height : 0.0) * laid->unit.normal[j];
      laid->points[i][j] = is_single ? (double)(float)place : place;
      laid->bounds[2 * j] = i ? fmin(laid->bounds[2 * j], laid->points[i][j]) : laid->points[i][j];
      laid->bounds[2 * j + 1] =
        i ? fmax(laid->bounds[2 * j + 1], laid->points[i][j]) : laid->points[i][j];
    }
  }
}

static double judged(const mesh* laid, bool is_single)
{
  water_flatness flatness;
  assert_true(water_flatness_begin(&laid->unit, identity, laid->bounds, is_single, &flatness));
  for (int i = 0; i < POINTS && water_flatness_add(laid->points[i], &flatness); ++i)
  {
  }
  return water_flatness_judge(&flatness);
}

// Wherever the plane is: what floats round is no height, and what they do not is one.
TEST(points_of_the_plane_have_no_height_but_their_rounding)
{
  dice from = dice_seeded(1);
  for (int i = 0; i < 400; ++i)
  {
    const double distance = i % 8 ? pow(10.0, i % 8) : 0.0;
    mesh laid = mesh_rolled(&from, distance);
    for (int is_single = 0; is_single < 2; ++is_single)
    {
      const double epsilon = is_single ? (double)FLT_EPSILON : DBL_EPSILON;
      lay(&from, 0.0, is_single, &laid);
      ASSERT_CLOSE(judged(&laid, is_single), 0.0, 0.0);
      const double height = (is_single ? 4.0 : 100.0) * epsilon * (distance + 30.0);
      if (height < 2e-3) // as high as the next test's
      {
        lay(&from, i & 8 ? height : -height, is_single, &laid);
        ASSERT_CLOSE(judged(&laid, is_single), height, 0.5 * height);
      }
    }
  }
}

// Points that several inspections looked at are judged together.
TEST(inspections_are_joined)
{
  dice from = dice_seeded(5);
  for (int i = 0; i < 20; ++i)
  {
    mesh laid = mesh_rolled(&from, 100.0);
    lay(&from, i % 2 ? 1e-3 : 0.1, false, &laid);
    water_flatness parts[2];
    for (int half = 0; half < 2; ++half)
    {
      assert_true(water_flatness_begin(&laid.unit, identity, laid.bounds, false, &parts[half]));
      for (int j = half; j < POINTS; j += 2)
      {
        water_flatness_add(laid.points[j], &parts[half]);
      }
    }
    const double reach = fmax(parts[0].reach, parts[1].reach);
    water_flatness_join(&parts[(i / 2) % 2], &parts[1 - (i / 2) % 2]);
    const water_flatness* joined = &parts[1 - (i / 2) % 2];
    ASSERT_CLOSE(joined->reach, reach, 0.0);
    const double judge = water_flatness_judge(joined);
    assert_true(judge == judged(&laid, false));
    assert_true(isinf(judge) == (i % 2 == 0));
  }
}

// What is as high as 1e-4 of the mesh's size is not looked at further: no eye takes it for flat.
TEST(high_points_end_the_search)
{
  dice from = dice_seeded(2);
  for (int i = 0; i < 50; ++i)
  {
    mesh laid = mesh_rolled(&from, 100.0);
    lay(&from, 0.1, false, &laid);
    assert_true(isinf(judged(&laid, false)));
    water_flatness flatness;
    assert_true(water_flatness_begin(&laid.unit, identity, laid.bounds, false, &flatness));
    assert_true(water_flatness_add(laid.points[0], &flatness));
    assert_false(water_flatness_add(laid.points[POINTS / 2], &flatness));
    const double hole[3] = { (double)NAN, 0.0, 0.0 };
    const double end[3] = { (double)INFINITY, 0.0, 0.0 };
    assert_true(water_flatness_begin(&laid.unit, identity, laid.bounds, false, &flatness));
    assert_true(water_flatness_add(hole, &flatness) && water_flatness_add(end, &flatness));
    ASSERT_CLOSE(water_flatness_judge(&flatness), 0.0, 0.0);
  }
}

TEST(without_bounds_or_with_a_projection_there_are_no_heights)
{
  const water_plane level = { { 0.0, 0.0, 1.0 }, -2.0 };
  const double empty[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
  const double unit[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  water_flatness flatness;
  assert_true(water_flatness_begin(&level, identity, unit, false, &flatness));
  assert_false(water_flatness_begin(&level, identity, empty, false, &flatness));
  const double wrong[] = { 1e-3, (double)NAN };
  for (int i = 0; i < 16; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      double matrix[16];
      memcpy(matrix, identity, sizeof matrix);
      matrix[i] += wrong[j];
      double height[4];
      assert_int_equal(water_flatness_heights(&level, matrix, height), j == 0 && i < 12);
    }
  }
}

// Pixels between a point of the surface and its own mirror image, as the eye sees them.
static double shift_px(const water_scene* scene, const double point[3], const double mirrored[3])
{
  double clip[2][4];
  project(&scene->eye, point, 1.0, clip[0]);
  project(&scene->eye, mirrored, 1.0, clip[1]);
  double longest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double ndc = clip[0][i] / clip[0][3] - clip[1][i] / clip[1][3];
    longest = fmax(longest, fabs(0.5 * ndc * scene->viewport_px[i]));
  }
  return is_inside(clip[0]) ? longest : 0.0;
}

// What is taken as flat shows no reflection 1/256 of a pixel beside its place. Not much less is
// taken as flat, either, where the surface is seen as near as the picture allows.
TEST(heights_that_are_seen_are_not_taken_as_flat)
{
  dice from = dice_seeded(3);
  const double center[3] = { 0.0, 0.0, 0.0 };
  int unseen = 0;
  int tight = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const random_scene random = scene_rolled(&from, i, center);
    const water_plan plan = plan_of(&random.scene, NULL);
    const double height = pow(10.0, dice_roll(&from, -6.0, 0.0));
    const bool is_unseen = water_flatness_is_unseen(&plan, height, random.scene.viewport_px);
    double worst = 0.0;
    for (int j = 0; j < 400; ++j)
    {
      double point[3];
      double mirrored[3];
      point_near(&from, &random, 30.0, point);
      const double drop = height_of(&random, point) - (j & 1 ? height : -height);
      for (int k = 0; k < 3; ++k)
      {
        point[k] -= drop * random.normal[k];
      }
      mirror_image(&random, point, mirrored);
      worst = fmax(worst, shift_px(&random.scene, point, mirrored));
    }
    if (is_unseen)
    {
      ++unseen;
      assert_true(worst < 1.0 / 256.0);
    }
    tight += is_unseen && worst > 1.0 / 2560.0;
    assert_true(water_flatness_is_unseen(&plan, 0.0, random.scene.viewport_px));
    assert_true(water_flatness_is_unseen(&plan, 1e-9, random.scene.viewport_px));
    assert_false(water_flatness_is_unseen(&plan, (double)INFINITY, random.scene.viewport_px));
    assert_false(water_flatness_is_unseen(&plan, 100.0, random.scene.viewport_px));
  }
  print_message("%d unseen, %d of them within a tenth of what is seen\n", unseen, tight);
  assert_true(unseen > 300 && tight > 100);
}

// Floats of a far mesh, shifted and scaled or not, tell the height of the vertex that they are.
TEST(vertices_know_their_height)
{
  dice from = dice_seeded(4);
  for (int i = 0; i < 2000; ++i)
  {
    const mesh world = mesh_rolled(&from, pow(10.0, dice_roll(&from, 0.0, 6.0)));
    // turned, moved and scaled: columns are axes
    mesh local = mesh_rolled(&from, i & 1 ? pow(10.0, dice_roll(&from, 0.0, 6.0)) : 0.0);
    double mesh_to_world[16] = { 0.0 };
    const double* columns[3] = { world.axes[1], world.unit.normal, world.axes[0] };
    for (int j = 0; j < 3; ++j)
    {
      const double stretch = pow(10.0, dice_roll(&from, -1.0, 1.0));
      for (int k = 0; k < 3; ++k)
      {
        mesh_to_world[4 * k + j] = stretch * columns[j][k];
      }
    }
    double middle[4];
    apply(mesh_to_world, local.middle, 0.0, middle);
    for (int k = 0; k < 3; ++k)
    {
      mesh_to_world[4 * k + 3] = world.middle[k] - middle[k];
    }
    mesh_to_world[15] = 1.0;
    lay(&from, 3.0, false, &local);
    const double scale_of_all = i & 2 ? dice_roll(&from, 0.1, 10.0) : 1.0;
    const double scale[3] = { scale_of_all, 2.0 * scale_of_all, 0.5 * scale_of_all };
    double shift[3] = { 0.0, 0.0, 0.0 };
    if (i & 2)
    {
      memcpy(shift, local.middle, sizeof shift);
      shift[0] += 5.0;
    }
    const water_side side = i & 4 ? WATER_BELOW : WATER_ABOVE;
    double height[4];
    double origin[3];
    double rise[4];
    assert_true(water_flatness_heights(&world.unit, mesh_to_world, height));
    water_flatness_vertices(height, side, local.bounds, shift, scale, origin, rise);
    for (int j = 0; j < POINTS; ++j)
    {
      float sum = 0.0f;
      double place[3]; // of the vertex as it is, in local coordinates
      for (int k = 0; k < 3; ++k)
      {
        const float vertex = (float)((local.points[j][k] - shift[k]) * scale[k]);
        assert_true(origin[k] == (double)(float)origin[k]);
        sum += (float)rise[k] * (vertex - (float)origin[k]);
        place[k] = (double)vertex / scale[k] + shift[k] - local.middle[k];
      }
      sum += (float)rise[3];
      double from_middle[4];
      apply(mesh_to_world, place, 0.0, from_middle);
      const double right = dot(world.unit.normal, from_middle) * (side == WATER_BELOW ? -1.0 : 1.0);
      ASSERT_CLOSE((double)sum, right, 3e-4); // of 400
    }
  }
}

// The largest height of a search is 1e-4 of the diagonal in world, and heights are known to 16
// roundings of the largest terms, in floats to one of a float.
TEST(limits_are_those_of_the_mesh)
{
  const water_plane level = { { 0.0, 0.0, 1.0 }, -100.0 };
  const double bounds[6] = { 1.0, 5.0, -1.0, 3.0, -3.0, 2.0 };
  double matrix[16] = { 1.0, 0.0, 2.0, 7.0, 2.0, 3.0, 0.0, 8.0, 2.0, 4.0, -1.0, 9.0, 0.0, 0.0, 0.0,
    1.0 };
  water_flatness flatness;
  assert_true(water_flatness_begin(&level, matrix, bounds, false, &flatness));
  const double sides[3] = { 4.0 * 3.0, 4.0 * 5.0, 5.0 * sqrt(5.0) }; // the columns are 3, 5, 5^1/2
  const double diagonal = sqrt(dot(sides, sides));
  ASSERT_CLOSE(flatness.limit / diagonal, 1e-4, 1e-16);
  // heights are 2 x + 4 y - z + 9 - 100
  const double terms = 2.0 * 5.0 + 4.0 * 3.0 + 3.0;
  ASSERT_CLOSE(flatness.rounding / (DBL_EPSILON * (terms + 100.0 + 91.0)), 16.0, 1e-12);
  const double rounding = flatness.rounding;
  assert_true(water_flatness_begin(&level, matrix, bounds, true, &flatness));
  ASSERT_CLOSE((flatness.rounding - rounding) / terms, (double)FLT_EPSILON, 1e-15);
}

// A height at a limit is not over it. The highest point is known, whatever the order.
TEST(heights_at_the_limits)
{
  const double half[3] = { 0.0, 0.0, 0.5 };
  const double low[3] = { 0.0, 0.0, -0.25 };
  const double high[3] = { 0.0, 0.0, -3.0 };
  water_flatness flatness = { { 0.0, 0.0, 1.0, 0.0 }, 0.0, 0.25, 0.5, 0.0 };
  assert_true(water_flatness_add(low, &flatness));
  ASSERT_CLOSE(water_flatness_judge(&flatness), 0.0, 0.0);
  assert_true(water_flatness_add(half, &flatness));
  ASSERT_CLOSE(water_flatness_judge(&flatness), 0.5, 0.0);
  assert_false(water_flatness_add(high, &flatness));
  assert_true(water_flatness_add(low, &flatness));
  ASSERT_CLOSE(flatness.reach, 3.0, 0.0);
  flatness.limit = 0.125;
  flatness.height_max = 0.0;
  assert_true(water_flatness_add(low, &flatness)); // over the limit, but not over its rounding
}

// The height from which on a surface is seen.
static double seen_from(const water_plan* plan, const int viewport_px[2])
{
  double low = 1e-9;
  double high = 10.0;
  while (high > low * (1.0 + 1e-12))
  {
    const double middle = sqrt(low * high);
    *(water_flatness_is_unseen(plan, middle, viewport_px) ? &low : &high) = middle;
  }
  return low;
}

// The picture's shift, in pixels along y, of the point over the picture's lowest middle that is
// that high, seen from an eye 5 over the water that looks up by an angle.
static double shift_at_bottom(double pitch, double half_angle, double height, int rows)
{
  const double down = half_angle - pitch; // of the lowest ray, under the horizon
  const double away = (5.0 - height) / tan(down);
  const double below = atan2(5.0 + height, away); // its mirror image, under the horizon
  return 0.5 * rows * (tan(below + pitch) / tan(half_angle) - 1.0);
}

// The limit is not only safe, but the very height at which the nearest water's reflection is off by
// a 256th of a pixel. In small pictures such heights are a part of the eye's.
TEST(limit_of_the_nearest_water)
{
  const double half_angle = 0.6;
  const double pitches[] = { 0.3, 0.1, 0.0 };
  for (size_t i = 0; i < sizeof pitches / sizeof *pitches; ++i)
  {
    const int viewport_px[2] = { 1, 2 };
    water_scene scene = lake();
    const double eye[3] = { 0.0, -10.0, 5.0 };
    const double target[3] = { 0.0, -10.0 + cos(pitches[i]), 5.0 + sin(pitches[i]) };
    const double up[3] = { 0.0, 0.0, 1.0 };
    const double side = tan(half_angle);
    const double box[4] = { -0.5 * side, 0.5 * side, -side, side };
    look_at(eye, target, up, scene.eye.world_to_view);
    frustum_matrix(box, 1.0, 1000.0, scene.eye.view_to_clip);
    const double bounds[6] = { -10.0, 10.0, -10.0, 1000.0, 0.0, 0.0 };
    memcpy(scene.surface_bounds, bounds, sizeof bounds);
    const water_plan plan = plan_of(&scene, NULL);
    const double height = seen_from(&plan, viewport_px);
    ASSERT_CLOSE(
      256.0 * shift_at_bottom(pitches[i], half_angle, height, viewport_px[1]), 1.0, 1e-6);
    // a near plane beyond that point: what is seen is farther away
    frustum_matrix((double[4]){ -50.0 * side, 50.0 * side, -100.0 * side, 100.0 * side }, 100.0,
      1e4, scene.eye.view_to_clip);
    const water_plan far_plan = plan_of(&scene, NULL);
    assert_true(seen_from(&far_plan, viewport_px) > 3.0 * height);
    // as high as the eye: seen
    assert_false(water_flatness_is_unseen(&plan, 5.0, viewport_px));
  }
}

// Many at once are judged as one by one.
TEST(points_are_added_at_once)
{
  dice from = dice_seeded(6);
  for (int i = 0; i < 40; ++i)
  {
    mesh laid = mesh_rolled(&from, 100.0);
    lay(&from, i % 2 ? 1e-3 : (i % 4 ? 0.1 : 30.0), false, &laid);
    laid.points[13][1] = (double)NAN;
    laid.points[14][0] = (double)INFINITY;
    water_flatness one;
    water_flatness all;
    assert_true(water_flatness_begin(&laid.unit, identity, laid.bounds, false, &one));
    all = one;
    for (int j = 0; j < POINTS; ++j)
    {
      water_flatness_add(laid.points[j], &one);
    }
    water_flatness_add_points(laid.points[0], POINTS, &all);
    assert_memory_equal(&all.reach, &one.reach, sizeof one.reach);
    assert_memory_equal(&all.height_max, &one.height_max, sizeof one.height_max);
    water_flatness_add_points(laid.points[0], 0, &all);
    ASSERT_CLOSE(all.reach, one.reach, 0.0);
  }
}

// Points count up to the largest double, one by one and together.
TEST(points_count_up_to_the_largest_number)
{
  const water_plane unit = { { 0.0, 0.0, 1.0 }, 0.0 };
  const double same[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  const double bounds[6] = { 0.0, 1.0, 0.0, 1.0, -1.0, 1.0 };
  const double point[3] = { 0.0, 0.0, DBL_MAX };
  water_flatness one;
  water_flatness all;
  assert_true(water_flatness_begin(&unit, same, bounds, false, &one));
  all = one;
  assert_false(water_flatness_add(point, &one));
  water_flatness_add_points(point, 1, &all);
  assert_true(isinf(one.height_max) && isinf(all.height_max));
}

TESTS(points_count_up_to_the_largest_number, limits_are_those_of_the_mesh, heights_at_the_limits,
  limit_of_the_nearest_water, points_of_the_plane_have_no_height_but_their_rounding,
  inspections_are_joined, high_points_end_the_search,
  without_bounds_or_with_a_projection_there_are_no_heights,
  heights_that_are_seen_are_not_taken_as_flat, vertices_know_their_height, points_are_added_at_once)
