// SPDX-License-Identifier: BSD-3-Clause
// test_baths.h: eyes over a bed with a sun, and where rays, followed through the world, say that
// the texture and the grid of caustics must lie.
#ifndef test_baths_h
#define test_baths_h

#include "test_scene.h"

#include "water_caustics.h"
#include "water_caustics_plan.h"

static const double pi = 3.141592653589793;

// An eye over the plane z = 0, its bed and its sun.
typedef struct bath
{
  double eye[3];
  double target[3];
  double up[3];
  double half[2]; // of the picture, at a distance of 1; in parallel: its half sides
  bool is_parallel;
  double depth;
  double sun_deg[2]; // height, turn
  water_caustics_input input;
} bath;

// By the order of the fields above. The fifth and the sixth see the horizon; the sixth lies on its
// side, with the water at the left.
static const bath baths[] = {
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1.2, 0.9 }, false, 3.0, { 50, 25 },
    { 1.333, 0.1, 0.05, { 400, 300 }, 16384, true } },
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 400, 300 }, 16384, false } },
  { { 3, -9, 7 }, { 4, 1, 0 }, { 0, 0, 1 }, { 8, 6 }, true, 20.0, { 60, 120 },
    { 1.4, 0.05, 0.0, { 300, 400 }, 16384, false } },
  { { 0, -6, 9 }, { 2, 0, 0 }, { 0, 0, 1 }, { 0.5, 0.4 }, false, 4.0, { 30, 310 },
    { 1.333, 0.05, 0.05, { 500, 400 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 4 }, { 0, 0, 1 }, { 0.8, 0.6 }, false, 2.0, { 35, 80 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 5 }, { 1, 0, 0 }, { 0.6, 0.8 }, false, 1.0, { 70, 10 },
    { 1.333, 0.05, 0.1, { 600, 800 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 5 }, { -1, 0, 0 }, { 0.6, 0.8 }, false, 1.0, { 70, 100 },
    { 1.333, 0.05, 0.1, { 600, 800 }, 16384, false } },
  // deeper than light comes back from; than four heights of the eye
  { { 0, 0, 20 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.3, 0.4 }, false, 90.0, { 20, 45 },
    { 1.333, 0.15, 0.2, { 90, 120 }, 16384, false } },
  { { 0, 0, 2 }, { 0.3, 0, 0 }, { 0, 1, 0 }, { 0.5, 0.5 }, false, 90.0, { 25, 60 },
    { 1.333, 0.2, 0.0, { 256, 256 }, 16384, false } },
  // a picture and a texture of the smallest sizes
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 1, 1 }, 16384, false } },
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 3.0, { 40, 200 },
    { 1.333, 0.1, 0.05, { 400, 3 }, 64, false } },
  // a picture so large that sides of 4096 are too small
  { { 1, 2, 10 }, { 1, 2, 0 }, { 0, 1, 0 }, { 8, 6 }, true, 0.1, { 40, 200 },
    { 1.333, 0.1, 0.05, { 9000, 8000 }, 16384, false } },
  // so steep that the grid is much wider than the texture, and both as large as they may be
  { { 0, 0, 10 }, { 0, 0, 0 }, { 0, 1, 0 }, { 1, 1 }, true, 3.0, { 15, 45 },
    { 1.333, 0.6, 0.05, { 100, 100 }, 64, false } },
  // the horizon across the picture, tilted to either side, and upside down
  { { 0, -10, 5 }, { 0, 0, 3 }, { 0.5, 0, 1 }, { 0.8, 0.6 }, false, 2.0, { 35, 80 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 3 }, { -0.5, 0, 1 }, { 0.8, 0.6 }, false, 2.0, { 35, 200 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 3 }, { 0.4, 0, -1 }, { 0.8, 0.6 }, false, 2.0, { 35, 80 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
  { { 0, -10, 5 }, { 0, 0, 3 }, { -0.4, 0, -1 }, { 0.8, 0.6 }, false, 2.0, { 35, 200 },
    { 1.333, 0.02, 0.1, { 800, 600 }, 16384, false } },
};

enum
{
  BATHS = sizeof baths / sizeof baths[0]
};

static inline void sun_of(const bath* of, double sun_dir[3])
{
  const double height = of->sun_deg[0] * pi / 180.0;
  const double turn = of->sun_deg[1] * pi / 180.0;
  sun_dir[0] = cos(height) * cos(turn);
  sun_dir[1] = cos(height) * sin(turn);
  sun_dir[2] = sin(height);
}

static inline water_plan plan_for(const bath* of)
{
  water_scene scene = lake();
  water_cull_reason reasons[8];
  const double box[4] = { -of->half[0], of->half[0], -of->half[1], of->half[1] };
  see_from(&scene, of->eye, of->target, of->up, box, 1.0, 1000.0);
  if (of->is_parallel)
  {
    ortho_matrix(box, 1.0, 1000.0, scene.eye.view_to_clip);
    scene.eye.parallel = true;
  }
  water_plan plan = plan_of(&scene, reasons);
  plan.bed_depth = of->depth;
  plan.has_sun = true;
  sun_of(of, plan.sun_dir);
  return plan;
}

// What light goes aside in calm water, per depth: the tangent of the angle by Snell's law, away
// from where it comes from.
static inline void snell(const double to_light[3], double index, double way[2])
{
  const double sine = hypot(to_light[0], to_light[1]) / index;
  const double tangent = sine / sqrt(1.0 - sine * sine);
  for (int i = 0; i < 2; ++i)
  {
    way[i] = sine > 0.0 ? -to_light[i] / (index * sine) * tangent : 0.0;
  }
}

// The camera in the world.
typedef struct lens
{
  const bath* of;
  double world_to_view[16]; // rows: right, above, back
} lens;

static inline lens lens_of(const bath* of)
{
  lens made = { of, { 0.0 } };
  look_at(of->eye, of->target, of->up, made.world_to_view);
  return made;
}

// The ray of a pixel, as long as the picture is away.
static inline void ray_at(const lens* eye, const double ndc[2], double start[3], double dir[3])
{
  const double* m = eye->world_to_view;
  for (int i = 0; i < 3; ++i)
  {
    const double aside = ndc[0] * eye->of->half[0] * m[i] + ndc[1] * eye->of->half[1] * m[4 + i];
    start[i] = eye->of->eye[i] + (eye->of->is_parallel ? aside : 0.0);
    dir[i] = -m[8 + i] + (eye->of->is_parallel ? 0.0 : aside);
  }
}

// Where the straight ray of a pixel is at a depth, from the point under the eye on.
static inline void straight_place(
  const lens* eye, const double ndc[2], double depth, double place[2])
{
  double start[3];
  double dir[3];
  ray_at(eye, ndc, start, dir);
  for (int i = 0; i < 2; ++i)
  {
    place[i] = start[i] + dir[i] * (start[2] + depth) / -dir[2] - eye->of->eye[i];
  }
}

static inline double widest_turn(const double to_light[3], double index)
{
  double turn[3];
  water_caustics_turn(to_light, index, turn);
  return fmax(turn[0], turn[2]);
}

// What must come out.
typedef struct answer
{
  double depth;
  double middle;
  double pixel;     // of the picture at a distance of 1
  double near_fall; // of a ray, as long as the picture is away: who falls less is too far away
  double way[2];    // of the sun's light
  double light[4];  // in NDC, low x, low y, high x, high y: the texture
  double grid[4];
} answer;

// Takes the bed of a pixel into the box.
static inline void add_bed(const lens* eye, const answer* known, const double ndc[2], double depth,
  double reach, double box[4])
{
  const bath* of = eye->of;
  double sun_dir[3];
  double start[3];
  double dir[3];
  double way[2];
  double place[2];
  sun_of(of, sun_dir);
  ray_at(eye, ndc, start, dir);
  normalise(dir);
  const double to_eye[3] = { -dir[0], -dir[1], -dir[2] };
  snell(to_eye, of->input.index, way);
  straight_place(eye, ndc, 0.0, place);
  const double sight = 2.5 * of->input.slope_rms *
    fmin(widest_turn(to_eye, of->input.index), widest_turn(sun_dir, of->input.index));
  const double moves = depth * hypot(reach, sight);
  for (int corner = 0; corner < 4; ++corner)
  {
    const double side[2] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0 };
    double at[3] = { 0.0, 0.0, -known->middle };
    for (int i = 0; i < 2; ++i)
    {
      const double bed = of->eye[i] + place[i] + depth * way[i] + side[i] * moves;
      at[i] = bed - depth * known->way[i] + known->middle * known->way[i];
    }
    double view[4];
    apply(eye->world_to_view, at, 1.0, view);
    for (int i = 0; i < 2; ++i)
    {
      const double seen = view[i] / of->half[i] / (of->is_parallel ? 1.0 : fmax(-view[2], 1e-12));
      box[i] = fmin(box[i], fmax(seen, -4.0));
      box[2 + i] = fmax(box[2 + i], fmin(seen, 4.0));
    }
  }
}

