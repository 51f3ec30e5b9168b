// SPDX-License-Identifier: BSD-3-Clause
#include "water_fit.h"

#include "water_fit_rows.h"
#include "water_math.h"
#include "water_plane.h"

#include <float.h>
#include <math.h>

static const double level_angle = 1e-4;                // rad; water_fit_judge says why
static const double steepest = 0.57735026918962576451; // tangent of 30 degrees
static const double left_max = 0.5; // of the heights' mean square, that a tilt leaves
// Of a narrow part: a tilt across it is not known when it is so much narrower than long, squared.
static const double narrow = 1e-8;
// Of a surface's diagonal: a reflection that is off by so much is not seen where the surface is.
static const double shared = 1e-6;
static const double roundings = 4.0; // of a height, in floats
// The two coordinates of each second moment.
static const int axes[6][2] = { { 0, 0 }, { 0, 1 }, { 1, 1 }, { 0, 2 }, { 1, 2 }, { 2, 2 } };

void water_fit_begin(const double up[3], water_fit* fit)
{
  memset(fit, 0, sizeof *fit);
  memcpy(fit->up, up, sizeof fit->up);
  water_plane_axes(up, fit->x_dir, fit->y_dir);
  water_bounds_begin(fit->bounds);
  fit->is_upright = up[2] == 1.0;
}

// A corner in the axes, from the fit's origin.
static inline void place_of(const water_fit* fit, const double corner[3], double place[3])
{
  const double off[3] = { corner[0] - fit->origin[0], corner[1] - fit->origin[1],
    corner[2] - fit->origin[2] };
  if (fit->is_upright) // the products below are then the same, and take a third of all the time
  {
    memcpy(place, off, sizeof off);
    return;
  }
  place[0] = water_vec3_dot(fit->x_dir, off);
  place[1] = water_vec3_dot(fit->y_dir, off);
  place[2] = water_vec3_dot(fit->up, off);
}

// The integral of the product of two coordinates over a triangle, over a twelfth of its area.
// Source: the integrals of linear functions' products, A (1 + [i = j]) / 12 for the corners i, j.
static inline double product_of(
  const double* a, const double* b, const double* c, const double* sum, int i, int j)
{
  return a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum[i] * sum[j];
}

static inline void add_triangle(
  const double* a, const double* b, const double* c, water_fit_integrals* polygon)
{
  const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  const double third = area * (1.0 / 3.0);
  const double share = area * (1.0 / 12.0);
  const double sum[3] = { a[0] + b[0] + c[0], a[1] + b[1] + c[1], a[2] + b[2] + c[2] };
  polygon->area += area;
  for (int i = 0; i < 3; ++i)
  {
    polygon->first[i] += third * sum[i];
  }
  polygon->second[0] += share * product_of(a, b, c, sum, 0, 0);
  polygon->second[1] += share * product_of(a, b, c, sum, 0, 1);
  polygon->second[2] += share * product_of(a, b, c, sum, 1, 1);
  polygon->second[3] += share * product_of(a, b, c, sum, 0, 2);
  polygon->second[4] += share * product_of(a, b, c, sum, 1, 2);
  polygon->second[5] += share * product_of(a, b, c, sum, 2, 2);
}

// Adds the polygon's integrals, with the sign that makes its area positive: all of it may turn
// clockwise.
static inline void add_integrals(const water_fit_integrals* polygon, water_fit_integrals* sum)
{
  const double sign = polygon->area < 0.0 ? -1.0 : 1.0;
  sum->area += sign * polygon->area;
  for (int i = 0; i < 3; ++i)
  {
    sum->first[i] += sign * polygon->first[i];
  }
  for (int i = 0; i < 6; ++i)
  {
    sum->second[i] += sign * polygon->second[i];
  }
}

// A corner of a polygon; without a list of corners, the points are the polygon's.
static inline const double* corner_of(const double* points, const int64_t* corners, size_t number)
{
  return points + 3 * (corners ? corners[number] : (int64_t)number);
}

