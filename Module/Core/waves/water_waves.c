// SPDX-License-Identifier: BSD-3-Clause
// water_waves.c: sine and Gerstner waves: dispersion, the surface at (x, y, t), buoys, shader rows.
#include "water_waves.h"

#include "water_math.h"
#include "water_phase.h"

static bool is_depth(double depth)
{
  return depth > 0.0; // not NaN; infinity is deep
}

water_status water_waves_omega(double k, double depth, double* omega)
{
  if (!isfinite(k) || k < 0.0)
  {
    return WATER_BAD_WAVENUMBER;
  }
  if (!is_depth(depth))
  {
    return WATER_BAD_DEPTH;
  }
  *omega = water_dispersion(k, depth);
  return WATER_OK;
}

// k * depth from root = omega sqrt(depth / g): y tanh y = root^2.
static double solve_dispersion(double root)
{
  if (root < 1e-8)
  {
    return root; // y = root (1 + root^2 / 6 ...): shallow
  }
  const double square = root * root;
  if (square > 20.0)
  {
    return square; // tanh is 1: deep
  }
  const double beta = 2.4908; // Guo's
  double y = square * pow(-expm1(-pow(root, beta)), -1.0 / beta);
  for (int step = 0; step < 4; ++step)
  {
    const double t = tanh(y);
    y -= (y * t - square) / (t + y * (1.0 - t * t));
  }
  return y;
}

water_status water_waves_wavenumber(double omega, double depth, double* k)
{
  if (!isfinite(omega) || omega < 0.0)
  {
    return WATER_BAD_FREQUENCY;
  }
  if (!is_depth(depth))
  {
    return WATER_BAD_DEPTH;
  }
  const double deep = omega / water_gravity * omega;
  const double root = omega * sqrt(depth / water_gravity);
  const double found = isfinite(root) ? solve_dispersion(root) / depth : deep;
  // in very deep water the product overflows before the answer does
  const double answer = isfinite(found) ? found : deep;
  if (!isfinite(answer))
  {
    return WATER_BAD_FREQUENCY;
  }
  *k = answer;
  return WATER_OK;
}

static water_status check_wave(const water_wave* wave)
{
  if (!(wave->amplitude >= 0.0 && wave->amplitude <= WATER_AMPLITUDE_MAX))
  {
    return WATER_BAD_WAVE_AMPLITUDE;
  }
  if (!isfinite(wave->wavelength) || !(wave->wavelength > 0.0) ||
    !isfinite(water_two_pi / wave->wavelength))
  {
    return WATER_BAD_WAVELENGTH;
  }
  if (!isfinite(wave->direction_rad))
  {
    return WATER_BAD_WAVE_DIRECTION;
  }
  if (!isfinite(wave->phase_rad))
  {
    return WATER_BAD_WAVE_PHASE;
  }
  if (!(wave->steepness >= 0.0 && wave->steepness <= 1.0))
  {
    return WATER_BAD_STEEPNESS;
  }
  return WATER_OK;
}

// Rounding of a sum that means 1; also what keeps Newton's matrix invertible on a cusp.
static const double rounding = 16.0 * DBL_EPSILON;

water_status water_waves_check(const water_wave* waves, size_t count, size_t* bad_index)
{
  double steepness = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    const water_wave* wave = &waves[i];
    water_status status = check_wave(wave);
    if (status == WATER_OK)
    {
      steepness += water_two_pi / wave->wavelength * (wave->amplitude * wave->steepness);
      status = steepness <= 1.0 + rounding ? WATER_OK : WATER_WAVES_FOLD;
    }
    if (status != WATER_OK)
    {
      *bad_index = i;
      return status;
    }
  }
  return WATER_OK;
}

water_status water_waves_at(const water_wave* waves, size_t count, double depth, double time,
  water_wave_term* terms, size_t* bad_index)
{
  if (!is_depth(depth))
  {
    return WATER_BAD_DEPTH;
  }
  if (!isfinite(time))
  {
    return WATER_BAD_TIME;
  }
  const water_status status = water_waves_check(waves, count, bad_index);
  if (status != WATER_OK)
  {
    return status;
  }
  for (size_t i = 0; i < count; ++i)
  {
    const water_wave* wave = &waves[i];
    water_wave_term* term = &terms[i];
    term->dir[0] = cos(wave->direction_rad);
    term->dir[1] = sin(wave->direction_rad);
    term->turns_per_m[0] = term->dir[0] / wave->wavelength;
    term->turns_per_m[1] = term->dir[1] / wave->wavelength;
    term->k = water_two_pi / wave->wavelength;
    term->amplitude = wave->amplitude;
    term->steepness = wave->steepness;
    const double frequency = water_dispersion(term->k, depth) / water_two_pi;
    const double own = water_turn(wave->phase_rad / water_two_pi);
    term->turns = water_turn(own - water_turns(frequency, time));
  }
  return WATER_OK;
}