static inline double fall_at(const lens* eye, const double ndc[2])
{
  double start[3];
  double dir[3];
  ray_at(eye, ndc, start, dir);
  return -dir[2];
}

// The bed of the picture's four sides, each in four steps, as far as its pixels are near.
static inline void find_bed(const lens* eye, const answer* known, double reach, double box[4])
{
  box[0] = box[1] = (double)INFINITY;
  box[2] = box[3] = -(double)INFINITY;
  for (int side = 0; side < 4; ++side)
  {
    const double fixed = side % 2 ? 1.0 : -1.0;
    double ends[2] = { -1.0, 1.0 };
    double ndc[2] = { fixed, fixed };
    const int along = side / 2;
    bool is_near[2];
    for (int k = 0; k < 2; ++k)
    {
      ndc[along] = ends[k];
      is_near[k] = fall_at(eye, ndc) >= known->near_fall;
    }
    if (!is_near[0] && !is_near[1])
    {
      continue;
    }
    if (is_near[0] != is_near[1]) // halve until the border is found
    {
      double near = is_near[0] ? -1.0 : 1.0;
      double far = -near;
      for (int step = 0; step < 60; ++step)
      {
        ndc[along] = 0.5 * (near + far);
        *(fall_at(eye, ndc) >= known->near_fall ? &near : &far) = ndc[along];
      }
      ends[is_near[0] ? 1 : 0] = near;
    }
    for (int step = 0; step <= 4; ++step)
    {
      ndc[along] = ends[0] + 0.25 * step * (ends[1] - ends[0]);
      add_bed(eye, known, ndc, 0.0, reach, box);
      add_bed(eye, known, ndc, known->depth, reach, box);
    }
  }
}

