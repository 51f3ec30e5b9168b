// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterWetPolygons: the parts of a polygon that are under water.
#ifndef vtkWaterWetPolygons_h
#define vtkWaterWetPolygons_h

#include "vtkType.h"
#include "water_shore.h"

#include <vector>

// Calls function(corners, points, count) for each: corners as of water_shore_cut, of the points
// passed along. A polygon that the shore crosses once is cut whole, others as the triangles that
// meet in their first corner.
//
// depths  of the mesh's points
template <typename Function>
void vtkWaterForWetParts(
  const double* depths, const vtkIdType* points, vtkIdType count, Function function)
{
  const auto all = static_cast<size_t>(count);
  std::vector<double> own(all);
  std::vector<water_shore_corner> corners(2 * all);
  const auto cut = [&](const vtkIdType* polygon, size_t size) {
    for (size_t i = 0; i < size; ++i)
    {
      own[i] = depths[polygon[i]];
    }
    const bool isSplit = water_shore_is_split(own.data(), size);
    const size_t made = isSplit ? 0 : water_shore_cut(own.data(), size, corners.data());
    if (made > 0)
    {
      function(corners.data(), polygon, made);
    }
    return !isSplit;
  };
  if (cut(points, all))
  {
    return;
  }
  for (size_t number = 0; number + 2 < all; ++number)
  {
    size_t three[3];
    water_shore_triangle(number, three);
    const vtkIdType triangle[3] = { points[three[0]], points[three[1]], points[three[2]] };
    cut(triangle, 3);
  }
}

#endif
