// SPDX-License-Identifier: BSD-3-Clause
// water_visibility.c: which cells of the reflection texture visible water looks up.
#include "water_visibility.h"

#include "water_math.h"
#include "water_prop.h"

// The GPU places a vertex, and the surface its lookup, to a fraction of a pixel.
static const double rounding_px = 0.25;

void water_visibility_begin(const int texture_px[2], const int rect_px[4], water_visibility* seen)
{
  memcpy(seen->texture_px, texture_px, sizeof seen->texture_px);
  memcpy(seen->rect_px, rect_px, sizeof seen->rect_px);
  seen->cell_px = 1;
  do
  {
    ++seen->cell_px;
    for (int i = 0; i < 2; ++i)
    {
      seen->size[i] = (rect_px[2 + i] + seen->cell_px - 1) / seen->cell_px;
    }
  } while ((double)seen->size[0] * seen->size[1] > (double)WATER_VISIBILITY_CELLS_MAX);
}

void water_visibility_walk_of(const int texture_px[2], const int rect_px[4],
  const int viewport_px[2], int cell_px, water_visibility_walk* walk)
{
  for (int i = 0; i < 2; ++i)
  {
    const double ratio = (double)viewport_px[i] / texture_px[i];
    // a pixel between four texels looks up all of them
    const double filter = texture_px[i] == viewport_px[i] ? 0.0 : 0.5 * ratio + 0.5;
    walk->first[i] = rect_px[i] * ratio - filter;
    walk->step[i] = cell_px * ratio;
    walk->pixel[i] = 2.0 / viewport_px[i];
    walk->size[i] = (int)ceil(walk->step[i] + 2.0 * filter) + (filter > 0.0);
  }
}

static int clamped(double place, int count)
{
  return (int)fmin(fmax(floor(place), 0.0), count - 1);
}

void water_visibility_rows(const water_visibility* seen, const int viewport_px[2], int rows[2])
{
  water_visibility_walk walk;
  water_visibility_walk_of(seen->texture_px, seen->rect_px, viewport_px, seen->cell_px, &walk);
  const double last = floor(walk.first[1] + walk.step[1] * (seen->size[1] - 1)) + walk.size[1] - 1;
  rows[0] = clamped(walk.first[1], viewport_px[1]);
  rows[1] = clamped(last, viewport_px[1]) - rows[0] + 1;
}

void water_visibility_mark(const water_visibility* seen, const int viewport_px[2], bool is_endless,
  const double plane_clip[4], double rounding, const int rows[2], const float* depths,
  int32_t* work, uint8_t* cells)
{
  const int width = viewport_px[0];
  water_visibility_walk walk;
  water_visibility_walk_of(seen->texture_px, seen->rect_px, viewport_px, seen->cell_px, &walk);
  // in single precision, which the rounding is for: several pixels at once
  const float by_depth = (float)(2.0 * plane_clip[2]);
  const float by_x = (float)(plane_clip[0] * walk.pixel[0]);
  const float limit = (float)rounding;
  const float background = is_endless ? 1.0f : FLT_MAX;
  for (int y = 0; y < seen->size[1]; ++y)
  {
    const double bottom = floor(walk.first[1] + walk.step[1] * y);
    memset(work, 0, (size_t)width * sizeof *work);
    for (int i = 0; i < walk.size[1]; ++i)
    {
      const int row = clamped(bottom + i, viewport_px[1]);
      const float* depth = depths + (size_t)(row - rows[0]) * (size_t)width;
      const float start = (float)(plane_clip[0] * (0.5 * walk.pixel[0] - 1.0) +
        plane_clip[1] * ((row + 0.5) * walk.pixel[1] - 1.0) - plane_clip[2] + plane_clip[3]);
      for (int x = 0; x < width; ++x)
      {
        work[x] |=
          (start + by_x * (float)x + by_depth * depth[x] <= limit) | (depth[x] >= background);
      }
    }
    for (int x = 0; x < seen->size[0]; ++x)
    {
      const double left = floor(walk.first[0] + walk.step[0] * x);
      int32_t is_open = 0;
      for (int i = 0; i < walk.size[0]; ++i)
      {
        is_open |=
          work[width - 1 - clamped(left + i, width)]; // the reflection texture is flipped in x
      }
      *cells++ = (uint8_t)is_open;
    }
  }
}

