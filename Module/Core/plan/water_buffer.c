// SPDX-License-Identifier: BSD-3-Clause
// water_buffer.c: whether a user's mesh is shaded once per pixel.
#include "water_buffer.h"

#include "water_math.h"

enum
{
  CELLS = 16,      // of the mesh's rectangle, along each side
  BLOCK_WIDTH = 4, // pixels that llvmpipe shades together, with AVX2
  BLOCK_HEIGHT = 2
};

static const double most_samples_of_all = 16e6; // of a picture: 0.8 GB of buffer
static const double pays = 2.0;                 // times as many runs: the buffer itself takes some
static const double pays_opaque = 6.0; // the same for the shorter shader of water that is not clear
static const double least = 0.02;      // runs per pixel of the picture that are not worth a buffer

// Looks with a long shader: others are a lookup at the pixel's place.
static const water_feature_set long_features = WATER_FEATURE_FLAG(RAY_TRACED) |
  WATER_FEATURE_FLAG(OFFSET) | WATER_FEATURE_FLAG(MEDIUM) | WATER_FEATURE_FLAG(WAVES);
// What a buffer does not have.
static const water_feature_set other_features = WATER_FEATURE_FLAG(HULLS) |
  WATER_FEATURE_FLAG(FLOW) | WATER_FEATURE_FLAG(MATTER) | WATER_FEATURE_FLAG(FOAM_DATA) |
  WATER_FEATURE_FLAG(PORT) | WATER_FEATURE_FLAG(OUTPUT);

double water_buffer_runs(double triangle_count, double area_px, int samples)
{
  // a triangle of random place and direction, half of a square: Minkowski's sum of it and a block
  const double side = sqrt(2.0 * area_px);
  const double blocks =
    1.0 + side / BLOCK_WIDTH + side / BLOCK_HEIGHT + area_px / (BLOCK_WIDTH * BLOCK_HEIGHT);
  const double shaded = fmin(1.0, area_px * fmax(samples, 1));
  return triangle_count * shaded * blocks * BLOCK_WIDTH * BLOCK_HEIGHT;
}

// Pixels of a place on the plane, from the picture's middle; false: it is behind the eye.
static bool to_picture(const water_buffer_input* input, double x, double y, double place_px[2])
{
  const double* rows = input->plan->dir_to_eye;
  const double from_eye[3] = { x - input->plan->origin_xy[0], y - input->plan->origin_xy[1],
    -input->plan->plane_view[3] };
  const double w = water_vec3_dot(rows + 9, from_eye);
  if (!(w > 0.0))
  {
    return false;
  }
  for (int i = 0; i < 2; ++i)
  {
    place_px[i] = 0.5 * input->viewport_px[i] * water_vec3_dot(rows + 3 * i, from_eye) / w;
  }
  return true;
}

// Area of a cell in the picture, 0 out of view; infinite if a part of it is behind the eye.
static double cell_area(const water_buffer_input* input, int column, int row)
{
  const double* sheet = input->sheet;
  const double step[2] = { (sheet[1] - sheet[0]) / CELLS, (sheet[3] - sheet[2]) / CELLS };
  const double x = sheet[0] + column * step[0];
  const double y = sheet[2] + row * step[1];
  double middle[2];
  if (!to_picture(input, x + 0.5 * step[0], y + 0.5 * step[1], middle) ||
    fabs(middle[0]) > 0.5 * input->viewport_px[0] || fabs(middle[1]) > 0.5 * input->viewport_px[1])
  {
    return 0.0;
  }
  double corners[4][2];
  for (int i = 0; i < 4; ++i)
  {
    if (!to_picture(
          input, x + (i == 1 || i == 2 ? step[0] : 0.0), y + (i >= 2 ? step[1] : 0.0), corners[i]))
    {
      return (double)INFINITY;
    }
  }
  const double* a = corners[0];
  const double* b = corners[1];
  const double* c = corners[2];
  const double* d = corners[3];
  return 0.5 * fabs((c[0] - a[0]) * (d[1] - b[1]) - (c[1] - a[1]) * (d[0] - b[0]));
}

static bool has_small_triangles(const water_buffer_input* input)
{
  const double picture = (double)input->viewport_px[0] * input->viewport_px[1];
  const double count = input->triangle_count / (CELLS * CELLS);
  double covered = 0.0;
  double runs = 0.0;
  for (int i = 0; i < CELLS * CELLS; ++i)
  {
    const double area = fmin(cell_area(input, i % CELLS, i / CELLS), picture);
    covered += area;
    runs += water_buffer_runs(count, area / count, input->samples);
  }
  const bool is_clear = (input->features & WATER_FEATURE_MEDIUM) != 0;
  return runs > (is_clear ? pays : pays_opaque) * fmin(covered, picture) + least * picture;
}

water_buffer_use water_buffer_judge(const water_buffer_input* input)
{
  const water_plan* plan = input->plan;
  const double samples = fmax(input->samples, 1);
  if (!input->is_on)
  {
    return WATER_BUFFER_OFF;
  }
  if (!input->is_software)
  {
    return WATER_BUFFER_HARDWARE;
  }
  if (!input->is_plain_draw || !plan)
  {
    return WATER_BUFFER_OTHER_DRAW;
  }
  if ((input->features & WATER_FEATURE_MESH) == 0 || !(input->triangle_count > 0.0))
  {
    return WATER_BUFFER_NO_MESH;
  }
  if ((input->features & other_features) != 0)
  {
    return WATER_BUFFER_FEATURE;
  }
  if ((input->features & long_features) == 0)
  {
    return WATER_BUFFER_SHORT_SHADER;
  }
  if (plan->clip_w[2] == 0.0)
  {
    return WATER_BUFFER_PARALLEL;
  }
  if (plan->is_submerged || plan->is_awash)
  {
    return WATER_BUFFER_SUBMERGED;
  }
  if (samples > WATER_BUFFER_SAMPLES_MAX ||
    (double)input->viewport_px[0] * input->viewport_px[1] * samples > most_samples_of_all)
  {
    return WATER_BUFFER_SIZE;
  }
  return has_small_triangles(input) ? WATER_BUFFER_IN_USE : WATER_BUFFER_LARGE_TRIANGLES;
}

const char* water_buffer_text(water_buffer_use use)
{
  static const char* const texts[] = {
#define WATER_BUFFER_TEXT(name, text) text,
    WATER_BUFFER_LIST(WATER_BUFFER_TEXT)
#undef WATER_BUFFER_TEXT
  };
  return (unsigned)use < WATER_BUFFER_COUNT ? texts[use] : "unknown";
}
