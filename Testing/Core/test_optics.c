// SPDX-License-Identifier: BSD-3-Clause
// test_optics.c: the reflectance, against numbers of Fresnel's own form.
#include "test_scene.h"

#include "water_optics.h"

static const double water = 1.333;

static double cos_deg(double angle_deg)
{
  return cos(angle_deg * acos(-1.0) / 180.0);
}

// Reflectances computed from sines and tangents of the angles (Fresnel's own form, another one than
// the core's), from above, from below, and for glass.
TEST(fresnel_has_the_known_values)
{
  const double known[][3] = { // eta, degrees, reflectance
    { 1.333, 0, 0.0203731878 }, { 1.333, 10, 0.0203836676 }, { 1.333, 20, 0.0205554062 },
    { 1.333, 30, 0.0214364659 }, { 1.333, 40, 0.0245023610 }, { 1.333, 50, 0.0336678738 },
    { 1.333, 60, 0.0596909192 }, { 1.333, 70, 0.1334750019 }, { 1.333, 80, 0.3479167070 },
    { 1.333, 85, 0.5835234787 }, { 1.333, 89, 0.8962764037 }, { 1.333, 90, 1.0 },
    { 1 / 1.333, 0, 0.0203731878 }, { 1 / 1.333, 15, 0.0205625231 },
    { 1 / 1.333, 30, 0.0255191623 }, { 1 / 1.333, 40, 0.0555815915 },
    { 1 / 1.333, 45, 0.1394584557 }, { 1 / 1.333, 48, 0.4330766462 },
    { 1 / 1.333, 48.5, 0.7003063339 }, { 1 / 1.333, 48.7, 1.0 }, { 1 / 1.333, 60, 1.0 },
    { 1 / 1.333, 90, 1.0 }, { 1.5, 0, 0.04 }, { 1.5, 60, 0.0891867128 }
  };
  for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i)
  {
    ASSERT_CLOSE(water_optics_fresnel(cos_deg(known[i][1]), known[i][0]), known[i][2], 1e-9);
  }
}

// At Brewster's angle, tan = eta, no light polarised in the plane of incidence is reflected, so
// half of the other is; there the rays are at right angles, and its share is (sin^2 - cos^2)^2 =
// cos^2(2b).
TEST(brewster_angle_reflects_one_polarisation)
{
  for (double eta = 1.1; eta < 2.5; eta += 0.1)
  {
    const double brewster = atan(eta);
    const double root = cos(2.0 * brewster);
    ASSERT_CLOSE(water_optics_fresnel(cos(brewster), eta), 0.5 * root * root, 1e-14);
  }
}

// From under water everything beyond 48.61 degrees is reflected, and not everything before; from
// above there is no such angle.
TEST(critical_angle_of_water)
{
  const double critical = water_optics_critical_rad(1.0 / water);
  ASSERT_CLOSE(critical * 180.0 / acos(-1.0), 48.6066263917, 1e-9);
  assert_true(water_optics_fresnel(cos(critical + 1e-9), 1.0 / water) == 1.0);
  assert_true(water_optics_schlick(cos(critical + 1e-9), 1.0 / water) == 1.0);
  assert_true(water_optics_fresnel(cos(critical - 1e-6), 1.0 / water) < 0.999);
  assert_true(water_optics_schlick(cos(critical - 1e-6), 1.0 / water) < 0.999);
  ASSERT_CLOSE(water_optics_critical_rad(water), 0.5 * acos(-1.0), 1e-15);
}

// Light takes the same path both ways: a ray and its refracted one have the same reflectance.
TEST(reflectance_is_the_same_both_ways)
{
  for (double angle_deg = 0.0; angle_deg < 89.5; angle_deg += 1.0)
  {
    const double sine = sin(angle_deg * acos(-1.0) / 180.0) / water; // Snell
    const double refracted = sqrt(1.0 - sine * sine);
    const double above = water_optics_fresnel(cos_deg(angle_deg), water);
    ASSERT_CLOSE(water_optics_fresnel(refracted, 1.0 / water), above, 1e-12);
    const double schlick = water_optics_schlick(cos_deg(angle_deg), water);
    ASSERT_CLOSE(water_optics_schlick(refracted, 1.0 / water), schlick, 1e-12);
  }
}

// Schlick's curve has the exact ends, and stays near the exact one for water, but is not the same.
TEST(schlick_is_close_to_fresnel)
{
  double largest = 0.0;
  for (double angle_deg = 0.0; angle_deg <= 90.0; angle_deg += 0.25)
  {
    const double cosine = cos_deg(angle_deg);
    const double apart = water_optics_schlick(cosine, water) - water_optics_fresnel(cosine, water);
    largest = fmax(largest, fabs(apart));
  }
  assert_true(largest > 0.05 && largest < 0.06);
  ASSERT_CLOSE(water_optics_schlick(1.0, water), 0.0203731878, 1e-9);
  ASSERT_CLOSE(water_optics_schlick(0.0, water), 1.0, 1e-15);
}

