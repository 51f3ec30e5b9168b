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

TESTS(points_of_the_plane_have_no_height_but_their_rounding, inspections_are_joined,
  high_points_end_the_search, without_bounds_or_with_a_projection_there_are_no_heights,
  heights_that_are_seen_are_not_taken_as_flat, vertices_know_their_height)
