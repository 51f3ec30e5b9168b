// SPDX-License-Identifier: BSD-3-Clause
#include "water_waterline.h"

#include "water_math.h"
#include "water_plane.h"

enum
{
  ROWS_MAX = 512 // few edges pass one, and the table stays small
};

void water_waterline_places(const double points_to_world[16], const water_plane* unit,
  const double origin[3], const double* points, size_t count, double* places)
{
  double x_dir[3];
  double y_dir[3];
  water_plane_axes(unit->normal, x_dir, y_dir);
  for (size_t i = 0; i < count; ++i)
  {
    double world[3];
    double from[3];
    for (int j = 0; j < 3; ++j)
    {
      const double* row = points_to_world + 4 * j;
      world[j] = water_vec3_dot(row, points + 3 * i) + row[3];
    }
    for (int j = 0; j < 3; ++j)
    {
      from[j] = world[j] - origin[j];
    }
    places[3 * i] = water_vec3_dot(x_dir, from);
    places[3 * i + 1] = water_vec3_dot(y_dir, from);
    places[3 * i + 2] = water_plane_height(unit, world);
  }
}

size_t water_waterline_find_wrong(const double* places, size_t count)
{
  size_t i = 0;
  while (i < 3 * count && fabs(places[i]) <= WATER_WATERLINE_REACH)
  {
    ++i;
  }
  return i / 3;
}

size_t water_waterline_near(const double* places, size_t count, double reach, size_t* near)
{
  size_t found = 0;
  for (size_t i = 0; i < count; ++i)
  {
    if (fabs(places[3 * i + 2]) <= reach)
    {
      near[found++] = i;
    }
  }
  return found;
}

bool water_waterline_cut(
  const size_t corners[3], const double* places, water_waterline_piece* piece)
{
  int found = 0;
  water_waterline_piece made = { 0 };
  for (int i = 0; i < 3; ++i)
  {
    const size_t a = corners[i];
    const size_t b = corners[(i + 1) % 3];
    if ((places[3 * a + 2] >= 0.0) == (places[3 * b + 2] >= 0.0))
    {
      continue; // round a triangle the sides change twice or never: found stays within 2
    }
    // from the same corner for both of an edge's triangles: they meet in the same place
    const size_t low = a < b ? a : b;
    const size_t high = a < b ? b : a;
    const double* from = places + 3 * low;
    const double* to = places + 3 * high;
    const double share = from[2] / (from[2] - to[2]);
    made.ends[found][0] = from[0] + share * (to[0] - from[0]);
    made.ends[found][1] = from[1] + share * (to[1] - from[1]);
    made.edges[found][0] = low;
    made.edges[found][1] = high;
    ++found;
  }
  if (found != 2)
  {
    return false;
  }
  *piece = made;
  return true;
}

static bool is_before(const water_waterline_end* one, const water_waterline_end* other)
{
  for (int i = 0; i < 2; ++i)
  {
    if (one->edge[i] != other->edge[i])
    {
      return one->edge[i] < other->edge[i];
    }
  }
  return one->which < other->which;
}

// Moves an end down a heap whose largest end is its first, to below all that are after it.
static void sift_down(water_waterline_end* ends, size_t at, size_t count)
{
  const water_waterline_end moved = ends[at];
  for (size_t child = 2 * at + 1; child < count; child = 2 * at + 1)
  {
    const bool is_second = child + 1 < count && is_before(ends + child, ends + child + 1);
    const size_t largest = is_second ? child + 1 : child;
    if (!is_before(&moved, ends + largest))
    {
      break;
    }
    ends[at] = ends[largest];
    at = largest;
  }
  ends[at] = moved;
}

// Sorts in place: C libraries may allocate in qsort. Source: Williams 1964, "Algorithm 232:
// Heapsort".
static void sort_ends(water_waterline_end* ends, size_t count)
{
  for (size_t i = count / 2; i-- > 0;)
  {
    sift_down(ends, i, count);
  }
  for (size_t last = count; last-- > 1;)
  {
    const water_waterline_end largest = ends[0];
    ends[0] = ends[last];
    ends[last] = largest;
    sift_down(ends, 0, last);
  }
}

static bool link_ends(
  water_waterline_piece* pieces, size_t count, water_waterline_end* ends, size_t* open_piece)
{
  for (size_t i = 0; i < 2 * count; ++i)
  {
    const size_t* edge = pieces[i / 2].edges[i % 2];
    ends[i].edge[0] = edge[0];
    ends[i].edge[1] = edge[1];
    ends[i].which = i;
  }
  sort_ends(ends, 2 * count);
  for (size_t i = 0; i < 2 * count; i += 2)
  {
    const bool is_pair = i + 1 < 2 * count && ends[i].edge[0] == ends[i + 1].edge[0] &&
      ends[i].edge[1] == ends[i + 1].edge[1];
    if (!is_pair)
    {
      *open_piece = ends[i].which / 2;
      return false;
    }
    const size_t one = ends[i].which;
    const size_t other = ends[i + 1].which;
    pieces[one / 2].next[one % 2] = other;
    pieces[other / 2].next[other % 2] = one;
  }
  return true;
}

