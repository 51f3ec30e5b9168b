// SPDX-License-Identifier: BSD-3-Clause
// test_target.c: size of the reflection texture and
// the rectangle of it that the water can look up.
#include "test_scene.h"

#include "water_math.h"
#include "water_target.h"

static const double nearby[3] = { 1.0, 2.0, 3.0 };

// An eye 10 over the lake looks straight down, 90 degrees high and wide on 400 x 400 pixels: the
// picture covers 20 x 20 of the water.
static water_scene from_above(double xmin, double xmax, double ymin, double ymax, double height)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, 10.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  const double bounds[6] = { xmin, xmax, ymin, ymax, -height, height };
  look_at(eye, target, up, scene.eye.world_to_view);
  frustum_matrix(box, 1.0, 100.0, scene.eye.view_to_clip);
  memcpy(scene.surface_bounds, bounds, sizeof bounds);
  scene.viewport_px[0] = 400;
  scene.viewport_px[1] = 400;
  return scene;
}

static void assert_rect(const water_scene* scene, int x, int y, int width, int height)
{
  const water_plan plan = plan_of(scene, NULL);
  const int* rect = plan.texture_rect_px;
  if (rect[0] != x || rect[1] != y || rect[2] != width || rect[3] != height)
  {
    print_error("rect is %d %d %d %d\n", rect[0], rect[1], rect[2], rect[3]);
    fail();
  }
}

// Size is picture times scale, rounded to the nearest, never under 1 pixel.
TEST(size_is_picture_times_scale)
{
  const int viewport[2] = { 801, 3 };
  const double scales[5] = { 1.0, 0.5, 0.25, 2.0, 0.01 };
  const int expected[5][2] = { { 801, 3 }, { 401, 2 }, { 200, 1 }, { 1602, 6 }, { 8, 1 } };
  for (int i = 0; i < 5; ++i)
  {
    int size[2];
    assert_int_equal(water_target_size(viewport, scales[i], 4096, size), WATER_OK);
    assert_int_equal(size[0], expected[i][0]);
    assert_int_equal(size[1], expected[i][1]);
    const int upright[2] = { viewport[1], viewport[0] };
    assert_int_equal(water_target_size(upright, scales[i], 4096, size), WATER_OK);
    assert_int_equal(size[0], expected[i][1]);
    assert_int_equal(size[1], expected[i][0]);
  }
}

// The GPU's limit itself fits, one pixel more does not, nor does a scale that no int can hold.
TEST(size_over_the_limit_is_refused)
{
  const int viewport[2] = { 100, 4096 };
  const int wide[2] = { 4097, 100 };
  int size[2] = { 7, 8 };
  assert_int_equal(water_target_size(wide, 1.0, 4096, size), WATER_TEXTURE_TOO_LARGE);
  assert_int_equal(water_target_size(viewport, 1.001, 4096, size), WATER_TEXTURE_TOO_LARGE);
  assert_int_equal(water_target_size(viewport, 1e300, 4096, size), WATER_TEXTURE_TOO_LARGE);
  assert_int_equal(water_target_size(viewport, 1.0, 0, size), WATER_TEXTURE_TOO_LARGE);
  assert_int_equal(size[0], 7);
  assert_int_equal(water_target_size(viewport, 1.0, 4096, size), WATER_OK);
}

// Seen straight down, a pond from x = 2 to 6 and y = 0 to 5 covers pixels 240 to 320 of the
// picture, so 80 to 160 of the reflection texture (flipped), and rows 200 to 300; two texels are
// added all around.
TEST(rect_of_a_known_pond_is_tight_and_flipped)
{
  const water_scene pond = from_above(2.0, 6.0, 0.0, 5.0, 0.0);
  assert_rect(&pond, 78, 198, 84, 104);
  water_scene half = pond;
  half.settings.texture_scale = 0.5;
  assert_rect(&half, 38, 98, 44, 54);
}

// A pond that is 1 higher at one place looks lower there: heights of -1 to 1 are seen 9 to 11 away,
// so the far corner reaches 6 / 9 of the half picture and the near one begins at 2 / 11.
TEST(rect_of_a_rough_pond_covers_the_mirror_images)
{
  water_scene pond = from_above(2.0, 6.0, 0.0, 5.0, 1.0);
  // x: 200 - 200 * 6/9 = 66.7, 200 - 200 * 2/11 = 163.6; y: 200, 200 + 200 * 5/9 = 311.1
  assert_rect(&pond, 64, 198, 102, 116);
  // only upwards: the box is seen 9 to 10 away, its images 10 to 11
  pond.surface_bounds[4] = 0.0;
  assert_rect(&pond, 64, 198, 102, 116);
}

