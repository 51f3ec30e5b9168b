// SPDX-License-Identifier: BSD-3-Clause
// water_triangle_cull.c: triangles that change no
// pixel of the reflection texture that is looked up.
#include "water_triangle_cull.h"

#include "water_math.h"

static const double single_rounding = 16.0 * (double)FLT_EPSILON;

// As fmin and fmax, but one instruction each; NaN cannot occur here.
static inline double lesser(double a, double b)
{
  return a < b ? a : b;
}

static inline double greater(double a, double b)
{
  return a > b ? a : b;
}

typedef struct picture // of a triangle
{
  double px[3][2]; // corners, from the corner of the drawn part
  double low[2];
  double high[2];
  double depth_min; // NDC
  double depth_max;
  double shift_px[2]; // how far a corner may be elsewhere
  double shift_depth;
  int first[2]; // pixels that it may have
  int last[2];
} picture;

void water_triangle_cull_begin(const int rect_px[4], const water_visibility* seen, float* depths)
{
  const size_t width = (size_t)rect_px[2];
  for (int y = 0; y < rect_px[3]; ++y, depths += width)
  {
    if (seen && y % seen->cell_px != 0)
    {
      memcpy(depths, depths - width, width * sizeof *depths); // the same cells
      continue;
    }
    const int cell_px = seen ? seen->cell_px : rect_px[2];
    for (int x = 0; x < rect_px[2]; x += cell_px)
    {
      const bool is_open = !seen || water_visibility_is_open(seen, x / cell_px, y / cell_px);
      const float depth = is_open ? FLT_MAX : -FLT_MAX;
      for (int i = x; i < x + cell_px && i < rect_px[2]; ++i)
      {
        depths[i] = depth;
      }
    }
  }
}

// The largest that |row| * |(x, 1)| becomes in a box.
static double size_of(const double row[4], const double box[6])
{
  double size = fabs(row[3]);
  for (int i = 0; i < 3; ++i)
  {
    size += fabs(row[i]) * fmax(fabs(box[2 * i]), fabs(box[2 * i + 1]));
  }
  return size;
}

void water_triangle_cull_allow(
  const water_triangle_cull_view* view, const double box[6], water_triangle_cull_slack* slack)
{
  const double w = size_of(view->to_clip + 12, box);
  for (size_t i = 0; i < 3; ++i)
  {
    // of the quotient by w, which is at most 1 where it matters
    const double unit = i < 2 ? 0.5 * view->texture_px[i] : 1.0;
    slack->clip[i] = unit * single_rounding * (size_of(view->to_clip + 4 * i, box) + w);
  }
  const double* kept = view->kept;
  slack->height = single_rounding *
    (size_of(kept, box) + (fabs(kept[0]) + fabs(kept[1]) + fabs(kept[2])) * view->reach);
}

static bool has_pixels(const water_triangle_cull_view* view, picture* of)
{
  for (int i = 0; i < 2; ++i)
  {
    const double from = of->low[i] - of->shift_px[i];
    const double to = of->high[i] + of->shift_px[i];
    const double begin = i == 0 ? view->columns[0] : 0.0;
    const double end = i == 0 ? view->columns[1] : view->rect_px[3];
    if (!(to > begin) || !(from < end))
    {
      return false;
    }
    // the pixels that it touches, or whose middles it may cover
    const double to_middle = view->has_samples ? 0.0 : 0.5;
    of->first[i] = (int)(greater(from, begin) + to_middle);
    of->last[i] = (int)(lesser(to, end - 0.5) + to_middle) - (view->has_samples ? 0 : 1);
    if (of->last[i] < of->first[i])
    {
      return false;
    }
  }
  return !view->seen || water_visibility_has(view->seen, of->first, of->last);
}

// An edge: the pixels with side * (x - slope * y - at_zero) >= 0 are on the triangle's side of it;
// if it runs along a row, side is 0, and those with turn * (y - at_zero) >= 0.
typedef struct edge
{
  double side;
  double turn;
  double slope;
  double at_zero;
  double outer; // further out than this no pixel is the triangle's, wherever its corners are put
  double inner; // and further in than this all are
} edge;

