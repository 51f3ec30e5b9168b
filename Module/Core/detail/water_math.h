// SPDX-License-Identifier: BSD-3-Clause
// water_math.h: the few vector and matrix helpers the core needs; private to the core.
//
// Matrices are 16 doubles, row-major, for column vectors. A plane is a row vector of 4: it goes
// from space a to space b by row * b_to_a. An output may be one of the inputs unless it says
// otherwise.
#ifndef water_math_h
#define water_math_h

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#ifdef __cplusplus
extern "C"
{
#endif

// A function that walks over large meshes: where the CPU has them, it uses wider instructions. Each
// number is still computed by the same operations, so results are the same. Only for static
// functions: a program would find the others of another library. WATER_NO_WIDE is for coverage,
// which would count the functions that this CPU does not call.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) &&       \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(WATER_NO_WIDE)
#define WATER_WIDE __attribute__((target_clones("default", "avx2")))
#define WATER_WIDE_PART __attribute__((always_inline)) // of such a function
#else
#define WATER_WIDE
#define WATER_WIDE_PART
#endif

static inline bool water_all_finite(const double* values, int count)
{
  for (int i = 0; i < count; ++i)
  {
    if (!isfinite(values[i]))
    {
      return false;
    }
  }
  return true;
}

// No number of a scene may be larger, nor an entry of a matrix or of its inverse: the product of
// any three of them, which is the most that the core multiplies, is still finite.
static const double water_largest = 1e100;

static inline bool water_all_usable(const double* values, int count)
{
  for (int i = 0; i < count; ++i)
  {
    if (!(fabs(values[i]) <= water_largest)) // NaN neither
    {
      return false;
    }
  }
  return true;
}

static inline bool water_bounds_are_finite(const double bounds[6])
{
  // one question for all, unless the sum of large numbers is not
  const double sum = bounds[0] + bounds[1] + bounds[2] + bounds[3] + bounds[4] + bounds[5];
  return isfinite(sum) || water_all_finite(bounds, 6);
}

// xmin, xmax, ymin, ymax, zmin, zmax; min > max on any axis: empty.
static inline bool water_bounds_is_empty(const double bounds[6])
{
  return bounds[0] > bounds[1] || bounds[2] > bounds[3] || bounds[4] > bounds[5];
}

// NaN is passed by.
static inline void water_bounds_add_point(double bounds[6], const double point[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = point[axis] < bounds[2 * axis] ? point[axis] : bounds[2 * axis];
    bounds[2 * axis + 1] = point[axis] > bounds[2 * axis + 1] ? point[axis] : bounds[2 * axis + 1];
  }
}

static inline void water_bounds_add(double bounds[6], const double other[6])
{
  for (int i = 0; i < 6; i += 2)
  {
    bounds[i] = other[i] < bounds[i] ? other[i] : bounds[i];
    bounds[i + 1] = other[i + 1] > bounds[i + 1] ? other[i + 1] : bounds[i + 1];
  }
}

// Nothing is in it yet.
static inline void water_bounds_begin(double bounds[6])
{
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] = i % 2 ? -DBL_MAX : DBL_MAX;
  }
}

// Corner 0 to 7 of a box; bit 0, 1, 2 of the number picks the upper end on x, y, z.
static inline void water_bounds_corner(const double bounds[6], int number, double corner[3])
{
  for (int i = 0; i < 3; ++i)
  {
    corner[i] = bounds[2 * i + ((number >> i) & 1)];
  }
}

static inline double water_vec3_dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double water_vec3_length(const double a[3])
{
  return sqrt(water_vec3_dot(a, a));
}

static inline void water_vec3_cross(const double a[3], const double b[3], double product[3])
{
  const double x = a[1] * b[2] - a[2] * b[1];
  const double y = a[2] * b[0] - a[0] * b[2];
  const double z = a[0] * b[1] - a[1] * b[0];
  product[0] = x;
  product[1] = y;
  product[2] = z;
}

static inline double water_vec4_dot(const double a[4], const double b[4])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

// product = matrix * column
static inline void water_mat4_apply(
  const double matrix[16], const double column[4], double product[4])
{
  double sum[4];
  for (int i = 0; i < 4; ++i)
  {
    sum[i] = water_vec4_dot(matrix + 4 * i, column);
  }
  memcpy(product, sum, sizeof sum);
}

static inline void water_mat4_apply_point(
  const double matrix[16], const double point[3], double product[4])
{
  const double column[4] = { point[0], point[1], point[2], 1.0 };
  water_mat4_apply(matrix, column, product);
}

