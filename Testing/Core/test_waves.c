// SPDX-License-Identifier: BSD-3-Clause
// test_waves.c: sines, trochoids, and the way back from a place to its point.
#include "test_scene.h"

#include "water_waves.h"

static const double two_pi = 6.283185307179586;
static const double deep = (double)INFINITY;

static void terms_of(
  const water_wave* waves, size_t count, double depth, double time, water_wave_term* terms)
{
  size_t bad_index = 0;
  assert_int_equal(water_waves_at(waves, count, depth, time, terms, &bad_index), WATER_OK);
}

// The height is A sin(k . x + phase - omega t): a quarter turn on, the crest is at the origin; it
// travels along its direction with omega / k.
TEST(sine_wave_is_where_it_should_be)
{
  const water_wave wave = { 0.5, 8.0, two_pi / 8.0, two_pi / 4.0, 0.0 };
  water_wave_term term;
  water_wave_point point;
  terms_of(&wave, 1, deep, 0.0, &term);
  water_waves_point(&term, 1, 0.0, 0.0, &point);
  ASSERT_CLOSE(point.displacement[2], 0.5, 1e-15);
  ASSERT_CLOSE(point.displacement[0], 0.0, 1e-15);
  ASSERT_CLOSE(point.jacobian, 1.0, 1e-15);
  ASSERT_CLOSE(point.normal[2], 1.0, 1e-15);
  const double seconds = 3.7;
  // phase velocity sqrt(g / k)
  const double way = seconds * sqrt(9.80665 * 8.0 / two_pi) * sqrt(0.5);
  terms_of(&wave, 1, deep, seconds, &term);
  water_waves_point(&term, 1, way, way, &point);
  ASSERT_CLOSE(point.displacement[2], 0.5, 1e-14);
  // whole wavelengths away, a million of them, it is the same
  water_wave_point far;
  water_waves_point(&term, 1, way + 8e6 * sqrt(0.5), way + 8e6 * sqrt(0.5), &far);
  ASSERT_CLOSE(far.displacement[2], 0.5, 1e-14);
}

static const water_wave crossing[3] = { { 0.4, 12.0, 0.3, 0.1, 0.9 }, { 0.2, 5.0, -0.8, 1.0, 0.8 },
  { 0.1, 3.0, 2.0, 2.5, 1.0 } };

// Slope, normal and area belong to the surface itself: differences of nearby points say the same.
TEST(normal_slope_and_area_are_those_of_the_surface)
{
  dice from = dice_seeded(3);
  water_wave_term terms[3];
  for (int round = 0; round < 500; ++round)
  {
    terms_of(crossing, 3, 6.0, dice_roll(&from, 0.0, 1e5), terms);
    const double rest[2] = { dice_roll(&from, -1e3, 1e3), dice_roll(&from, -1e3, 1e3) };
    const double step = 1e-4;
    double tangent[2][3] = { { 0.0 } };
    for (int i = 0; i < 2; ++i)
    {
      for (int side = -1; side <= 1; side += 2)
      {
        water_wave_point near_by;
        const double x = rest[0] + (i == 0 ? side * step : 0.0);
        const double y = rest[1] + (i == 1 ? side * step : 0.0);
        water_waves_point(terms, 3, x, y, &near_by);
        for (int j = 0; j < 3; ++j)
        {
          tangent[i][j] += side * near_by.displacement[j] / (2.0 * step);
        }
      }
      tangent[i][i] += 1.0;
    }
    double normal[3];
    cross(tangent[0], tangent[1], normal);
    water_wave_point point;
    water_waves_point(terms, 3, rest[0], rest[1], &point);
    ASSERT_CLOSE(point.jacobian, normal[2], 1e-7);
    for (int i = 0; i < 2; ++i)
    {
      ASSERT_CLOSE(point.slope[i], -normal[i] / normal[2], 1e-5);
    }
    normalise(normal);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(point.normal[i], normal[i], 1e-6);
    }
  }
}

