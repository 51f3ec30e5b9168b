// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPolygons.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
// What is wrong with cells; empty: nothing is.
//
// start   number of the first of them in the data set
// points  their number
std::string FindWrongPoint(vtkCellArray* cells, vtkIdType start, vtkIdType points)
{
  const auto isWrong = [points](const vtkIdType* corners, vtkIdType count) {
    return std::any_of(corners, corners + count, [points](vtkIdType point) {
      // without a sign, a negative number is larger than all others
      return static_cast<vtkTypeUInt64>(point) >= static_cast<vtkTypeUInt64>(points);
    });
  };
  if (!cells || !vtkWaterHasCell(cells, isWrong)) // every step of a mesh is asked
  {
    return {};
  }
  vtkIdType wrongCell = -1; // the first one
  vtkIdType wrongPoint = 0;
  vtkWaterForEachCell(cells, [&](vtkIdType cell, const vtkIdType* corners, vtkIdType count) {
    const vtkIdType* wrong = std::find_if(
      corners, corners + count, [points](vtkIdType point) { return point < 0 || point >= points; });
    if (wrong != corners + count && wrongCell < 0)
    {
      wrongCell = cell;
      wrongPoint = *wrong;
    }
  });
  if (wrongCell < 0)
  {
    return {};
  }
  return "cell " + std::to_string(start + wrongCell) + " has the point " +
    std::to_string(wrongPoint) +
    (points > 0 ? "; points must lie in [0, " + std::to_string(points - 1) + "]"
                : "; the mesh has no points");
}
}

//------------------------------------------------------------------------------
std::string vtkWaterFindWrongPoint(vtkDataSet* input)
{
  const vtkIdType points = input->GetNumberOfPoints();
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(input))
  {
    return FindWrongPoint(grid->GetCells(), 0, points);
  }
  std::string wrong;
  if (auto* mesh = vtkPolyData::SafeDownCast(input))
  {
    vtkIdType start = 0; // in this order
    for (vtkCellArray* cells :
      { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
    {
      wrong = wrong.empty() ? FindWrongPoint(cells, start, points) : wrong;
      start += cells ? cells->GetNumberOfCells() : 0;
    }
  }
  return wrong;
}

//------------------------------------------------------------------------------
void vtkWaterPolygonsOf(vtkDataSet* input, vtkPolyData* mesh)
{
  mesh->ShallowCopy(input);
  if (!vtkPolyData::SafeDownCast(input))
  {
    vtkNew<vtkDataSetSurfaceFilter> outside;
    outside->SetInputData(input);
    outside->Update();
    mesh->ShallowCopy(outside->GetOutput());
  }
  if (mesh->GetNumberOfPolys() != mesh->GetNumberOfCells())
  {
    vtkNew<vtkTriangleFilter> polygons;
    polygons->SetInputData(mesh);
    polygons->PassLinesOff();
    polygons->PassVertsOff();
    polygons->Update();
    mesh->ShallowCopy(polygons->GetOutput());
  }
}
