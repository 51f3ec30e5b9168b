// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPolygons.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSmartPointer.h"
#include "vtkStructuredGrid.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <map>

namespace
{
// The number of points that a cell of a type has; 0: any number.
vtkIdType PointsOfType(int type)
{
  auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetNumberOfPoints() : 0;
}

// The first cell with fewer points than its type has; empty: there is none.
std::string FindMissingCorner(vtkUnstructuredGrid* grid)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  const vtkIdType types = grid->GetCellTypes() ? grid->GetCellTypes()->GetNumberOfValues() : 0;
#else
  const vtkIdType types =
    grid->GetCellTypesArray() ? grid->GetCellTypesArray()->GetNumberOfValues() : 0;
#endif
  if (types < grid->GetCells()->GetNumberOfCells())
  {
    return "the grid has " + std::to_string(types) + " cell types; it has " +
      std::to_string(grid->GetCells()->GetNumberOfCells()) + " cells";
  }
  std::map<int, vtkIdType> wanted;
  std::string wrong;
  vtkWaterForEachCell(grid->GetCells(), [&](vtkIdType cell, const vtkIdType*, vtkIdType count) {
    const int type = grid->GetCellType(cell);
    auto known = wanted.find(type);
    known = known == wanted.end() ? wanted.emplace(type, PointsOfType(type)).first : known;
    if (wrong.empty() && count < known->second)
    {
      wrong = "cell " + std::to_string(cell) + " has " + std::to_string(count) +
        (count == 1 ? " point" : " points") + "; cells of its type (" + std::to_string(type) +
        ") have " + std::to_string(known->second);
    }
  });
  return wrong;
}

// What is wrong with the offsets of cells, which must ascend from 0 and end in the list of points;
// empty: nothing is.
std::string FindWrongOffset(vtkCellArray* cells)
{
  vtkDataArray* offsets = cells->GetOffsetsArray();
  const vtkIdType count = offsets->GetNumberOfValues();
  const vtkIdType most = cells->GetNumberOfConnectivityIds();
  const int64_t* starts = vtkWaterCellLists(cells).Starts;
  vtkIdType before = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType start = starts ? static_cast<vtkIdType>(starts[i])
                                   : static_cast<vtkIdType>(offsets->GetComponent(i, 0));
    if (start < before || start > most || (i == 0 && start != 0))
    {
      return "offset " + std::to_string(i) +
        " of the cells is wrong; offsets must ascend from 0 to at most " + std::to_string(most);
    }
    before = start;
  }
  return {};
}

// What is wrong with the points of a grid of rows; empty: nothing is.
std::string FindMissingPoint(vtkDataSet* input)
{
  int size[3] = { 0, 0, 0 };
  if (auto* grid = vtkStructuredGrid::SafeDownCast(input))
  {
    grid->GetDimensions(size);
    const vtkIdType wanted = static_cast<vtkIdType>(size[0]) * size[1] * size[2];
    return grid->GetNumberOfPoints() >= wanted
      ? std::string()
      : "the grid has " + std::to_string(grid->GetNumberOfPoints()) +
        " points; its dimensions need " + std::to_string(wanted);
  }
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(input))
  {
    grid->GetDimensions(size);
    vtkDataArray* const axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType has = axes[i] ? axes[i]->GetNumberOfTuples() : 0;
      if (has < size[i])
      {
        return "the grid has " + std::to_string(has) + " coordinates along axis " +
          std::to_string(i) + "; its dimensions need " + std::to_string(size[i]);
      }
    }
  }
  return {};
}

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
  const std::string wrongOffset = cells ? FindWrongOffset(cells) : std::string();
  if (!cells || !wrongOffset.empty() || !vtkWaterHasCell(cells, isWrong))
  {
    return wrongOffset;
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
    const std::string wrong = FindWrongPoint(grid->GetCells(), 0, points);
    return wrong.empty() && grid->GetCells() ? FindMissingCorner(grid) : wrong;
  }
  std::string wrong = FindMissingPoint(input);
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
