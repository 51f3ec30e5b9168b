// SPDX-License-Identifier: BSD-3-Clause
// water_rank_layers.c: what ranks have blended, in the order of its depth.
#include "water_rank_pixels.h"

#include "water_math.h"

#include <string.h>

static void over_bytes(const uint32_t* front, uint32_t* back)
{
  unsigned char source[4];
  unsigned char result[4];
  memcpy(source, front, 4);
  memcpy(result, back, 4);
  const unsigned int through = 255u - source[3];
  for (int i = 0; i < 4; ++i)
  {
    const unsigned int sum = source[i] + (result[i] * through + 127u) / 255u;
    result[i] = (unsigned char)(sum > 255u ? 255u : sum);
  }
  memcpy(back, result, 4);
}

static void over_floats(const uint32_t front[4], uint32_t back[4])
{
  float source[4];
  float result[4];
  memcpy(source, front, sizeof source);
  memcpy(result, back, sizeof result);
  for (int i = 0; i < 4; ++i)
  {
    result[i] = source[i] + result[i] * (1.0f - source[3]);
  }
  memcpy(back, result, sizeof result);
}

void water_rank_pixels_over(const uint32_t* front, size_t words, size_t pixel_count, uint32_t* back)
{
  for (size_t i = 0; i < pixel_count; ++i)
  {
    if (words == 1)
    {
      over_bytes(front + i, back + i);
    }
    else
    {
      over_floats(front + 4 * i, back + 4 * i);
    }
  }
}

// Is there a plane across an axis with the first box and the eye on one side, the second box on the
// other?
static bool may_be_first(const double first[6], const double second[6], const double eye[3],
  const double direction[3], bool is_parallel)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* a = first + 2 * axis;
    const double* b = second + 2 * axis;
    const bool is_below =
      a[1] <= b[0] && (is_parallel ? direction[axis] >= 0.0 : eye[axis] <= b[0]);
    const bool is_above =
      b[1] <= a[0] && (is_parallel ? direction[axis] <= 0.0 : eye[axis] >= b[1]);
    if (is_below || is_above)
    {
      return true;
    }
  }
  return false;
}

// Must the first box be blended over the second one? If either may be first, no ray meets both.
static bool hides(const double first[6], const double second[6], const double eye[3],
  const double direction[3], bool is_parallel)
{
  return may_be_first(first, second, eye, direction, is_parallel) &&
    !may_be_first(second, first, eye, direction, is_parallel);
}

// How far away a box is, along the view or from the eye; an empty one is behind all.
static double centre_distance(
  const double box[6], const double eye[3], const double direction[3], bool is_parallel)
{
  double along = 0.0;
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double off = 0.5 * (box[2 * axis] + box[2 * axis + 1]) - eye[axis];
    along += off * direction[axis];
    square += off * off;
  }
  return water_bounds_is_empty(box) ? (double)INFINITY : is_parallel ? along : sqrt(square);
}

void water_rank_pixels_order(const double (*bounds)[6], size_t box_count, const double eye[3],
  const double focal_point[3], bool is_parallel, size_t* order, size_t* blockers)
{
  const double direction[3] = { focal_point[0] - eye[0], focal_point[1] - eye[1],
    focal_point[2] - eye[2] };
  const size_t taken = SIZE_MAX;
  for (size_t i = 0; i < box_count; ++i)
  {
    const bool is_empty = water_bounds_is_empty(bounds[i]);
    blockers[i] = is_empty ? box_count : 0; // more than any other has
    for (size_t j = 0; j < box_count && !is_empty; ++j)
    {
      blockers[i] += j != i && !water_bounds_is_empty(bounds[j]) &&
        hides(bounds[j], bounds[i], eye, direction, is_parallel);
    }
  }
  for (size_t next = 0; next < box_count; ++next)
  {
    size_t best = box_count;
    double best_distance = (double)INFINITY;
    for (size_t i = 0; i < box_count; ++i)
    {
      const double distance = centre_distance(bounds[i], eye, direction, is_parallel);
      if (blockers[i] != taken &&
        (best == box_count || blockers[i] < blockers[best] ||
          (blockers[i] == blockers[best] && distance < best_distance)))
      {
        best = i;
        best_distance = distance;
      }
    }
    order[next] = best;
    blockers[best] = taken;
    for (size_t i = 0; i < box_count && !water_bounds_is_empty(bounds[best]); ++i)
    {
      blockers[i] -= blockers[i] != taken && !water_bounds_is_empty(bounds[i]) &&
        hides(bounds[best], bounds[i], eye, direction, is_parallel);
    }
  }
}
