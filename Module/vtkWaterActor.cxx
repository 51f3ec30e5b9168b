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
#include "vtkWaterProperty.h"
#include "vtkWaterReflection.h"
#include "vtkWaterReflectionPass.h"
#include "water_plane.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkWaterActor);

namespace
{
// The renderers that show a prop, itself or as a part of assemblies.
void FindRenderers(vtkProp* prop, std::vector<vtkRenderer*>& renderers)
{
  for (int i = 0; i < prop->GetNumberOfConsumers(); ++i)
  {
    vtkObject* consumer = prop->GetConsumer(i);
    if (auto* renderer = vtkRenderer::SafeDownCast(consumer))
    {
      renderers.push_back(renderer);
    }
    else if (auto* assembly = vtkProp::SafeDownCast(consumer))
    {
      FindRenderers(assembly, renderers);
    }
  }
}

bool IsRendering(vtkRenderer* renderer)
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  return (window && window->CheckInRenderStatus()) || vtkWaterFrame::NumberOf(renderer) != 0;
}
}

//------------------------------------------------------------------------------
vtkWaterActor::vtkWaterActor()
  : Internal(std::make_unique<Internals>(this))
  , Plane(vtkSmartPointer<vtkPlane>::New()) // z = 0, +z up
  , WaterProperty(vtkSmartPointer<vtkWaterProperty>::New())
  , OwnPass(vtkSmartPointer<vtkWaterReflectionPass>::New())
{
  this->Superclass::SetMapper(this->Internal->Sheet.GetMapper());
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
void vtkWaterActor::SetSheetBounds(double xmin, double xmax, double ymin, double ymax)
{
  const double bounds[4] = { xmin, xmax, ymin, ymax };
  if (!std::all_of(bounds, bounds + 4, [](double bound) { return vtkMath::IsFinite(bound); }) ||
    !(xmin < xmax && ymin < ymax))
  {
    vtkErrorMacro("SheetBounds are (" << xmin << ", " << xmax << ", " << ymin << ", " << ymax
                                      << "); they must be finite with xmin < xmax and ymin < ymax. "
                                         "They stay as they were.");
    return;
  }
  if (!this->UseSheetBounds || !std::equal(bounds, bounds + 4, this->SheetBounds))
  {
    std::copy(bounds, bounds + 4, this->SheetBounds);
    this->UseSheetBounds = true;
    this->SheetToHorizon = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::ResetSheetBounds()
{
  if (this->UseSheetBounds || this->SheetToHorizon)
  {
    std::fill(this->SheetBounds, this->SheetBounds + 4, 0.0);
    this->UseSheetBounds = false;
    this->SheetToHorizon = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetSheetToHorizon()
{
  if (!this->SheetToHorizon)
  {
    this->ResetSheetBounds();
    this->SheetToHorizon = true;
    this->Modified();
  }
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
vtkWaterReflectionPass* vtkWaterActor::GetReflectionPass()
{
  return this->ComposedPass ? this->ComposedPass.Get() : this->OwnPass.Get();
}

//------------------------------------------------------------------------------
const char* vtkWaterActor::GetLastError() const
{
  const auto& errors = this->Internal->Errors;
  return errors.empty() ? "" : errors.front().Text.c_str();
}

//------------------------------------------------------------------------------
vtkWaterSource* vtkWaterActor::GetSource()
{
  return this->Internal.get();
}

//------------------------------------------------------------------------------
bool vtkWaterActor::UsesOwnSheet()
{
  return this->Mapper == this->Internal->Sheet.GetMapper();
}

//------------------------------------------------------------------------------
void vtkWaterActor::UpdateSheet()
{
  Internals& internal = *this->Internal;
  if (internal.IsUpdatingSheet)
  {
    return; // the scene was asked for its bounds, and asks all that it holds
  }
  if (!this->UsesOwnSheet())
  {
    const bool hasInput = this->Mapper->GetNumberOfInputPorts() == 0 ||
      this->Mapper->GetNumberOfInputConnections(0) > 0;
    internal.Report(nullptr,
      hasInput
        ? vtkWaterError()
        : vtkWaterError{ "no input", "the water's mapper has no input. There is no water." });
    return;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this, scene);
  if (scene.empty() && !this->UseSheetBounds && !this->SheetToHorizon)
  {
    return; // not in a scene yet
  }
  const vtkMTimeType frame = scene.empty() ? 0 : vtkWaterFrame::NumberOf(scene.front());
  if (frame != 0 && internal.FittedFrame == frame)
  {
    return; // asking all props for their bounds costs time
  }
  internal.FittedFrame = frame;
  vtkWaterSnapshot fitted; // what errors name
  internal.ReadPlane(&fitted.Plane, fitted.Origin);
  std::copy_n(this->Plane->GetOrigin(), 3, fitted.GivenOrigin);
  std::copy_n(this->Plane->GetNormal(), 3, fitted.GivenNormal);
  internal.IsUpdatingSheet = true;
  const water_status status = this->SheetToHorizon
    ? internal.Sheet.Clear(fitted.Plane)
    : internal.Sheet.Fit(
        fitted.Plane, fitted.Origin, this->UseSheetBounds ? this->SheetBounds : nullptr, scene);
  internal.IsUpdatingSheet = false;
  if (status == WATER_BAD_SURFACE && std::none_of(scene.begin(), scene.end(), IsRendering))
  {
    return; // asked for its bounds while there is nothing yet to be as wide as: no frame, no fault
  }
  if (status != WATER_OK)
  {
    internal.GetOwnReflection().Decline(WATER_NO_REFLECT_FAILED);
  }
  internal.Report(nullptr, status == WATER_OK ? vtkWaterError() : vtkWaterDescribe(status, fitted));
}

//------------------------------------------------------------------------------
double vtkWaterActor::Internals::GetSceneDiagonal()
{
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  const vtkMTimeType frame = scene.empty() ? 0 : vtkWaterFrame::NumberOf(scene.front());
  if (!this->IsUpdatingSheet && (frame == 0 || frame != this->MeasuredFrame))
  {
    this->MeasuredFrame = frame;
    double bounds[6];
    this->IsUpdatingSheet = true; // a scene that is asked for its bounds asks this water, too
    vtkWaterSheet::FindSceneBounds(scene, bounds);
    this->IsUpdatingSheet = false;
    this->SceneDiagonal =
      vtkMath::AreBoundsInitialized(bounds) ? vtkBoundingBox(bounds).GetDiagonalLength() : 0.0;
  }
  return this->SceneDiagonal;
}

//------------------------------------------------------------------------------
double* vtkWaterActor::GetBounds()
{
  this->UpdateSheet();
  if (!this->Internal->WarmUp.GetIsDone())
  {
    this->Internal->WarmUp.Expect(); // cullers ask for bounds, and may be all that do
  }
  if (this->IsEndless())
  {
    vtkMath::UninitializeBounds(this->Bounds); // of vtkProp3D, for its other questions
    return nullptr;
  }
  double* bounds = this->Superclass::GetBounds();
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
  this->Superclass::SetMapper(mapper ? mapper : this->Internal->Sheet.GetMapper());
  this->Internal->Report(nullptr, vtkWaterError());
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterActor::HasOpaqueGeometry()
{
  return this->GetForceOpaque() || this->WaterProperty->GetOpacity() >= 1.0
    ? this->Superclass::HasOpaqueGeometry()
    : 0;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterActor::HasTranslucentPolygonalGeometry()
{
  return this->GetForceOpaque() || this->WaterProperty->GetOpacity() >= 1.0
    ? this->Superclass::HasTranslucentPolygonalGeometry()
    : 1;
}

//------------------------------------------------------------------------------
void vtkWaterActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->OwnPass->ReleaseGraphicsResources(window);
  this->Internal->Surface.ReleaseGraphicsResources(window);
  this->Internal->Secondary.ReleaseGraphicsResources(window);
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
  this->Superclass::ShallowCopy(prop);
  if (other)
  {
    if (other->UsesOwnSheet())
    {
      this->SetMapper(nullptr);
    }
    this->SetPlane(other->Plane);
    this->SetTime(other->Time);
    this->SetWaterProperty(other->WaterProperty);
    if (other->UseSheetBounds)
    {
      this->SetSheetBounds(other->SheetBounds);
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
    this->WaterProperty->GetMTime(), this->OwnPass->GetMTime() });
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
    os << (this->SheetToHorizon ? "to the horizon\n" : "those of the scene\n");
  }
  os << indent << "Surface: " << (this->UsesOwnSheet() ? "own sheet" : "mapper of the user")
     << "\n";
  os << indent << "Time: " << this->Time << "\n";
  vtkWaterLook look;
  this->Internal->Describe(look);
  os << indent << "MetresPerUnit in use: " << look.MetresPerUnit
     << (look.HidesWaves ? "; the waves are too short to be seen in this scene" : "") << "\n";
  os << indent << "WaterProperty:\n";
  this->WaterProperty->PrintSelf(os, next);
  os << indent << "ReflectionPass (" << (this->ComposedPass ? "composed by hand" : "own") << "):\n";
  this->GetReflectionPass()->PrintSelf(os, next);
  os << indent << "LastError: " << (*this->GetLastError() ? this->GetLastError() : "(none)")
     << "\n";
}
VTK_ABI_NAMESPACE_END