// Let the corners be off by at most (dx, dy) each.
//
// Outside: the function of an edge e is linear, and at a corner that is put elsewhere at most
// dx |ey| + dy |ex| less than at the corner, where it is not negative. So it is at no place between
// three such corners less than minus that.
//
// Inside: with u, v from a pixel to the ends of an edge, its function u x v is off by at most
// dx (|uy| + |vy|) + dy (|ux| + |vx|) + 2 dx dy. The sum is convex in the pixel; so in the triangle
// it is at most the mean of its values at the three corners by the pixel's barycentric coordinates,
// of which the one that belongs to the edge is u x v over twice the area.
//
// Returns false when an edge is so short, or so nearly along a row, that no number says where it
// meets it.
static bool find_edges(const picture* of, edge edges[3])
{
  const double(*px)[2] = of->px;
  const double twice_area =
    (px[1][0] - px[0][0]) * (px[2][1] - px[0][1]) - (px[1][1] - px[0][1]) * (px[2][0] - px[0][0]);
  const double turn = twice_area < 0.0 ? -1.0 : 1.0;
  const double* shift = of->shift_px;
  for (int i = 0; i < 3; ++i)
  {
    const double* from = px[(i + 1) % 3];
    const double* to = px[(i + 2) % 3];
    const double* third = px[i];
    double off = 0.0; // dx |ey| + dy |ex|
    double at_third = 0.0;
    for (int j = 0; j < 2; ++j)
    {
      off += shift[1 - j] * fabs(to[j] - from[j]);
      at_third += shift[1 - j] * (fabs(to[j] - third[j]) + fabs(from[j] - third[j]));
    }
    const double share = 1.0 - (at_third - off) / fabs(twice_area);
    const double at_inside =
      share > 0.0 ? (off + 2.0 * shift[0] * shift[1]) / share : (double)INFINITY;
    const double rise = turn * (from[1] - to[1]);
    const double run = turn * (to[0] - from[0]);
    edge* made = edges + i;
    made->side = rise;
    made->turn = run;
    made->slope = rise != 0.0 ? -run / rise : 0.0;
    made->at_zero = rise != 0.0 ? from[0] - made->slope * from[1] : from[1];
    const double length = fabs(rise != 0.0 ? rise : run);
    made->outer = off / length;
    made->inner = at_inside / length;
    if (!(fabs(made->at_zero) + made->outer < DBL_MAX))
    {
      return false;
    }
  }
  return true;
}

// The pixels of a row whose middles may lie in the triangle, or, if is_inner, must.
static void find_row(const picture* of, const edge edges[3], bool is_inner, int y, int row[2])
{
  const double middle = y + 0.5;
  double low = of->first[0];
  double high = of->last[0] + 0.5;
  for (int i = 0; i < 3; ++i)
  {
    const edge* at = edges + i;
    const double in = is_inner ? at->inner : -at->outer;
    if (at->side > 0.0)
    {
      low = greater(low, at->slope * middle + at->at_zero + in);
    }
    else if (at->side < 0.0)
    {
      high = lesser(high, at->slope * middle + at->at_zero - in);
    }
    else if ((at->turn > 0.0 ? middle - at->at_zero : at->at_zero - middle) < in)
    {
      high = -1.0;
    }
  }
  // an edge along the row may leave it farther away than an integer can hold
  low = lesser(low, of->last[0] + 1.0);
  row[0] = (int)(low + 0.5); // the first middle from low on
  row[1] = high < 0.5 ? -1 : (int)(high - 0.5);
}

// Are all pixels of a triangle nearer? edges: NULL for all of its box.
static bool is_hidden(const water_triangle_cull_view* view, const picture* of, const edge* edges)
{
  const float nearest = (float)(of->depth_min - of->shift_depth);
  const float* depths = view->depths + (size_t)of->first[1] * (size_t)view->rect_px[2];
  for (int y = of->first[1]; y <= of->last[1]; ++y, depths += view->rect_px[2])
  {
    int row[2] = { of->first[0], of->last[0] };
    if (edges)
    {
      find_row(of, edges, false, y, row);
    }
    int is_open = 0; // an integer, and to the row's end: compilers do several pixels at once
    for (int x = row[0]; x <= row[1]; ++x)
    {
      is_open |= depths[x] >= nearest;
    }
    if (is_open)
    {
      return false;
    }
  }
  return true;
}

