// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterVertexData.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShaderProgram.h"

#include "water_flow.h"
#include "water_foam_measure.h"
#include "water_matter.h"

#include <algorithm>
#include <sstream>

namespace
{
double VelocityOf(int, double value)
{
  return water_flow_component(value);
}

double ConcentrationOf(int, double value)
{
  return water_matter_concentration(value);
}

double MeasureOf(int measure, double value)
{
  return water_foam_measure_value(static_cast<water_foam_measure>(measure), value);
}

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
      if (!arrays->GetArray(i)) // texts
      {
        continue;
      }
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(no name)");
    }
  }
  return names.empty() ? "none" : names;
}

// "1 component", "2 components".
std::string Counted(int count)
{
  return std::to_string(count) + (count == 1 ? " component" : " components");
}

// Of cells as of points: each point has the mean of its cells.
vtkSmartPointer<vtkDataArray> ToPoints(vtkPolyData* mesh, vtkDataArray* cells)
{
  vtkNew<vtkPolyData> alone;
  alone->CopyStructure(mesh);
  alone->GetCellData()->AddArray(cells);
  vtkNew<vtkCellDataToPointData> ofCells;
  ofCells->SetInputData(alone);
  ofCells->Update();
  return ofCells->GetOutput()->GetPointData()->GetArray(cells->GetName());
}
}

//------------------------------------------------------------------------------
const vtkWaterVertexData::Use& vtkWaterVertexData::Flow()
{
  static const Use use = { "waterFlowMC", "velocities", 2, 3, nullptr, 0, VelocityOf };
  return use;
}

//------------------------------------------------------------------------------
const vtkWaterVertexData::Use& vtkWaterVertexData::Matter()
{
  static const Use use = { "waterMatterMC", "concentrations", 1, 1,
    "they must be finite and not negative; others count as 0", 0, ConcentrationOf };
  return use;
}

//------------------------------------------------------------------------------
const vtkWaterVertexData::Use& vtkWaterVertexData::Foam(int measure)
{
  static const char* const attribute = "waterFoamMC";
  static const char* const rule = "they must be finite and not negative; others count as 0";
  static const Use uses[WATER_FOAM_MEASURE_COUNT] = {
    { attribute, "covers of foam", 1, 1,
      "they must lie in [0, 1]; larger ones count as 1, and others as 0", WATER_FOAM_COVER,
      MeasureOf },
    { attribute, "Froude numbers", 1, 1, rule, WATER_FOAM_FROUDE_NUMBER, MeasureOf },
    { attribute, "breaking indices", 1, 1, rule, WATER_FOAM_BREAKING_INDEX, MeasureOf }
  };
  return uses[std::clamp(measure, 0, static_cast<int>(WATER_FOAM_MEASURE_COUNT) - 1)];
}

//------------------------------------------------------------------------------
std::string vtkWaterVertexData::Check(vtkMapper* mapper, const Use& use, const std::string& name)
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
    return "there is no numeric array '" + name + "'; the numeric arrays are: " + NamesOf(data);
  }
  const int components = array->GetNumberOfComponents();
  if (components < use.Least || components > use.Most)
  {
    return "the array '" + name + "' has " + Counted(components) + "; " + use.Values +
      " must have " + std::to_string(use.Least) +
      (use.Least < use.Most ? " or " + std::to_string(use.Most) : "");
  }
  if (array->GetNumberOfTuples() != count)
  {
    return "the array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
      " values; it must have " + std::to_string(count);
  }
  return "";
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkWaterVertexData::Convert(
  vtkDataArray* array, const Use& use, bool isOfPoints)
{
  auto made = vtkSmartPointer<vtkFloatArray>::New();
  made->SetName("values");
  made->SetNumberOfComponents(use.Most);
  made->SetNumberOfTuples(array->GetNumberOfTuples());
  made->FillValue(0.0f);
  const int components = std::min(array->GetNumberOfComponents(), use.Most);
  vtkIdType wrongCount = 0;
  std::ostringstream first;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < components; ++j)
    {
      const double value = array->GetComponent(i, j);
      const double used = use.Convert(use.Kind, value);
      made->SetTypedComponent(i, j, static_cast<float>(used));
      if (use.Rule && !(used == value) && ++wrongCount == 1)
      {
        first << value << " at " << (isOfPoints ? "point " : "cell ") << i;
      }
    }
  }
  if (wrongCount > 0)
  {
    this->Wrong = std::to_string(wrongCount) + " of the " +
      std::to_string(array->GetNumberOfTuples()) + " " + use.Values + " are wrong (the first is " +
      first.str() + "): " + use.Rule;
  }
  return made;
}

