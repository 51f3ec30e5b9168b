// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMeshPlacement.h"

#include "vtkCellArray.h"
#include "vtkDataSetMapper.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkWaterUncutMesh.h"

#include <algorithm>
#include <sstream>

namespace
{
// Of a mesh, at most, that are looked at: it may change every frame.
constexpr vtkIdType kSampledCells = 4096;

std::string Describe(const water_placement_verdict& verdict)
{
  if (!verdict.is_off && !verdict.is_upright)
  {
    return std::string();
  }
  std::ostringstream text;
  text << "The water's mesh does not lie in its plane: ";
  if (verdict.is_upright)
  {
    text << "it is tilted by " << vtkMath::DegreesFromRadians(verdict.angle_rad)
         << " degrees; the tilt must lie in [0, "
         << vtkMath::DegreesFromRadians(verdict.angle_max_rad) << "]";
  }
  else
  {
    text << "its mean height above the plane is " << verdict.height << "; it must lie in ["
         << -verdict.height_max << ", " << verdict.height_max << "], 1 % of the mesh's diagonal";
  }
  text << ". It is drawn where it is, with the reflection of the plane; SetLevel or SetPlane moves "
          "the plane.";
  return text.str();
}
}

//------------------------------------------------------------------------------
vtkPolyData* vtkWaterMeshPlacement::FindMesh(vtkMapper* mapper)
{
  if (!(vtkPolyDataMapper::SafeDownCast(mapper) || vtkDataSetMapper::SafeDownCast(mapper)) ||
    mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  return mesh && mesh->GetPoints() ? mesh : nullptr;
}

//------------------------------------------------------------------------------
water_placement_verdict vtkWaterMeshPlacement::Judge(
  vtkPolyData* mesh, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  water_placement placement;
  water_placement_begin(&unit, &placement);
  vtkCellArray* cells = mesh->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  const vtkIdType step = std::max<vtkIdType>(count / kSampledCells, 1);
  auto* uncut = vtkWaterUncutMesh::SafeDownCast(mesh);
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < count; cell += step)
  {
    cells->GetCellAtId(cell, points);
    if (uncut && !uncut->HasWater(points->GetPointer(0), points->GetNumberOfIds()))
    {
      continue;
    }
    double corners[3][3]; // of a fan about the first point
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      double place[4] = { 0.0, 0.0, 0.0, 1.0 };
      mesh->GetPoint(points->GetId(i), place);
      meshToWorld->MultiplyPoint(place, place);
      if (i > 2)
      {
        std::copy_n(corners[2], 3, corners[1]);
      }
      std::copy_n(place, 3, corners[std::min<vtkIdType>(i, 2)]);
      if (i >= 2)
      {
        water_placement_add(corners[0], corners[1], corners[2], &placement);
      }
    }
  }
  return water_placement_judge(&placement);
}

//------------------------------------------------------------------------------
std::string vtkWaterMeshPlacement::Check(
  vtkMapper* mapper, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkPolyData* mesh = FindMesh(mapper);
  if (!mesh)
  {
    return std::string();
  }
  const vtkWaterMeshPlace place = vtkWaterMeshPlaceOf(meshToWorld, unit);
  if (mesh == this->Mesh && mesh->GetMTime() == this->MeshTime && place == this->Place)
  {
    return std::string();
  }
  this->Mesh = mesh;
  this->MeshTime = mesh->GetMTime();
  this->Place = place;
  const std::string text = Describe(Judge(mesh, meshToWorld, unit));
  const bool wasSaid = this->IsSaid;
  this->IsSaid = !text.empty();
  return wasSaid ? std::string() : text;
}
