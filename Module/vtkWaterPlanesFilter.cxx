// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPlanesFilter.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkWaterCompat.h"
#include "vtkWaterGridPolygons.h"
#include "vtkWaterParts.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterVertexNormals.h"
#include "water_plane.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterPlanesFilter);

namespace
{
bool IsPolygon(int type)
{
  return type == VTK_TRIANGLE || type == VTK_QUAD || type == VTK_POLYGON;
}

// The first polygon of a data set that has too few points to be one; empty: there is none.
std::string FindTooFewPoints(vtkDataSet* input)
{
  auto* mesh = vtkPolyData::SafeDownCast(input);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  vtkCellArray* cells = mesh ? mesh->GetPolys() : (grid ? grid->GetCells() : nullptr);
  std::string few;
  const auto isTooFew = [](const vtkIdType*, vtkIdType count) { return count < 3; };
  if (!cells || !vtkWaterHasCell(cells, isTooFew))
  {
    return few;
  }
  const vtkIdType start = mesh ? mesh->GetNumberOfVerts() + mesh->GetNumberOfLines() : 0;
  vtkWaterForEachCell(cells, [&](vtkIdType cell, const vtkIdType*, vtkIdType count) {
    if (count < 3 && few.empty() && (mesh || IsPolygon(grid->GetCellType(cell))))
    {
      few = "cell " + std::to_string(start + cell) + " is a polygon of " + std::to_string(count) +
        " points; it must have at least 3";
    }
  });
  return few;
}

// Smooth ones, where the mesh has none.
void AddNormals(vtkPolyData* block)
{
  if (!block->GetPointData()->GetNormals())
  {
    block->GetPointData()->SetNormals(vtkWaterVertexNormals(block).Get());
  }
}
}

//------------------------------------------------------------------------------
vtkWaterPlanesFilter::vtkWaterPlanesFilter() = default;

//------------------------------------------------------------------------------
vtkWaterPlanesFilter::~vtkWaterPlanesFilter() = default;

//------------------------------------------------------------------------------
void vtkWaterPlanesFilter::SetUpDirection(double x, double y, double z)
{
  const double given[3] = { x, y, z };
  const water_plane plane = { { x, y, z }, 0.0 };
  water_plane unit;
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    vtkErrorMacro("UpDirection is ("
      << x << ", " << y << ", " << z << "); it must be finite and not zero. It stays ("
      << this->UpDirection[0] << ", " << this->UpDirection[1] << ", " << this->UpDirection[2]
      << ").");
    return;
  }
  if (!std::equal(given, given + 3, this->UpDirection))
  {
    std::copy_n(given, 3, this->UpDirection);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterPlanesFilter::SetMaximumNumberOfPlanes(int planes)
{
  vtkWaterSetInRange(MaximumNumberOfPlanes, planes, 1, 4096);
}

//------------------------------------------------------------------------------
int vtkWaterPlanesFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkWaterPlanesFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* input = vtkDataSet::GetData(inputVector[0]);
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector);
  this->NumberOfPlanes = 0;
  if (!input || input->GetNumberOfCells() == 0)
  {
    return 1;
  }
  const std::string wrong = vtkWaterFindWrongPoint(input);
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong << ". There are no planes.");
    return 1; // once: a failure would be told by the pipeline, too
  }
  const std::string few = FindTooFewPoints(input);
  if (!few.empty())
  {
    vtkErrorMacro(<< few << ". Such cells are left out.");
  }
  vtkNew<vtkPolyData> mesh;
  vtkWaterGridPolygons polygons;
  polygons.Make(input, mesh);
  if (mesh->GetNumberOfPolys() == 0 || mesh->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const double* up = this->UpDirection;
  const water_plane plane = { { up[0], up[1], up[2] }, 0.0 };
  water_plane unit = plane;
  water_plane_normalise(&plane, &unit); // the setter has checked it
  vtkWaterParts parts;
  parts.Find(mesh, unit.normal, static_cast<size_t>(this->MaximumNumberOfPlanes));
  const size_t count = parts.GetPlanes().size();
  const bool hasRest = count > 0 && parts.GetPlanes().back().IsRest;
  this->NumberOfPlanes = static_cast<int>(hasRest ? count - 1 : count);
  output->SetNumberOfBlocks(static_cast<unsigned int>(count));
  for (size_t i = 0; i < count; ++i)
  {
    const vtkWaterParts::Plane& found = parts.GetPlanes()[i];
    vtkNew<vtkPolyData> block;
    if (parts.HasAll(i))
    {
      block->ShallowCopy(mesh);
    }
    else
    {
      parts.Extract(mesh, i, block);
    }
    if (!found.IsFlat)
    {
      AddNormals(block);
    }
    parts.Describe(i, block);
    const auto number = static_cast<unsigned int>(i);
    output->SetBlock(number, block);
    output->GetMetaData(number)->Set(
      vtkCompositeDataSet::NAME(), ("water " + std::to_string(i)).c_str());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkWaterPlanesFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UpDirection: (" << this->UpDirection[0] << ", " << this->UpDirection[1] << ", "
     << this->UpDirection[2] << ")\n";
  os << indent << "MaximumNumberOfPlanes: " << this->MaximumNumberOfPlanes << "\n";
  os << indent << "NumberOfPlanes: " << this->NumberOfPlanes << "\n";
}
VTK_ABI_NAMESPACE_END
