// SPDX-License-Identifier: BSD-3-Clause
// test_scene.h: scenes, cameras and random numbers for the tests. Nothing in here calls the core:
// a test's truth must not come from what it tests.
#ifndef test_scene_h
#define test_scene_h

#include "test_main.h"

#include <float.h>
#include <string.h>

#include "water_plan.h"

// Knuth's MMIX generator; the seed is part of the test, so a failure repeats.
typedef struct dice
{
  uint64_t state;
} dice;

static inline dice dice_seeded(uint64_t seed)
{
  dice made = { seed };
  print_message("seed %u\n", (unsigned)seed);
  return made;
}

static inline double dice_roll(dice* from, double low, double high)
{
  from->state = from->state * 6364136223846793005u + 1442695040888963407u;
  return low + (high - low) * (double)(from->state >> 11) / 9007199254740992.0; // 2^53
}

static inline void dice_dir(dice* from, double dir[3])
{
  double length = 0.0;
  while (length < 0.1 || length > 1.0)
  {
    for (int i = 0; i < 3; ++i)
    {
      dir[i] = dice_roll(from, -1.0, 1.0);
    }
    length = sqrt(dir[0] * dir[0] + dir[1] * dir[1] + dir[2] * dir[2]);
  }
  for (int i = 0; i < 3; ++i)
  {
    dir[i] /= length;
  }
}

static inline double dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double c[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void normalise(double a[3])
{
  const double length = sqrt(dot(a, a));
  for (int i = 0; i < 3; ++i)
  {
    a[i] /= length;
  }
}

static inline double determinant3(const double m[16])
{
  double yz[3];
  cross(m + 4, m + 8, yz);
  return dot(m, yz);
}

static inline void apply(const double m[16], const double v[3], double w, double out[4])
{
  for (int i = 0; i < 4; ++i)
  {
    out[i] = m[4 * i] * v[0] + m[4 * i + 1] * v[1] + m[4 * i + 2] * v[2] + m[4 * i + 3] * w;
  }
}

// World to clip through the view first, as precise as a test can be.
static inline void project(const water_camera* camera, const double v[3], double w, double out[4])
{
  double view[4];
  apply(camera->world_to_view, v, w, view);
  apply(camera->view_to_clip, view, view[3], out);
}

static inline int is_inside(const double clip[4])
{
  return fabs(clip[0]) <= clip[3] && fabs(clip[1]) <= clip[3] && fabs(clip[2]) <= clip[3];
}

// gluLookAt
static inline void look_at(
  const double eye[3], const double target[3], const double up[3], double m[16])
{
  double back[3];
  double right[3];
  double above[3];
  for (int i = 0; i < 3; ++i)
  {
    back[i] = eye[i] - target[i];
  }
  normalise(back);
  cross(up, back, right);
  normalise(right);
  cross(back, right, above);
  const double* rows[3] = { right, above, back };
  for (int i = 0; i < 3; ++i)
  {
    memcpy(m + 4 * i, rows[i], 3 * sizeof(double));
    m[4 * i + 3] = -dot(rows[i], eye);
    m[12 + i] = 0.0;
  }
  m[15] = 1.0;
}

// glFrustum: box is left, right, bottom, top on the near plane
static inline void frustum_matrix(const double box[4], double near_z, double far_z, double m[16])
{
  memset(m, 0, 16 * sizeof(double));
  m[0] = 2.0 * near_z / (box[1] - box[0]);
  m[2] = (box[1] + box[0]) / (box[1] - box[0]);
  m[5] = 2.0 * near_z / (box[3] - box[2]);
  m[6] = (box[3] + box[2]) / (box[3] - box[2]);
  m[10] = -(far_z + near_z) / (far_z - near_z);
  m[11] = -2.0 * far_z * near_z / (far_z - near_z);
  m[14] = -1.0;
}

// glOrtho
static inline void ortho_matrix(const double box[4], double near_z, double far_z, double m[16])
{
  memset(m, 0, 16 * sizeof(double));
  m[0] = 2.0 / (box[1] - box[0]);
  m[3] = -(box[1] + box[0]) / (box[1] - box[0]);
  m[5] = 2.0 / (box[3] - box[2]);
  m[7] = -(box[3] + box[2]) / (box[3] - box[2]);
  m[10] = -2.0 / (far_z - near_z);
  m[11] = -(far_z + near_z) / (far_z - near_z);
  m[15] = 1.0;
}

// Lets an eye in perspective see a scene; box as in frustum_matrix.
static inline void see_from(water_scene* scene, const double eye[3], const double target[3],
  const double up[3], const double box[4], double near_z, double far_z)
{
  look_at(eye, target, up, scene->eye.world_to_view);
  frustum_matrix(box, near_z, far_z, scene->eye.view_to_clip);
}

// A lake z = 0 of 20 x 20 with an eye 5 over it, 800 x 600 pixels, 90 degrees high.
static inline water_scene lake(void)
{
  water_scene scene;
  memset(&scene, 0, sizeof scene);
  const double eye[3] = { 0.0, -10.0, 5.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double box[4] = { -4.0 / 3.0, 4.0 / 3.0, -1.0, 1.0 };
  const double bounds[6] = { -10.0, 10.0, -10.0, 10.0, 0.0, 0.0 };
  see_from(&scene, eye, target, up, box, 1.0, 1000.0);
  scene.viewport_px[0] = 800;
  scene.viewport_px[1] = 600;
  scene.plane.normal[2] = 1.0;
  memcpy(scene.surface_bounds, bounds, sizeof bounds);
  scene.look.index_of_refraction = 1.333;
  scene.settings.texture_scale = 1.0;
  scene.max_texture_px = 16384;
  scene.max_samples = 32;
  scene.settings.skips = WATER_MAY_SKIP_ALL;
  return scene;
}

// A pond seen straight down from 10 above its middle, half a field of view of 45 degrees.
static inline water_scene pool(double half)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, 10.0 };
  const double target[3] = { 0.0, 0.0, 0.0 };
  const double up[3] = { 0.0, 1.0, 0.0 };
  const double box[4] = { -1.0, 1.0, -1.0, 1.0 };
  see_from(&scene, eye, target, up, box, 1.0, 1000.0);
  for (int i = 0; i < 4; ++i)
  {
    scene.surface_bounds[i] = i % 2 ? half : -half;
  }
  return scene;
}