static inline answer answer_for(const lens* eye)
{
  const bath* of = eye->of;
  const double height = of->eye[2];
  answer known = { .depth = of->depth };
  double sun_dir[3];
  sun_of(of, sun_dir);
  snell(sun_dir, of->input.index, known.way);
  if (of->input.extinction > 0.0) // on both ways together a 256th of the light is left
  {
    known.depth = fmin(known.depth, 0.5 * log(256.0) / of->input.extinction);
  }
  known.depth = of->is_parallel ? known.depth : fmin(known.depth, 4.0 * height);
  known.middle =
    of->is_parallel ? 0.5 * known.depth : sqrt(height * (height + known.depth)) - height;
  known.pixel = 2.0 * of->half[1] / of->input.viewport_px[1];
  if (!of->is_parallel)
  {
    // a pixel is three depths wide, in the direction of the longest ray
    double longest = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      const double ndc[2] = { corner % 2 ? 1.0 : -1.0, corner / 2 ? 1.0 : -1.0 };
      double start[3];
      double dir[3];
      ray_at(eye, ndc, start, dir);
      longest = fmax(longest, hypot(dir[0], dir[1]));
    }
    known.near_fall = height * longest / sqrt(3.0 * known.depth * height / known.pixel);
  }
  find_bed(eye, &known, 0.0, known.light);
  find_bed(
    eye, &known, 2.5 * of->input.slope_rms * widest_turn(sun_dir, of->input.index), known.grid);
  return known;
}

#endif