// Of a fan about the first corner. Triangles that turn clockwise have negative areas, so what the
// fan covers outside a concave polygon is taken away again.
static inline void add_fan(const water_fit* fit, const double* points, const int64_t* corners,
  size_t count, water_fit_integrals* sum)
{
  water_fit_integrals polygon = { 0.0, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  double first[3];
  double sides[2][3]; // of the triangle, by turns
  place_of(fit, corner_of(points, corners, 0), first);
  place_of(fit, corner_of(points, corners, 1), sides[1]);
  for (size_t k = 2; k < count; ++k)
  {
    place_of(fit, corner_of(points, corners, k), sides[k % 2]);
    add_triangle(first, sides[1 - k % 2], sides[k % 2], &polygon);
  }
  add_integrals(&polygon, sum);
}

static inline bool are_usable(const double* points, const int64_t* corners, size_t count)
{
  bool are = count >= 3;
  for (size_t k = 0; k < count; ++k)
  {
    are = are && water_all_usable(corner_of(points, corners, k), 3);
  }
  return are;
}

// Adds quads of a list from its beginning, as long as there are many in a row, after a first
// polygon. Returns how many.
static size_t add_rows(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, water_fit* fit)
{
  if (!corners || !fit->is_upright || count < WATER_FIT_LANES || water_bounds_is_empty(fit->bounds))
  {
    return 0;
  }
  water_fit_integrals sum = { fit->area, { fit->first[0], fit->first[1], fit->first[2] }, { 0.0 } };
  memcpy(sum.second, fit->second, sizeof sum.second);
  const size_t done =
    water_fit_rows_add(points, starts, corners, count, fit->origin, fit->bounds, &sum);
  fit->area = sum.area;
  memcpy(fit->first, sum.first, sizeof sum.first);
  memcpy(fit->second, sum.second, sizeof sum.second);
  return done;
}

static inline size_t add_polygons(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, water_fit* fit)
{
  // sums and bounds of their own: in the fit's memory, each polygon would wait for the one before
  water_fit_integrals sum = { fit->area, { fit->first[0], fit->first[1], fit->first[2] }, { 0.0 } };
  double bounds[6];
  memcpy(sum.second, fit->second, sizeof sum.second);
  memcpy(bounds, fit->bounds, sizeof bounds);
  size_t done = 0;
  for (; done < count; ++done)
  {
    const int64_t* polygon = corners ? corners + starts[done] : NULL;
    const size_t size = (size_t)(starts[done + 1] - starts[done]);
    if (!are_usable(points, polygon, size))
    {
      break;
    }
    if (water_bounds_is_empty(bounds))
    {
      memcpy(fit->origin, corner_of(points, polygon, 0), sizeof fit->origin);
    }
    for (size_t k = 0; k < size; ++k)
    {
      water_bounds_add_point(bounds, corner_of(points, polygon, k));
    }
    if (size == 4) // a loop of a known length is faster, and most large meshes have quads
    {
      add_fan(fit, points, polygon, 4, &sum);
    }
    else
    {
      add_fan(fit, points, polygon, size, &sum);
    }
  }
  fit->area = sum.area;
  memcpy(fit->first, sum.first, sizeof sum.first);
  memcpy(fit->second, sum.second, sizeof sum.second);
  memcpy(fit->bounds, bounds, sizeof bounds);
  return done;
}

size_t water_fit_add_polygons(
  const double* points, const int64_t* starts, const int64_t* corners, size_t count, water_fit* fit)
{
  size_t done = 0;
  while (done < count)
  {
    const size_t row = add_rows(points, starts + done, corners, count - done, fit);
    const size_t left = count - done - row;
    const size_t alone =
      left < WATER_FIT_LANES ? left : WATER_FIT_LANES; // the first of all, or no row
    const size_t added = add_polygons(points, starts + done + row, corners, alone, fit);
    done += row + added;
    if (added < alone)
    {
      break;
    }
  }
  return done;
}

bool water_fit_add_polygon(const double* corners, size_t count, water_fit* fit)
{
  const int64_t starts[2] = { 0, (int64_t)count };
  return add_polygons(corners, starts, NULL, 1, fit) == 1;
}

void water_fit_add(const double a[3], const double b[3], const double c[3], water_fit* fit)
{
  const double corners[9] = { a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2] };
  water_fit_add_polygon(corners, 3, fit);
}

void water_fit_join(const water_fit* other, water_fit* fit)
{
  if (water_bounds_is_empty(other->bounds))
  {
    return;
  }
  if (water_bounds_is_empty(fit->bounds))
  {
    *fit = *other;
    return;
  }
  double off[3]; // what the other's places are less than they are from this fit's origin
  place_of(fit, other->origin, off);
  for (int number = 0; number < 6; ++number)
  {
    const int i = axes[number][0];
    const int j = axes[number][1];
    fit->second[number] += other->second[number] + off[i] * other->first[j] +
      off[j] * other->first[i] + off[i] * off[j] * other->area;
  }
  for (int i = 0; i < 3; ++i)
  {
    fit->first[i] += other->first[i] + off[i] * other->area;
  }
  fit->area += other->area;
  water_bounds_add(fit->bounds, other->bounds);
}