//------------------------------------------------------------------------------
bool vtkWaterVertexData::Upload(vtkPolyData* mesh, const Use& use, const std::string& name)
{
  const std::pair<void*, vtkMTimeType> now(mesh, mesh->GetMTime());
  if (this->Uploaded == now && this->UploadedUse == &use && this->Name == name &&
    this->Buffer->GetHandle() != 0)
  {
    return true;
  }
  this->Wrong.clear();
  vtkIdType count = 0;
  vtkDataArray* array = Find(mesh, name, &count);
  if (!array || array->GetNumberOfTuples() != count)
  {
    return false; // VTK's filter reads without looking
  }
  const bool isOfPoints = mesh->GetPointData()->GetArray(name.c_str()) != nullptr;
  vtkSmartPointer<vtkDataArray> values = this->Convert(array, use, isOfPoints);
  if (!isOfPoints)
  {
    values = ToPoints(mesh, values);
  }
  auto* floats = vtkFloatArray::SafeDownCast(values);
  if (!floats || floats->GetNumberOfTuples() != mesh->GetNumberOfPoints())
  {
    return false;
  }
  this->Uploaded = { nullptr, 0 };
  if (!this->Buffer->Upload(floats->GetPointer(0), static_cast<size_t>(floats->GetNumberOfValues()),
        vtkOpenGLBufferObject::ArrayBuffer))
  {
    return false;
  }
  this->Uploaded = now;
  this->UploadedUse = &use;
  this->Name = name;
  return true;
}

//------------------------------------------------------------------------------
void vtkWaterVertexData::Add(vtkPolyData* mesh, const Use& use, const std::string& name,
  vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertices)
{
  if (!mesh || !vertices || !program->IsAttributeUsed(use.Attribute))
  {
    return;
  }
  vertices->Bind();
  if (!this->Upload(mesh, use, name) ||
    !vertices->AddAttributeArray(program, this->Buffer, use.Attribute, 0,
      use.Most * static_cast<int>(sizeof(float)), VTK_FLOAT, use.Most, false))
  {
    vertices->RemoveAttributeArray(use.Attribute); // 0 for all
  }
}

//------------------------------------------------------------------------------
bool vtkWaterVertexData::Add(vtkFloatArray* values, const char* attribute,
  vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertices)
{
  vertices->Bind();
  const std::pair<void*, vtkMTimeType> now(values, values->GetMTime());
  if (this->Uploaded != now || this->Buffer->GetHandle() == 0)
  {
    this->Uploaded = { nullptr, 0 };
    if (!this->Buffer->Upload(values->GetPointer(0),
          static_cast<size_t>(values->GetNumberOfValues()), vtkOpenGLBufferObject::ArrayBuffer))
    {
      return false;
    }
    this->Uploaded = now;
  }
  return vertices->AddAttributeArray(
    program, this->Buffer, attribute, 0, sizeof(float), VTK_FLOAT, 1, false);
}

//------------------------------------------------------------------------------
void vtkWaterVertexData::ReleaseGraphicsResources()
{
  this->Buffer->ReleaseGraphicsResources();
  this->Uploaded = { nullptr, 0 };
}
