// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterActor.h"

#include "vtkBoundingBox.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterFrame.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflection.h"
#include "vtkWaterReflectionPass.h"
#include "water_matter.h"
#include "water_plane.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterActor);

//------------------------------------------------------------------------------
vtkWaterActor::vtkWaterActor()
  : Internal(std::make_unique<Internals>(this))
  , Plane(vtkSmartPointer<vtkPlane>::New()) // z = 0, +z up
  , WaterProperty(vtkSmartPointer<vtkWaterProperty>::New())
  , OwnPass(vtkSmartPointer<vtkWaterReflectionPass>::New())
{
  this->Superclass::SetMapper(this->Internal->Sheet.GetMapper());
  water_matter_sediment(this->MatterAbsorption, this->MatterScattering);
}

//------------------------------------------------------------------------------
vtkWaterActor::~vtkWaterActor() = default;

//------------------------------------------------------------------------------
void vtkWaterActor::SetLevel(double z)
{
  if (!vtkMath::IsFinite(z))
  {
    vtkErrorMacro("Level is " << z << "; it must be finite. It stays " << this->GetLevel() << ".");
    return;
  }
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(0.0, 0.0, z);
  plane->SetNormal(0.0, 0.0, 1.0);
  this->SetPlane(plane);
}

//------------------------------------------------------------------------------
double vtkWaterActor::GetLevel()
{
  return this->Plane->GetOrigin()[2];
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetPlane(vtkPlane* plane)
{
  if (!plane)
  {
    this->SetLevel(0.0);
  }
  else if (this->Plane != plane)
  {
    this->Plane = plane;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPlane* vtkWaterActor::GetPlane()
{
  return this->Plane;
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetWaterProperty(vtkWaterProperty* property)
{
  if (!property)
  {
    this->WaterProperty = vtkSmartPointer<vtkWaterProperty>::New();
    this->Modified();
  }
  else if (this->WaterProperty != property)
  {
    this->WaterProperty = property;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkWaterProperty* vtkWaterActor::GetWaterProperty()
{
  return this->WaterProperty;
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetSceneReflection(bool isOn)
{
  if (this->SceneReflection != isOn)
  {
    this->SceneReflection = isOn;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMeshSlopes(bool isOn)
{
  if (this->MeshSlopes != isOn)
  {
    this->MeshSlopes = isOn;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkWaterReflectionPass* vtkWaterActor::GetReflectionPass()
{
  return this->ComposedPass ? this->ComposedPass.Get() : this->OwnPass.Get();
}

//------------------------------------------------------------------------------
const char* vtkWaterActor::GetLastError() const
{
  const Internals& internal = *this->Internal;
  if (!internal.Errors.empty())
  {
    return internal.Errors.front().Text.c_str();
  }
  for (const std::string* error :
    { &internal.HullError, &internal.FlowError, &internal.MatterError })
  {
    if (!error->empty())
    {
      return error->c_str();
    }
  }
  return internal.FoamError.c_str();
}

//------------------------------------------------------------------------------
vtkWaterSource* vtkWaterActor::GetSource()
{
  return this->Internal.get();
}

//------------------------------------------------------------------------------
double* vtkWaterActor::GetBounds()
{
  double* bounds = this->FindBounds();
  // a culler that one rank alone goes by would leave the others waiting for it; later in the frame
  // engines ask where ranks have something to be composited
  return bounds && this->Internal->IsKeptFromCullers() ? nullptr : bounds;
}

//------------------------------------------------------------------------------
double* vtkWaterActor::FindBounds()
{
  this->UpdateSheet();
  if (!this->Internal->WarmUp.GetIsDone())
  {
    this->Internal->WarmUp.Expect(); // cullers ask for bounds, and may be all that do
  }
  if (this->IsEndless())
  {
    vtkMath::UninitializeBounds(this->Bounds); // of vtkProp3D, for its other questions
    return this->Internal->FindSeenBounds(this->DisplacedBounds) ? this->DisplacedBounds : nullptr;
  }
  const bool wasDrawing = this->Internal->IsDrawing;
  this->Internal->SetIsDrawing(true); // the other mapper would have to cut
  double* bounds = this->Superclass::GetBounds();
  this->Internal->SetIsDrawing(wasDrawing);
  if (!this->Internal->IsDisplaced() || !bounds || !vtkMath::AreBoundsInitialized(bounds))
  {
    return bounds;
  }
  water_plane plane;
  water_plane unit;
  double origin[3];
  this->Internal->ReadPlane(&plane, origin);
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return bounds;
  }
  vtkWaterLook look;
  this->Internal->Describe(look);
  water_plane_displaced_bounds(
    &unit, bounds, look.WaveHeightMax, look.WaveReach, this->DisplacedBounds);
  return this->DisplacedBounds;
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMapper(vtkMapper* mapper)
{
  this->Internal->SetDrawnMapper(nullptr);
  this->Superclass::SetMapper(mapper ? mapper : this->Internal->Sheet.GetMapper());
  this->Internal->Report(nullptr, vtkWaterError());
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterActor::HasOpaqueGeometry()
{
  if (!this->GetForceOpaque() && this->WaterProperty->GetOpacity() < 1.0)
  {
    return 0;
  }
  const vtkTypeBool isOpaque = this->Superclass::HasOpaqueGeometry(); // updates the mapper
  return this->ShowsOpaqueData() ? 1 : isOpaque;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterActor::HasTranslucentPolygonalGeometry()
{
  if (!this->GetForceOpaque() && this->WaterProperty->GetOpacity() < 1.0)
  {
    return 1;
  }
  const vtkTypeBool isTranslucent = this->Superclass::HasTranslucentPolygonalGeometry();
  return this->ShowsOpaqueData() ? 0 : isTranslucent;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::ShowsOpaqueData()
{
  return this->Mapper && !this->GetForceTranslucent() && this->GetProperty()->GetOpacity() >= 1.0 &&
    vtkWaterMeshTraits::ShowsScalars(this->Mapper);
}

//------------------------------------------------------------------------------
void vtkWaterActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->OwnPass->ReleaseGraphicsResources(window);
  this->Internal->Surface.ReleaseGraphicsResources(window);
  this->Internal->Secondary.ReleaseGraphicsResources(window);
  this->Internal->SecondaryOfScene.ReleaseGraphicsResources(window);
  if (vtkTexture* environment = this->WaterProperty->GetEnvironmentTexture())
  {
    environment->ReleaseGraphicsResources(window);
  }
  this->Internal->Sea.ReleaseGraphicsResources(window);
  this->Internal->Grid.GetMapper()->ReleaseGraphicsResources(window);
  this->Internal->Horizon.ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkWaterActor::ShallowCopy(vtkProp* prop)
{
  auto* other = vtkWaterActor::SafeDownCast(prop);
  if (other == this)
  {
    return;
  }
  this->Superclass::ShallowCopy(prop);
  if (other)
  {
    if (other->UsesOwnSheet())
    {
      this->SetMapper(nullptr);
    }
    this->SetPlane(other->Plane);
    this->SetTime(other->Time);
    this->SetSceneReflection(other->SceneReflection);
    this->SetMeshSlopes(other->MeshSlopes);
    this->SetFlowArrayName(other->FlowArrayName);
    this->SetFlowPeriod(other->FlowPeriod);
    this->SetMatterArrayName(other->MatterArrayName);
    this->SetMatterAbsorption(other->MatterAbsorption);
    this->SetMatterScattering(other->MatterScattering);
    this->SetFoamArrayName(other->FoamArrayName);
    this->SetFoamMeasure(other->FoamMeasure);
    this->RemoveAllHulls();
    for (int i = 0; i < other->GetNumberOfHulls(); ++i)
    {
      this->AddHull(other->GetHull(i));
    }
    this->SetWaterProperty(other->WaterProperty);
    if (other->UseSheetBounds)
    {
      this->SetSheetBounds(other->SheetBounds);
    }
    else if (other->SheetIsAutomatic)
    {
      this->SetSheetToAutomatic();
    }
    else if (other->SheetToHorizon)
    {
      this->SetSheetToHorizon();
    }
    else
    {
      this->ResetSheetBounds();
    }
    this->OwnPass->CopySettings(other->OwnPass);
    this->OwnPass->SetShowReflection(other->OwnPass->GetShowReflection());
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkWaterActor::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Plane->GetMTime(),
    this->WaterProperty->GetMTime(), this->OwnPass->GetMTime(), this->Internal->Hulls.GetMTime() });
}

//------------------------------------------------------------------------------
void vtkWaterActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const vtkIndent next = indent.GetNextIndent();
  os << indent << "Plane:\n";
  this->Plane->PrintSelf(os, next);
  os << indent << "SheetBounds: ";
  if (this->UseSheetBounds)
  {
    os << "(" << this->SheetBounds[0] << ", " << this->SheetBounds[1] << ", "
       << this->SheetBounds[2] << ", " << this->SheetBounds[3] << ")\n";
  }
  else
  {
    os << (this->SheetToHorizon ? "to the horizon" : "those of the scene")
       << (this->SheetIsAutomatic ? " (automatic)\n" : "\n");
  }
  os << indent << "Surface: " << (this->UsesOwnSheet() ? "built-in sheet" : "user's mapper")
     << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "MeshSlopes: " << (this->MeshSlopes ? "on" : "off") << "\n";
  os << indent << "FlowArrayName: " << this->FlowArrayName << "\n";
  os << indent << "FlowPeriod: " << this->FlowPeriod << "\n";
  os << indent << "MatterArrayName: " << this->MatterArrayName << "\n";
  os << indent << "MatterAbsorption: (" << this->MatterAbsorption[0] << ", "
     << this->MatterAbsorption[1] << ", " << this->MatterAbsorption[2] << ")\n";
  os << indent << "MatterScattering: (" << this->MatterScattering[0] << ", "
     << this->MatterScattering[1] << ", " << this->MatterScattering[2] << ")\n";
  os << indent << "FoamArrayName: " << this->FoamArrayName << "\n";
  os << indent << "FoamMeasure: " << this->GetFoamMeasureAsString() << "\n";
  os << indent << "SceneReflection: " << (this->SceneReflection ? "on" : "off") << "\n";
  os << indent << "Hulls: " << this->GetNumberOfHulls() << "\n";
  vtkWaterLook look;
  this->Internal->Describe(look);
  os << indent << "MetresPerUnit in use: " << look.MetresPerUnit
     << (look.HidesWaves ? "; the waves are too short to be seen in this scene" : "") << "\n";
  os << indent << "WaterProperty:\n";
  this->WaterProperty->PrintSelf(os, next);
  os << indent << "ReflectionPass (" << (this->ComposedPass ? "added by the user" : "own")
     << "):\n";
  this->GetReflectionPass()->PrintSelf(os, next);
  os << indent << "LastError: " << (*this->GetLastError() ? this->GetLastError() : "(none)")
     << "\n";
}
VTK_ABI_NAMESPACE_END