// Phase of (x, y) plus a short way from there, in turns; the way is not reduced.
static double turns_at(const water_wave_term* term, double x, double y, const double way[2])
{
  const double there =
    water_turn(water_turns(term->turns_per_m[0], x) + water_turns(term->turns_per_m[1], y));
  return water_turn(term->turns + there) + term->turns_per_m[0] * way[0] +
    term->turns_per_m[1] * way[1];
}

static water_wave_sum surface_at(
  const water_wave_term* terms, size_t count, double x, double y, const double way[2])
{
  water_wave_sum sum = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0 }, { 1.0, 0.0, 1.0 } };
  for (size_t i = 0; i < count; ++i)
  {
    const water_wave_term* term = &terms[i];
    const double angle = water_two_pi * turns_at(term, x, y, way);
    const double sine = sin(angle);
    const double cosine = cos(angle);
    const double pull = term->steepness * term->amplitude;
    const double bend = term->k * pull * sine;
    for (int j = 0; j < 2; ++j)
    {
      sum.moved[j] += pull * cosine * term->dir[j];
      sum.gradient[j] += term->k * term->amplitude * cosine * term->dir[j];
    }
    sum.moved[2] += term->amplitude * sine;
    sum.stretch[0] -= bend * term->dir[0] * term->dir[0];
    sum.stretch[1] -= bend * term->dir[0] * term->dir[1];
    sum.stretch[2] -= bend * term->dir[1] * term->dir[1];
  }
  return sum;
}

// least  area over that at rest, >= 0: what is less counts as that
static water_wave_point point_of(const water_wave_sum* at, double least)
{
  water_wave_point point;
  // the cross product of the two tangents, (sxx, sxy, gx) and (sxy, syy, gy)
  const double area = at->stretch[0] * at->stretch[2] - at->stretch[1] * at->stretch[1];
  point.jacobian = fmax(area, least); // sines do not fold: below 0 is rounding
  const double across[3] = { at->stretch[1] * at->gradient[1] - at->stretch[2] * at->gradient[0],
    at->stretch[1] * at->gradient[0] - at->stretch[0] * at->gradient[1], point.jacobian };
  const double length = water_vec3_length(across);
  for (int i = 0; i < 3; ++i)
  {
    point.displacement[i] = at->moved[i];
    // on a cusp one tangent vanishes, and its direction is rounding; the crest then points up
    point.normal[i] = length > rounding ? across[i] / length : (i == 2 ? 1.0 : 0.0);
  }
  for (int i = 0; i < 2; ++i)
  {
    point.slope[i] = length > rounding ? -across[i] / point.jacobian : 0.0;
  }
  return point;
}

void water_waves_point(
  const water_wave_term* terms, size_t count, double x, double y, water_wave_point* point)
{
  const double way[2] = { 0.0, 0.0 };
  const water_wave_sum at = surface_at(terms, count, x, y, way);
  *point = point_of(&at, 0.0);
}

static const double least_area = 0.1; // of seas; sines end at their cusps

typedef struct guess
{
  double way[2]; // from the place to the point at rest; short, so that it keeps its digits
  double miss[2];
  double distance; // length of the miss
  water_wave_sum at;
} guess;

typedef struct search
{
  const water_wave_term* terms;
  size_t count;
  const water_wave_others* others; // NULL: none
  double place[2];
} search;

static guess guess_at(const search* of, const double way[2])
{
  const double x = of->place[0];
  const double y = of->place[1];
  guess made = { { way[0], way[1] }, { 0.0, 0.0 }, 0.0,
    surface_at(of->terms, of->count, x, y, way) };
  if (of->others != NULL && !of->others->add(of->others->context, x + way[0], y + way[1], &made.at))
  {
    made.at.moved[2] = (double)NAN;
  }
  made.miss[0] = way[0] + made.at.moved[0];
  made.miss[1] = way[1] + made.at.moved[1];
  made.distance = hypot(made.miss[0], made.miss[1]);
  return made;
}

// The next point of Newton's method; where other waves fold, the point that closes the gap.
static void step_from(const guess* from, const search* of, double go[2])
{
  const double xx = from->at.stretch[0] + rounding;
  const double xy = from->at.stretch[1];
  const double yy = from->at.stretch[2] + rounding;
  const double area = xx * yy - xy * xy;
  const bool folds = of->others != NULL && !(area > least_area && xx > 0.0);
  go[0] = folds ? from->miss[0] : (yy * from->miss[0] - xy * from->miss[1]) / area;
  go[1] = folds ? from->miss[1] : (xx * from->miss[1] - xy * from->miss[0]) / area;
}