// Gerstner's trochoid, after Lamb, "Hydrodynamics", 251: its steepest tangent has sine kA, and its
// mean level over the ground is k A^2 / 2 under the level of rest.
TEST(trochoid_has_its_known_slope_and_mean_level)
{
  const double steep = 0.6;
  const water_wave wave = { steep * 10.0 / two_pi, 10.0, 0.0, 0.0, 1.0 };
  water_wave_term term;
  terms_of(&wave, 1, deep, 12.3, &term);
  double largest = 0.0;
  double sum = 0.0;
  for (int i = 0; i < 4000; ++i)
  {
    water_wave_point point;
    double rest[2];
    water_waves_point(&term, 1, 0.0025 * i, 0.0, &point);
    largest = fmax(largest, sqrt(1.0 - point.normal[2] * point.normal[2]));
    assert_int_equal(water_waves_find(&term, 1, 0.0025 * i, 5.0, rest, &point), WATER_OK);
    sum += point.displacement[2] / 4000.0;
  }
  ASSERT_CLOSE(largest, steep, 1e-6);
  ASSERT_CLOSE(sum, -0.5 * steep * wave.amplitude, 1e-12);
}

// What is found over a place lies over the place, far out and late too, and is what the point at
// rest says.
TEST(find_undoes_the_displacement)
{
  dice from = dice_seeded(4);
  water_wave waves[3];
  memcpy(waves, crossing, sizeof waves);
  for (int round = 0; round < 3000; ++round)
  {
    double sum = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      waves[i].direction_rad = dice_roll(&from, 0.0, two_pi);
      waves[i].wavelength = dice_roll(&from, 1.0, 50.0);
      waves[i].amplitude = dice_roll(&from, 0.0, 1.0);
      sum += two_pi / waves[i].wavelength * waves[i].amplitude * waves[i].steepness;
    }
    for (int i = 0; i < 3; ++i)
    {
      waves[i].amplitude *= (round % 2 == 0 ? 0.999 : 0.5) / sum;
    }
    water_wave_term terms[3];
    terms_of(waves, 3, 20.0, dice_roll(&from, 0.0, 1e7), terms);
    const double size = round % 3 == 0 ? 1e6 : 10.0;
    const double x = dice_roll(&from, -size, size);
    const double y = dice_roll(&from, -size, size);
    double rest[2];
    water_wave_point found;
    water_wave_point there;
    assert_int_equal(water_waves_find(terms, 3, x, y, rest, &found), WATER_OK);
    ASSERT_CLOSE(rest[0] + found.displacement[0], x, 4e-16 * size + 1e-14);
    ASSERT_CLOSE(rest[1] + found.displacement[1], y, 4e-16 * size + 1e-14);
    water_waves_point(terms, 3, rest[0], rest[1], &there);
    ASSERT_CLOSE(there.displacement[2], found.displacement[2], 1e-15 * size + 1e-14);
  }
}

// A trochoid at its limit has a cusp at the crest, where no area is left; the normal points up, and
// the height over the cusp and beside it is still found.
TEST(cusp_is_safe)
{
  const water_wave wave = { 1.0, two_pi, 0.0, two_pi / 4.0, 1.0 };
  water_wave_term term;
  water_wave_point point;
  double rest[2];
  terms_of(&wave, 1, deep, 0.0, &term);
  water_waves_point(&term, 1, 0.0, 3.0, &point);
  ASSERT_CLOSE(point.jacobian, 0.0, 1e-15);
  ASSERT_CLOSE(point.normal[2], 1.0, 0.0);
  ASSERT_CLOSE(point.slope[0], 0.0, 0.0);
  assert_int_equal(water_waves_find(&term, 1, 0.0, 0.0, rest, &point), WATER_OK);
  ASSERT_CLOSE(point.displacement[2], 1.0, 1e-9);
  for (double x = -3.0; x < 3.0; x += 0.01)
  {
    assert_int_equal(water_waves_find(&term, 1, x, 0.0, rest, &point), WATER_OK);
    ASSERT_CLOSE(rest[0] - sin(rest[0]), x, 1e-14); // the cycloid
    ASSERT_CLOSE(point.displacement[2], cos(rest[0]), 1e-9);
    assert_true(point.normal[2] >= 0.0);
  }
}