// A random scene that must be planned: any plane, eye on either side of it, looking at a point of
// the water near `center`; perspective, off-axis and parallel in turn.
typedef struct random_scene
{
  water_scene scene;
  double eye[3];
  double view_dir[3]; // unit length
  double target[3];   // on the water
  double normal[3];   // unit length, towards the eye
  int is_parallel;
} random_scene;

static inline random_scene scene_rolled(dice* from, int number, const double center[3])
{
  random_scene made;
  memset(&made, 0, sizeof made);
  made.scene = lake();
  made.is_parallel = number % 3 == 2;
  double normal[3];
  double arm[3];
  double up[3];
  dice_dir(from, normal);
  dice_dir(from, up);
  do
  {
    dice_dir(from, arm); // not within 3 degrees of the surface, nor of up
  } while (fabs(dot(arm, normal)) < 0.05 || fabs(dot(arm, up)) > 0.95);
  const double scale = dice_roll(from, 0.1, 10.0); // of the plane's normal as the user gives it
  const double side = dot(arm, normal) > 0.0 ? 1.0 : -1.0;
  const double distance = dice_roll(from, 3.0, 30.0);
  for (int i = 0; i < 3; ++i)
  {
    made.target[i] = center[i] + dice_roll(from, -1.0, 1.0);
    made.eye[i] = made.target[i] + distance * arm[i];
    made.view_dir[i] = -arm[i];
    made.normal[i] = side * normal[i];
    made.scene.plane.normal[i] = scale * normal[i];
    made.scene.surface_bounds[2 * i] = made.target[i] - 8.0;
    made.scene.surface_bounds[2 * i + 1] = made.target[i] + 8.0;
  }
  made.scene.plane.offset = -scale * dot(normal, made.target);
  look_at(made.eye, made.target, up, made.scene.eye.world_to_view);
  const double size = made.is_parallel ? distance : 1.0;
  const double shift_x = number % 3 == 1 ? dice_roll(from, -0.4, 0.4) : 0.0;
  const double shift_y = number % 3 == 1 ? dice_roll(from, -0.4, 0.4) : 0.0;
  const double box[4] = { (shift_x - 0.8) * size, (shift_x + 0.8) * size, (shift_y - 0.6) * size,
    (shift_y + 0.6) * size };
  if (made.is_parallel)
  {
    ortho_matrix(box, 0.5, 100.0, made.scene.eye.view_to_clip);
    made.scene.eye.parallel = true;
  }
  else
  {
    frustum_matrix(box, 1.0, 100.0, made.scene.eye.view_to_clip);
  }
  return made;
}

// Signed distance from the water, towards the eye; exact for large worlds, as it starts at the
// target.
static inline double height_of(const random_scene* random, const double point[3])
{
  const double arm[3] = { point[0] - random->target[0], point[1] - random->target[1],
    point[2] - random->target[2] };
  return dot(random->normal, arm);
}

static inline void mirror_image(const random_scene* random, const double point[3], double out[3])
{
  const double twice = 2.0 * height_of(random, point);
  for (int i = 0; i < 3; ++i)
  {
    out[i] = point[i] - twice * random->normal[i];
  }
}

static inline void point_near(dice* from, const random_scene* random, double reach, double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] = random->target[i] + dice_roll(from, -reach, reach);
  }
}

// One of 64 points of a box, spread over all of it.
static inline void box_point(const double bounds[6], int number, double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    const double part = ((number >> (2 * i)) & 3) / 3.0;
    point[i] = (1.0 - part) * bounds[2 * i] + part * bounds[2 * i + 1];
  }
}

// Where the reflection texture shows a point, in pixels from the corner of the rectangle that is
// drawn.
static inline void map_place(
  const water_plan* plan, const double point[3], double clip[4], double px[2])
{
  project(&plan->mirrored, point, 1.0, clip);
  for (int i = 0; i < 2; ++i)
  {
    px[i] = 0.5 * (1.0 + clip[i] / clip[3]) * plan->texture_px[i] - plan->texture_rect_px[i];
  }
}

static inline water_plan plan_of(const water_scene* scene, water_cull_reason* reasons)
{
  water_plan plan;
  assert_string_equal(water_status_text(water_plan_make(scene, &plan, reasons)), "no error");
  return plan;
}

#endif
