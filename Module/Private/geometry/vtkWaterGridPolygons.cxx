// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterGridPolygons.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"
#include "vtkWaterPolygons.h"

#include <algorithm>
#include <utility>

namespace
{
// Are points or cells marked as hidden, or as those of another part of the mesh?
bool HasGhosts(vtkDataSet* input)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  return input->GetPointData()->HasArray(name) || input->GetCellData()->HasArray(name);
}

// Has the grid only cells that are polygons as they stand?
bool HasPolygonsOnly(vtkUnstructuredGrid* input)
{
  vtkNew<vtkCellTypes> types;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  input->GetDistinctCellTypes(types);
#else
  input->GetCellTypes(types);
#endif
  for (vtkIdType i = 0; i < types->GetNumberOfTypes(); ++i)
  {
    const int type = types->GetCellType(i);
    if (type != VTK_TRIANGLE && type != VTK_QUAD && type != VTK_POLYGON)
    {
      return false;
    }
  }
  return types->GetNumberOfTypes() > 0;
}

// Points along each axis; {}: the data set has no rows of points.
std::array<int, 3> DimensionsOf(vtkDataSet* input)
{
  std::array<int, 3> dimensions{};
  if (auto* curved = vtkStructuredGrid::SafeDownCast(input))
  {
    curved->GetDimensions(dimensions.data());
  }
  else if (auto* image = vtkImageData::SafeDownCast(input))
  {
    image->GetDimensions(dimensions.data());
  }
  else if (auto* straight = vtkRectilinearGrid::SafeDownCast(input))
  {
    straight->GetDimensions(dimensions.data());
  }
  return dimensions;
}

// All numbers that the places of the points depend on, besides their number.
std::vector<double> AxesOf(vtkDataSet* input)
{
  std::vector<double> axes;
  if (auto* image = vtkImageData::SafeDownCast(input))
  {
    axes.insert(axes.end(), image->GetOrigin(), image->GetOrigin() + 3);
    axes.insert(axes.end(), image->GetSpacing(), image->GetSpacing() + 3);
    const double* turn = image->GetDirectionMatrix()->GetData();
    axes.insert(axes.end(), turn, turn + 9);
    const int* extent = image->GetExtent(); // points are counted from its first
    axes.insert(axes.end(), extent, extent + 6);
  }
  else if (auto* straight = vtkRectilinearGrid::SafeDownCast(input))
  {
    for (vtkDataArray* along :
      { straight->GetXCoordinates(), straight->GetYCoordinates(), straight->GetZCoordinates() })
    {
      for (vtkIdType i = 0; along && i < along->GetNumberOfTuples(); ++i)
      {
        axes.push_back(along->GetComponent(i, 0));
      }
    }
  }
  return axes;
}

// Is a bit set in a mark of points or cells? No mark: it is not.
bool IsMarked(vtkUnsignedCharArray* marks, vtkIdType i, unsigned char bit)
{
  return marks && i < marks->GetNumberOfValues() && (marks->GetValue(i) & bit) != 0;
}

// VTK's filter keeps the hidden cells of rows, and leaves them to the mapper.
void LeaveHidden(vtkPolyData* mesh)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  auto* ofPoints = vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetArray(name));
  auto* ofCells = vtkUnsignedCharArray::SafeDownCast(mesh->GetCellData()->GetArray(name));
  std::vector<vtkIdType> hidden;
  vtkWaterForEachCell(
    mesh->GetPolys(), [&](vtkIdType cell, const vtkIdType* points, vtkIdType count) {
      const bool isHidden = IsMarked(ofCells, cell, vtkDataSetAttributes::HIDDENCELL) ||
        std::any_of(points, points + count, [ofPoints](vtkIdType point) {
          return IsMarked(ofPoints, point, vtkDataSetAttributes::HIDDENPOINT);
        });
      if (isHidden)
      {
        hidden.push_back(cell);
      }
    });
  if (hidden.empty())
  {
    return;
  }
  mesh->BuildCells();
  for (const vtkIdType cell : hidden)
  {
    mesh->DeleteCell(cell);
  }
  mesh->RemoveDeletedCells();
}

