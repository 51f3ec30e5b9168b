// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterSignature.h"

#include "vtkAbstractMapper.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkFollower.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkTrivialProducer.h"
#include "vtkUniforms.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWaterProps.h"
#include "vtkWaterSource.h"

#include <algorithm>
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
  return IsOneOf(
    prop, { "vtkActor", "vtkOpenGLActor", "vtkFollower", "vtkOpenGLSkybox", "vtkSkybox" });
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

vtkMTimeType TimeOf(vtkDataObject* data)
{
  vtkMTimeType time = data ? data->GetMTime() : 0;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkSmartPointer<vtkCompositeDataIterator> it;
    it.TakeReference(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      time = std::max(time, it->GetCurrentDataObject()->GetMTime());
    }
  }
  return time;
}

bool HasUniforms(vtkUniforms* uniforms)
{
  return uniforms && uniforms->GetNumberOfUniforms() > 0;
}
}

//------------------------------------------------------------------------------
void vtkWaterSignature::Read(vtkRenderer* renderer, const std::vector<vtkProp*>& props)
{
  this->Values.clear();
  this->IsComplete = true;
  this->Values.reserve(6 * props.size() + 16);
  this->AddRenderer(renderer);
  this->AddNumber(renderer->GetRenderWindow()->GetDesiredUpdateRate()); // volumes sample by it
  this->Add(static_cast<vtkMTimeType>(vtkMapper::GetResolveCoincidentTopology()));
  double offsets[6] = {};
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(offsets[0], offsets[1]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(offsets[2], offsets[3]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(offsets[4]);
  offsets[5] = vtkMapper::GetResolveCoincidentTopologyZShift();
  for (const double offset : offsets)
  {
    this->AddNumber(offset);
  }

  vtkLightCollection* lights = renderer->GetLights();
  this->Values.emplace_back(lights, lights->GetMTime());
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    vtkMatrix4x4* matrix = light->GetTransformMatrix();
    this->Values.emplace_back(
      light, std::max(light->GetMTime(), matrix ? matrix->GetMTime() : vtkMTimeType(0)));
  }
  this->AddTexture(renderer->GetEnvironmentTexture());
  this->AddTexture(renderer->GetBackgroundTexture());
  for (vtkProp* prop : props)
  {
    this->AddProp(renderer, prop);
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddNumber(double value)
{
  vtkMTimeType bits = 0;
  std::memcpy(&bits, &value, std::min(sizeof bits, sizeof value));
  this->Add(bits);
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddShadows(vtkRenderer* renderer, vtkShadowMapPass* pass)
{
  this->Values.emplace_back(pass, pass->GetMTime());
  this->Values.emplace_back(
    pass->GetShadowMapBakerPass(), pass->GetShadowMapBakerPass()->GetMTime());
  vtkCollectionSimpleIterator it;
  renderer->GetViewProps()->InitTraversal(it);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(it))
  {
    if (prop->GetVisibility() && !prop->IsA("vtkActor2D"))
    {
      this->AddProp(renderer, prop);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddRenderer(vtkRenderer* renderer)
{
  // One by one: its time says too much, as any change of the camera counts, and taking a picture of
  // the window changes it twice.
  for (int i = 0; i < 3; ++i)
  {
    this->AddNumber(renderer->GetBackground()[i]);
    this->AddNumber(renderer->GetBackground2()[i]);
    this->AddNumber(renderer->GetAmbient()[i]);
    this->AddNumber(renderer->GetEnvironmentUp()[i]);
    this->AddNumber(renderer->GetEnvironmentRight()[i]);
  }
  this->AddNumber(renderer->GetBackgroundAlpha());
  this->AddNumber(renderer->GetOcclusionRatio());
  for (const int flag : { static_cast<int>(renderer->GetGradientBackground()),
         static_cast<int>(renderer->GetTexturedBackground()),
         static_cast<int>(renderer->GetTwoSidedLighting()),
         static_cast<int>(renderer->GetUseDepthPeeling()),
         static_cast<int>(renderer->GetUseDepthPeelingForVolumes()),
         static_cast<int>(renderer->GetMaximumNumberOfPeels()),
         static_cast<int>(renderer->GetUseImageBasedLighting()),
         static_cast<int>(renderer->GetUseSSAO()), static_cast<int>(renderer->GetUseShadows()) })
  {
    this->Add(static_cast<vtkMTimeType>(flag));
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  this->Add(renderer->GetUseOIT() ? 1 : 0);
#endif
  auto* openGL = vtkOpenGLRenderer::SafeDownCast(renderer);
  this->Add(openGL && openGL->GetUseSphericalHarmonics() ? 1 : 0);
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddProp(vtkRenderer* renderer, vtkProp* prop)
{
  if (vtkWaterSource* source = vtkWaterSource::Of(prop))
  {
    this->AddWater(*source->Take(renderer));
    return;
  }
  this->Values.emplace_back(prop, prop->GetMTime());
  if (vtkPropCollection* parts = vtkWaterProps::GetParts(prop))
  {
    vtkCollectionSimpleIterator it;
    parts->InitTraversal(it);
    while (vtkProp* part = parts->GetNextProp(it))
    {
      this->AddProp(renderer, part);
    }
    return;
  }
  vtkAbstractMapper* mapper = nullptr;
  if (IsKnownActor(prop))
  {
    auto* actor = static_cast<vtkActor*>(prop);
    vtkMatrix4x4* matrix = actor->GetUserMatrix();
    this->Add(matrix ? matrix->GetMTime() : 0);
    this->AddProperty(actor->GetProperty());
    this->AddProperty(actor->GetBackfaceProperty());
    this->AddTexture(actor->GetTexture());
    mapper = actor->GetMapper();
    if (auto* follower = vtkFollower::SafeDownCast(prop))
    {
      this->Add(follower->GetCamera() ? follower->GetCamera()->GetMTime() : 0);
    }
  }
  else if (IsOneOf(prop, { "vtkVolume" }))
  {
    auto* volume = static_cast<vtkVolume*>(prop);
    vtkMatrix4x4* matrix = volume->GetUserMatrix();
    this->Add(matrix ? matrix->GetMTime() : 0);
    this->Add(volume->GetProperty()->GetMTime());
    mapper = volume->GetMapper();
  }
  else if (IsOneOf(prop, { "vtkImageSlice", "vtkImageActor" }))
  {
    auto* slice = static_cast<vtkImageSlice*>(prop);
    this->Add(slice->GetProperty()->GetMTime());
    mapper = slice->GetMapper();
  }
  else
  {
    this->IsComplete = false;
  }
  this->AddShaders(prop, mapper);
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddShaders(vtkProp* prop, vtkAbstractMapper* mapper)
{
  vtkShaderProperty* shaders = prop->GetShaderProperty();
  this->Add(shaders->GetShaderMTime());
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
void vtkWaterSignature::AddWater(const vtkWaterSnapshot& water)
{
  // One by one, and not by its time of change, which the time of its waves counts for: they are
  // seen as the mean of all times.
  const vtkWaterLook& look = water.Look;
  this->Values.emplace_back(water.Actor, 0);
  for (int i = 0; i < 3; ++i)
  {
    this->AddNumber(water.Plane.normal[i]);
    this->AddNumber(look.DeepColor[i]);
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
  this->AddProperty(water.Actor->GetProperty());
  this->AddProperty(water.Actor->GetBackfaceProperty());
  if (look.Environment)
  {
    this->AddTexture(look.Environment);
  }
  this->AddShaders(water.Actor, water.Actor->GetMapper());
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddMapper(vtkAbstractMapper* mapper)
{
  this->AddAlgorithm(mapper);
  // its time does not count what it points to
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator it;
    planes->InitTraversal(it);
    while (vtkPlane* plane = planes->GetNextPlane(it))
    {
      this->Values.emplace_back(plane, plane->GetMTime());
    }
  }
  if (auto* volume = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    this->Values.emplace_back(volume->GetMaskInput(), TimeOf(volume->GetMaskInput()));
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddAlgorithm(vtkAlgorithm* algorithm)
{
  this->Values.emplace_back(algorithm, algorithm->GetMTime());
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, i);
      vtkDataObject* data = algorithm->GetInputDataObject(port, i);
      this->Values.emplace_back(data, TimeOf(data));
      if (vtkTrivialProducer::SafeDownCast(producer))
      {
        continue; // it is the data
      }
      auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(producer->GetExecutive());
      if (!pipeline)
      {
        this->IsComplete = false;
        continue;
      }
      pipeline->UpdatePipelineMTime();
      this->Values.emplace_back(producer, pipeline->GetPipelineMTime());
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddProperty(vtkProperty* property)
{
  this->Values.emplace_back(property, property ? property->GetMTime() : 0);
  if (property)
  {
    for (const auto& texture : property->GetAllTextures())
    {
      this->AddTexture(texture.second);
    }
  }
}

//------------------------------------------------------------------------------
void vtkWaterSignature::AddTexture(vtkTexture* texture)
{
  if (!texture)
  {
    this->Add(0);
    return;
  }
  if (!IsOneOf(texture, { "vtkTexture", "vtkOpenGLTexture" }) ||
    texture->GetNumberOfInputConnections(0) == 0)
  {
    this->IsComplete = false; // filled by somebody else
  }
  this->Add(texture->GetLookupTable() ? texture->GetLookupTable()->GetMTime() : 0);
  this->Add(texture->GetTransform() ? texture->GetTransform()->GetMTime() : 0);
  this->AddAlgorithm(texture);
}

//------------------------------------------------------------------------------
bool vtkWaterSignature::IsSameAs(const vtkWaterSignature& other) const
{
  return this->IsComplete && other.IsComplete && this->Values == other.Values;
}