static inline void water_mat4_apply_dir(
  const double matrix[16], const double dir[3], double product[4])
{
  const double column[4] = { dir[0], dir[1], dir[2], 0.0 };
  water_mat4_apply(matrix, column, product);
}

// product = row * matrix: how a plane changes space.
static inline void water_mat4_apply_row(
  const double row[4], const double matrix[16], double product[4])
{
  double sum[4];
  for (int j = 0; j < 4; ++j)
  {
    sum[j] = row[0] * matrix[j] + row[1] * matrix[4 + j] + row[2] * matrix[8 + j] +
      row[3] * matrix[12 + j];
  }
  memcpy(product, sum, sizeof sum);
}

// product = a * b
static inline void water_mat4_multiply(const double a[16], const double b[16], double product[16])
{
  double sum[16];
  for (int i = 0; i < 4; ++i)
  {
    water_mat4_apply_row(a + 4 * i, b, sum + 4 * i);
  }
  memcpy(product, sum, sizeof sum);
}

// Inverse of a matrix with the last row 0 0 0 1. Rows of the inverse of the 3x3 part are cross
// products over the determinant (Cramer), so a translation of any size stays out of the rotation.
//
// Returns false if the 3x3 part is singular. Then inverse is unchanged.
static inline bool water_mat4_invert_affine(const double matrix[16], double inverse[16])
{
  const double c0[3] = { matrix[0], matrix[4], matrix[8] };
  const double c1[3] = { matrix[1], matrix[5], matrix[9] };
  const double c2[3] = { matrix[2], matrix[6], matrix[10] };
  const double origin[3] = { matrix[3], matrix[7], matrix[11] };
  double rows[3][3];
  water_vec3_cross(c1, c2, rows[0]);
  water_vec3_cross(c2, c0, rows[1]);
  water_vec3_cross(c0, c1, rows[2]);
  const double determinant = water_vec3_dot(c0, rows[0]);
  if (determinant == 0.0 || !isfinite(1.0 / determinant))
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      rows[i][j] /= determinant;
      inverse[4 * i + j] = rows[i][j];
      inverse[12 + j] = 0.0;
    }
    inverse[4 * i + 3] = -water_vec3_dot(rows[i], origin);
  }
  inverse[15] = 1.0;
  return true;
}

// Power of two that brings the largest of 4 values, stride apart, into [1/2, 1); 0 if all are 0.
static inline int water_mat4_exponent(const double* values, int stride, bool* is_zero)
{
  double largest = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    largest = fmax(largest, fabs(values[i * stride]));
  }
  int exponent = 0;
  (void)frexp(largest, &exponent);
  *is_zero = largest == 0.0;
  return -exponent;
}

// A matrix on its way to its inverse (water_mat4_invert).
typedef struct water_mat4_elimination
{
  double left[4][4];
  double right[4][4];
  int row_exponent[4];
  int column_exponent[4];
  int row_of[4]; // column -> the row that holds its pivot; -1: none yet
  bool used[4];
} water_mat4_elimination;

// Scales rows, then columns, by powers of two; false: a column is 0.
static inline bool water_mat4_equilibrate(const double matrix[16], water_mat4_elimination* e)
{
  memset(e, 0, sizeof *e);
  memcpy(e->left, matrix, sizeof e->left);
  for (int i = 0; i < 4; ++i)
  {
    bool is_zero = false;
    e->row_exponent[i] = water_mat4_exponent(e->left[i], 1, &is_zero);
    for (int j = 0; j < 4; ++j)
    {
      e->left[i][j] = ldexp(e->left[i][j], e->row_exponent[i]);
    }
    e->right[i][i] = 1.0;
    e->row_of[i] = -1;
  }
  for (int j = 0; j < 4; ++j)
  {
    bool is_zero = false;
    e->column_exponent[j] = water_mat4_exponent(&e->left[0][j], 4, &is_zero);
    if (is_zero)
    {
      return false;
    }
    for (int i = 0; i < 4; ++i)
    {
      e->left[i][j] = ldexp(e->left[i][j], e->column_exponent[j]);
    }
  }
  return true;
}