// So close to a cusp that no area is left to a double, the water comes from far beside it: from the
// cube root of six times as far.
TEST(beside_a_cusp_the_water_comes_from_farther)
{
  const double places[3] = { 1e-12, 1e-10, 3e-9 };
  const double angles[2] = { 0.0, 0.25 * two_pi }; // along either axis
  for (int i = 0; i < 12; ++i)
  {
    const int axis = i / 3 % 2;
    const double place = (i / 6 ? -1.0 : 1.0) * places[i % 3];
    const water_wave wave = { 1.0, two_pi, angles[axis], two_pi / 4.0, 1.0 };
    water_wave_term term;
    water_wave_point point;
    double rest[2];
    terms_of(&wave, 1, deep, 0.0, &term);
    assert_int_equal(
      water_waves_find(&term, 1, axis ? 0.0 : place, axis ? place : 0.0, rest, &point), WATER_OK);
    ASSERT_CLOSE(rest[axis], cbrt(6.0 * place), 1e-2 * fabs(cbrt(6.0 * place)));
  }
}

// No wave, no surface but the plane.
TEST(no_waves_are_a_flat_surface)
{
  double rest[2] = { 0.0, 0.0 };
  water_wave_point point;
  assert_int_equal(water_waves_find(NULL, 0, 3.0, -4.0, rest, &point), WATER_OK);
  ASSERT_CLOSE(rest[0], 3.0, 0.0);
  ASSERT_CLOSE(rest[1], -4.0, 0.0);
  ASSERT_CLOSE(point.normal[2], 1.0, 0.0);
  ASSERT_CLOSE(point.displacement[2], 0.0, 0.0);
}

// rms height and slope are those of many points of the surface.
TEST(rms_is_that_of_the_surface)
{
  water_wave waves[3];
  memcpy(waves, crossing, sizeof waves);
  water_wave_term terms[3];
  double squares[2] = { 0.0, 0.0 };
  for (int i = 0; i < 3; ++i)
  {
    waves[i].steepness = 0.0;
  }
  terms_of(waves, 3, deep, 0.0, terms);
  dice from = dice_seeded(5);
  const int count = 100000;
  for (int i = 0; i < count; ++i)
  {
    water_wave_point point;
    water_waves_point(terms, 3, dice_roll(&from, -1e5, 1e5), dice_roll(&from, -1e5, 1e5), &point);
    squares[0] += point.displacement[2] * point.displacement[2] / count;
    squares[1] += (point.slope[0] * point.slope[0] + point.slope[1] * point.slope[1]) / count;
  }
  double height = 0.0;
  double slope = 0.0;
  water_waves_rms(waves, 3, &height, &slope);
  ASSERT_CLOSE(height, sqrt(squares[0]), 0.01 * height);
  ASSERT_CLOSE(slope, sqrt(squares[1]), 0.01 * slope);
}

// A shader that adds up the rows in float about their origin gets the core's height within 1e-4 of
// the amplitude, at 1e7 s and a million metres out.
TEST(rows_give_the_same_height_in_float)
{
  water_wave_term terms[3];
  water_wave_row rows[3];
  const double origin[2] = { 1e6, -2e6 };
  terms_of(crossing, 3, 6.0, 1e7, terms);
  water_waves_rows(terms, 3, origin[0], origin[1], rows);
  dice from = dice_seeded(6);
  for (int round = 0; round < 1000; ++round)
  {
    const double way[2] = { dice_roll(&from, -100.0, 100.0), dice_roll(&from, -100.0, 100.0) };
    float sum = 0.0f;
    for (int i = 0; i < 3; ++i)
    {
      assert_true(fabsf(rows[i].phase) < 3.1416f);
      const float along = rows[i].k[0] * (float)way[0] + rows[i].k[1] * (float)way[1];
      sum += rows[i].amplitude * sinf(along + rows[i].phase);
    }
    water_wave_point point;
    water_waves_point(terms, 3, origin[0] + way[0], origin[1] + way[1], &point);
    ASSERT_CLOSE((double)sum, point.displacement[2], 0.7e-4);
  }
  ASSERT_CLOSE((double)rows[1].steepness, 0.8, 1e-7);
}

