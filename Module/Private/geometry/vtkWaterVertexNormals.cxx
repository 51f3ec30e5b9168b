// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVertexNormals.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterShoreCells.h"
#include "water_polygon.h"

#include <algorithm>
#include <vector>

namespace
{
// The same sums without a list of the cells' normals, which several threads need.
template <typename Predicate>
void AddInOrder(const double* points, const vtkWaterCellLists& lists, vtkIdType count,
  Predicate isLand, float* sums)
{
  for (vtkIdType cell = 0; cell < count;)
  {
    vtkIdType next = cell;
    while (next < count && !isLand(next))
    {
      ++next;
    }
    water_polygon_add_normals(
      points, lists.Starts + cell, lists.Corners, static_cast<size_t>(next - cell), sums);
    cell = next + 1;
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkWaterVertexNormals(
  vtkPolyData* mesh, const vtkWaterShoreCells* shore, vtkWaterKept<vtkFloatArray>* kept)
{
  const auto isLand = [shore](vtkIdType cell) {
    return shore && shore->Kinds[static_cast<size_t>(cell)] == vtkWaterShoreCells::Dry;
  };
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkWaterKept<vtkFloatArray> alone;
  const vtkSmartPointer<vtkFloatArray> normals = (kept ? kept : &alone)->Take("Normals", 3, count);
  float* all = normals->GetPointer(0);
  std::fill_n(all, 3 * count, 0.0f);
  const vtkWaterPlaces places(mesh->GetPoints());
  vtkCellArray* cells = mesh->GetPolys();
  const vtkWaterCellLists lists(cells);
  if (places.GetDoubles() && lists.Starts && vtkSMPTools::GetEstimatedNumberOfThreads() == 1)
  {
    AddInOrder(places.GetDoubles(), lists, cells->GetNumberOfCells(), isLand, all);
    water_polygon_unit_normals(all, static_cast<size_t>(count));
    return normals;
  }
  std::vector<float> ofCells(3 * static_cast<size_t>(cells->GetNumberOfCells()));
  vtkWaterForBlocks(cells->GetNumberOfCells(), [&](vtkIdType, vtkIdType begin, vtkIdType end) {
    std::vector<double> corners;
    vtkWaterForCells(
      cells, begin, end, [&](vtkIdType cell, const vtkIdType* points, vtkIdType cornerCount) {
        if (isLand(cell))
        {
          return;
        }
        corners.resize(3 * static_cast<size_t>(cornerCount));
        for (vtkIdType i = 0; i < cornerCount; ++i)
        {
          places.Get(points[i], &corners[3 * static_cast<size_t>(i)]);
        }
        double normal[3];
        water_polygon_normal(corners.data(), static_cast<size_t>(cornerCount), normal);
        std::copy_n(normal, 3, &ofCells[3 * static_cast<size_t>(cell)]);
      });
  });
  vtkWaterForEachCell(cells, [&](vtkIdType cell, const vtkIdType* points, vtkIdType cornerCount) {
    if (isLand(cell))
    {
      return;
    }
    const float* normal = &ofCells[3 * static_cast<size_t>(cell)];
    for (vtkIdType i = 0; i < cornerCount; ++i)
    {
      float* sum = all + 3 * points[i];
      sum[0] += normal[0];
      sum[1] += normal[1];
      sum[2] += normal[2];
    }
  });
  vtkSMPTools::For(0, count, [all](vtkIdType begin, vtkIdType end) {
    water_polygon_unit_normals(all + 3 * begin, static_cast<size_t>(end - begin));
  });
  return normals;
}
