// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterProps.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCameraActor.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLightActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkProp3DCollection.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTrivialProducer.h"
#include "vtkVersionMacros.h"
#include "vtkVolume.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"
#include "vtkWaterAccess.h"
#include "vtkWaterPropKeys.h"

#include <algorithm>
#include <cstring>

#if VTK_MODULE_ENABLE_VTK_RenderingImage // ParaView's VTK is built without it
#include "vtkImageStack.h"
#endif

namespace
{
void AddIfThere(vtkProp* part, vtkPropCollection* parts)
{
  if (part)
  {
    parts->AddItem(part);
  }
}

// Adds what a prop draws without handing its keys on to it. Assemblies hand them on, and most
// actors.
void AddParts(vtkProp* prop, vtkPropCollection* parts)
{
  if (vtkActor::SafeDownCast(prop))
  {
    return;
  }
#if VTK_MODULE_ENABLE_VTK_RenderingImage
  if (auto* stack = vtkImageStack::SafeDownCast(prop))
  {
    stack->GetImages(parts);
    return;
  }
#endif
  if (auto* camera = vtkCameraActor::SafeDownCast(prop))
  {
    camera->GetBounds(); // makes it
    AddIfThere(vtkWaterAccess::CameraActor::FrustumOf(camera), parts);
  }
  else if (auto* light = vtkLightActor::SafeDownCast(prop))
  {
    light->GetBounds(); // makes them
    AddIfThere(vtkWaterAccess::LightActor::ConeOf(light), parts);
    if (vtkCameraActor* frustum = vtkWaterAccess::LightActor::FrustumOf(light))
    {
      AddParts(frustum, parts);
    }
  }
  else if (!vtkWaterProps::GetParts(prop))
  {
    prop->GetActors(parts); // of axes, and of representations of widgets
  }
}

void ForEachPart(vtkProp* prop, const std::function<void(vtkProp*)>& function)
{
  const vtkNew<vtkPropCollection> parts; // not its own list, which it walks as it draws
  AddParts(prop, parts);
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    function(part);
    if (part != prop)
    {
      ForEachPart(part, function); // a camera among what a widget draws
    }
  }
}