double water_waves_least_area(void)
{
  return least_area;
}

water_status water_waves_find_all(const water_wave_term* terms, size_t count,
  const water_wave_others* others, double x, double y, double rest[2], water_wave_point* point)
{
  const search of = { terms, count, others, { x, y } };
  double reach = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    reach += terms[i].steepness * terms[i].amplitude;
  }
  const double enough =
    fmax(8.0 * DBL_EPSILON * reach, others != NULL ? 1e-6 * others->across : 0.0);
  const int halvings = others != NULL ? 8 : 60;
  const double start[2] = { 0.0, 0.0 };
  guess best = guess_at(&of, start);
  bool is_better = true;
  // each step at least shortens the miss; near the solution it squares it, near a cusp it takes off
  // two thirds, and 100 of those leave nothing
  for (int step = 0; step < 100 && is_better && best.distance > enough; ++step)
  {
    double go[2];
    step_from(&best, &of, go);
    is_better = false;
    double part = 1.0;
    for (int halving = 0; halving < halvings && !is_better; ++halving)
    {
      const double way[2] = { best.way[0] - part * go[0], best.way[1] - part * go[1] };
      const guess next = guess_at(&of, way);
      is_better = next.distance < best.distance;
      best = is_better ? next : best;
      part *= 0.5;
    }
  }
  if (!isfinite(x) || !isfinite(y) || !isfinite(best.at.moved[2]))
  {
    return WATER_BAD_POINT;
  }
  rest[0] = x + best.way[0];
  rest[1] = y + best.way[1];
  *point = point_of(&best.at, others != NULL ? least_area : 0.0);
  return WATER_OK;
}

water_status water_waves_find(const water_wave_term* terms, size_t count, double x, double y,
  double rest[2], water_wave_point* point)
{
  return water_waves_find_all(terms, count, NULL, x, y, rest, point);
}

double water_waves_looked_up(const water_wave* waves, size_t count)
{
  double slope = 0.0;
  double fold = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    const double steep = water_two_pi / waves[i].wavelength * waves[i].amplitude;
    slope += steep;
    fold += waves[i].steepness * steep;
  }
  return fold < 1.0 ? 4.0 * slope / (1.0 - fold) : (double)INFINITY;
}

void water_waves_rms(const water_wave* waves, size_t count, double* height, double* slope)
{
  double height_sum = 0.0;
  double slope_sum = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    const double amplitude = waves[i].amplitude;
    const double steep = water_two_pi / waves[i].wavelength * amplitude;
    height_sum += 0.5 * amplitude * amplitude;
    slope_sum += 0.5 * steep * steep;
  }
  *height = sqrt(height_sum);
  *slope = sqrt(slope_sum);
}

void water_waves_tilt(const double slope[2], double normal[3])
{
  const double x = normal[0] - slope[0] * normal[2];
  const double y = normal[1] - slope[1] * normal[2];
  const double length = sqrt(x * x + y * y + normal[2] * normal[2]);
  normal[0] = x / length;
  normal[1] = y / length;
  normal[2] /= length;
}

void water_waves_scale(double units_per_m, water_wave_term* terms, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    terms[i].amplitude *= units_per_m;
    terms[i].k /= units_per_m;
    terms[i].turns_per_m[0] /= units_per_m;
    terms[i].turns_per_m[1] /= units_per_m;
  }
}

void water_waves_reach(const water_wave* waves, size_t count, double* height, double* across)
{
  *height = 0.0;
  *across = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    *height += waves[i].amplitude;
    *across += waves[i].amplitude * waves[i].steepness;
  }
}

void water_waves_rows(
  const water_wave_term* terms, size_t count, double x, double y, water_wave_row* rows)
{
  const double way[2] = { 0.0, 0.0 };
  for (size_t i = 0; i < count; ++i)
  {
    const water_wave_term* term = &terms[i];
    rows[i].k[0] = (float)(term->k * term->dir[0]);
    rows[i].k[1] = (float)(term->k * term->dir[1]);
    rows[i].amplitude = (float)term->amplitude;
    rows[i].phase = (float)(water_two_pi * water_turn(turns_at(term, x, y, way)));
    rows[i].steepness = (float)term->steepness;
  }
}

double water_waves_number(const water_wave* waves, size_t count)
{
  double height = 0.0;
  double slope = 0.0;
  water_waves_rms(waves, count, &height, &slope);
  return height > 0.0 ? slope / height : 0.0;
}

int water_waves_rest_steps(bool is_displaced, bool is_steep)
{
  const int from_place = 3;
  return is_displaced ? 1 : is_steep ? from_place : 0;
}

double water_waves_slack(double height_max)
{
  return 0.25 * height_max;
}
