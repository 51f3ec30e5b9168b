// SPDX-License-Identifier: BSD-3-Clause
// water_regions.h: which points of a mesh are connected by its cells.
//
// Source: Tarjan and van Leeuwen 1984, "Worst-case Analysis of Set Union Algorithms": union with
// path halving.
#ifndef water_regions_h
#define water_regions_h

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

// Makes each point a separate region.
//
// parents  one for each point; the other functions work on it
void water_regions_begin(int64_t* parents, size_t count);

// The point that stands for the region of a point.
int64_t water_regions_find(int64_t* parents, int64_t point);

// Makes one region of those of a cell's points. The lowest point stands for it.
void water_regions_join(int64_t* parents, const int64_t* points, size_t count);

#ifdef __cplusplus
}
#endif
#endif
