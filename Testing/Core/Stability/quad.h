// SPDX-License-Identifier: BSD-3-Clause
// quad.h: the truths' arithmetic: 113 bits (IEEE 754 binary128, GCC's libquadmath), 2^60 times
// finer than what it judges. Doubles in it are exact.
#ifndef quad_h
#define quad_h

#include <quadmath.h>

typedef __float128 quad;

static inline quad quad_dot(const quad a[3], const quad b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline quad quad_length(const quad a[3])
{
  return sqrtq(quad_dot(a, a));
}

static inline void quad_of(const double* values, int count, quad* made)
{
  for (int i = 0; i < count; ++i)
  {
    made[i] = (quad)values[i];
  }
}

// Rows of 4 times (x, w).
static inline void quad_apply(
  const double* matrix, int row_count, const quad x[3], quad w, quad* product)
{
  for (int i = 0; i < row_count; ++i)
  {
    const double* row = matrix + 4 * i;
    product[i] = (quad)row[0] * x[0] + (quad)row[1] * x[1] + (quad)row[2] * x[2] + (quad)row[3] * w;
  }
}

// Determinant of the rotation part.
static inline quad quad_determinant(const double m[16])
{
  quad r[9];
  for (int i = 0; i < 9; ++i)
  {
    r[i] = (quad)m[4 * (i / 3) + i % 3];
  }
  return r[0] * (r[4] * r[8] - r[5] * r[7]) - r[1] * (r[3] * r[8] - r[5] * r[6]) +
    r[2] * (r[3] * r[7] - r[4] * r[6]);
}

// Inverse of the rotation part, for a matrix that is not quite one: cofactors over determinant.
static inline void quad_invert_rotation(const double m[16], quad inverse[9])
{
  const quad scale = 1 / quad_determinant(m);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double* a = m + 4 * ((j + 1) % 3);
      const double* b = m + 4 * ((j + 2) % 3);
      const int k = (i + 1) % 3;
      const int l = (i + 2) % 3;
      inverse[3 * i + j] = scale * ((quad)a[k] * (quad)b[l] - (quad)a[l] * (quad)b[k]);
    }
  }
}

#endif