// Water beside the picture, which a plan does not ask for, still has a rectangle within the
// reflection texture.
TEST(rect_is_never_empty)
{
  for (int side = 0; side < 4; ++side)
  {
    const double far_out = side % 2 ? 40.0 : -40.0;
    const double x = side < 2 ? far_out : 0.0;
    const double y = side < 2 ? 0.0 : far_out;
    const water_scene scene = from_above(x - 1.0, x + 1.0, y - 1.0, y + 1.0, 0.0);
    const int size[2] = { 400, 400 };
    const water_plane level = { { 0.0, 0.0, 1.0 }, 0.0 };
    int rect[4];
    const double all_picture[2] = { 1.0, 1.0 };
    double box[4];
    water_target_box(&scene.eye, &level, scene.surface_bounds, box);
    water_target_rect(box, all_picture, size, rect);
    for (int i = 0; i < 2; ++i)
    {
      assert_int_in_range(rect[i], 0, 399);
      assert_int_in_range(rect[2 + i], 1, 400 - rect[i]);
    }
  }
}

// Water that fills the picture, or reaches behind the eye, takes what the picture has of it: all of
// it, or for a lake with its horizon in the middle of the picture the half below.
TEST(rect_is_clamped_to_the_map)
{
  const water_scene all = from_above(-500.0, 500.0, -500.0, 500.0, 0.0);
  assert_rect(&all, 0, 0, 400, 400);
  water_scene around = all;
  const double eye[3] = { 0.0, 0.0, 10.0 };
  const double ahead[3] = { 0.0, 1.0, 10.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, ahead, up, around.eye.world_to_view);
  // the shore 500 ahead is 10 / 500 of the half picture under the horizon: row 196, and 2 of
  // padding
  assert_rect(&around, 0, 0, 400, 198);
}

// Waves higher than the eye mirror points behind it: all of the reflection texture, as they have no
// picture.
TEST(rect_is_all_of_the_map_where_there_is_no_picture)
{
  water_scene scene = from_above(2.0, 6.0, 0.0, 5.0, 0.0);
  scene.surface_bounds[4] = -12.0; // its mirror image is 2 over the eye
  assert_rect(&scene, 0, 0, 400, 400);
}

// Whatever the eye sees of the water looks up a pixel of the rectangle: points of the box that are
// in the picture, their own pixel and that of their mirror image. The rectangle lies within the
// reflection texture.
TEST(rect_covers_every_lookup)
{
  dice from = dice_seeded(23);
  int looked_up = 0;
  int saved = 0;
  for (int round = 0; round < 5000; ++round)
  {
    random_scene random = scene_rolled(&from, round, nearby);
    const double* bounds = random.scene.surface_bounds;
    for (int i = 0; i < 6; ++i)
    {
      random.scene.surface_bounds[i] =
        random.target[i / 2] + (i % 2 ? 1.0 : -1.0) * dice_roll(&from, 0.0, 3.0);
    }
    random.scene.settings.texture_scale = dice_roll(&from, 0.3, 2.0);
    const water_plan plan = plan_of(&random.scene, NULL);
    const int* rect = plan.texture_rect_px;
    assert_true(rect[0] >= 0 && rect[1] >= 0 && rect[2] >= 1 && rect[3] >= 1);
    assert_true(rect[0] + rect[2] <= plan.texture_px[0]);
    assert_true(rect[1] + rect[3] <= plan.texture_px[1]);
    saved += rect[2] < plan.texture_px[0] && rect[3] < plan.texture_px[1];
    for (int number = 0; number < 125; ++number)
    {
      const int steps[3] = { number % 5, number / 5 % 5, number / 25 };
      double point[3];
      double image[3];
      double clip[4];
      for (int i = 0; i < 3; ++i)
      {
        point[i] = bounds[2 * i] + (bounds[2 * i + 1] - bounds[2 * i]) * 0.25 * (double)steps[i];
      }
      project(&random.scene.eye, point, 1.0, clip);
      if (!is_inside(clip))
      {
        continue;
      }
      mirror_image(&random, point, image);
      for (int pass = 0; pass < 2; ++pass)
      {
        project(&random.scene.eye, pass ? image : point, 1.0, clip);
        const double x = (0.5 - 0.5 * clip[0] / clip[3]) * plan.texture_px[0];
        const double y = (0.5 + 0.5 * clip[1] / clip[3]) * plan.texture_px[1];
        if (clip[3] > 0.0 && x >= 0.0 && x <= plan.texture_px[0] && y >= 0.0 &&
          y <= plan.texture_px[1])
        {
          assert_true(x >= rect[0] && x <= rect[0] + rect[2]);
          assert_true(y >= rect[1] && y <= rect[1] + rect[3]);
          ++looked_up;
        }
      }
    }
  }
  assert_int_in_range(looked_up, 100000, 2000000);
  assert_int_in_range(saved, 1000, 5000);
}

