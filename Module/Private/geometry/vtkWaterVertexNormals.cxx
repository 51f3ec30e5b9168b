// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVertexNormals.h"

#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkWaterCellChunks.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterShoreCells.h"
#include "water_polygon.h"

#include <algorithm>
#include <vector>

namespace
{
// Calls function(begin, end) for rows of cells that are not land.
template <typename Predicate, typename Function>
void ForRows(vtkIdType begin, vtkIdType end, Predicate isLand, Function function)
{
  for (vtkIdType cell = begin; cell < end;)
  {
    vtkIdType next = cell;
    while (next < end && !isLand(next))
    {
      ++next;
    }
    if (next > cell)
    {
      function(cell, next);
    }
    cell = next + 1;
  }
}

// The same sums without a list of the cells' normals: by one thread, or by several of which each
// adds to the points that no block before its own has; the others follow, in the order of cells.
template <typename Predicate>
void AddInPlace(const double* points, vtkCellArray* cells, Predicate isLand,
  const vtkWaterCellBlocks* blocks, float* sums)
{
  const vtkWaterCellLists lists(cells);
  const auto add = [&](vtkIdType begin, vtkIdType end, const water_polygon_share* share) {
    const auto count = static_cast<size_t>(end - begin);
    const int64_t* starts = lists.Starts + begin;
    share ? water_polygon_add_shared_normals(points, starts, lists.Corners, count, share, sums)
          : water_polygon_add_normals(points, starts, lists.Corners, count, sums);
  };
  const auto shareOf = [&](vtkIdType block, bool isOwned) {
    return water_polygon_share{ blocks->FirstBlocks.data(), static_cast<uint16_t>(block), isOwned };
  };
  if (!blocks)
  {
    ForRows(0, cells->GetNumberOfCells(), isLand,
      [&](vtkIdType begin, vtkIdType end) { add(begin, end, nullptr); });
    return;
  }
  vtkWaterForBlocks(
    cells->GetNumberOfCells(), [&](vtkIdType block, vtkIdType first, vtkIdType last) {
      const water_polygon_share share = shareOf(block, true);
      ForRows(
        first, last, isLand, [&](vtkIdType begin, vtkIdType end) { add(begin, end, &share); });
    });
  for (vtkIdType cell : blocks->SharedCells)
  {
    const water_polygon_share share = shareOf(cell / vtkWaterBlockSize, false);
    if (!isLand(cell))
    {
      add(cell, cell + 1, &share);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkWaterVertexNormals(vtkPolyData* mesh,
  const vtkWaterShoreCells* shore, vtkWaterKept<vtkFloatArray>* kept,
  const vtkWaterCellBlocks* blocks)
{
  const auto isLand = [shore](vtkIdType cell) {
    return shore && shore->Kinds[static_cast<size_t>(cell)] == vtkWaterShoreCells::Dry;
  };
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkWaterKept<vtkFloatArray> alone;
  const vtkSmartPointer<vtkFloatArray> normals = (kept ? kept : &alone)->Take("Normals", 3, count);
  float* all = normals->GetPointer(0);
  vtkSMPTools::For(0, count,
    [all](vtkIdType begin, vtkIdType end) { std::fill(all + 3 * begin, all + 3 * end, 0.0f); });
  const auto finish = [all](vtkIdType begin, vtkIdType end) {
    water_polygon_unit_normals(all + 3 * begin, static_cast<size_t>(end - begin));
  };
  const vtkWaterPlaces places(mesh->GetPoints());
  vtkCellArray* cells = mesh->GetPolys();
  const bool isAlone = vtkSMPTools::GetEstimatedNumberOfThreads() == 1;
  if (places.GetDoubles() && vtkWaterCellLists(cells).Starts && (isAlone || blocks))
  {
    AddInPlace(places.GetDoubles(), cells, isLand, isAlone ? nullptr : blocks, all);
    vtkSMPTools::For(0, count, finish);
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
  vtkSMPTools::For(0, count, finish);
  return normals;
}