// Each value out of its range has its own status and names the wave; the outputs stay as they were.
TEST(bad_waves_are_refused)
{
  const double nan = (double)NAN;
  const double infinity = (double)INFINITY;
  const struct
  {
    water_wave wave;
    water_status status;
  } cases[] = {
    { { nan, 1, 0, 0, 0 }, WATER_BAD_WAVE_AMPLITUDE },
    { { -1, 1, 0, 0, 0 }, WATER_BAD_WAVE_AMPLITUDE },
    { { infinity, 1, 0, 0, 0 }, WATER_BAD_WAVE_AMPLITUDE },
    { { 1.1e9, 1, 0, 0, 0 }, WATER_BAD_WAVE_AMPLITUDE },
    { { 1, 0, 0, 0, 0 }, WATER_BAD_WAVELENGTH },
    { { 1, nan, 0, 0, 0 }, WATER_BAD_WAVELENGTH },
    { { 1, infinity, 0, 0, 0 }, WATER_BAD_WAVELENGTH },
    { { 1, 1e-310, 0, 0, 0 }, WATER_BAD_WAVELENGTH },
    { { 1, 1, nan, 0, 0 }, WATER_BAD_WAVE_DIRECTION },
    { { 1, 1, 0, infinity, 0 }, WATER_BAD_WAVE_PHASE },
    { { 1, 1, 0, 0, -0.1 }, WATER_BAD_STEEPNESS },
    { { 1, 1, 0, 0, 1.1 }, WATER_BAD_STEEPNESS },
    { { 1, 1, 0, 0, nan }, WATER_BAD_STEEPNESS },
    { { 1, 6, 0, 0, 1 }, WATER_WAVES_FOLD },
  };
  for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i)
  {
    const water_wave waves[2] = { crossing[0], cases[i].wave };
    water_wave_term terms[2] = { { { 0.0, 0.0 }, { 0.0, 0.0 }, 7.0, 0.0, 0.0, 0.0 } };
    size_t bad_index = 9;
    assert_int_equal(water_waves_check(waves, 2, &bad_index), cases[i].status);
    assert_int_equal(bad_index, 1);
    assert_int_equal(water_waves_at(waves, 2, deep, 0.0, terms, &bad_index), cases[i].status);
    assert_true(terms[0].k == 7.0);
  }
  // two that do not fold alone, together do
  const water_wave both[2] = { { 1, 10, 0, 0, 1 }, { 1, 10, 1, 0, 1 } };
  size_t bad_index = 9;
  assert_int_equal(water_waves_check(both, 1, &bad_index), WATER_OK);
  assert_int_equal(water_waves_check(both, 2, &bad_index), WATER_WAVES_FOLD);
  assert_int_equal(bad_index, 1);
}

TEST(bad_numbers_are_refused)
{
  const double nan = (double)NAN;
  water_wave_term term;
  size_t bad_index = 9;
  assert_int_equal(water_waves_at(crossing, 1, -2.0, 0.0, &term, &bad_index), WATER_BAD_DEPTH);
  assert_int_equal(water_waves_at(crossing, 1, 2.0, nan, &term, &bad_index), WATER_BAD_TIME);
  assert_int_equal(water_waves_at(crossing, 1, 2.0, deep, &term, &bad_index), WATER_BAD_TIME);
  assert_int_equal(bad_index, 9);
  terms_of(crossing, 1, 2.0, 0.0, &term);
  double rest[2] = { 7.0, 7.0 };
  water_wave_point point;
  assert_int_equal(water_waves_find(&term, 1, nan, 0.0, rest, &point), WATER_BAD_POINT);
  assert_int_equal(water_waves_find(&term, 1, 0.0, deep, rest, &point), WATER_BAD_POINT);
  assert_true(rest[0] == 7.0);
}

