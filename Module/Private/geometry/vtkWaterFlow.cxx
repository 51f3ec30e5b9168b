// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterFlow.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"

#include "water_flow.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr const char* kAttribute = "waterFlowMC";

// Of points, or else of cells; and how many values it must have.
vtkDataArray* Find(vtkDataSet* data, const std::string& name, vtkIdType* count)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  *count = array ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  return array ? array : data->GetCellData()->GetArray(name.c_str());
}

std::string NamesOf(vtkDataSet* data)
{
  std::string names;
  for (vtkDataSetAttributes* arrays : { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      const char* name = arrays->GetArrayName(i);
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(no name)");
    }
  }
  return names.empty() ? "none" : names;
}

// Of cells as of points: each point has the mean of its cells.
vtkDataArray* FindOfPoints(
  vtkPolyData* mesh, const std::string& name, vtkCellDataToPointData* ofCells)
{
  vtkDataArray* array = mesh->GetPointData()->GetArray(name.c_str());
  vtkDataArray* cells = mesh->GetCellData()->GetArray(name.c_str());
  if (array || !cells)
  {
    return array;
  }
  if (cells->GetNumberOfTuples() != mesh->GetNumberOfCells())
  {
    return nullptr; // VTK's filter reads without looking
  }
  vtkNew<vtkPolyData> alone;
  alone->CopyStructure(mesh);
  alone->GetCellData()->AddArray(cells);
  ofCells->SetInputData(alone);
  ofCells->Update();
  return ofCells->GetOutput()->GetPointData()->GetArray(name.c_str());
}
}

//------------------------------------------------------------------------------
std::string vtkWaterFlow::Check(vtkMapper* mapper, const std::string& name)
{
  vtkDataSet* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
    ? vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0))
    : nullptr;
  if (!data)
  {
    return "'" + name +
      "' is an array of a mesh, and the water has none: its mapper must have one data set";
  }
  if (data->GetNumberOfPoints() == 0)
  {
    return ""; // nothing is wet yet
  }
  vtkIdType count = 0;
  vtkDataArray* array = Find(data, name, &count);
  if (!array)
  {
    return "there is no numeric array '" + name + "'; the arrays are: " + NamesOf(data);
  }
  const int components = array->GetNumberOfComponents();
  if (components != 2 && components != 3)
  {
    return "the array '" + name + "' has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + "; velocities must have 2 or 3";
  }
  if (array->GetNumberOfTuples() != count)
  {
    return "the array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
      " values; it must have " + std::to_string(count);
  }
  return "";
}

//------------------------------------------------------------------------------
bool vtkWaterFlow::Upload(vtkPolyData* mesh, const std::string& name)
{
  const std::pair<void*, vtkMTimeType> now(mesh, mesh->GetMTime());
  if (this->Uploaded == now && this->Name == name && this->Buffer->GetHandle() != 0)
  {
    return true;
  }
  vtkNew<vtkCellDataToPointData> ofCells;
  vtkDataArray* array = FindOfPoints(mesh, name, ofCells);
  if (!array || array->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    return false;
  }
  const int components = std::min(array->GetNumberOfComponents(), 3);
  std::vector<float> values(3 * static_cast<size_t>(array->GetNumberOfTuples()), 0.0f);
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      values[static_cast<size_t>(3 * i + j)] =
        static_cast<float>(water_flow_component(array->GetComponent(i, j)));
    }
  }
  this->Uploaded = { nullptr, 0 };
  if (!this->Buffer->Upload(values, vtkOpenGLBufferObject::ArrayBuffer))
  {
    return false;
  }
  this->Uploaded = now;
  this->Name = name;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterFlow::Add(vtkPolyData* mesh, const std::string& name, vtkShaderProgram* program,
  vtkOpenGLVertexArrayObject* vertices)
{
  if (!mesh || !vertices || !program->IsAttributeUsed(kAttribute))
  {
    return;
  }
  vertices->Bind();
  if (!this->Upload(mesh, name) ||
    !vertices->AddAttributeArray(
      program, this->Buffer, kAttribute, 0, 3 * sizeof(float), VTK_FLOAT, 3, false))
  {
    vertices->RemoveAttributeArray(kAttribute); // 0 for all
  }
}

//------------------------------------------------------------------------------
void vtkWaterFlow::ReleaseGraphicsResources()
{
  this->Buffer->ReleaseGraphicsResources();
  this->Uploaded = { nullptr, 0 };
}
