// SPDX-License-Identifier: BSD-3-Clause
// test_roughness.c: how rough a view of the water looks, by its smallest pixel.
#include "test_scene.h"

#include "water_quality.h"

// Seen straight down from 10 over a pool, a quarter of a turn of view: a pixel of 100 is 0.2 on
// each side, and turns a wave of 0.5 rad per unit by 0.1 on the mean of its directions.
TEST(roughness_is_of_a_pixel_on_the_water)
{
  water_scene scene = pool(10.0);
  scene.viewport_px[0] = scene.viewport_px[1] = 100;
  scene.has_waves = true;
  scene.slope_rms = 0.05;
  scene.slope_max = (double)INFINITY;
  const water_plan plan = plan_of(&scene, NULL);
  water_roughness roughness;
  water_quality_roughness(&scene, &plan, 0.5, &roughness);
  ASSERT_CLOSE(roughness.slope_rms, 0.05, 0.0);
  ASSERT_CLOSE(roughness.turn_rad, 0.1, 1e-9);
  ASSERT_CLOSE(roughness.pixels_per_radian, 50.0, 1e-9);
  // nothing is known of the first frame, nor of water that is not seen
  water_plan none;
  memset(&none, 0, sizeof none);
  water_quality_roughness(&scene, &none, 0.5, &roughness);
  ASSERT_CLOSE(roughness.turn_rad, 0.0, 0.0);
}

// In a view that is tilted and rolled the pixel that counts is the smallest in a corner of what the
// reflection texture is drawn for: view rays through it, the pixel to its right and the one above
// meet the water at places that far apart. The reflection texture is flipped.
TEST(roughness_is_of_the_smallest_pixel_in_a_corner)
{
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.3, 0.0, 1.0 };
  for (int side = -1; side <= 1; side += 2)
  {
    water_scene scene = lake();
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.surface_bounds[0] = side < 0 ? -6.0 : 2.0;
    scene.surface_bounds[1] = side < 0 ? -2.0 : 6.0;
    scene.surface_bounds[3] = -2.0; // its picture's corners are under the horizon
    scene.viewport_px[0] = 80;
    scene.viewport_px[1] = 60;
    const water_plan plan = plan_of(&scene, NULL);
    const int* rect = plan.texture_rect_px;
    const double* view = scene.eye.world_to_view;
    double least = DBL_MAX;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x_px = plan.texture_px[0] - (rect[0] + (corner & 1 ? rect[2] : 0));
      const double y_px = rect[1] + (corner & 2 ? rect[3] : 0);
      double places[3][2];
      for (int ray = 0; ray < 3; ++ray)
      {
        const double x = 4.0 / 3.0 * (2.0 * (x_px + (ray == 1)) / 80.0 - 1.0);
        const double y = 2.0 * (y_px + (ray == 2)) / 60.0 - 1.0;
        double dir[3];
        for (int i = 0; i < 3; ++i)
        {
          dir[i] = x * view[i] + y * view[4 + i] - view[8 + i];
        }
        assert_true(dir[2] < 0.0);
        places[ray][0] = eye[0] - eye[2] / dir[2] * dir[0];
        places[ray][1] = eye[1] - eye[2] / dir[2] * dir[1];
      }
      const double across = hypot(places[1][0] - places[0][0], places[1][1] - places[0][1]);
      const double along = hypot(places[2][0] - places[0][0], places[2][1] - places[0][1]);
      least = fmin(least, hypot(across, along));
    }
    water_roughness roughness;
    water_quality_roughness(&scene, &plan, 3.0, &roughness);
    ASSERT_CLOSE(roughness.turn_rad, 3.0 * least / sqrt(2.0), 1e-9);
  }
}

// Where the ray of a pixel meets the lake's level, by the camera's own axes.
static void place_of_pixel(
  const water_scene* scene, const double eye[3], double x, double y, double place[2])
{
  const double* view = scene->eye.world_to_view;
  double dir[3];
  for (int i = 0; i < 3; ++i)
  {
    dir[i] = view[i] * x / scene->eye.view_to_clip[0] +
      view[4 + i] * y / scene->eye.view_to_clip[5] - view[8 + i];
  }
  for (int i = 0; i < 2; ++i)
  {
    place[i] = eye[i] - eye[2] / dir[2] * dir[i];
  }
}

// The turn of a wave over a pixel where it is seen best: the corner of the reflection texture's
// drawn part whose pixel is the smallest on the water. For a pond to one side of the picture.
TEST(roughness_is_that_of_the_nearest_corner)
{
  water_scene scene = lake();
  scene.slope_rms = 0.1;
  for (int round = 0; round < 2; ++round)
  {
    const double eye[3] = { round == 0 ? -4.0 : 3.0, -10.0, 5.0 };
    const double target[3] = { 0.0, 0.0, 0.0 };
    const double up[3] = { 0.0, 0.0, 1.0 };
    look_at(eye, target, up, scene.eye.world_to_view);
    scene.surface_bounds[0] = round == 0 ? 0.5 : -4.0;
    scene.surface_bounds[1] = round == 0 ? 4.0 : -0.5;
    scene.surface_bounds[2] = -7.0;
    scene.surface_bounds[3] = -3.0;
    const water_plan plan = plan_of(&scene, NULL);
    const int* rect = plan.texture_rect_px;
    double least = DBL_MAX;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double x = 1.0 - 2.0 * (rect[0] + (corner & 1 ? rect[2] : 0)) / 800.0; // flipped
      const double y = 2.0 * (rect[1] + (corner & 2 ? rect[3] : 0)) / 600.0 - 1.0;
      double here[2];
      double across[2];
      double down[2];
      place_of_pixel(&scene, eye, x, y, here);
      place_of_pixel(&scene, eye, x + 2.0 / 800.0, y, across);
      place_of_pixel(&scene, eye, x, y + 2.0 / 600.0, down);
      least = fmin(least,
        hypot(hypot(across[0] - here[0], across[1] - here[1]),
          hypot(down[0] - here[0], down[1] - here[1])));
    }
    water_roughness roughness;
    water_quality_roughness(&scene, &plan, 3.0, &roughness);
    ASSERT_CLOSE(roughness.turn_rad, 3.0 * least / sqrt(2.0), 1e-9);
    ASSERT_CLOSE(roughness.pixels_per_radian, 300.0, 1e-9);
    assert_true(roughness.slope_rms == 0.1);
  }
  scene.look.constant_reflectance = true; // a view, but no reflection texture
  const water_plan dull = plan_of(&scene, NULL);
  water_roughness roughness;
  water_quality_roughness(&scene, &dull, 3.0, &roughness);
  assert_true(roughness.turn_rad == 0.0);
}

TESTS(roughness_is_of_a_pixel_on_the_water, roughness_is_of_the_smallest_pixel_in_a_corner,
  roughness_is_that_of_the_nearest_corner)
