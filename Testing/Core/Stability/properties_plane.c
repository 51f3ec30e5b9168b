// SPDX-License-Identifier: BSD-3-Clause
// properties_plane.c: the plane, the mirror, the optics: what needs no plan.
#include "properties.h"

#include "water_mirror.h"
#include "water_optics.h"
#include "water_plane.h"

#include <math.h>

static double absolute(quad value)
{
  return (double)fabsq(value);
}

// The longest entry s of the normal divides first (u), three squares (3 u each) are summed (2 u),
// the root halves that (2.5 u) and rounds (u), the quotient rounds (u): 5.5 u.
static void check_unit(const stress_case* of, const water_plane* unit, stress_record* record)
{
  double error = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const quad truth = of->normal[i];
    error = truth == 0 ? fmax(error, fabs(unit->normal[i]))
                       : fmax(error, absolute(((quad)unit->normal[i] - truth) / truth));
  }
  stress_keep(record, UNIT_NORMAL, (double)of->length, error, 6.0 * stress_u);
  const quad truth = of->offset;
  stress_keep(record, UNIT_OFFSET, absolute(truth),
    truth == 0 ? fabs(unit->offset) : absolute(((quad)unit->offset - truth) / truth),
    6.0 * stress_u);
}

// |n|^2 is off 1 by 7 u (the common part of the error above does not cancel in it, the entries' own
// 2 u do), which R^2 - I shows fourfold: 28 u; entries of R are off by 3 u, the matrix by 9 u
// (Frobenius), the square by twice that: 46 u. The translation: 2 d (14 u + 9 u + 8 u).
static void check_twice(const water_plane* unit, stress_record* record)
{
  double mirror[16];
  water_plane_mirror_matrix(unit, mirror);
  double linear = 0.0;
  double shift = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      quad sum = (i == j ? -1 : 0) + (j == 3 ? (quad)mirror[4 * i + 3] : 0);
      for (int k = 0; k < 3; ++k)
      {
        sum += (quad)mirror[4 * i + k] * (quad)mirror[4 * k + j];
      }
      *(j < 3 ? &linear : &shift) = fmax(j < 3 ? linear : shift, absolute(sum));
    }
  }
  stress_keep(record, MIRROR_TWICE, fabs(unit->offset), linear, 48.0 * stress_u);
  stress_keep(record, MIRROR_TWICE, fabs(unit->offset),
    unit->offset == 0.0 ? shift : shift / fabs(unit->offset), 64.0 * stress_u);
}

// Each product adds 4 u of the lengths that meet in it to what R^2 - I gives: 48 + 7 + 4 = 59 u for
// the rotation; 102 u of the plane's and 8 u of the view's offset for the translation. The
// determinant: |1 - 2 |n|^2| is off by 14 u, R's entries give 16 u, the product's 21 u.
static void check_camera(const stress_case* of, const water_plane* unit, stress_record* record)
{
  const water_camera* eye = &of->scene.eye;
  const double* view = eye->world_to_view;
  water_camera once;
  water_camera twice;
  water_mirror_camera(eye, unit, &once);
  water_mirror_camera(&once, unit, &twice);
  const double reach = fabs(unit->offset) + hypot(hypot(view[3], view[7]), view[11]);
  double linear = 0.0;
  double shift = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    const double error = fabs(twice.world_to_view[i] - view[i]);
    *(i % 4 < 3 ? &linear : &shift) = fmax(i % 4 < 3 ? linear : shift, error);
  }
  stress_keep(record, CAMERA_TWICE, reach, linear, 64.0 * stress_u);
  stress_keep(record, CAMERA_TWICE, reach, shift / reach, 128.0 * stress_u);
  const double given = absolute(quad_determinant(view) - 1);
  stress_keep(record, DETERMINANT, reach, absolute(quad_determinant(once.world_to_view) - 1),
    64.0 * stress_u + given);
}

void stress_plane(const stress_case* of, stress_record* record)
{
  water_plane unit;
  const water_status status = water_plane_normalise(&of->scene.plane, &unit);
  stress_keep(record, ACCEPTED, 1.0, status == WATER_OK ? 0.0 : 1.0, 0.0);
  if (status == WATER_OK)
  {
    check_unit(of, &unit, record);
    check_twice(&unit, record);
    check_camera(of, &unit, record);
  }
}

// Fresnel's two amplitudes from eta and the cosine, without any rearrangement.
static quad fresnel(quad c, quad eta)
{
  const quad g_squared = eta * eta - 1 + c * c;
  if (g_squared < 0)
  {
    return 1;
  }
  const quad g = sqrtq(g_squared);
  const quad s = c + g == 0 ? 0 : (c - g) / (c + g);
  const quad p = c + g == 0 ? 0 : (eta * eta * c - g) / (eta * eta * c + g);
  return (s * s + p * p) / 2;
}

// The squared cosine of the refracted ray is off by 4 u of what it is summed from, so the cosine by
// half of that over itself, or by the root of it where it vanishes (the critical angle); the
// amplitudes fall with it by 2 c / (c + g)^2 and 2 eta^2 c / (eta^2 c + g)^2; all else is 16 u.
static double fresnel_bound(double c, double eta)
{
  const double error = 4.0 * stress_u * (fabs((eta - 1.0) * (eta + 1.0)) + c * c);
  const double squared = (eta - 1.0) * (eta + 1.0) + c * c;
  const double g = sqrt(fmax(squared - error, 0.0));
  const double off = g > 0.0 ? fmin(error / g, sqrt(2.0 * error)) : sqrt(2.0 * error);
  const double s = c + g;
  const double p = eta * eta * c + g;
  const double fall = s > 0.0 ? 2.0 * c / (s * s) + 2.0 * eta * eta * c / (p * p) : 0.0;
  return fmin(16.0 * stress_u + off * fall, 1.0);
}

void stress_optics(stress_case* of, stress_record* record)
{
  // up to 2 + sqrt(3): beyond it the reflectance of unpolarised light has a minimum of its own
  const double index = 1.0 + fmin(case_roll_decades(of, -17.0, 0.5), 2.7);
  const double eta = case_roll(of, 0.0, 1.0) < 0.5 ? index : 1.0 / index;
  const double critical = eta < 1.0 ? sqrt((1.0 - eta) * (1.0 + eta)) : 0.0;
  const double way = case_roll_decades(of, -17.0, 0.0);
  const double kinds[4] = { case_roll(of, 0.0, 1.0), critical + way, critical - way, 1.0 - way };
  const double c = fmin(fmax(kinds[(int)case_roll(of, 0.0, 4.0)], 0.0), 1.0);
  const double found = water_optics_fresnel(c, eta);
  const double error = absolute((quad)found - fresnel((quad)c, (quad)eta));
  const double bound = fresnel_bound(c, eta);
  stress_keep(record, FRESNEL, 1.0 / fmax(fabs(c - critical), 1e-18),
    found >= 0.0 && found <= 1.0 ? error : (double)INFINITY, bound);
  const double more = fmin(c + way, 1.0);
  const double rise = water_optics_fresnel(more, eta) - found;
  stress_keep(record, FRESNEL_ORDER, 1.0 / way, fmax(rise, 0.0), bound + fresnel_bound(more, eta));
}