// A tilted normal has the sum of both slopes; on a cusp, where the normal lies flat, it stays.
TEST(tilt_adds_slopes)
{
  const double slope[2] = { 0.3, -0.2 };
  const double length = sqrt(1.0 + 0.25 + 0.01);
  double normal[3] = { -0.5 / length, 0.1 / length, 1.0 / length };
  water_waves_tilt(slope, normal);
  ASSERT_CLOSE(normal[0] / normal[2], -0.8, 1e-15);
  ASSERT_CLOSE(normal[1] / normal[2], 0.3, 1e-15);
  ASSERT_CLOSE(hypot(hypot(normal[0], normal[1]), normal[2]), 1.0, 1e-15);
  double flat[3] = { 1.0, 0.0, 0.0 };
  water_waves_tilt(slope, flat);
  assert_true(flat[0] == 1.0 && flat[1] == 0.0 && flat[2] == 0.0);
}

// No point of the surface leaves its reach, and crests that meet come near it.
TEST(reach_holds_the_surface)
{
  const water_wave waves[2] = { { 0.5, 6.0, 0.3, 0.0, 0.6 }, { 0.25, 4.0, 1.1, 0.0, 0.2 } };
  double height = 0.0;
  double across = 0.0;
  water_waves_reach(waves, 2, &height, &across);
  ASSERT_CLOSE(height, 0.75, 1e-15);
  ASSERT_CLOSE(across, 0.35, 1e-15);
  water_wave_term terms[2];
  terms_of(waves, 2, 5.0, 0.0, terms);
  double highest = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    for (int j = 0; j < 200; ++j)
    {
      water_wave_point point;
      water_waves_point(terms, 2, 0.3 * i, 0.3 * j, &point);
      assert_true(fabs(point.displacement[2]) <= height);
      assert_true(hypot(point.displacement[0], point.displacement[1]) <= across);
      highest = fmax(highest, point.displacement[2]);
    }
  }
  assert_true(highest > 0.98 * height);
}

// One wave is as steep as k A, and looked up by 4 times that; its number is its own. Waves about to
// fold have no steepest slope.
TEST(slope_looked_up_bounds_the_slope)
{
  water_wave wave = { 0 };
  wave.amplitude = 0.1;
  wave.wavelength = 2.0;
  const double k = 3.14159265358979323846;
  ASSERT_CLOSE(water_waves_looked_up(&wave, 1), 0.4 * k, 1e-12);
  ASSERT_CLOSE(water_waves_number(&wave, 1), k, 1e-12);
  wave.steepness = 1.0;
  ASSERT_CLOSE(water_waves_looked_up(&wave, 1), 0.4 * k / (1.0 - 0.1 * k), 1e-12);
  wave.amplitude = 1.0 / k;
  assert_true(isinf(water_waves_looked_up(&wave, 1)));
  ASSERT_CLOSE(water_waves_looked_up(NULL, 0), 0.0, 0.0);
  ASSERT_CLOSE(water_waves_number(NULL, 0), 0.0, 0.0);
}

// A place that is no number has no surface, whichever of its two parts it is, waves or none.
TEST(no_place_has_no_surface)
{
  const double bad[3] = { (double)NAN, (double)INFINITY, (double)-INFINITY };
  for (int i = 0; i < 3; ++i)
  {
    double rest[2] = { 7.0, 7.0 };
    water_wave_point point;
    assert_int_equal(water_waves_find(NULL, 0, bad[i], 1.0, rest, &point), WATER_BAD_POINT);
    assert_int_equal(water_waves_find(NULL, 0, 1.0, bad[i], rest, &point), WATER_BAD_POINT);
    assert_true(rest[0] == 7.0 && rest[1] == 7.0);
    assert_int_equal(water_waves_find(NULL, 0, 1.0, 2.0, rest, &point), WATER_OK);
    assert_true(rest[0] == 1.0 && rest[1] == 2.0 && point.displacement[2] == 0.0);
  }
}

