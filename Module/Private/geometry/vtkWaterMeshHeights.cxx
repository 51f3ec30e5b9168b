// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterMeshHeights.h"

#include "vtkCellArray.h"
#include "vtkDataSetMapper.h"
#include "vtkIdList.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkWaterPolygons.h"
#include "vtkWaterUncutMesh.h"
#include "water_flatness.h"
#include "water_slopes.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
// Of a mesh, about, that are looked at for its slopes: it may change every frame.
constexpr vtkIdType kCells = 1 << 17;

vtkPointSet* FindData(vtkMapper* mapper)
{
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  auto* ofMesh = vtkPolyDataMapper::SafeDownCast(mapper);
  auto* ofData = vtkDataSetMapper::SafeDownCast(mapper);
  vtkPointSet* data = ofMesh ? ofMesh->GetInput() : nullptr;
  if (ofData)
  {
    data = vtkPointSet::SafeDownCast(ofData->GetInput());
  }
  return data && data->GetPoints() ? data : nullptr;
}

// Of its polygons against the plane.
double MeasureSlopes(vtkPointSet* data, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  water_slopes slopes;
  water_slopes_begin(&unit, &slopes);
  auto* uncut = vtkWaterUncutMesh::SafeDownCast(data);
  auto* mesh = vtkPolyData::SafeDownCast(data); // asking that by cells would make it build them
  const vtkIdType count = mesh ? mesh->GetPolys()->GetNumberOfCells() : data->GetNumberOfCells();
  const vtkIdType step = std::max<vtkIdType>(count / kCells, 1);
  const vtkWaterPlaces places(data->GetPoints());
  const vtkWaterCellLists lists(mesh ? mesh->GetPolys() : nullptr);
  if (places.GetDoubles() && lists.Starts) // the loop below copies each corner several times
  {
    const double* matrix = meshToWorld->IsIdentity() ? nullptr : &meshToWorld->Element[0][0];
    std::vector<water_slopes> found(static_cast<size_t>(vtkWaterBlockCount(count)), slopes);
    vtkWaterForBlocks(count, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
      for (vtkIdType cell = (begin + step - 1) / step * step; cell < end; cell += step)
      {
        const int64_t* corners = lists.Corners + lists.Starts[cell];
        const vtkIdType size = lists.Starts[cell + 1] - lists.Starts[cell];
        if (!uncut || uncut->HasWater(reinterpret_cast<const vtkIdType*>(corners), size))
        {
          water_slopes_add_polygon(places.GetDoubles(), corners, static_cast<size_t>(size), matrix,
            &found[static_cast<size_t>(block)]);
        }
      }
    });
    for (const water_slopes& ofBlock : found)
    {
      water_slopes_join(&ofBlock, &slopes);
    }
    return water_slopes_rms(&slopes);
  }
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < count; cell += step)
  {
    mesh ? mesh->GetPolys()->GetCellAtId(cell, points) : data->GetCellPoints(cell, points);
    if (uncut && !uncut->HasWater(points->GetPointer(0), points->GetNumberOfIds()))
    {
      continue;
    }
    double corners[3][3]; // of a fan about the first point
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      double place[4] = { 0.0, 0.0, 0.0, 1.0 };
      data->GetPoint(points->GetId(i), place);
      meshToWorld->MultiplyPoint(place, place);
      if (i > 2)
      {
        std::copy_n(corners[2], 3, corners[1]);
      }
      std::copy_n(place, 3, corners[std::min<vtkIdType>(i, 2)]);
      if (i >= 2)
      {
        water_slopes_add(corners[0], corners[1], corners[2], &slopes);
      }
    }
  }
  return water_slopes_rms(&slopes);
}
}

//------------------------------------------------------------------------------
vtkWaterMesh vtkWaterMeshHeights::Measure(
  vtkPointSet* data, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkWaterMesh mesh;
  mesh.HeightMax = std::numeric_limits<double>::infinity();
  if (!data)
  {
    return mesh;
  }
  vtkPoints* points = data->GetPoints();
  points->GetBounds(mesh.Bounds);
  std::copy_n(&meshToWorld->Element[0][0], 16, mesh.ToWorld);
  water_flatness flatness;
  if (!water_flatness_begin(&unit, &meshToWorld->Element[0][0], mesh.Bounds,
        points->GetDataType() != VTK_DOUBLE, &flatness))
  {
    return mesh;
  }
  mesh.HasVertexHeights = true;
  std::copy_n(flatness.height, 4, mesh.Height);
  const vtkWaterPlaces places(points);
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<water_flatness> found(static_cast<size_t>(vtkWaterBlockCount(count)), flatness);
  vtkWaterForBlocks(count, [&](vtkIdType block, vtkIdType begin, vtkIdType end) {
    water_flatness* all = &found[static_cast<size_t>(block)];
    if (places.GetDoubles())
    {
      water_flatness_add_points(
        places.GetDoubles() + 3 * begin, static_cast<size_t>(end - begin), all);
      return;
    }
    double point[3];
    for (vtkIdType i = begin; i < end; ++i)
    {
      places.Get(i, point);
      water_flatness_add(point, all);
    }
  });
  for (const water_flatness& ofBlock : found)
  {
    water_flatness_join(&ofBlock, &flatness);
  }
  mesh.HeightMax = water_flatness_judge(&flatness);
  mesh.Reach = flatness.reach;
  if (mesh.HeightMax > 0.0)
  {
    mesh.SlopeRMS = MeasureSlopes(data, meshToWorld, unit);
    mesh.IsSloped = water_slopes_are_seen(mesh.SlopeRMS);
  }
  return mesh;
}

//------------------------------------------------------------------------------
const vtkWaterMesh& vtkWaterMeshHeights::Read(
  vtkMapper* mapper, vtkMatrix4x4* meshToWorld, const water_plane& unit)
{
  vtkPointSet* data = FindData(mapper);
  vtkPoints* points = data ? data->GetPoints() : nullptr;
  const vtkWaterMeshPlace place = vtkWaterMeshPlaceOf(meshToWorld, unit);
  const vtkMTimeType time = points ? std::max(points->GetMTime(), data->GetMTime()) : 0;
  if (points != this->Points || time != this->PointsTime || place != this->Place || !points)
  {
    this->Points = points;
    this->PointsTime = time;
    this->Place = place;
    this->Mesh = Measure(data, meshToWorld, unit);
  }
  return this->Mesh;
}
