// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSheet.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkWaterProps.h"

#include <algorithm>

namespace
{
// Bounds of what a prop shows, waters left out: they are what is fitted. An assembly that holds a
// water is taken apart.
//
// parent  matrix of the assembly that the prop is a part of; nullptr: of none
void AddBounds(vtkProp* prop, vtkMatrix4x4* parent, vtkBoundingBox& box)
{
  if (!prop->GetVisibility() || !prop->GetUseBounds() || prop->IsA("vtkWaterActor") ||
    prop->IsA("vtkSkybox"))
  {
    return;
  }
  if (vtkWaterProps::HoldsWater(prop))
  {
    vtkNew<vtkMatrix4x4> matrix;
    if (auto* placed = vtkProp3D::SafeDownCast(prop))
    {
      placed->ComputeMatrix();
      matrix->DeepCopy(placed->GetMatrix());
    }
    if (parent)
    {
      vtkMatrix4x4::Multiply4x4(parent, matrix, matrix);
    }
    vtkPropCollection* parts = vtkWaterProps::GetParts(prop);
    vtkCollectionSimpleIterator it;
    parts->InitTraversal(it);
    while (vtkProp* part = parts->GetNextProp(it))
    {
      AddBounds(part, matrix, box);
    }
    return;
  }
  const double* bounds = vtkWaterProps::GetBounds(prop);
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds) ||
    !std::all_of(bounds, bounds + 6, [](double bound) { return vtkMath::IsFinite(bound); }))
  {
    return;
  }
  if (!parent)
  {
    box.AddBounds(bounds);
    return;
  }
  const vtkBoundingBox own(bounds);
  for (int i = 0; i < 8; ++i)
  {
    double corner[4] = { 0.0, 0.0, 0.0, 1.0 };
    own.GetCorner(i, corner);
    parent->MultiplyPoint(corner, corner);
    box.AddPoint(corner);
  }
}
}

//------------------------------------------------------------------------------
vtkWaterSheet::vtkWaterSheet()
{
  this->Points->SetDataTypeToDouble();
  this->Rectangle->SetPoints(this->Points);
  this->Mapper->SetInputData(this->Rectangle);
  this->Mapper->ScalarVisibilityOff();
}

//------------------------------------------------------------------------------
vtkWaterSheet::~vtkWaterSheet() = default;

//------------------------------------------------------------------------------
vtkPolyDataMapper* vtkWaterSheet::GetMapper()
{
  return this->Mapper;
}

//------------------------------------------------------------------------------
void vtkWaterSheet::FindSceneBounds(const std::vector<vtkRenderer*>& scene, double bounds[6])
{
  vtkBoundingBox box;
  for (vtkRenderer* renderer : scene)
  {
    vtkPropCollection* props = renderer->GetViewProps();
    vtkCollectionSimpleIterator it;
    props->InitTraversal(it);
    while (vtkProp* prop = props->GetNextProp(it))
    {
      AddBounds(prop, nullptr, box);
    }
  }
  vtkMath::UninitializeBounds(bounds);
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSheet::SetParts(const std::vector<double>& corners, const double normal[3])
{
  if (corners == this->Corners && std::equal(normal, normal + 3, this->Normal))
  {
    return;
  }
  this->Corners = corners;
  std::copy_n(normal, 3, this->Normal);
  const auto count = static_cast<vtkIdType>(corners.size() / 3);
  this->Points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  vtkNew<vtkCellArray> cells;
  for (vtkIdType corner = 0; corner < count; ++corner)
  {
    this->Points->SetPoint(corner, corners.data() + 3 * corner);
    normals->InsertNextTuple(normal);
    if (corner % 4 == 0)
    {
      const vtkIdType quad[4] = { corner, corner + 1, corner + 2, corner + 3 };
      cells->InsertNextCell(4, quad);
    }
  }
  this->Points->Modified();
  this->Rectangle->SetPolys(cells);
  this->Rectangle->GetPointData()->SetNormals(normals);
  this->Rectangle->Modified();
}

//------------------------------------------------------------------------------
water_status vtkWaterSheet::Fit(const water_plane& plane, const double origin[3],
  const double bounds[4], const double scene[6], const std::vector<double>& wet)
{
  water_plane unit;
  water_status status = water_plane_normalise(&plane, &unit);
  if (status != WATER_OK)
  {
    return status;
  }
  double x_dir[3];
  double y_dir[3];
  water_plane_axes(unit.normal, x_dir, y_dir);
  double sheet[4];
  if (bounds)
  {
    std::copy_n(bounds, 4, sheet);
  }
  else
  {
    status = water_sheet_bounds(origin, x_dir, y_dir, scene, sheet);
    if (status != WATER_OK)
    {
      return status;
    }
  }
  std::vector<double> corners(12);
  water_sheet_corners(origin, x_dir, y_dir, sheet, corners.data());
  std::copy_n(sheet, 4, this->Bounds);
  this->SetParts(wet.empty() ? corners : wet, unit.normal);
  return WATER_OK;
}

//------------------------------------------------------------------------------
water_status vtkWaterSheet::Clear(const water_plane& plane)
{
  if (this->Points->GetNumberOfPoints() > 0)
  {
    this->Rectangle->SetPolys(nullptr);
    this->Rectangle->GetPointData()->SetNormals(nullptr);
    this->Points->Reset();
    this->Points->Modified();
    std::fill(this->Normal, this->Normal + 3, 0.0); // no sheet has that
    this->Rectangle->Modified();
  }
  water_plane unit;
  return water_plane_normalise(&plane, &unit);
}
