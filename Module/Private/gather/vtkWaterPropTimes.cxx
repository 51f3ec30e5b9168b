// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPropTimes.h"

#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkExecutive.h"
#include "vtkFollower.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWaterProps.h"
#include "vtkWaterSource.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>

namespace
{
// Exact classes: what is derived from them may look different for reasons of its own.
bool IsOneOf(vtkObjectBase* object, std::initializer_list<const char*> names)
{
  const char* own = object->GetClassName();
  return std::any_of(
    names.begin(), names.end(), [own](const char* name) { return std::strcmp(own, name) == 0; });
}

bool IsKnownActor(vtkProp* prop)
{
  return IsOneOf(prop,
    { "vtkActor", "vtkOpenGLActor", "vtkFollower", "vtkOpenGLSkybox", "vtkSkybox",
      "vtkPVLODActor" });
}

bool IsKnownMapper(vtkAbstractMapper* mapper)
{
  return IsOneOf(mapper,
    { "vtkOpenGLPolyDataMapper", "vtkPolyDataMapper", "vtkDataSetMapper", "vtkGlyph3DMapper",
      "vtkOpenGLGlyph3DMapper", "vtkOpenGLSphereMapper", "vtkOpenGLStickMapper",
      "vtkCompositePolyDataMapper", "vtkCompositePolyDataMapper2", "vtkOpenGLImageSliceMapper",
      "vtkImageSliceMapper", "vtkOpenGLGPUVolumeRayCastMapper", "vtkSmartVolumeMapper",
      "vtkFixedPointVolumeRayCastMapper" });
}

bool HasUniforms(vtkUniforms* uniforms)
{
  return uniforms && uniforms->GetNumberOfUniforms() > 0;
}
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::Clear()
{
  this->Entries.clear();
  this->IsComplete = true;
  this->IsAskable = true;
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::Read(vtkRenderer* renderer, vtkProp* prop)
{
  this->Clear();
  this->AddProp(renderer, prop);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterPropTimes::Ask(const Entry& entry)
{
  vtkObject* object = entry.Of;
  switch (entry.Asked)
  {
    case TIME:
    case HOLDER:
      return object->GetMTime();
    case SHADERS:
      return static_cast<vtkShaderProperty*>(object)->GetShaderMTime();
    case MAPPER: // who observes it says so nowhere
      return object->HasObserver(vtkCommand::UpdateShaderEvent) ? 0 : object->GetMTime();
    case EXECUTIVE:
      return reinterpret_cast<uintptr_t>(static_cast<vtkAlgorithm*>(object)->GetExecutive());
    case PIPELINE:
    {
      auto* pipeline = static_cast<vtkDemandDrivenPipeline*>(object);
      pipeline->UpdatePipelineMTime();
      return pipeline->GetPipelineMTime();
    }
    default:
      return entry.Last;
  }
}

//------------------------------------------------------------------------------
bool vtkWaterPropTimes::AreUnchanged() const
{
  return this->CanBeAsked() && !this->Entries.empty() &&
    std::all_of(this->Entries.begin(), this->Entries.end(),
      [](const Entry& entry) { return Ask(entry) == entry.Last; });
}

//------------------------------------------------------------------------------
bool vtkWaterPropTimes::AreSameAs(const vtkWaterPropTimes& other) const
{
  return this->IsComplete && other.IsComplete &&
    std::equal(this->Entries.begin(), this->Entries.end(), other.Entries.begin(),
      other.Entries.end(), [](const Entry& one, const Entry& two) {
        const bool isHolder = one.Asked == HOLDER || one.Asked == EXECUTIVE;
        return one.Asked == two.Asked && (isHolder || (one.Of == two.Of && one.Last == two.Last));
      });
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::Add(vtkObject* object, Question question)
{
  Entry entry = { object, 0, object ? question : NUMBER };
  entry.Last = Ask(entry);
  this->Entries.push_back(entry);
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddNumber(double value)
{
  vtkMTimeType bits = 0;
  std::memcpy(&bits, &value, std::min(sizeof bits, sizeof value));
  this->Add(bits);
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddParts(vtkRenderer* renderer, vtkProp* prop)
{
  this->IsAskable = false; // parts come and go behind the assembly's back
  vtkPropCollection* parts = vtkWaterProps::GetParts(prop);
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    this->AddProp(renderer, part);
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddProp(vtkRenderer* renderer, vtkProp* prop)
{
  if (vtkWaterSource* source = vtkWaterSource::Of(prop))
  {
    this->AddWater(*source->Take(renderer));
    return;
  }
  // that of an actor counts its matrix, its properties and its texture
  this->Add(prop);
  if (vtkWaterProps::GetParts(prop))
  {
    this->AddParts(renderer, prop);
    return;
  }
  vtkAbstractMapper* mapper = nullptr;
  if (IsKnownActor(prop))
  {
    auto* actor = static_cast<vtkActor*>(prop);
    this->AddTexturesOf(actor->GetProperty());
    this->AddTexturesOf(actor->GetBackfaceProperty());
    this->AddTexture(actor->GetTexture());
    // a skybox has a mapper of its own, and watches it: what it sets is its own and the camera's
    const bool isSkybox = IsOneOf(prop, { "vtkOpenGLSkybox" });
    mapper = isSkybox ? nullptr : actor->GetMapper();
    // ParaView's chooses between two mappers, and says so nowhere: it is read anew in each frame
    this->IsAskable = this->IsAskable && !IsOneOf(prop, { "vtkPVLODActor" });
    if (auto* follower = vtkFollower::SafeDownCast(prop))
    {
      this->Add(follower->GetCamera());
    }
  }
  else if (IsOneOf(prop, { "vtkVolume" }))
  {
    auto* volume = static_cast<vtkVolume*>(prop);
    this->Add(volume->GetUserMatrix());
    this->Add(volume->GetProperty());
    mapper = volume->GetMapper();
  }
  else if (IsOneOf(prop, { "vtkImageSlice", "vtkImageActor" }))
  {
    auto* slice = static_cast<vtkImageSlice*>(prop);
    this->Add(slice->GetProperty());
    mapper = slice->GetMapper();
  }
  else
  {
    this->IsComplete = false;
  }
  this->AddShaders(prop, mapper);
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddShaders(vtkProp* prop, vtkAbstractMapper* mapper)
{
  vtkShaderProperty* shaders = prop->GetShaderProperty();
  this->Add(shaders, SHADERS);
  // uniforms may be set at any time, and what observes the shader does so
  if (HasUniforms(shaders->GetVertexCustomUniforms()) ||
    HasUniforms(shaders->GetFragmentCustomUniforms()) ||
    HasUniforms(shaders->GetGeometryCustomUniforms()) ||
    (mapper && (!IsKnownMapper(mapper) || mapper->HasObserver(vtkCommand::UpdateShaderEvent))))
  {
    this->IsComplete = false;
  }
  if (mapper)
  {
    this->AddMapper(mapper);
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddWater(const vtkWaterSnapshot& water)
{
  // One by one, and not by its time of change, which the time of its waves counts for: they are
  // seen as the mean of all times.
  this->IsAskable = false;
  const vtkWaterLook& look = water.Look;
  this->Add(reinterpret_cast<uintptr_t>(water.Actor));
  for (int i = 0; i < 3; ++i)
  {
    this->AddNumber(water.Plane.normal[i]);
    this->AddNumber(look.DeepColor[i]);
    this->AddNumber(look.Medium.absorption[i]);
    this->AddNumber(look.Medium.scattering[i]);
    this->AddNumber(look.MeanSlopes[i]);
  }
  for (const double value : { water.Plane.offset, look.Opacity, look.Optics.index_of_refraction,
         look.Optics.constant_reflectance ? look.Optics.reflectance : -1.0 })
  {
    this->AddNumber(value);
  }
  const double* matrix = &water.Actor->GetMatrix()->Element[0][0];
  std::for_each(matrix, matrix + 16, [this](double element) { this->AddNumber(element); });
  this->Add(water.Actor->GetForceOpaque() ? 1 : 0);
  this->Add(water.Actor->GetForceTranslucent() ? 1 : 0);
  this->Add(water.IsRough() ? 1 : 0);
  this->Add(look.HasDeepColor ? 1 : 0);
  for (vtkProperty* property : { water.Actor->GetProperty(), water.Actor->GetBackfaceProperty() })
  {
    this->Add(property);
    this->AddTexturesOf(property);
  }
  if (look.Environment)
  {
    this->AddTexture(look.Environment);
  }
  this->AddShaders(water.Actor, water.Actor->GetMapper());
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddMapper(vtkAbstractMapper* mapper)
{
  this->Add(mapper, MAPPER);
  // its time does not count what it points to
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      this->Add(plane);
    }
  }
  if (auto* volume = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    this->AddData(volume->GetMaskInput());
  }
  this->AddInputs(mapper);
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddInputs(vtkAlgorithm* algorithm)
{
  this->Add(algorithm, EXECUTIVE);
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      // it holds the data and their producer, and what is asked of that
      this->Add(algorithm->GetExecutive()->GetInputInformation(port, i), HOLDER);
      this->AddData(algorithm->GetInputDataObject(port, i));
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, i);
      if (vtkTrivialProducer::SafeDownCast(producer))
      {
        continue; // it is the data
      }
      auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive());
      this->Add(pipeline, PIPELINE);
      this->IsComplete = this->IsComplete && pipeline;
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddData(vtkDataObject* data)
{
  this->Add(data);
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    this->IsAskable = false; // its blocks may be replaced
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      this->Add(it->GetCurrentDataObject());
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddTexturesOf(vtkProperty* property)
{
  if (property)
  {
    for (const auto& texture : property->GetAllTextures())
    {
      this->AddTexture(texture.second);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterPropTimes::AddTexture(vtkTexture* texture)
{
  this->Add(texture);
  if (!texture)
  {
    return;
  }
  if (!IsOneOf(texture, { "vtkTexture", "vtkOpenGLTexture" }) ||
    texture->GetNumberOfInputConnections(0) == 0)
  {
    this->IsComplete = false; // filled by somebody else
  }
  this->Add(texture->GetLookupTable());
  this->Add(texture->GetTransform());
  this->AddInputs(texture);
}
