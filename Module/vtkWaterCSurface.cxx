// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCSurface.cxx: the part of the C interface, vtkWaterC.h, that makes meshes, and the
// water's surface of one. Copies and calls.
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkWaterCInternals.h"

#include <algorithm>

using namespace vtkWaterC;

namespace
{
constexpr const char* kFlow = "vtk_water_flow"; // name of the array
}

//------------------------------------------------------------------------------
std::string vtkWaterC::DescribeBadMesh(
  const double* points, size_t pointCount, const int64_t* triangles, size_t triangleCount)
{
  if (!AreFinite(points, 3 * pointCount))
  {
    return "points must be finite";
  }
  for (size_t i = 0; i < 3 * triangleCount; ++i)
  {
    if (triangles[i] < 0 || static_cast<uint64_t>(triangles[i]) >= pointCount)
    {
      return "triangle " + std::to_string(i / 3) + " refers to point " +
        std::to_string(triangles[i]) + "; there are " + std::to_string(pointCount);
    }
  }
  return std::string();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkWaterC::MakeMesh(
  const double* points, size_t pointCount, const int64_t* triangles, size_t triangleCount)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(static_cast<vtkIdType>(pointCount));
  for (size_t i = 0; i < pointCount; ++i)
  {
    places->SetPoint(static_cast<vtkIdType>(i), points + 3 * i);
  }
  vtkNew<vtkCellArray> cells;
  for (size_t i = 0; i < triangleCount; ++i)
  {
    cells->InsertNextCell({ static_cast<vtkIdType>(triangles[3 * i]),
      static_cast<vtkIdType>(triangles[3 * i + 1]), static_cast<vtkIdType>(triangles[3 * i + 2]) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(places);
  data->SetPolys(cells);
  return data;
}

vtk_water_status vtk_water_actor_set_surface(vtk_water_actor* actor, const double* points,
  size_t point_count, const int64_t* triangles, size_t triangle_count)
{
  if (actor && points && !triangles)
  {
    return Guarded([] { return Fail(VTK_WATER_NULL_ARGUMENT, "triangles is NULL"); });
  }
  const std::string wrong =
    points ? DescribeBadMesh(points, point_count, triangles, triangle_count) : std::string();
  if (!wrong.empty())
  {
    return Guarded([&] { return Fail(VTK_WATER_BAD_VALUE, wrong); });
  }
  return Change(actor, [=](vtkWaterActor* water, vtkWaterProperty*) {
    vtkNew<vtkPolyDataMapper> mapper;
    actor->Surface = points ? MakeMesh(points, point_count, triangles, triangle_count) : nullptr;
    mapper->SetInputData(actor->Surface);
    water->SetFlowArrayName("");
    water->SetMapper(points ? mapper.Get() : nullptr);
  });
}

vtk_water_status vtk_water_actor_set_flow(
  vtk_water_actor* actor, const double* velocities, size_t point_count)
{
  return Guarded([&] {
    if (!actor)
    {
      return Fail(VTK_WATER_NULL_ARGUMENT, "actor is NULL");
    }
    vtkWaterActor* water = actor->Object;
    vtkPolyData* mesh = actor->Surface;
    const vtkIdType places = mesh ? mesh->GetNumberOfPoints() : 0;
    if (velocities && (!mesh || static_cast<uint64_t>(places) != point_count))
    {
      return Fail(VTK_WATER_BAD_VALUE,
        "there are velocities of " + std::to_string(point_count) + " points; " +
          (mesh ? "the surface has " + std::to_string(places)
                : std::string(
                    "the water needs a surface of as many, by vtk_water_actor_set_surface")));
    }
    if (!velocities)
    {
      water->SetFlowArrayName("");
      return VTK_WATER_OK;
    }
    vtkNew<vtkDoubleArray> array;
    array->SetName(kFlow);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(places);
    std::copy_n(velocities, 3 * point_count, array->GetPointer(0));
    mesh->GetPointData()->AddArray(array);
    mesh->Modified();
    water->SetFlowArrayName(kFlow);
    return VTK_WATER_OK;
  });
}

vtk_water_status vtk_water_actor_set_flow_period(vtk_water_actor* actor, double seconds)
{
  return Change(
    actor, [=](vtkWaterActor* water, vtkWaterProperty*) { water->SetFlowPeriod(seconds); });
}
