// SPDX-License-Identifier: BSD-3-Clause
// test_math.c: the helpers and the inverses, on which everything else stands.
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

// Numbers are asked up to the count and no further.
TEST(numbers_are_finite_or_usable_up_to_their_count)
{
  const double bad[3] = { (double)NAN, (double)INFINITY, 1.0001e100 };
  for (int i = 0; i < 3; ++i)
  {
    const double values[4] = { -1e100, 1e100, 0.0, i == 1 ? -bad[i] : bad[i] };
    const bool is_finite = i == 2;
    assert_true(water_all_finite(values, 3));
    assert_true(water_all_usable(values, 3));
    assert_int_equal(water_all_finite(values, 4), is_finite);
    assert_false(water_all_usable(values, 4));
    assert_true(water_all_finite(values + 3, 0));
    assert_true(water_all_usable(values + 3, 0));
  }
}

// A box is finite when each of its numbers is, whatever their sum; empty when it is so on any axis,
// which a flat one is not.
TEST(boxes_are_finite_and_empty_by_axis)
{
  const double huge[6] = { -1.0, DBL_MAX, -1.0, DBL_MAX, -1.0, DBL_MAX };
  const double flat[6] = { 1.0, 1.0, 2.0, 2.0, -3.0, -3.0 };
  assert_true(water_bounds_are_finite(huge));
  assert_true(water_bounds_are_finite(flat));
  assert_false(water_bounds_is_empty(huge));
  assert_false(water_bounds_is_empty(flat));
  for (int i = 0; i < 6; ++i)
  {
    double box[6];
    memcpy(box, flat, sizeof box);
    box[i] = i % 2 ? -4.0 : 4.0; // either end past the other
    assert_true(water_bounds_is_empty(box));
    box[i] = (double)NAN;
    assert_false(water_bounds_are_finite(box));
    box[i] = (double)INFINITY;
    assert_false(water_bounds_are_finite(box));
    memcpy(box, huge, sizeof box);
    box[i] = -(double)INFINITY;
    assert_false(water_bounds_are_finite(box));
  }
}

// Bit 0, 1 and 2 of a corner's number pick the upper end on x, y and z.
TEST(corners_are_numbered_in_binary)
{
  const double box[6] = { 1.0, 2.0, 10.0, 20.0, 100.0, 200.0 };
  const double sums[8] = { 111.0, 112.0, 121.0, 122.0, 211.0, 212.0, 221.0, 222.0 };
  for (int number = 0; number < 8; ++number)
  {
    double corner[4] = { 0.0, 0.0, 0.0, 7.0 };
    water_bounds_corner(box, number, corner);
    assert_true(corner[0] + corner[1] + corner[2] == sums[number]);
    assert_true(corner[0] < 10.0 && corner[2] >= 100.0 && corner[3] == 7.0);
  }
}

// Small whole numbers have exact products, worked out by hand.
TEST(products_of_whole_numbers_are_exact)
{
  const double a[4] = { 1.0, 2.0, 3.0, 4.0 };
  const double b[4] = { 5.0, 7.0, 11.0, 13.0 };
  const double sides[3] = { 2.0, 3.0, 6.0 };
  assert_true(water_vec3_dot(a, b) == 52.0);
  assert_true(water_vec4_dot(a, b) == 104.0);
  assert_true(water_vec3_length(sides) == 7.0);
  double product[4];
  water_vec3_cross(a, b, product);
  assert_true(product[0] == 1.0 && product[1] == 4.0 && product[2] == -3.0);

  const double m[16] = { 1, 2, 0, 3, -1, 4, 1, 0, 2, 0, 5, -2, 1, 1, 0, 6 };
  const double columns[3][4] = { { 17, 10, 9, 27 }, { 8, 10, 15, 9 }, { 5, 10, 17, 3 } };
  const double row[4] = { 9, 14, 17, 21 };
  for (int i = 0; i < 4; ++i)
  {
    water_mat4_apply(m, a, product);
    assert_true(product[i] == columns[0][i]);
    water_mat4_apply_point(m, a, product);
    assert_true(product[i] == columns[1][i]);
    water_mat4_apply_dir(m, a, product);
    assert_true(product[i] == columns[2][i]);
    water_mat4_apply_row(a, m, product);
    assert_true(product[i] == row[i]);
  }
  const double squared[16] = { 2, 13, 2, 21, -3, 14, 9, -5, 10, 2, 25, -16, 6, 12, 1, 39 };
  double both[17];
  both[16] = 7.0;
  water_mat4_multiply(m, m, both);
  assert_memory_equal(both, squared, sizeof squared);
  assert_true(both[16] == 7.0);
}

// The power of two is that of the largest of four, their signs aside; others are passed by.
TEST(exponent_is_that_of_the_largest_of_four)
{
  double values[17] = { 0.0 };
  bool is_zero = false;
  for (int stride = 1; stride <= 4; stride += 3)
  {
    for (int i = 0; i < 17; ++i)
    {
      values[i] = i % stride == 0 && i / stride < 4 ? (i == stride ? -12.0 : 1.0) : 1e9;
    }
    assert_int_equal(water_mat4_exponent(values, stride, &is_zero), -4);
    assert_false(is_zero);
  }
  const double zeros[5] = { 0.0, 0.0, 0.0, 0.0, 1.0 };
  assert_int_equal(water_mat4_exponent(zeros, 1, &is_zero), 0);
  assert_true(is_zero);
}

// A matrix times its inverse is the identity.
TEST(inverse_undoes_random_matrices)
{
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
  const double m[16] = { 1, 1, 0, 0, 1, 1 + 1e-8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double inverse[16];
  assert_true(water_mat4_invert(m, inverse));
  assert_inverse(m, inverse, 1e-14);
}

// A matrix whose rows depend on each other, or with a row or column of zeros, has none, whatever
// its scale; nor has one that is not finite. The output is left alone.
TEST(inverse_refuses_singular_matrices)
{
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

// A pivot of 16 roundings of the largest entry, here 1/2 of it, is the smallest; a determinant
// whose inverse overflows is none.
TEST(inverse_ends_where_it_is_said_to)
{
  for (int i = 0; i < 2; ++i)
  {
    const double close = 1.0 + (i == 0 ? 32.0 : 31.0) * DBL_EPSILON;
    const double m[16] = { 1, 1, 0, 0, 1, close, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    double inverse[16];
    assert_int_equal(water_mat4_invert(m, inverse), i == 0);
  }
  const double tiny[16] = { 1e-155, 0, 0, 0, 0, 1e-155, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  double inverse[16] = { 7.0 };
  assert_false(water_mat4_invert_affine(tiny, inverse));
  assert_true(inverse[0] == 7.0);
}

// Where the inverse of a projection is 0 it is 0, not a rounding: the view ray of a parallel camera
// is its third column, and a rounding of its frustum's width would turn it.
TEST(inverse_of_a_projection_keeps_its_zeros)
{
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

TESTS(numbers_are_finite_or_usable_up_to_their_count, boxes_are_finite_and_empty_by_axis,
  corners_are_numbered_in_binary, products_of_whole_numbers_are_exact,
  exponent_is_that_of_the_largest_of_four, inverse_undoes_random_matrices,
  inverse_survives_any_scale, inverse_exists_close_to_singular, inverse_refuses_singular_matrices,
  inverse_ends_where_it_is_said_to, inverse_of_a_projection_keeps_its_zeros,
  affine_inverse_finds_the_eye)