// A guard band is none below 1, whatever the numbers it is made of: the reflection texture is never
// smaller than the picture.
TEST(guard_band_never_shrinks_the_map)
{
  const water_scene scene = lake();
  const double slopes[4] = { -1.0, -1e300, (double)-INFINITY, 0.0 };
  const double bands[4] = { 0.5, -1e300, (double)NAN, (double)-INFINITY };
  for (int i = 0; i < 4; ++i)
  {
    assert_true(water_target_guard_band(&scene.eye, slopes[i]) == 1.0);
    int px[2] = { 800, 600 };
    double scale[2];
    const double both[2] = { bands[i], bands[i] };
    water_target_widen(both, 16384, px, scale);
    assert_true(px[0] == 800 && px[1] == 600 && scale[0] == 1.0 && scale[1] == 1.0);
  }
  assert_true(water_target_guard_band(&scene.eye, 1e300) == 1.25);
}

// Waves look up beyond a part of the picture by the turn of its steepest ray, which for a frustum
// that is not symmetric leads to one certain corner.
TEST(reach_is_the_turn_of_the_steepest_ray)
{
  const double boxes[4][4] = { { -0.2, 0.9, -0.5, 0.3 }, { -0.9, 0.2, -0.5, 0.3 },
    { -0.2, 0.9, -0.3, 0.5 }, { -0.9, 0.2, -0.3, 0.5 } };
  water_scene scene = lake();
  for (int i = 0; i < 4; ++i)
  {
    frustum_matrix(boxes[i], 1.0, 100.0, scene.eye.view_to_clip);
    const double steepest = hypot(0.9, 0.5);
    const double turned = tan(atan(steepest) + 2.0 * atan(0.1)) - steepest;
    double box[4] = { -0.1, -0.2, 0.3, 0.4 };
    water_target_reach(&scene.eye, 0.1, box);
    ASSERT_CLOSE(box[0], -0.1 - turned * 2.0 / 1.1, 1e-12);
    ASSERT_CLOSE(box[1], -0.2 - turned * 2.0 / 0.8, 1e-12);
    ASSERT_CLOSE(box[2], 0.3 + turned * 2.0 / 1.1, 1e-12);
    ASSERT_CLOSE(box[3], 0.4 + turned * 2.0 / 0.8, 1e-12);
    double calm[4] = { -0.1, -0.2, 0.3, 0.4 };
    water_target_reach(&scene.eye, 0.0, calm);
    assert_true(calm[0] == -0.1 && calm[1] == -0.2 && calm[2] == 0.3 && calm[3] == 0.4);
    double rough[4] = { 0.0, 0.0, 0.0, 0.0 };
    water_target_reach(&scene.eye, 10.0, rough);
    assert_true(isinf(rough[0]) && isinf(rough[3]));
    // waves turn a pixel by the larger of the two scales
    ASSERT_CLOSE(water_target_guard_band(&scene.eye, 0.01), 1.0 + 0.02 * 2.0 / 0.8, 1e-12);
  }
  ortho_matrix(boxes[0], 1.0, 100.0, scene.eye.view_to_clip);
  double parallel[4] = { 0.0, 0.0, 0.0, 0.0 };
  water_target_reach(&scene.eye, 0.1, parallel);
  assert_true(isinf(parallel[0]) && isinf(parallel[3]));
  double still[4] = { 0.1, 0.2, 0.3, 0.4 };
  water_target_reach(&scene.eye, 0.0, still);
  assert_true(still[0] == 0.1 && still[1] == 0.2 && still[2] == 0.3 && still[3] == 0.4);
}