// No difference of index, no surface: nothing is reflected at any angle; cosines that rounding took
// out of [0, 1] count as the nearest end.
TEST(ends_of_the_range_are_safe)
{
  for (int i = 0; i <= 10; ++i)
  {
    ASSERT_CLOSE(water_optics_fresnel(0.1 * i, 1.0), 0.0, 1e-15);
  }
  ASSERT_CLOSE(water_optics_fresnel(1.0 + 1e-9, water), 0.0203731878, 1e-9);
  ASSERT_CLOSE(water_optics_fresnel(-1e-9, water), 1.0, 1e-15);
  ASSERT_CLOSE(water_optics_schlick(-1e-9, water), 1.0, 1e-15);
}

// From above the other side is the water, from below the air.
TEST(plan_carries_the_index_beyond)
{
  water_scene scene = lake();
  ASSERT_CLOSE(plan_of(&scene, NULL).eta, 1.333, 1e-15);
  scene.plane.normal[2] = -1.0; // now the eye is below
  ASSERT_CLOSE(plan_of(&scene, NULL).eta, 0.7501875469, 1e-10);
}

// Waters that share a reflection texture are as one that reflects no less than each: from any
// angle.
TEST(joined_waters_reflect_no_less_than_each)
{
  const water_look looks[4] = { { 1.333, 0.3, true }, { 1.333, 0.5, true }, { 1.333, 0.1, false },
    { 1.5, 0.1, false } };
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      water_look all = looks[i];
      water_optics_join(looks + j, &all);
      for (int k = 0; k < 2; ++k)
      {
        const water_look* one = looks + (k ? i : j);
        for (double cosine = 0.0; cosine <= 1.0; cosine += 0.125)
        {
          const double mine = one->constant_reflectance
            ? one->reflectance
            : water_optics_fresnel(cosine, one->index_of_refraction);
          const double joined = all.constant_reflectance
            ? all.reflectance
            : water_optics_fresnel(cosine, all.index_of_refraction);
          assert_true(joined >= mine);
        }
      }
    }
  }
  water_look same = looks[2];
  water_optics_join(looks + 2, &same);
  assert_false(same.constant_reflectance); // not made a mirror by its like
}

// The most that is reflected, of the corners of a part of the picture; rows that mix x and y. Waves
// tilt the surface farther from the ray, by the angle of their slope.
static void assert_most(double slope_max)
{
  const double rows[9] = { 1.0, 0.5, 0.1, -0.25, 1.0, 0.2, 0.1, 0.3, -1.0 };
  const double box[4] = { -0.2, 0.1, 0.6, 0.9 };
  const water_look look = { 1.333, 0.0, false };
  double most = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double x = corner & 1 ? box[2] : box[0];
    const double y = corner & 2 ? box[3] : box[1];
    const double ray[3] = { x + 0.5 * y + 0.1, -0.25 * x + y + 0.2, 0.1 * x + 0.3 * y - 1.0 };
    const double flat = -ray[2] / sqrt(dot(ray, ray));
    // the cosine of a sum of angles
    const double c = (flat - sqrt(1.0 - flat * flat) * slope_max) / hypot(1.0, slope_max);
    const double g = sqrt(1.333 * 1.333 - 1.0 + c * c);
    const double s = (c - g) / (c + g);
    const double p = (1.333 * 1.333 * c - g) / (1.333 * 1.333 * c + g);
    most = fmax(most, 0.5 * (s * s + p * p));
  }
  ASSERT_CLOSE(water_optics_reflectance_max(&look, 1.333, rows, box, slope_max), most, 1e-14);
}

TEST(most_is_reflected_in_a_corner)
{
  assert_most(0.0);
  assert_most(0.25);
}

// An index under 1, a reflectance beyond [0, 1], and numbers that are none, are refused.
TEST(looks_beyond_their_ranges_are_refused)
{
  const double indices[4] = { 0.999, (double)NAN, (double)INFINITY, -(double)INFINITY };
  const double reflectances[4] = { -0.001, 1.001, (double)NAN, (double)INFINITY };
  for (int i = 0; i < 4; ++i)
  {
    const water_look thin = { indices[i], 0.5, true };
    const water_look bright = { 1.333, reflectances[i], true };
    assert_int_equal(water_optics_check(&thin), WATER_BAD_INDEX);
    assert_int_equal(water_optics_check(&bright), WATER_BAD_REFLECTANCE);
  }
}

TESTS(looks_beyond_their_ranges_are_refused, fresnel_has_the_known_values,
  brewster_angle_reflects_one_polarisation, critical_angle_of_water,
  reflectance_is_the_same_both_ways, schlick_is_close_to_fresnel, ends_of_the_range_are_safe,
  plan_carries_the_index_beyond, joined_waters_reflect_no_less_than_each,
  most_is_reflected_in_a_corner)