// Chooses the next pivot; false: there is none.
static inline bool water_mat4_pivot(const water_mat4_elimination* e, int* row, int* column)
{
  double largest = 0.0;
  for (int i = 0; i < 16; ++i)
  {
    if (!e->used[i / 4] && e->row_of[i % 4] < 0)
    {
      largest = fmax(largest, fabs(e->left[i / 4][i % 4]));
    }
  }
  if (largest < 16.0 * DBL_EPSILON)
  {
    return false;
  }
  *row = 0;
  *column = 0;
  int fewest = 5;
  for (int i = 0; i < 4; ++i)
  {
    int count = 0; // of what the row would spread to others
    for (int j = 0; j < 4; ++j)
    {
      count += e->row_of[j] < 0 && e->left[i][j] != 0.0 ? 1 : 0;
    }
    for (int j = 0; j < 4 && !e->used[i]; ++j)
    {
      if (e->row_of[j] < 0 && fabs(e->left[i][j]) >= 0.125 * largest && count < fewest)
      {
        fewest = count;
        *row = i;
        *column = j;
      }
    }
  }
  return true;
}

// Takes a pivot's column out of all other rows.
static inline void water_mat4_eliminate(water_mat4_elimination* e, int row, int column)
{
  e->used[row] = true;
  e->row_of[column] = row;
  const double pivot = e->left[row][column];
  for (int j = 0; j < 4; ++j)
  {
    e->left[row][j] /= pivot;
    e->right[row][j] /= pivot;
  }
  for (int i = 0; i < 4; ++i)
  {
    const double factor = e->left[i][column];
    for (int j = 0; j < 4 && i != row; ++j)
    {
      e->left[i][j] -= factor * e->left[row][j];
      e->right[i][j] -= factor * e->right[row][j];
    }
  }
}

// Inverse of any matrix: Gauss-Jordan elimination with pivoting on the equilibrated matrix (Golub
// and Van Loan, "Matrix Computations", 3.4 and 3.5). Rows, then columns, are scaled by powers of
// two first, which is exact: near and far planes of any ratio, and units of any size, then give
// pivots near 1, and a pivot under 16 roundings of 1 means that the matrix has no inverse. A pivot
// is at least an eighth of the largest entry, and of those one in the row with the fewest entries
// (Markowitz 1957, "The Elimination Form of the Inverse"), so that zeros of a projection's inverse
// are zeros: a rounding in their place, times a scale of 1e9, would turn a view direction.
//
// Returns false if singular or not finite. Then inverse is unchanged.
static inline bool water_mat4_invert(const double matrix[16], double inverse[16])
{
  water_mat4_elimination e;
  if (!water_all_finite(matrix, 16) || !water_mat4_equilibrate(matrix, &e))
  {
    return false;
  }
  for (int step = 0; step < 4; ++step)
  {
    int row = 0;
    int column = 0;
    if (!water_mat4_pivot(&e, &row, &column))
    {
      return false;
    }
    water_mat4_eliminate(&e, row, column);
  }
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      inverse[4 * i + j] = ldexp(e.right[e.row_of[i]][j], e.column_exponent[i] + e.row_exponent[j]);
    }
  }
  return true;
}

// A rectangle of a texture (x, y, width, height) in its NDC: low x, low y, high x, high y.
static inline void water_rect_to_ndc(const int rect_px[4], const int texture_px[2], double box[4])
{
  for (int i = 0; i < 2; ++i)
  {
    box[i] = 2.0 * rect_px[i] / texture_px[i] - 1.0;
    box[2 + i] = 2.0 * (rect_px[i] + rect_px[2 + i]) / texture_px[i] - 1.0;
  }
}

// The part of the picture around a box: low x, low y, high x, high y in NDC.
//
// to_clip  from the box's space
//
// Returns false where the box has no such part: a corner is not before the eye.
static inline bool water_bounds_picture(
  const double to_clip[16], const double bounds[6], double picture[4])
{
  picture[0] = picture[1] = DBL_MAX;
  picture[2] = picture[3] = -DBL_MAX;
  for (int number = 0; number < 8; ++number)
  {
    double corner[3];
    double clip[4];
    water_bounds_corner(bounds, number, corner);
    water_mat4_apply_point(to_clip, corner, clip);
    const double place[2] = { clip[0] / clip[3], clip[1] / clip[3] };
    if (!(clip[3] > 0.0) || !water_all_finite(place, 2))
    {
      return false;
    }
    for (int i = 0; i < 2; ++i)
    {
      picture[i] = fmin(picture[i], place[i]);
      picture[2 + i] = fmax(picture[2 + i], place[i]);
    }
  }
  return true;
}

#ifdef __cplusplus
}
#endif
#endif
