// SPDX-License-Identifier: BSD-3-Clause
// test_medium.c: refraction, attenuation, single scattering and Jerlov's table.
#include "test_scene.h"

#include "water_medium.h"
#include "water_optics.h"

static const double water = 1.333;
static const double pi = 3.141592653589793;

// Fermat: of all ways from a point above to a point below, the refracted one takes the least time.
// Found by golden section, with no sine in it.
TEST(refracted_ray_is_the_fastest_way)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  for (double reach = 0.1; reach < 20.0; reach *= 1.5)
  {
    double low = 0.0; // from 1 above the origin to (reach, 0, -2)
    double high = reach;
    for (int i = 0; i < 100; ++i)
    {
      const double left = high - 0.6180339887498949 * (high - low);
      const double right = low + 0.6180339887498949 * (high - low);
      const double left_time = hypot(left, 1.0) + water * hypot(reach - left, 2.0);
      const double right_time = hypot(right, 1.0) + water * hypot(reach - right, 2.0);
      *(left_time < right_time ? &high : &low) = left_time < right_time ? right : left;
    }
    double in[3] = { low, 0.0, -1.0 };
    double out[3] = { reach - low, 0.0, -2.0 };
    normalise(in);
    normalise(out);
    double refracted[3];
    assert_int_equal(water_medium_refract(in, up, water, refracted), WATER_OK);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(refracted[i], out[i], 1e-6);
    }
    ASSERT_CLOSE(water_medium_cosine(-in[2], water), -out[2], 1e-6);
    ASSERT_CLOSE(water_medium_path(2.0, -in[2], water), hypot(reach - low, 2.0), 1e-5);
    // the bed's point appears straight over its place, on the line of sight
    const double apparent = (reach - low) * -in[2] / in[0];
    ASSERT_CLOSE(water_medium_apparent_depth(2.0, -in[2], water), apparent, 1e-5);
  }
}

// The way back is the way there; either side of the normal will do; unit length; in one plane.
TEST(refraction_is_reversible)
{
  dice from = dice_seeded(8);
  for (int round = 0; round < 5000; ++round)
  {
    double normal[3];
    double dir[3];
    dice_dir(&from, normal);
    dice_dir(&from, dir);
    double refracted[3];
    double other[3];
    double back[3];
    assert_int_equal(water_medium_refract(dir, normal, water, refracted), WATER_OK);
    ASSERT_CLOSE(dot(refracted, refracted), 1.0, 1e-14);
    assert_true(dot(dir, normal) * dot(refracted, normal) > 0.0);
    double plane[3];
    cross(dir, normal, plane);
    ASSERT_CLOSE(dot(plane, refracted), 0.0, 1e-15);
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = -normal[i];
      other[i] = -refracted[i];
    }
    assert_int_equal(water_medium_refract(other, normal, 1.0 / water, back), WATER_OK);
    assert_int_equal(water_medium_refract(dir, normal, water, other), WATER_OK);
    for (int i = 0; i < 3; ++i)
    {
      ASSERT_CLOSE(other[i], refracted[i], 0.0);
      ASSERT_CLOSE(back[i], -dir[i], 1e-9); // a grazing ray's cosine is a root of rounding
    }
  }
}

// Seen from below the sky ends at 48.607 degrees; beyond it there is no refracted ray.
TEST(window_has_its_half_angle)
{
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double critical = water_optics_critical_rad(1.0 / water);
  ASSERT_CLOSE(critical * 180.0 / pi, 48.607, 1e-3);
  double refracted[3] = { 7.0, 7.0, 7.0 };
  const double inside[3] = { sin(critical - 1e-9), 0.0, cos(critical - 1e-9) };
  const double outside[3] = { sin(critical + 1e-9), 0.0, cos(critical + 1e-9) };
  assert_int_equal(
    water_medium_refract(outside, up, 1.0 / water, refracted), WATER_TOTAL_REFLECTION);
  assert_true(refracted[0] == 7.0);
  assert_int_equal(water_medium_refract(inside, up, 1.0 / water, refracted), WATER_OK);
  ASSERT_CLOSE(refracted[0], 1.0, 1e-8); // along the surface
  ASSERT_CLOSE(water_medium_cosine(outside[2], 1.0 / water), 0.0, 0.0);
}

// At nadir a pool of 2 m looks 1.5 m deep; towards the horizon the bed rises to the surface. With
// no difference of index nothing is moved.
TEST(apparent_depth_has_known_ends)
{
  ASSERT_CLOSE(water_medium_apparent_depth(2.0, 1.0, water), 1.5003750937734434, 1e-15);
  ASSERT_CLOSE(water_medium_apparent_depth(2.0, 0.0, water), 0.0, 0.0);
  ASSERT_CLOSE(water_medium_apparent_depth(2.0, 0.4, 1.0), 2.0, 1e-15);
  ASSERT_CLOSE(water_medium_path(2.0, 1.0 + 1e-9, water), 2.0, 1e-15);
}