void water_visibility_sum(water_visibility* seen, const uint8_t* cells)
{
  const size_t width = (size_t)seen->size[0];
  const size_t height = (size_t)seen->size[1];
  memset(seen->counts, 0, (width + 1) * sizeof *seen->counts);
  for (size_t y = 0; y < height; ++y)
  {
    const uint32_t* below = seen->counts + y * (width + 1);
    uint32_t* row = seen->counts + (y + 1) * (width + 1);
    uint32_t count = 0;
    row[0] = 0;
    for (size_t x = 0; x < width; ++x)
    {
      count += cells[y * width + x] != 0;
      row[x + 1] = below[x + 1] + count;
    }
  }
}

// Is any of the cells looked up, from the first to before the end?
static bool has_open(const water_visibility* seen, const size_t first[2], const size_t end[2])
{
  const size_t width = (size_t)seen->size[0] + 1;
  const uint32_t* top = seen->counts + end[1] * width;
  const uint32_t* bottom = seen->counts + first[1] * width;
  return top[end[0]] - top[first[0]] != bottom[end[0]] - bottom[first[0]];
}

bool water_visibility_is_open(const water_visibility* seen, int x, int y)
{
  const size_t first[2] = { (size_t)x, (size_t)y };
  const size_t end[2] = { first[0] + 1, first[1] + 1 };
  return has_open(seen, first, end);
}

size_t water_visibility_closed(const water_visibility* seen, float (*boxes)[4])
{
  const int* rect = seen->rect_px;
  size_t count = 0;
  for (int y = 0; y < seen->size[1]; ++y)
  {
    int first = 0; // of a run of closed cells
    for (int x = 0; x <= seen->size[0]; ++x)
    {
      if (x < seen->size[0] && !water_visibility_is_open(seen, x, y))
      {
        continue;
      }
      if (x > first)
      {
        const int corners[4] = { first, y, x, y + 1 };
        for (int i = 0; i < 4; ++i)
        {
          const int axis = i % 2;
          const int place = corners[i] * seen->cell_px; // cells may reach over the rectangle
          const int px = rect[axis] + (place < rect[2 + axis] ? place : rect[2 + axis]);
          boxes[count][i] = (float)(2.0 * px / seen->texture_px[axis] - 1.0);
        }
        ++count;
      }
      first = x + 1;
    }
  }
  return count;
}

bool water_visibility_has(const water_visibility* seen, const int first_px[2], const int last_px[2])
{
  // a product by the inverse, from the middle of a pixel, is the quotient, and ten times as fast
  const double cells = 1.0 / seen->cell_px;
  size_t first[2];
  size_t end[2];
  for (int i = 0; i < 2; ++i)
  {
    first[i] = (size_t)(int)((first_px[i] + 0.5) * cells);
    end[i] = (size_t)(int)((last_px[i] + 0.5) * cells) + 1;
  }
  return has_open(seen, first, end);
}

bool water_visibility_meets(
  const water_visibility* seen, const double to_clip[16], const double bounds[6], double reach_px)
{
  double picture[4];
  if (!water_bounds_picture(to_clip, bounds, picture))
  {
    return true; // about the eye
  }
  size_t first[2];
  size_t end[2];
  for (int i = 0; i < 2; ++i)
  {
    // in cells, from the rectangle's corner
    const double reach = reach_px + rounding_px;
    const double from =
      (0.5 * (1.0 + picture[i]) * seen->texture_px[i] - reach - seen->rect_px[i]) / seen->cell_px;
    const double to =
      (0.5 * (1.0 + picture[2 + i]) * seen->texture_px[i] + reach - seen->rect_px[i]) /
      seen->cell_px;
    if (!(to > 0.0) || !(from < seen->size[i]))
    {
      return false;
    }
    first[i] = (size_t)fmax(from, 0.0);
    end[i] = (size_t)ceil(fmin(to, seen->size[i]));
  }
  return has_open(seen, first, end);
}

void water_visibility_cull(const water_visibility* seen, const water_camera* mirrored,
  const water_prop* props, size_t prop_count, unsigned skips, water_cull_reason* reasons)
{
  double world_to_clip[16];
  water_mat4_multiply(mirrored->view_to_clip, mirrored->world_to_view, world_to_clip);
  for (size_t i = 0; i < prop_count && (skips & WATER_MAY_SKIP_PROPS); ++i)
  {
    if (reasons[i] == WATER_CULL_NONE && !water_prop_is_unbounded(props + i) &&
      !water_visibility_meets(
        seen, world_to_clip, props[i].bounds, 0.5 * (double)props[i].width_px))
    {
      reasons[i] = WATER_CULL_OUT_OF_WATER;
    }
  }
}