// Is a volume's only transfer function 0 wherever it is given? Other ways of blending show
// something even then, and labels and further components have functions of their own.
bool HasNoOpacity(vtkVolume* volume, vtkVolumeMapper* mapper)
{
  vtkVolumeProperty* look = volume->GetProperty();
  vtkDataSet* data = mapper->GetDataSetInput();
  vtkDataArray* scalars = data ? data->GetPointData()->GetScalars() : nullptr;
  if (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND || look->GetNumberOfLabels() > 0 ||
    look->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D || !scalars ||
    scalars->GetNumberOfComponents() != 1)
  {
    return false;
  }
  vtkPiecewiseFunction* opacity = look->GetScalarOpacity();
  double node[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    if (opacity->GetNodeValue(i, node) == 1 && node[1] > 0.0)
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
vtkProp* vtkWaterProps::GetStandIn(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkWaterPropKeys::StandIn())
    ? vtkProp::SafeDownCast(keys->Get(vtkWaterPropKeys::StandIn()))
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterProps::DropOwnStandIn(vtkProp* prop)
{
  if (GetStandIn(prop) == prop)
  {
    prop->GetPropertyKeys()->Remove(vtkWaterPropKeys::StandIn());
  }
}

//------------------------------------------------------------------------------
void vtkWaterProps::ForEachOf(vtkProp* prop, const std::function<void(vtkProp*)>& function)
{
  function(prop);
  ForEachPart(prop, function);
  if (vtkProp* drawn = GetStandIn(prop))
  {
    function(drawn);
    ForEachPart(drawn, function);
  }
}

//------------------------------------------------------------------------------
void vtkWaterProps::ForEach(vtkPropCollection* props, const std::function<void(vtkProp*)>& function)
{
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    ForEachOf(prop, function);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterProps::HasAny(vtkProp* prop, bool (*has)(vtkProp*))
{
  vtkPropCollection* parts = GetParts(prop);
  if (!parts)
  {
    return has(prop);
  }
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    if (HasAny(part, has))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
const double* vtkWaterProps::GetBounds(vtkProp* prop)
{
  // what is derived from it may have bounds of its own
  if (std::strcmp(prop->GetClassName(), "vtkOpenGLActor") == 0)
  {
    auto* actor = static_cast<vtkActor*>(prop);
    vtkMapper* mapper = actor->GetMapper();
    const bool hasData = mapper && IsInWorld(actor) &&
      std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0 &&
      mapper->GetNumberOfInputConnections(0) == 1 &&
      vtkTrivialProducer::SafeDownCast(mapper->GetInputAlgorithm(0, 0));
    vtkDataObject* data = hasData ? mapper->GetInputDataObject(0, 0) : nullptr;
    if (data &&
      std::max({ actor->GetMTime(), mapper->GetMTime(), data->GetMTime() }) <
        vtkWaterAccess::Actor::BoundsTimeOf(actor))
    {
      return vtkWaterAccess::Actor::BoundsOf(actor);
    }
  }
  return prop->GetBounds();
}

//------------------------------------------------------------------------------
bool vtkWaterProps::IsInWorld(vtkProp3D* prop)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return prop->GetCoordinateSystem() == vtkProp3D::WORLD;
#else
  return prop != nullptr; // there is nothing else
#endif
}

//------------------------------------------------------------------------------
vtkPropCollection* vtkWaterProps::GetParts(vtkProp* prop)
{
  if (auto* assembly = vtkAssembly::SafeDownCast(prop))
  {
    return assembly->GetParts();
  }
  auto* assembly = vtkPropAssembly::SafeDownCast(prop);
  return assembly ? assembly->GetParts() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterProps::IsOverlay(vtkProp* prop)
{
  if (prop->IsA("vtkActor2D"))
  {
    return true;
  }
  if (prop->IsA("vtkProp3D") || prop->GetBounds()) // most are the former, whose bounds take time
  {
    return false;
  }
  vtkNew<vtkPropCollection> parts;
  prop->GetActors(parts);
  prop->GetVolumes(parts);
  vtkNew<vtkPropCollection> flat;
  prop->GetActors2D(flat);
  // some name none of their parts
  return parts->GetNumberOfItems() == 0 &&
    (flat->GetNumberOfItems() > 0 ||
      (prop->IsA("vtkWidgetRepresentation") && std::strstr(prop->GetClassName(), "2D")));
}

//------------------------------------------------------------------------------
bool vtkWaterProps::HoldsWater(vtkProp* prop)
{
  return HasAny(prop, [](vtkProp* part) { return part->IsA("vtkWaterActor") != 0; });
}

//------------------------------------------------------------------------------
void vtkWaterProps::ForEachVolume(vtkProp* prop, const std::function<void(vtkProp*)>& function)
{
  const vtkNew<vtkPropCollection> volumes;
  vtkPropCollection* parts = GetParts(prop);
  if (!parts)
  {
    prop->GetVolumes(volumes);
  }
  vtkPropCollection* found = parts ? parts : volumes.Get();
  vtkCollectionSimpleIterator it;
  found->InitTraversal(it);
  while (vtkProp* next = found->GetNextProp(it))
  {
    parts ? ForEachVolume(next, function) : function(next);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterProps::HoldsVolume(vtkProp* prop)
{
  bool holds = false;
  ForEachVolume(prop, [&holds](vtkProp*) { holds = true; });
  return holds;
}

//------------------------------------------------------------------------------
std::vector<vtkWaterProps::Box> vtkWaterProps::GetVolumeBoxes(vtkProp* prop)
{
  std::vector<Box> boxes;
  const auto add = [&boxes](const double* bounds, vtkMatrix4x4* matrix) {
    if (bounds)
    {
      Box box;
      std::copy(bounds, bounds + 6, box.Bounds.begin());
      std::copy(matrix->GetData(), matrix->GetData() + 16, box.BoxToWorld.begin());
      boxes.push_back(box);
    }
  };
  bool isKnown = true;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    auto* volume = vtkVolume::SafeDownCast(node->GetViewProp());
    auto* mapper = volume ? vtkVolumeMapper::SafeDownCast(volume->GetMapper()) : nullptr;
    const bool isPlain = mapper && !volume->IsA("vtkMultiVolume");
    isKnown = isKnown && (isPlain || !HoldsVolume(node->GetViewProp()));
    if (isPlain && volume->GetVisibility() && !HasNoOpacity(volume, mapper))
    {
      add(mapper->GetBounds(), node->GetMatrix());
    }
  }
  if (!isKnown)
  {
    boxes.clear();
    add(prop->GetBounds(), vtkNew<vtkMatrix4x4>());
  }
  return boxes;
}

//------------------------------------------------------------------------------
vtkWaterDrawnProps::vtkWaterDrawnProps(vtkRenderer* renderer)
  : Begin(vtkWaterAccess::Renderer::PropsOf(renderer))
  , End(this->Begin ? this->Begin + vtkWaterAccess::Renderer::PropCountOf(renderer) : nullptr)
{
}

//------------------------------------------------------------------------------
vtkProp** vtkWaterDrawnProps::Find(vtkProp* prop) const
{
  return std::find(this->Begin, this->End, prop);
}
