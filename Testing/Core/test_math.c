// SPDX-License-Identifier: BSD-3-Clause
// test_math.c: the inverses, on which everything else stands.
#include "test_scene.h"

#include "water_math.h"

static void assert_inverse(const double m[16], const double inverse[16], double tolerance)
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      double sum = 0.0;
      double size = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        sum += m[4 * i + k] * inverse[4 * k + j];
        size += fabs(m[4 * i + k] * inverse[4 * k + j]);
      }
      ASSERT_CLOSE(sum, i == j ? 1.0 : 0.0, tolerance * (1.0 + size));
    }
  }
}

// A matrix times its inverse is the identity.
TEST(inverse_undoes_random_matrices)
{
  UNUSED;
  dice from = dice_seeded(1);
  for (int round = 0; round < 2000; ++round)
  {
    double m[16];
    double inverse[16];
    for (int i = 0; i < 16; ++i)
    {
      m[i] = dice_roll(&from, -1.0, 1.0);
    }
    assert_true(water_mat4_invert(m, inverse));
    assert_inverse(m, inverse, 1e-10);
  }
}

// Near and far planes 1e18 apart, and scenes in any unit, have an inverse.
TEST(inverse_survives_any_scale)
{
  UNUSED;
  const double box[4] = { -1e-6, 2e-6, -1e-6, 1e-6 };
  double m[16];
  double inverse[16];
  frustum_matrix(box, 1e-6, 1e12, m);
  assert_true(water_mat4_invert(m, inverse));
  assert_inverse(m, inverse, 1e-14);
  for (int i = 0; i < 16; ++i)
  {
    m[i] *= 1e-200;
  }
  assert_true(water_mat4_invert(m, inverse));
  assert_inverse(m, inverse, 1e-14);
  // rows in units of their own
  double rows[16] = { 2, 1, 0, 1, 1, 3, 1, 0, 0, 1, 2, 1, 1, 0, 1, 4 };
  for (int i = 0; i < 16; ++i)
  {
    const int row = i / 4;
    rows[i] *= pow(10.0, 30.0 * row - 45.0);
  }
  assert_true(water_mat4_invert(rows, inverse));
  assert_inverse(rows, inverse, 1e-14);
}

// Rows that differ in the eighth digit only still have an inverse.
TEST(inverse_exists_close_to_singular)
{
  UNUSED;
  const double m[16] = { 1, 1, 0, 0, 1, 1 + 1e-8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double inverse[16];
  assert_true(water_mat4_invert(m, inverse));
  assert_inverse(m, inverse, 1e-14);
}

// A matrix whose rows depend on each other, or with a row or column of zeros, has none, whatever
// its scale; nor has one that is not finite. The output is left alone.
TEST(inverse_refuses_singular_matrices)
{
  UNUSED;
  double cases[5][16] = {
    { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 17 },
    { 1e9, 2e9, 3e9, 4e9, 1e-9, 2e-9, 3e-9, 4e-9, 0, 0, 1, 0, 0, 0, 0, 1 },
    { 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },
    { 1, 0, 0, 1, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 1 },
    { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },
  };
  cases[4][5] = (double)NAN;
  for (int number = 0; number < 5; ++number)
  {
    double inverse[16] = { 7.0 };
    assert_false(water_mat4_invert(cases[number], inverse));
    assert_true(inverse[0] == 7.0);
  }
}

// Where the inverse of a projection is 0 it is 0, not a rounding: the view ray of a parallel camera
// is its third column, and a rounding of its frustum's width would turn it.
TEST(inverse_of_a_projection_keeps_its_zeros)
{
  UNUSED;
  dice from = dice_seeded(61);
  for (int round = 0; round < 1000; ++round)
  {
    double m[16];
    double inverse[16];
    const double half = pow(10.0, dice_roll(&from, -9.0, 9.0));
    const double x = half * dice_roll(&from, -100.0, 100.0);
    const double y = half * dice_roll(&from, -100.0, 100.0);
    const double near_z = pow(10.0, dice_roll(&from, -6.0, 6.0));
    const double far_z = near_z * pow(10.0, dice_roll(&from, 0.1, 8.0));
    const double box[4] = { x - half, x + half, y - half, y + half };
    ortho_matrix(box, near_z, far_z, m);
    assert_true(water_mat4_invert(m, inverse));
    static const int parallel_zeros[9] = { 1, 2, 4, 6, 8, 9, 12, 13, 14 };
    for (int i = 0; i < 9; ++i)
    {
      assert_true(inverse[parallel_zeros[i]] == 0.0);
    }
    frustum_matrix(box, near_z, far_z, m);
    assert_true(water_mat4_invert(m, inverse));
    static const int perspective_zeros[9] = { 1, 2, 4, 6, 8, 9, 10, 12, 13 };
    for (int i = 0; i < 9; ++i)
    {
      assert_true(inverse[perspective_zeros[i]] == 0.0);
    }
  }
}

// The inverse of a view takes the origin of view space to the eye, however far out the eye is.
TEST(affine_inverse_finds_the_eye)
{
  UNUSED;
  const double eye[3] = { 5e6, -4e6, 12.5 };
  const double target[3] = { 5e6 + 3.0, -4e6 + 4.0, 11.0 };
  const double up[3] = { 0.0, 0.0, 1.0 };
  double view[16];
  double inverse[16];
  look_at(eye, target, up, view);
  assert_true(water_mat4_invert_affine(view, inverse));
  for (int i = 0; i < 3; ++i)
  {
    ASSERT_CLOSE(inverse[4 * i + 3], eye[i], 1e-8);
  }
  assert_inverse(view, inverse, 1e-14);
  const double flat[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1 };
  assert_false(water_mat4_invert_affine(flat, inverse));
}

int main(void)
{
  const struct CMUnitTest tests[] = {
    RUN(inverse_undoes_random_matrices),
    RUN(inverse_survives_any_scale),
    RUN(inverse_exists_close_to_singular),
    RUN(inverse_refuses_singular_matrices),
    RUN(inverse_of_a_projection_keeps_its_zeros),
    RUN(affine_inverse_finds_the_eye),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
