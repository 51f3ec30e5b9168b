// SPDX-License-Identifier: BSD-3-Clause
// first_water: a pyramid stands in waves, driven from C. Writes a picture in the format PPM.
//
// usage: first_water [PICTURE.ppm [TIME]]    TIME of the waves in seconds, default 0
#include <vtkWaterC.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum
{
  WIDTH = 640,
  HEIGHT = 400
};

static const double pyramid_points[] = { -0.5, -0.5, -0.5, 0.5, -0.5, -0.5, 0.5, 0.5, -0.5, -0.5,
  0.5, -0.5, 0.0, 0.0, 0.6 };
static const int64_t pyramid_triangles[] = { 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4 };

// Says what went wrong; returns whether all is well.
static int is_fine(vtk_water_status status, const char* what)
{
  if (status != VTK_WATER_OK)
  {
    fprintf(stderr, "first_water: %s: %s: %s\n", what, vtk_water_status_text(status),
      vtk_water_last_error());
  }
  return status == VTK_WATER_OK;
}

static int fill(vtk_water_scene* scene, vtk_water_actor* water, double time)
{
  const double bottom[3] = { 0.93, 0.94, 0.93 }, top[3] = { 0.30, 0.50, 0.76 };
  const double color[3] = { 0.90, 0.45, 0.25 }, bounds[4] = { -9.0, 9.0, -9.0, 9.0 };
  const double eye[3] = { 1.2, -3.3, 0.6 }, target[3] = { 0.0, 0.0, 0.0 },
               up[3] = { 0.0, 0.0, 1.0 };
  return is_fine(vtk_water_scene_set_sky(scene, bottom, top), "sky") &&
    is_fine(
      vtk_water_scene_add_mesh(scene, pyramid_points, 5, pyramid_triangles, 4, color), "mesh") &&
    is_fine(vtk_water_actor_set_level(water, -0.2), "level") &&
    is_fine(vtk_water_actor_set_sheet_bounds(water, bounds), "sheet") &&
    is_fine(vtk_water_actor_add_wave(water, 0.010, 0.8, 30.0, 0.0, 0.0), "wave") &&
    is_fine(vtk_water_actor_add_wave(water, 0.006, 0.4, 75.0, 0.0, 0.0), "wave") &&
    is_fine(vtk_water_actor_set_time(water, time), "time") &&
    is_fine(vtk_water_scene_add_water(scene, water), "water") &&
    is_fine(vtk_water_scene_set_camera(scene, eye, target, up, 30.0), "camera");
}

static int write_picture(const char* file, const unsigned char* pixels)
{
  FILE* out = fopen(file, "wb");
  const size_t count = (size_t)3 * WIDTH * HEIGHT;
  int is_written = out != NULL;
  if (out)
  {
    is_written =
      fprintf(out, "P6 %d %d 255\n", WIDTH, HEIGHT) > 0 && fwrite(pixels, 1, count, out) == count;
    is_written = fclose(out) == 0 && is_written;
  }
  if (!is_written)
  {
    fprintf(stderr, "first_water: %s cannot be written\n", file);
  }
  return is_written;
}

int main(int argc, char* argv[])
{
  static unsigned char pixels[3 * WIDTH * HEIGHT];
  const char* file = argc > 1 ? argv[1] : "first_water.ppm";
  vtk_water_scene* scene = NULL;
  vtk_water_actor* water = NULL;
  vtk_water_pass* pass = NULL;
  const char* decision = "";
  int64_t props = 0;

  if (argc > 1 && (!strcmp(argv[1], "--help") || !strcmp(argv[1], "-h")))
  {
    puts("usage: first_water [PICTURE.ppm [TIME]]    TIME of the waves in seconds, default 0");
    return 0;
  }
  const int is_done = is_fine(vtk_water_scene_new(WIDTH, HEIGHT, &scene), "scene") &&
    is_fine(vtk_water_actor_new(&water), "water") &&
    fill(scene, water, argc > 2 ? atof(argv[2]) : 0.0) &&
    is_fine(vtk_water_scene_render(scene, pixels, sizeof pixels), "render") &&
    is_fine(vtk_water_actor_get_pass(water, &pass), "pass") &&
    is_fine(vtk_water_pass_get_decision(pass, &decision), "decision") &&
    is_fine(vtk_water_pass_get_prop_count(pass, &props), "props") && write_picture(file, pixels);
  if (is_done)
  {
    printf("%s: reflection %s, %d mesh reflected\n", file, decision, (int)props);
  }
  vtk_water_actor_delete(water);
  vtk_water_scene_delete(scene);
  return is_done ? 0 : 1;
}