// Pure water loses 1 - 1/e of its red in 1 / 0.34 m; two ways one after the other multiply.
TEST(transmittance_is_bouguers)
{
  const water_medium medium = { { 0.34, 0.0565, 0.00922 }, { 0.0, 0.01, 0.002 } };
  double once[3];
  double twice[3];
  water_medium_transmittance(&medium, 1.0 / 0.34, once);
  water_medium_transmittance(&medium, 2.0 / 0.34, twice);
  ASSERT_CLOSE(once[0], 0.36787944117144233, 1e-15);
  ASSERT_CLOSE(once[1], exp(-0.0665 / 0.34), 1e-15);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(twice[i], once[i] * once[i], 1e-15);
  }
}

// What is scattered towards the eye, added up layer by layer: the sun's way down, a share of
// b phase ds, the way up. In many thin ones.
TEST(inscatter_is_the_sum_of_its_layers)
{
  const water_medium medium = { { 0.4, 0.05, 0.0 }, { 0.01, 0.03, 0.0 } };
  const double sun = 0.8;
  const double eye = 0.95;
  const double phase = 0.25 / pi;
  const double depth = 12.0;
  double sum[3] = { 0.0, 0.0, 0.0 };
  const int layers = 20000;
  for (int layer = 0; layer < layers; ++layer)
  {
    const double z = (layer + 0.5) * depth / layers;
    double down[3];
    double up[3];
    water_medium_transmittance(&medium, z / sun, down);
    water_medium_transmittance(&medium, z / eye, up);
    for (int i = 0; i < 3; ++i)
    {
      // irradiance 1 on a level plane is 1 / sun facing the sun
      sum[i] += down[i] / sun * medium.scattering[i] * phase * up[i] * depth / layers / eye;
    }
  }
  double inscatter[3];
  water_medium_inscatter(&medium, depth, sun, eye, phase, inscatter);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(inscatter[i], sum[i], 1e-6 * sum[i]);
  }
  // clear to the bottom of infinity, there is nothing to see
  double bottomless[3];
  water_medium_inscatter(&medium, (double)INFINITY, sun, eye, phase, bottomless);
  ASSERT_CLOSE(bottomless[0], inscatter[0], 1e-4 * inscatter[0]);
  assert_true(bottomless[1] > inscatter[1]);
  ASSERT_CLOSE(bottomless[2], 0.0, 0.0);
}

// Deep clear water is blue by the ratio b_b / a that all reflectance formulas share; its albedo is
// of the size of 0.33 b_b / a (Morel and Prieur 1977), within a factor of 2.
TEST(deep_clear_water_is_blue)
{
  water_medium medium;
  assert_int_equal(water_type_medium(WATER_TYPE_I, &medium), WATER_OK);
  double inscatter[3];
  water_medium_inscatter(&medium, (double)INFINITY, 1.0, 1.0, 0.5 / pi, inscatter);
  assert_true(inscatter[2] > 4.0 * inscatter[1] && inscatter[1] > 4.0 * inscatter[0]);
  const double known = 0.33 * medium.scattering[2] / medium.absorption[2];
  const double albedo = pi * inscatter[2];
  assert_true(albedo > 0.5 * known && albedo < 2.0 * known);
}

// Jerlov's numbers: type I passes 98.1 % of the blue a metre, 9C a fifth; daylight fades in the
// given order of types in every channel; each type's medium has Kd / 1.0395 in all and is never
// negative.
TEST(jerlov_types_are_in_order)
{
  double before[3] = { 0.0, 0.0, 0.0 };
  double kd[3];
  for (int type = 0; type < WATER_TYPE_COUNT; ++type)
  {
    water_medium medium;
    assert_int_equal(water_type_attenuation((water_type)type, kd), WATER_OK);
    assert_int_equal(water_type_medium((water_type)type, &medium), WATER_OK);
    assert_int_equal(water_medium_check(&medium), WATER_OK);
    for (int i = 0; i < 3; ++i)
    {
      assert_true(kd[i] >= before[i]);
      before[i] = kd[i];
      ASSERT_CLOSE(1.0395 * (medium.absorption[i] + medium.scattering[i]), kd[i], 1e-15);
    }
  }
  ASSERT_CLOSE(exp(-kd[2]), 0.2, 0.01);
  assert_int_equal(water_type_attenuation(WATER_TYPE_I, kd), WATER_OK);
  ASSERT_CLOSE(exp(-kd[2]), 0.981, 5e-4);
  // sea water scatters 0.0045 and 0.0019 at 450 and 550 nm (Morel's table, the same publication)
  water_medium medium;
  assert_int_equal(water_type_medium(WATER_TYPE_I, &medium), WATER_OK);
  ASSERT_CLOSE(2.0 * medium.scattering[2], 0.0045, 1e-4);
  ASSERT_CLOSE(2.0 * medium.scattering[1], 0.0019, 1e-4);
  assert_string_equal(water_type_text(WATER_TYPE_IB), "IB");
  assert_string_equal(water_type_text(WATER_TYPE_9C), "9C");
  assert_string_equal(water_type_text((water_type)-1), "unknown type");
}

