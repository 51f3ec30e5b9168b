// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterClustersMesh.cxx: the part of vtkWaterClusters that reads meshes, once until they change.
#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkWaterAccess.h"
#include "vtkWaterClusters.h"
#include "vtkWaterGL.h"

#include <new>

namespace
{
vtkDataArray* PointsOf(vtkPolyDataMapper* mapper)
{
  vtkPoints* points = mapper->GetInput() ? mapper->GetInput()->GetPoints() : nullptr;
  return points ? points->GetData() : nullptr;
}

// Both null: they are of another type.
water_points NumbersOf(vtkDataArray* points)
{
  auto* floats = vtkFloatArray::FastDownCast(points);
  auto* doubles = vtkDoubleArray::FastDownCast(points);
  return { floats ? floats->GetPointer(0) : nullptr, doubles ? doubles->GetPointer(0) : nullptr };
}
}

//------------------------------------------------------------------------------
void vtkWaterClusters::Read(vtkOpenGLPolyDataMapper* mapper, Mesh& mesh)
{
  mesh.Boxes.clear();
  mesh.Indices.clear();
  mesh.Points = nullptr;
  vtkOpenGLIndexBufferObject* buffer = vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper);
  const size_t count = water_clusters_count(buffer->IndexCount / 3);
  if (count == 0 || buffer->IndexCount % 3 != 0)
  {
    return;
  }
  mesh.Indices.resize(buffer->IndexCount);
  GLint bound = 0;
  glGetIntegerv(GL_COPY_READ_BUFFER, &bound); // the binding's name is also that of its query
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer->GetHandle()));
  glGetBufferSubData(GL_COPY_READ_BUFFER, 0,
    static_cast<GLsizeiptr>(mesh.Indices.size() * sizeof(uint32_t)), mesh.Indices.data());
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(bound));
  mesh.Boxes.resize(count);
  vtkDataArray* points = PointsOf(mapper);
  water_mesh described;
  if (!points || !Describe(points, mesh, described) || !water_clusters_bound(&described))
  {
    mesh.Boxes.clear(); // not the indices of these points
    return;
  }
  // a copy: who writes into the points and does not say so yet is still shown the old ones
  mesh.Points.TakeReference(points->NewInstance());
  mesh.Points->DeepCopy(points);
  if (mesh.Points->GetNumberOfTuples() != points->GetNumberOfTuples())
  {
    throw std::bad_alloc(); // which VTK may only have said
  }
}

//------------------------------------------------------------------------------
bool vtkWaterClusters::Describe(vtkDataArray* points, Mesh& mesh, water_mesh& described)
{
  described.points = NumbersOf(points);
  described.point_count = points ? static_cast<size_t>(points->GetNumberOfTuples()) : 0;
  described.indices = mesh.Indices.data();
  described.triangle_count = mesh.Indices.size() / 3;
  described.boxes = reinterpret_cast<double(*)[6]>(mesh.Boxes.data()); // of std::array<double, 6>
  return described.points.floats || described.points.doubles;
}

//------------------------------------------------------------------------------
vtkWaterClusters::MeshState vtkWaterClusters::StateOf(
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  vtkOpenGLIndexBufferObject* buffer = vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper);
  vtkProperty* property = actor->GetProperty();
  return { mapper->GetInput() ? mapper->GetInput()->GetMTime() : 0, mapper->GetMTime(),
    reinterpret_cast<vtkMTimeType>(property), property->GetMTime(), buffer->IndexCount,
    static_cast<vtkMTimeType>(buffer->GetHandle()) };
}

//------------------------------------------------------------------------------
vtkWaterClusters::Mesh* vtkWaterClusters::UpdateMesh(
  vtkOpenGLPolyDataMapper* mapper, vtkActor* actor, bool isSoftware)
{
  Mesh& mesh = this->Meshes[mapper];
  MeshState state = StateOf(mapper, actor);
  if (!isSoftware)
  {
    state[2] = state[3] = 0; // runs know no property: to read the buffer back waits for the GPU
  }
  if (!mesh.Mapper || mesh.State != state)
  {
    mesh.Mapper = mapper;
    mesh.State = state;
    vtkDataArray* points = PointsOf(mapper);
    if (isSoftware)
    {
      Read(mapper, mesh);
    }
    else
    {
      const water_points numbers = NumbersOf(points);
      const bool isKnown = numbers.floats || numbers.doubles;
      mesh.Runs.Read(vtkWaterAccess::PolyDataMapper::TrianglesOf(mapper), numbers,
        isKnown ? static_cast<size_t>(points->GetNumberOfTuples()) : 0);
    }
  }
  return mesh.Boxes.empty() && !mesh.Runs.IsKnown() ? nullptr : &mesh;
}