// Beyond the reflection texture a part of the picture is the texel at its border.
TEST(rect_beyond_the_map_is_its_border)
{
  const double beyond[4] = { 2.0, 2.0, 3.0, 3.0 };
  const double before[4] = { -3.0, -3.0, -2.0, -2.0 };
  const double scale[2] = { 1.0, 1.0 };
  const int px[2] = { 800, 600 };
  int rect[4];
  water_target_rect(beyond, scale, px, rect);
  assert_true(rect[0] == 0 && rect[2] == 1 && rect[1] == 599 && rect[3] == 1);
  water_target_rect(before, scale, px, rect);
  assert_true(rect[0] == 799 && rect[2] == 1 && rect[1] == 0 && rect[3] == 1);
  // of a view that is not flipped
  int own[4];
  water_target_rect_of_eye(before, scale, px, own);
  assert_true(own[0] == 0 && own[2] == 1 && own[1] == 0 && own[3] == 1);
  double box[4];
  water_rect_to_ndc(rect, px, box);
  ASSERT_CLOSE(box[0], 2.0 * 799.0 / 800.0 - 1.0, 1e-15);
  ASSERT_CLOSE(box[1], -1.0, 1e-15);
  ASSERT_CLOSE(box[2], 1.0, 1e-15);
  ASSERT_CLOSE(box[3], 2.0 / 600.0 - 1.0, 1e-15);
}

// Waves look up as much beside a tile as beside the picture that it is a tile of, on each side.
TEST(guard_band_of_a_tile_is_that_of_the_picture)
{
  const water_scene scene = lake();
  const int tile_scale[2] = { 4, 2 };
  water_camera tile = scene.eye;
  tile.view_to_clip[0] *= 4.0;
  tile.view_to_clip[5] *= 2.0;
  const water_camera whole = water_target_whole(&tile, tile_scale);
  assert_memory_equal(&whole, &scene.eye, sizeof whole);
  double bands[2];
  water_target_tile_bands(1.25, tile_scale, bands);
  int px[2] = { 200, 300 };
  double scale[2];
  water_target_widen(bands, 16384, px, scale);
  assert_true(px[0] == 200 + 2 * 100 && px[1] == 300 + 2 * 75);
}

// A guard band ends at the limit of textures, with even margins.
TEST(guard_band_ends_at_the_limit)
{
  int px[2] = { 1000, 995 };
  double scale[2];
  const double bands[2] = { 1e300, 1e300 };
  water_target_widen(bands, 1100, px, scale);
  assert_true(px[0] == 1100 && px[1] == 995 + 2 * 52);
  ASSERT_CLOSE(scale[0], 1000.0 / 1100.0, 1e-15);
  assert_int_equal(water_target_size(px, (double)INFINITY, 16384, px), WATER_BAD_TEXTURE_SCALE);
  assert_int_equal(water_target_size(px, 0.0, 16384, px), WATER_BAD_TEXTURE_SCALE);
}

// Frames that are averaged have textures twice as fine, where these are to be had.
TEST(averaged_frames_are_twice_as_fine)
{
  const int viewport_px[2] = { 640, 480 };
  assert_true(water_target_fine_scale(viewport_px, 1.0, 4096) == 2.0);
  assert_true(water_target_fine_scale(viewport_px, 0.5, 4096) == 1.0);
  assert_true(water_target_fine_scale(viewport_px, 1.0, 1280) == 2.0);
  assert_true(water_target_fine_scale(viewport_px, 1.0, 1279) == 1.0);
}

TESTS(guard_band_of_a_tile_is_that_of_the_picture, averaged_frames_are_twice_as_fine,
  size_is_picture_times_scale, size_over_the_limit_is_refused,
  rect_of_a_known_pond_is_tight_and_flipped, rect_of_a_rough_pond_covers_the_mirror_images,
  rect_is_never_empty, rect_is_clamped_to_the_map, rect_is_all_of_the_map_where_there_is_no_picture,
  rect_covers_every_lookup, guard_band_never_shrinks_the_map, reach_is_the_turn_of_the_steepest_ray,
  rect_beyond_the_map_is_its_border, guard_band_ends_at_the_limit)