void GiveArrays(vtkDataSet* input, vtkPolyData* mesh)
{
  mesh->GetPointData()->ShallowCopy(input->GetPointData());
  mesh->GetCellData()->ShallowCopy(input->GetCellData());
  mesh->GetFieldData()->ShallowCopy(input->GetFieldData());
}
}

//------------------------------------------------------------------------------
vtkWaterGridPolygons::vtkWaterGridPolygons() = default;

//------------------------------------------------------------------------------
vtkWaterGridPolygons::~vtkWaterGridPolygons() = default;

//------------------------------------------------------------------------------
void vtkWaterGridPolygons::Make(vtkDataSet* input, vtkPolyData* mesh)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (!(grid ? this->MakeOfCells(grid, mesh) : this->MakeOfRows(input, mesh)))
  {
    vtkWaterPolygonsOf(input, mesh);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterGridPolygons::MakeOfCells(vtkUnstructuredGrid* input, vtkPolyData* mesh)
{
  if (HasGhosts(input) || !HasPolygonsOnly(input))
  {
    return false;
  }
  mesh->Initialize();
  mesh->SetPoints(input->GetPoints());
  mesh->SetPolys(input->GetCells());
  GiveArrays(input, mesh);
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterGridPolygons::MakeOfRows(vtkDataSet* input, vtkPolyData* mesh)
{
  const std::array<int, 3> dimensions = DimensionsOf(input);
  std::array<int, 2> sides{};
  size_t count = 0; // of axes along which there are cells
  for (const int points : dimensions)
  {
    if (points > 1 && count < sides.size())
    {
      sides[count] = points;
    }
    count += points > 1 ? 1 : 0;
  }
  if (count != sides.size())
  {
    return false;
  }
  auto* curved = vtkStructuredGrid::SafeDownCast(input);
  if (!curved)
  {
    this->PlacePoints(input);
  }
  this->ListQuads(sides);
  mesh->Initialize();
  mesh->SetPoints(curved ? curved->GetPoints() : this->Points.Get());
  mesh->SetPolys(this->Quads);
  GiveArrays(input, mesh);
  if (HasGhosts(input))
  {
    LeaveHidden(mesh);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterGridPolygons::ListQuads(const std::array<int, 2>& sides)
{
  if (this->Quads && sides == this->Sides)
  {
    return;
  }
  this->Sides = sides;
  const vtkIdType row = sides[0];
  const vtkIdType count = (row - 1) * (sides[1] - 1);
  vtkNew<vtkIdTypeArray> starts;
  vtkNew<vtkIdTypeArray> corners;
  starts->SetNumberOfValues(count + 1);
  corners->SetNumberOfValues(4 * count);
  vtkIdType* corner = corners->GetPointer(0);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const vtkIdType first = cell / (row - 1) * row + cell % (row - 1);
    starts->SetValue(cell, 4 * cell);
    for (const vtkIdType point : { first, first + 1, first + row + 1, first + row })
    {
      *corner++ = point;
    }
  }
  starts->SetValue(count, 4 * count);
  this->Quads = vtkSmartPointer<vtkCellArray>::New();
  this->Quads->SetData(starts, corners);
}

//------------------------------------------------------------------------------
void vtkWaterGridPolygons::PlacePoints(vtkDataSet* input)
{
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<double> axes = AxesOf(input);
  if (this->Points && axes == this->Axes && this->Points->GetNumberOfPoints() == count)
  {
    return;
  }
  this->Axes = std::move(axes);
  this->Points = vtkSmartPointer<vtkPoints>::New();
  this->Points->SetDataTypeToDouble();
  this->Points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double place[3];
    input->GetPoint(i, place);
    this->Points->SetPoint(i, place);
  }
}