TEST(bad_numbers_are_refused)
{
  const double bad[4] = { -0.1, (double)NAN, (double)INFINITY, 1.1e9 };
  for (int i = 0; i < 4; ++i)
  {
    water_medium medium = { { 0.1, 0.1, 0.1 }, { 0.1, 0.1, 0.1 } };
    assert_int_equal(water_medium_check(&medium), WATER_OK);
    medium.scattering[i % 3] = bad[i];
    assert_int_equal(water_medium_check(&medium), WATER_BAD_SCATTERING);
    medium.absorption[i % 3] = bad[i];
    assert_int_equal(water_medium_check(&medium), WATER_BAD_ABSORPTION);
  }
  double kd[3] = { 7.0, 7.0, 7.0 };
  water_medium medium;
  assert_int_equal(water_type_attenuation(WATER_TYPE_COUNT, kd), WATER_BAD_WATER_TYPE);
  assert_int_equal(water_type_medium((water_type)-1, &medium), WATER_BAD_WATER_TYPE);
  const double up[3] = { 0.0, 0.0, 1.0 };
  const double down[3] = { 0.0, 0.0, -1.0 };
  const double none[3] = { 0.0, 0.0, (double)NAN };
  const double large[3] = { 0.0, 0.0, 2.0 };
  assert_int_equal(water_medium_refract(none, up, water, kd), WATER_BAD_DIRECTION);
  assert_int_equal(water_medium_refract(down, large, water, kd), WATER_BAD_DIRECTION);
  assert_int_equal(water_medium_refract(down, up, 0.0, kd), WATER_BAD_INDEX_RATIO);
  assert_int_equal(water_medium_refract(down, up, bad[1], kd), WATER_BAD_INDEX_RATIO);
  assert_int_equal(water_medium_refract(down, up, bad[2], kd), WATER_BAD_INDEX_RATIO);
  assert_true(kd[0] == 7.0);
}

// Clear water without scattering is black, water that only scatters returns a third of the light,
// and pure water is blue.
TEST(reflectance_is_the_share_that_comes_back)
{
  const water_medium black = { { 0.3, 0.1, 0.05 }, { 0.0, 0.0, 0.0 } };
  const water_medium milk = { { 0.0, 0.0, 0.0 }, { 2.0, 1.0, 0.5 } };
  const water_medium nothing = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
  double share[3];
  double extinction[3];
  water_medium_extinction(&milk, extinction);
  water_medium_reflectance(&milk, share);
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(share[i], 0.33, 1e-15);
    ASSERT_CLOSE(extinction[i], milk.scattering[i], 0.0);
  }
  water_medium_reflectance(&black, share);
  ASSERT_CLOSE(share[0] + share[1] + share[2], 0.0, 0.0);
  water_medium_reflectance(&nothing, share);
  ASSERT_CLOSE(share[0] + share[1] + share[2], 0.0, 0.0);
  water_medium ocean;
  assert_int_equal(water_type_medium(WATER_TYPE_I, &ocean), WATER_OK);
  water_medium_reflectance(&ocean, share);
  assert_true(share[2] > 5.0 * share[1] && share[1] > share[0]);
}

// Coefficients may be 0 and 1e9, each of them.
TEST(coefficients_at_both_ends_are_accepted)
{
  const double ends[2] = { 0.0, 1e9 };
  for (int i = 0; i < 12; ++i)
  {
    water_medium medium = { { 0.1, 0.1, 0.1 }, { 0.1, 0.1, 0.1 } };
    (i < 6 ? medium.absorption : medium.scattering)[i % 3] = ends[i % 2];
    assert_int_equal(water_medium_check(&medium), WATER_OK);
  }
}

TESTS(coefficients_at_both_ends_are_accepted, refracted_ray_is_the_fastest_way,
  refraction_is_reversible, window_has_its_half_angle, apparent_depth_has_known_ends,
  transmittance_is_bouguers, inscatter_is_the_sum_of_its_layers, deep_clear_water_is_blue,
  jerlov_types_are_in_order, bad_numbers_are_refused, reflectance_is_the_share_that_comes_back)
