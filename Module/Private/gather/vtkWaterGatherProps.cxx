// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterGatherProps.cxx: the part of vtkWaterGather that reads one prop: what is drawn for it,
// its flags, bounds and parts.
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkProp.h"
#include "vtkProp3DCollection.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkTrivialProducer.h"
#include "vtkVersionMacros.h"
#include "vtkWaterAccess.h"
#include "vtkWaterActor.h"
#include "vtkWaterGather.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterShaderHook.h"

#include <algorithm>
#include <cstring>

namespace
{
// Is the prop the water that is mirrored at, another sheet of its plane, or an assembly with any
// water?
bool IsOfWater(vtkProp* prop, vtkWaterActor* mirrored)
{
  auto* water = vtkWaterActor::SafeDownCast(prop);
  return water ? vtkWaterGather::AreInOnePlane(water, mirrored) : vtkWaterGather::HoldsWater(prop);
}

uint32_t ReadFlags(vtkProp* prop, vtkWaterActor* mirrored)
{
  uint32_t flags = prop->GetVisibility() ? static_cast<uint32_t>(WATER_PROP_VISIBLE) : 0u;
  if (IsOfWater(prop, mirrored))
  {
    flags |= WATER_PROP_IS_WATER;
  }
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkWaterReflectionPass::NOT_REFLECTED()) &&
    keys->Get(vtkWaterReflectionPass::NOT_REFLECTED()) != 0)
  {
    flags |= WATER_PROP_NOT_REFLECTED;
  }
  if (prop->IsA("vtkActor2D"))
  {
    flags |= WATER_PROP_OVERLAY;
  }
  if (prop->IsA("vtkBillboardTextActor3D") || prop->IsA("vtkFlagpoleLabel"))
  {
    flags |= WATER_PROP_LABEL;
  }
  if (prop->IsA("vtkSkybox"))
  {
    flags |= WATER_PROP_NO_BOUNDS;
  }
  return flags;
}

// Does a prop, or a part of it, have a property?
bool HasAny(vtkProp* prop, bool (*has)(vtkProp*))
{
  vtkPropCollection* parts = vtkWaterGather::GetParts(prop);
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

// Are points of it drawn larger than its bounds know?
bool HasSplats(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
  return mapper &&
    (mapper->IsA("vtkPointGaussianMapper") || mapper->IsA("vtkOpenGLSphereMapper") ||
      mapper->IsA("vtkOpenGLStickMapper"));
}

// How wide points and lines are drawn, in pixels.
float ReadWidth(vtkProp* prop)
{
  float width = 0.0f;
  if (vtkPropCollection* parts = vtkWaterGather::GetParts(prop))
  {
    vtkCollectionSimpleIterator it;
    parts->InitTraversal(it);
    while (vtkProp* part = parts->GetNextProp(it))
    {
      width = std::max(width, ReadWidth(part));
    }
  }
  else if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    width = std::max(actor->GetProperty()->GetPointSize(), actor->GetProperty()->GetLineWidth());
  }
  return width;
}
}

//------------------------------------------------------------------------------
vtkProp* vtkWaterGather::FindStandIn(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  auto* other = keys && keys->Has(vtkWaterReflectionPass::STAND_IN())
    ? vtkProp::SafeDownCast(keys->Get(vtkWaterReflectionPass::STAND_IN()))
    : nullptr;
  return other && !HoldsWater(other) ? other : prop;
}

//------------------------------------------------------------------------------
water_prop vtkWaterGather::ReadProp(vtkProp* prop, vtkProp* drawn, vtkWaterActor* mirrored)
{
  water_prop read;
  read.flags = ReadFlags(prop, mirrored);
  if (vtkWaterShaderHook::GetOfThread()->Refusals.Has(drawn))
  {
    read.flags |= WATER_PROP_REFUSED;
  }
  read.width_px = ReadWidth(drawn);
  vtkMath::UninitializeBounds(read.bounds);
  const uint32_t noneNeeded = WATER_PROP_IS_WATER | WATER_PROP_NOT_REFLECTED | WATER_PROP_OVERLAY |
    WATER_PROP_LABEL | WATER_PROP_REFUSED;
  if ((read.flags & WATER_PROP_VISIBLE) && !(read.flags & noneNeeded))
  {
    const double* bounds = GetBounds(drawn); // may bring a pipeline up to date
    if (bounds && !HasAny(drawn, HasSplats))
    {
      std::copy(bounds, bounds + 6, read.bounds);
    }
    else
    {
      read.flags |= WATER_PROP_NO_BOUNDS;
    }
  }
  return read;
}

//------------------------------------------------------------------------------
const double* vtkWaterGather::GetBounds(vtkProp* prop)
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
bool vtkWaterGather::IsInWorld(vtkProp3D* prop)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  return prop->GetCoordinateSystem() == vtkProp3D::WORLD;
#else
  return prop != nullptr; // there is nothing else
#endif
}

//------------------------------------------------------------------------------
vtkPropCollection* vtkWaterGather::GetParts(vtkProp* prop)
{
  if (auto* assembly = vtkAssembly::SafeDownCast(prop))
  {
    return assembly->GetParts();
  }
  auto* assembly = vtkPropAssembly::SafeDownCast(prop);
  return assembly ? assembly->GetParts() : nullptr;
}

//------------------------------------------------------------------------------
bool vtkWaterGather::HoldsWater(vtkProp* prop)
{
  return HasAny(prop, [](vtkProp* part) { return part->IsA("vtkWaterActor") != 0; });
}

//------------------------------------------------------------------------------
bool vtkWaterGather::HoldsVolume(vtkProp* prop)
{
  return HasAny(prop, [](vtkProp* part) {
    const vtkNew<vtkPropCollection> volumes;
    part->GetVolumes(volumes);
    return volumes->GetNumberOfItems() > 0;
  });
}