// The slope of the best plane. covariance: xx, xy, yy, x height, y height
static void find_slope(const double covariance[5], double slope[2])
{
  const double xx = covariance[0];
  const double xy = covariance[1];
  const double yy = covariance[2];
  const double trace = xx + yy;
  const double det = xx * yy - xy * xy;
  slope[0] = slope[1] = 0.0;
  if (!(trace > 0.0))
  {
    return;
  }
  if (det > narrow * trace * trace)
  {
    slope[0] = (yy * covariance[3] - xy * covariance[4]) / det;
    slope[1] = (xx * covariance[4] - xy * covariance[3]) / det;
    return;
  }
  // along its length alone
  const double angle = 0.5 * atan2(2.0 * xy, xx - yy);
  const double along[2] = { cos(angle), sin(angle) };
  const double tilt = (along[0] * covariance[3] + along[1] * covariance[4]) / trace;
  slope[0] = tilt * along[0];
  slope[1] = tilt * along[1];
}

water_status water_fit_judge(const water_fit* fit, water_fit_plane* plane)
{
  double diagonal[3];
  for (int i = 0; i < 3; ++i)
  {
    diagonal[i] = fit->bounds[2 * i + 1] - fit->bounds[2 * i];
  }
  // an upright part has the area of its corners' rounding; of very large coordinates the products
  // of two overflow first, times an area
  const double least = roundings * DBL_EPSILON * water_vec3_dot(diagonal, diagonal);
  if (!(fit->area > least) || !water_all_finite(fit->second, 6))
  {
    return WATER_BAD_SURFACE;
  }
  double mean[3];
  for (int i = 0; i < 3; ++i)
  {
    mean[i] = fit->first[i] / fit->area;
  }
  double covariance[6];
  for (int i = 0; i < 6; ++i)
  {
    covariance[i] = fit->second[i] / fit->area - mean[axes[i][0]] * mean[axes[i][1]];
  }
  double slope[2];
  find_slope(covariance, slope);
  const double unevenness = fmax(covariance[5], 0.0);
  const double left = fmax(unevenness - slope[0] * covariance[3] - slope[1] * covariance[4], 0.0);
  const double tilt = hypot(slope[0], slope[1]);
  const bool is_tilted = tilt >= level_angle && tilt <= steepest && left <= left_max * unevenness;
  const double length = is_tilted ? sqrt(1.0 + tilt * tilt) : 1.0;
  water_fit_plane made;
  for (int i = 0; i < 3; ++i)
  {
    const double leaned = fit->up[i] - slope[0] * fit->x_dir[i] - slope[1] * fit->y_dir[i];
    made.normal[i] = is_tilted ? leaned / length : fit->up[i];
    made.middle[i] =
      fit->origin[i] + mean[0] * fit->x_dir[i] + mean[1] * fit->y_dir[i] + mean[2] * fit->up[i];
  }
  // a level one as its height alone, which no rounding of the middle's place changes
  const double height = water_vec3_dot(fit->up, fit->origin) + mean[2];
  for (int i = 0; i < 3; ++i)
  {
    made.origin[i] = is_tilted ? made.middle[i] : height * fit->up[i];
  }
  made.reach = water_vec3_length(diagonal);
  made.area = fit->area;
  made.rms = sqrt(is_tilted ? left : unevenness) / length;
  made.is_level = !is_tilted;
  *plane = made;
  return WATER_OK;
}

double water_fit_tolerance(double diagonal, double coordinate, bool is_single)
{
  const double rounding = is_single ? (double)FLT_EPSILON : DBL_EPSILON;
  return shared * diagonal + roundings * rounding * coordinate;
}

// How far a part is from the plane of another, at most.
static double apart(const water_fit_plane* part, const water_fit_plane* other)
{
  double off[3];
  double turn[3];
  for (int i = 0; i < 3; ++i)
  {
    off[i] = part->middle[i] - other->origin[i];
    turn[i] = part->normal[i] - other->normal[i];
  }
  return fabs(water_vec3_dot(other->normal, off)) + part->reach * water_vec3_length(turn);
}

size_t water_fit_share(const water_fit_plane* parts, size_t count, double tolerance, size_t most,
  size_t* plane, size_t* first)
{
  size_t planes = 0;
  for (size_t i = 0; i < count; ++i)
  {
    size_t found = 0;
    while (found < planes && !(apart(&parts[i], &parts[first[found]]) <= tolerance))
    {
      ++found;
    }
    if (planes == 0 || (found == planes && planes < most))
    {
      first[planes++] = i;
    }
    plane[i] = found; // without one that is their maximum number, which does not grow
  }
  return planes;
}

bool water_fit_rest(const water_fit_plane* parts, size_t count, const size_t* plane, size_t planes,
  const double up[3], water_fit_plane* rest)
{
  double lowest = (double)INFINITY;
  for (size_t i = 0; i < count; ++i)
  {
    const double height = water_vec3_dot(up, parts[i].middle);
    if (plane[i] < planes || !(height < lowest))
    {
      continue;
    }
    lowest = height;
    *rest = parts[i];
  }
  if (isinf(lowest))
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    rest->normal[i] = up[i];
    rest->origin[i] = lowest * up[i];
  }
  rest->is_level = true;
  return true;
}