static void cover(const water_triangle_cull_view* view, const picture* of, const edge edges[3])
{
  const float depth = (float)(of->depth_max + of->shift_depth);
  for (int y = of->first[1]; y <= of->last[1]; ++y)
  {
    float* depths = view->depths + (size_t)y * (size_t)view->rect_px[2];
    int row[2];
    find_row(of, edges, true, y, row);
    for (int x = row[0]; x <= row[1]; ++x)
    {
      depths[x] = depths[x] < depth ? depths[x] : depth;
    }
  }
}

// May a triangle with a corner beside or behind the eye be in the picture? Not if all of it is on
// the wrong side of one of the picture's sides.
static bool is_about_view(const water_triangle_cull_view* view,
  const water_triangle_cull_slack* slack, const water_corner* const corners[3])
{
  double most[4] = { -DBL_MAX, -DBL_MAX, -DBL_MAX, -DBL_MAX }; // into the picture from its sides
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* clip = corners[corner]->clip;
    if (!water_all_finite(clip, 4))
    {
      return true;
    }
    for (int i = 0; i < 2; ++i)
    {
      const double from_low =
        0.5 * (clip[3] + clip[i]) * view->texture_px[i] - clip[3] * view->rect_px[i];
      most[i] = greater(most[i], from_low);
      most[2 + i] = greater(most[2 + i], clip[3] * view->rect_px[2 + i] - from_low);
    }
  }
  return most[0] >= -slack->clip[0] && most[1] >= -slack->clip[1] && most[2] >= -slack->clip[0] &&
    most[3] >= -slack->clip[1];
}

void water_triangle_cull_project(const water_triangle_cull_view* view, const water_points* points,
  size_t number, water_corner* corner)
{
  double place[3];
  water_points_get(points, number, place);
  for (size_t i = 0; i < 3; ++i)
  {
    place[i] -= view->origin[i];
  }
  water_mat4_apply_point(view->to_clip, place, corner->clip);
  corner->height = water_vec3_dot(view->kept, place) + view->kept[3];
  corner->w_inverse = 1.0 / corner->clip[3];
  corner->depth = corner->clip[2] * corner->w_inverse;
  for (int i = 0; i < 2; ++i)
  {
    corner->px[i] =
      0.5 * (1.0 + corner->clip[i] * corner->w_inverse) * view->texture_px[i] - view->rect_px[i];
  }
}

bool water_triangle_cull_add(const water_triangle_cull_view* view,
  const water_triangle_cull_slack* slack, const water_corner* const corners[3])
{
  picture of;
  of.low[0] = of.low[1] = of.depth_min = DBL_MAX;
  of.high[0] = of.high[1] = of.depth_max = -DBL_MAX;
  double w_inverse_max = 0.0;
  double lowest = DBL_MAX;
  double highest = -DBL_MAX;
  for (int i = 0; i < 3; ++i)
  {
    const water_corner* corner = corners[i];
    if (!(corner->clip[3] > 0.0))
    {
      return is_about_view(view, slack, corners);
    }
    for (int j = 0; j < 2; ++j)
    {
      of.px[i][j] = corner->px[j];
      of.low[j] = lesser(of.low[j], corner->px[j]);
      of.high[j] = greater(of.high[j], corner->px[j]);
    }
    lowest = lesser(lowest, corner->height);
    highest = greater(highest, corner->height);
    of.depth_min = lesser(of.depth_min, corner->depth);
    of.depth_max = greater(of.depth_max, corner->depth);
    w_inverse_max = greater(w_inverse_max, corner->w_inverse);
  }
  for (int i = 0; i < 2; ++i)
  {
    of.shift_px[i] = view->grid_px + slack->clip[i] * w_inverse_max;
  }
  of.shift_depth = single_rounding + slack->clip[2] * w_inverse_max;
  if (highest < -slack->height || !has_pixels(view, &of))
  {
    return false;
  }
  if (!view->depths || view->has_samples)
  {
    return true;
  }
  if (is_hidden(view, &of, NULL))
  {
    return false;
  }
  edge edges[3];
  const bool has_edges = find_edges(&of, edges);
  if (has_edges && is_hidden(view, &of, edges))
  {
    return false;
  }
  // neither the water nor the ends of the view cut it
  if (has_edges && view->is_solid && lowest > slack->height &&
    of.depth_min > -1.0 + of.shift_depth && of.depth_max < 1.0 - of.shift_depth)
  {
    cover(view, &of, edges);
  }
  return true;
}
