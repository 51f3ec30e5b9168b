// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMeshHeights.h"

#include "vtkDataSetMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "water_flatness.h"

#include <algorithm>
#include <limits>

namespace
{
vtkPoints* FindPoints(vtkMapper* mapper)
{
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  auto* ofMesh = vtkPolyDataMapper::SafeDownCast(mapper);
  auto* ofData = vtkDataSetMapper::SafeDownCast(mapper);
  vtkPointSet* mesh = ofMesh ? ofMesh->GetInput() : nullptr;
  if (ofData)
  {
    mesh = vtkPointSet::SafeDownCast(ofData->GetInput());
  }
  return mesh ? mesh->GetPoints() : nullptr;
}
}

//------------------------------------------------------------------------------
vtkWaterMesh vtkWaterMeshHeights::Measure(
  vtkPoints* points, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkWaterMesh mesh;
  mesh.HeightMax = std::numeric_limits<double>::infinity();
  if (!points)
  {
    return mesh;
  }
  points->GetBounds(mesh.Bounds);
  water_flatness flatness;
  if (!water_flatness_begin(&unit, &meshToWorld->Element[0][0], mesh.Bounds,
        points->GetDataType() != VTK_DOUBLE, &flatness))
  {
    return mesh;
  }
  mesh.HasVertexHeights = true;
  std::copy_n(flatness.height, 4, mesh.Height);
  double point[3];
  bool isOpen = true;
  for (vtkIdType i = 0; isOpen && i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, point);
    isOpen = water_flatness_add(point, &flatness);
  }
  mesh.HeightMax = water_flatness_judge(&flatness);
  return mesh;
}

//------------------------------------------------------------------------------
const vtkWaterMesh& vtkWaterMeshHeights::Read(
  vtkMapper* mapper, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkPoints* points = FindPoints(mapper);
  const vtkWaterMeshPlace place = vtkWaterMeshPlaceOf(meshToWorld, unit);
  const vtkMTimeType time = points ? points->GetMTime() : 0;
  if (points != this->Points || time != this->PointsTime || place != this->Place || !points)
  {
    this->Points = points;
    this->PointsTime = time;
    this->Place = place;
    this->Mesh = Measure(points, meshToWorld, unit);
  }
  return this->Mesh;
}
