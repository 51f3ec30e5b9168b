// SPDX-License-Identifier: BSD-3-Clause
// test_horizon.h: views of endless planes, for the tests of their sheets and plans.
#ifndef test_horizon_h
#define test_horizon_h

#include "test_scene.h"

// Where the view ray of a place in NDC meets the plane, for a camera of scene_rolled.
//
// Returns how far along the ray that is, over the eye's height; below 0: it does not meet it.
static inline double meet(const random_scene* random, const double ndc[2], double point[3])
{
  const double* to_clip = random->scene.eye.view_to_clip;
  const double* rows = random->scene.eye.world_to_view;
  double base[3];
  double ray[3];
  for (int k = 0; k < 3; ++k)
  {
    double sum[2] = { 0.0, 0.0 };
    for (int i = 0; i < 2; ++i)
    {
      const double shift = random->is_parallel ? -to_clip[4 * i + 3] : to_clip[4 * i + 2];
      sum[random->is_parallel ? 0 : 1] += (ndc[i] + shift) / to_clip[5 * i] * rows[4 * i + k];
    }
    base[k] = random->eye[k] + sum[0];
    ray[k] = sum[1] - rows[8 + k];
  }
  const double height = height_of(random, base);
  const double fall = -dot(random->normal, ray);
  for (int k = 0; k < 3; ++k)
  {
    point[k] = base[k] + height / fall * ray[k];
  }
  return random->is_parallel ? 1.0 : 1.0 / fall;
}

// A frustum as that of lake(), with other depths.
static inline void set_depths(water_scene* scene, double near_z, double far_z)
{
  const double box[4] = { -4.0 / 3.0 * near_z, 4.0 / 3.0 * near_z, -near_z, near_z };
  frustum_matrix(box, near_z, far_z, scene->eye.view_to_clip);
}

// An eye over a level plane, looking along it.
static inline water_scene shore(double height, double pitch)
{
  water_scene scene = lake();
  const double eye[3] = { 0.0, 0.0, height };
  const double target[3] = { 0.0, height, height * (1.0 + pitch) };
  const double up[3] = { 0.0, 0.0, 1.0 };
  look_at(eye, target, up, scene.eye.world_to_view);
  return scene;
}

#endif
