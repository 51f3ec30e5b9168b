// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterCSurface.cxx: the part of the C interface, vtkWaterC.h, that makes meshes, and the
// water's surface of one. Copies and calls.
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkWaterCInternals.h"
#include "water_foam_measure.h"

#include <algorithm>

using namespace vtkWaterC;

namespace
{
// names of arrays
constexpr const char* kFlow = "vtk_water_flow";
constexpr const char* kMatter = "vtk_water_matter";
constexpr const char* kFoam = "vtk_water_foam";

// Gives the surface's points values, and names them to the water. nullptr: it gets an empty name.
//
// what  the values are
vtk_water_status SetPointValues(vtk_water_actor* actor, const double* values, size_t count,
  int components, const char* name, const char* what,
  void (vtkWaterActor::*setName)(const std::string&))
{
  if (!actor)
  {
    return Fail(VTK_WATER_NULL_ARGUMENT, "actor is NULL");
  }
  vtkPolyData* mesh = actor->Surface;
  const vtkIdType places = mesh ? mesh->GetNumberOfPoints() : 0;
  if (values && (!mesh || static_cast<uint64_t>(places) != count))
  {
    return Fail(VTK_WATER_BAD_VALUE,
      std::string("there are ") + what + " of " + std::to_string(count) + " points; " +
        (mesh ? "the surface has " + std::to_string(places)
              : std::string("first set a surface with as many (vtk_water_actor_set_surface)")));
  }
  if (values)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(places);
    std::copy_n(values, static_cast<size_t>(components) * count, array->GetPointer(0));
    mesh->GetPointData()->AddArray(array);
    mesh->Modified();
  }
  (actor->Object->*setName)(values ? name : "");
  return VTK_WATER_OK;
}
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
  const vtk_water_status status = Guarded([&] {
    const std::string wrong =
      points ? DescribeBadMesh(points, point_count, triangles, triangle_count) : std::string();
    return wrong.empty() ? VTK_WATER_OK : Fail(VTK_WATER_BAD_VALUE, wrong);
  });
  if (status != VTK_WATER_OK)
  {
    return status;
  }
  return Change(actor, [=](vtkWaterActor* water, vtkWaterProperty*) {
    vtkNew<vtkPolyDataMapper> mapper;
    actor->Surface = points ? MakeMesh(points, point_count, triangles, triangle_count) : nullptr;
    mapper->SetInputData(actor->Surface);
    water->SetFlowArrayName("");
    water->SetMatterArrayName("");
    water->SetFoamArrayName("");
    water->SetMapper(points ? mapper.Get() : nullptr);
  });
}

vtk_water_status vtk_water_actor_set_flow(
  vtk_water_actor* actor, const double* velocities, size_t point_count)
{
  return Guarded([&] {
    return SetPointValues(
      actor, velocities, point_count, 3, kFlow, "velocities", &vtkWaterActor::SetFlowArrayName);
  });
}

vtk_water_status vtk_water_actor_set_matter(
  vtk_water_actor* actor, const double* concentrations, size_t point_count)
{
  return Guarded([&] {
    return SetPointValues(actor, concentrations, point_count, 1, kMatter, "concentrations",
      &vtkWaterActor::SetMatterArrayName);
  });
}

vtk_water_status vtk_water_actor_set_matter_optics(
  vtk_water_actor* actor, const double absorption[3], const double scattering[3])
{
  if (actor && (!absorption || !scattering))
  {
    return Guarded([&] {
      return Fail(
        VTK_WATER_NULL_ARGUMENT, absorption ? "scattering is NULL" : "absorption is NULL");
    });
  }
  return Change(actor, [=](vtkWaterActor* water, vtkWaterProperty*) {
    double before[3];
    water->GetMatterAbsorption(before);
    water->SetMatterAbsorption(absorption);
    if (lastError.empty())
    {
      water->SetMatterScattering(scattering);
    }
    if (!lastError.empty())
    {
      water->SetMatterAbsorption(before); // a failed call changes nothing
    }
  });
}

vtk_water_status vtk_water_actor_set_foam_data(
  vtk_water_actor* actor, const double* values, size_t point_count, const char* measure)
{
  return Guarded([&] {
    const int number = water_foam_measure_of(measure);
    if (actor && values && number == WATER_FOAM_MEASURE_COUNT)
    {
      return measure
        ? Fail(VTK_WATER_BAD_VALUE,
            std::string("measure is '") + measure + "'; it must be cover, froude or breaking")
        : Fail(VTK_WATER_NULL_ARGUMENT, "measure is NULL");
    }
    const vtk_water_status status = SetPointValues(
      actor, values, point_count, 1, kFoam, "values of foam", &vtkWaterActor::SetFoamArrayName);
    if (status == VTK_WATER_OK && values)
    {
      actor->Object->SetFoamMeasure(number);
    }
    return status;
  });
}

vtk_water_status vtk_water_actor_set_flow_period(vtk_water_actor* actor, double seconds)
{
  return Change(
    actor, [=](vtkWaterActor* water, vtkWaterProperty*) { water->SetFlowPeriod(seconds); });
}