// A sine given as other waves, which know their derivatives: a water_waves_add.
typedef struct other_wave
{
  double k;
  double amplitude;
  double steepness;
} other_wave;

static bool add_other(const void* context, double x, double y, water_wave_sum* sum)
{
  const other_wave* wave = context;
  const double angle = wave->k * x;
  (void)y;
  sum->moved[0] += wave->steepness * wave->amplitude * cos(angle);
  sum->moved[2] += wave->amplitude * sin(angle);
  sum->gradient[0] += wave->k * wave->amplitude * cos(angle);
  sum->stretch[0] -= wave->steepness * wave->k * wave->amplitude * sin(angle);
  return fabs(x) < 1e6;
}

// Other waves are found as the same ones among the terms are, and so are the points of waves that
// are steeper than breaking ones, whose normals are less steep; where no surface is known there is
// none.
TEST(other_waves_are_found_as_terms)
{
  const water_wave same = { 0.3, 6.0, 0.0, 0.0, 0.8 };
  water_wave_term term;
  terms_of(&same, 1, INFINITY, 0.0, &term);
  other_wave wave = { two_pi / 6.0, 0.3, 0.8 };
  water_wave_others others = { add_other, &wave, 0.24 };
  ASSERT_CLOSE(water_waves_least_area(), 0.1, 0.0);
  for (int i = 0; i < 100; ++i)
  {
    const double x = -5.0 + 0.1 * i;
    double rest[2];
    double other_rest[2];
    water_wave_point found;
    water_wave_point other;
    assert_int_equal(water_waves_find(&term, 1, x, 0.5, rest, &found), WATER_OK);
    assert_int_equal(water_waves_find_all(NULL, 0, &others, x, 0.5, other_rest, &other), WATER_OK);
    ASSERT_CLOSE(other_rest[0], rest[0], 1e-6);
    ASSERT_CLOSE(other_rest[1], 0.5, 1e-6);
    ASSERT_CLOSE(other.displacement[2], found.displacement[2], 1e-6);
    ASSERT_CLOSE(other.slope[0], found.slope[0], 1e-5);
  }
  wave.amplitude = 1.15; // k A Q is 0.963: steeper than breaking waves
  others.across = 0.92;
  for (int i = 0; i < 100; ++i)
  {
    const double x = -5.0 + 0.1 * i;
    double rest[2];
    water_wave_point found;
    assert_int_equal(water_waves_find_all(NULL, 0, &others, x, 0.0, rest, &found), WATER_OK);
    ASSERT_CLOSE(rest[0] + wave.steepness * wave.amplitude * cos(wave.k * rest[0]), x, 1e-4);
  }
  double rest[2] = { 7.0, 7.0 };
  water_wave_point found;
  assert_int_equal(water_waves_find_all(NULL, 0, &others, 2e6, 0.0, rest, &found), WATER_BAD_POINT);
  ASSERT_CLOSE(rest[0], 7.0, 0.0);
}

TESTS(other_waves_are_found_as_terms, sine_wave_is_where_it_should_be,
  normal_slope_and_area_are_those_of_the_surface, trochoid_has_its_known_slope_and_mean_level,
  find_undoes_the_displacement, cusp_is_safe, beside_a_cusp_the_water_comes_from_farther,
  no_waves_are_a_flat_surface, rms_is_that_of_the_surface, rows_give_the_same_height_in_float,
  bad_waves_are_refused, bad_numbers_are_refused, tilt_adds_slopes, reach_holds_the_surface,
  slope_looked_up_bounds_the_slope, no_place_has_no_surface)
