// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterPropReader.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkWaterPropKeys.h"
#include "vtkWaterProps.h"
#include "vtkWaterSource.h"
#include "water_plane.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
// Rulers and axes beside a scene: no objects of it.
const char* const kAnnotations[] = { "vtkCubeAxesActor", "vtkAxesActor", "vtkAxisActor",
  "vtkAxisFollower", "vtkProp3DAxisFollower", "vtkPolarAxesActor", "vtkGridAxesActor2D",
  "vtkGridAxesActor3D", "vtkGridAxesPlaneActor2D", "vtkAnnotatedCubeActor" };

// Those whose letters and lines are the same in views of any size.
const char* const kRulers[] = { "vtkCubeAxesActor", "vtkPolarAxesActor" };

// Does a pipeline begin with a text?
bool IsOfText(vtkAlgorithm* filter)
{
  while (
    filter && filter->GetNumberOfInputPorts() > 0 && filter->GetNumberOfInputConnections(0) > 0)
  {
    filter = filter->GetInputAlgorithm(0, 0);
  }
  return filter && filter->IsA("vtkVectorText");
}

bool IsAnnotation(vtkProp* prop)
{
  const char* name = prop->GetClassName();
  if (std::strcmp(name, "vtkOpenGLActor") == 0)
  {
    return false; // most of them
  }
  if (prop->IsA("vtkFollower") && IsOfText(static_cast<vtkActor*>(prop)->GetMapper()))
  {
    return true;
  }
  return std::any_of(std::begin(kAnnotations), std::end(kAnnotations),
    [prop](const char* annotation) { return prop->IsA(annotation); });
}

// Is the prop the water that is mirrored at, another sheet of its plane, or an assembly with any
// water?
bool IsOfWater(vtkProp* prop, const vtkWaterSnapshot& mirrored)
{
  vtkWaterSource* source = vtkWaterSource::Of(prop);
  if (!source)
  {
    return vtkWaterProps::HoldsWater(prop);
  }
  water_plane plane;
  double origin[3];
  source->ReadPlane(&plane, origin);
  return prop == mirrored.Actor ||
    water_plane_is_shared(&plane, origin, &mirrored.Plane, mirrored.Origin);
}

// hasStandIn  what is drawn in reflections is another prop, which the user has chosen
uint32_t ReadFlags(vtkProp* prop, bool hasStandIn, const vtkWaterSnapshot& mirrored)
{
  uint32_t flags = prop->GetVisibility() ? static_cast<uint32_t>(WATER_PROP_VISIBLE) : 0u;
  if (IsOfWater(prop, mirrored))
  {
    flags |= WATER_PROP_IS_WATER;
  }
  vtkInformation* keys = prop->GetPropertyKeys();
  const bool isMarked = keys && keys->Has(vtkWaterPropKeys::NotReflected());
  if (isMarked && keys->Get(vtkWaterPropKeys::NotReflected()) != 0)
  {
    flags |= WATER_PROP_NOT_REFLECTED;
  }
  if (vtkWaterProps::IsOverlay(prop))
  {
    flags |= WATER_PROP_OVERLAY;
  }
  const bool isTurned = prop->IsA("vtkBillboardTextActor3D") || prop->IsA("vtkFlagpoleLabel");
  if (isTurned || (!isMarked && !hasStandIn && IsAnnotation(prop)))
  {
    flags |= WATER_PROP_LABEL;
    const bool isRuler = std::any_of(std::begin(kRulers), std::end(kRulers),
      [prop](const char* ruler) { return prop->IsA(ruler); });
    flags |= isRuler ? static_cast<uint32_t>(WATER_PROP_RULER) : 0u;
  }
  if (prop->IsA("vtkSkybox"))
  {
    flags |= WATER_PROP_NO_BOUNDS | WATER_PROP_IS_SKY;
  }
  return flags;
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
  if (vtkPropCollection* parts = vtkWaterProps::GetParts(prop))
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
vtkProp* vtkWaterPropReader::FindDrawn(vtkProp* prop)
{
  vtkProp* other = vtkWaterProps::GetStandIn(prop);
  return other && !vtkWaterProps::HoldsWater(other) ? other : prop;
}

//------------------------------------------------------------------------------
water_prop vtkWaterPropReader::Read(
  vtkProp* prop, vtkProp* drawn, const vtkWaterSnapshot& mirrored, bool isRefused)
{
  water_prop read;
  read.flags = ReadFlags(prop, drawn != prop, mirrored);
  if (isRefused)
  {
    read.flags |= WATER_PROP_REFUSED;
  }
  read.width_px = ReadWidth(drawn);
  vtkMath::UninitializeBounds(read.bounds);
  const uint32_t noneNeeded = WATER_PROP_IS_WATER | WATER_PROP_NOT_REFLECTED | WATER_PROP_OVERLAY |
    WATER_PROP_LABEL | WATER_PROP_REFUSED;
  if ((read.flags & WATER_PROP_VISIBLE) && !(read.flags & noneNeeded))
  {
    const double* bounds = vtkWaterProps::GetBounds(drawn); // may bring a pipeline up to date
    if (bounds && !vtkWaterProps::HasAny(drawn, HasSplats))
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
