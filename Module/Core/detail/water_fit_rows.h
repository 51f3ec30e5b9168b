// SPDX-License-Identifier: BSD-3-Clause
// water_fit_rows.h: rows of quads, many at once, for the fit of a plane; private to the core.
#ifndef water_fit_rows_h
#define water_fit_rows_h

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// So many quads are summed at once, each in sums of its own: compilers use wide instructions then.
#define WATER_FIT_LANES 16

// Integrals over a polygon, with the sign of the side that it turns to.
typedef struct water_fit_integrals
{
  double area;
  double first[3];
  double second[6];
} water_fit_integrals;

// Adds quads of a list from its beginning, as long as there are many in a row.
//
// points   rows of 3
// starts   count + 1: where each polygon's corners begin in the list, and where the last one's end
// corners  points
// origin   that places are relative to
// bounds   of all corners, extended
//
// Returns how many.
size_t water_fit_rows_add(const double* points, const int64_t* starts, const int64_t* corners,
  size_t count, const double origin[3], double bounds[6], water_fit_integrals* sum);

#ifdef __cplusplus
}
#endif
#endif