static void turn_piece(water_waterline_piece* piece)
{
  for (int j = 0; j < 2; ++j)
  {
    const double end = piece->ends[0][j];
    piece->ends[0][j] = piece->ends[1][j];
    piece->ends[1][j] = end;
  }
}

// Follows a loop, starting at the first end of a piece. Links refer to the ends as they were before
// pieces were turned.
//
// is_turning  turns all pieces once more; or else each so that it begins where the last one ends
//
// Returns twice the area, positive counter-clockwise.
static double go_round(water_waterline_piece* pieces, size_t first, bool is_turning)
{
  double area = 0.0;
  size_t at = 2 * first; // piece, and the end where it is entered
  const double origin[2] = { pieces[first].ends[0][0], pieces[first].ends[0][1] };
  do
  {
    water_waterline_piece* piece = pieces + at / 2;
    if (is_turning || at % 2 == 1)
    {
      turn_piece(piece);
    }
    piece->is_seen = true;
    area += (piece->ends[0][0] - origin[0]) * (piece->ends[1][1] - origin[1]) -
      (piece->ends[0][1] - origin[1]) * (piece->ends[1][0] - origin[0]);
    at = piece->next[1 - at % 2];
  } while (at / 2 != first);
  return area;
}

bool water_waterline_close(
  water_waterline_piece* pieces, size_t count, water_waterline_end* ends, size_t* open_piece)
{
  if (!link_ends(pieces, count, ends, open_piece))
  {
    return false;
  }
  for (size_t i = 0; i < count; ++i)
  {
    if (!pieces[i].is_seen && go_round(pieces, i, false) < 0.0)
    {
      (void)go_round(pieces, i, true);
    }
  }
  return true;
}

// The rows that a piece passes.
static void find_rows(
  const water_waterline_piece* piece, const water_waterline_rows* rows, int range[2])
{
  const int axis = rows->axis;
  const double low = rows->middle[axis] - rows->half[axis];
  const double per_row = 2.0 * rows->half[axis] / rows->count;
  const double one = (piece->ends[0][axis] - low) / per_row;
  const double other = (piece->ends[1][axis] - low) / per_row;
  // and those beside them: the shader's place has a float's rounding
  range[0] = (int)fmax(floor(fmin(one, other) - 0.01), 0.0);
  range[1] = (int)fmin(floor(fmax(one, other) + 0.01), rows->count - 1.0);
}

bool water_waterline_lay(
  const water_waterline_piece* pieces, size_t count, water_waterline_rows* rows)
{
  double low[2] = { (double)INFINITY, (double)INFINITY };
  double high[2] = { -(double)INFINITY, -(double)INFINITY };
  for (size_t i = 0; i < 2 * count; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      low[j] = fmin(low[j], pieces[i / 2].ends[i % 2][j]);
      high[j] = fmax(high[j], pieces[i / 2].ends[i % 2][j]);
    }
  }
  water_waterline_rows made = { 0 };
  for (int j = 0; j < 2; ++j)
  {
    made.middle[j] = 0.5 * (low[j] + high[j]);
    made.half[j] = 0.5 * (high[j] - low[j]);
  }
  if (count == 0 || !(made.half[0] > 0.0 && made.half[1] > 0.0) || !isfinite(made.half[0]) ||
    !isfinite(made.half[1]))
  {
    return false;
  }
  made.axis = made.half[1] > made.half[0] ? 1 : 0;
  made.count = (int)fmin((double)count, ROWS_MAX);
  size_t passing[ROWS_MAX] = { 0 };
  for (size_t i = 0; i < count; ++i)
  {
    int range[2];
    find_rows(pieces + i, &made, range);
    for (int row = range[0]; row <= range[1]; ++row)
    {
      made.longest = ++passing[row] > made.longest ? passing[row] : made.longest;
    }
  }
  made.longest += 1; // the number
  *rows = made;
  return true;
}

void water_waterline_fill(const water_waterline_piece* pieces, size_t count,
  const water_waterline_rows* rows, float* texels)
{
  const size_t width = 4 * rows->longest;
  for (size_t i = 0; i < (size_t)rows->count * width; ++i)
  {
    texels[i] = 0.0f;
  }
  for (size_t i = 0; i < count; ++i)
  {
    int range[2];
    find_rows(pieces + i, rows, range);
    for (int row = range[0]; row <= range[1]; ++row)
    {
      float* first = texels + (size_t)row * width;
      first[0] += 1.0f;
      float* edge = first + 4 * (size_t)first[0];
      for (int j = 0; j < 4; ++j)
      {
        edge[j] = (float)(pieces[i].ends[j / 2][j % 2] - rows->middle[j % 2]);
      }
    }
  }
}
