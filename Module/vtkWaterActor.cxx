// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWaterActor.h"

#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterGather.h"
#include "vtkWaterGrid.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWaterSea.h"
#include "vtkWaterSecondarySurface.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterSheet.h"
#include "vtkWaterSurfaceShader.h"
#include "water_plan.h"

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
}

//------------------------------------------------------------------------------
vtkWaterActor::vtkWaterActor()
  : Plane(vtkSmartPointer<vtkPlane>::New()) // z = 0, +z up
  , WaterProperty(vtkSmartPointer<vtkWaterProperty>::New())
  , OwnPass(vtkSmartPointer<vtkWaterReflectionPass>::New())
  , Sheet(std::make_unique<vtkWaterSheet>())
  , Grid(std::make_unique<vtkWaterGrid>())
  , Surface(std::make_unique<vtkWaterSurfaceShader>())
  , Secondary(std::make_unique<vtkWaterSecondarySurface>())
  , Sea(std::make_unique<vtkWaterSea>())
{
  this->Superclass::SetMapper(this->Sheet->GetMapper());
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
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::ResetSheetBounds()
{
  if (this->UseSheetBounds)
  {
    std::fill(this->SheetBounds, this->SheetBounds + 4, 0.0);
    this->UseSheetBounds = false;
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
  return this->Errors.empty() ? "" : this->Errors.front().Text.c_str();
}

//------------------------------------------------------------------------------
void vtkWaterActor::ReportError(vtkRenderer* renderer, const vtkWaterError& error)
{
  // The plane is looked at twice, for the sheet and for the plan, and by every renderer.
  const bool isKnown = std::any_of(this->Errors.begin(), this->Errors.end(),
    [&error](const SourcedError& other) { return other.Kind == error.Kind; });
  this->Errors.erase(std::remove_if(this->Errors.begin(), this->Errors.end(),
                       [renderer](const SourcedError& other) {
                         return other.Renderer == renderer || (!other.IsOfSheet && !other.Renderer);
                       }),
    this->Errors.end());
  if (error.Text.empty())
  {
    return;
  }
  SourcedError sourced;
  sourced.Kind = error.Kind;
  sourced.Text = error.Text;
  sourced.Renderer = renderer;
  sourced.IsOfSheet = !renderer;
  // what is wrong with the sheet is said first
  this->Errors.insert(renderer ? this->Errors.end() : this->Errors.begin(), sourced);
  if (!isKnown)
  {
    vtkErrorMacro(<< error.Text);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::HasSheetError() const
{
  return !this->Errors.empty() && this->Errors.front().IsOfSheet;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::UsesOwnSheet()
{
  return this->Mapper == this->Sheet->GetMapper();
}

//------------------------------------------------------------------------------
void vtkWaterActor::UpdateSheet()
{
  if (this->IsUpdatingSheet)
  {
    return; // the scene was asked for its bounds, and asks all that it holds
  }
  if (!this->UsesOwnSheet())
  {
    const bool hasInput = this->Mapper->GetNumberOfInputPorts() == 0 ||
      this->Mapper->GetNumberOfInputConnections(0) > 0;
    this->ReportError(nullptr,
      hasInput
        ? vtkWaterError()
        : vtkWaterError{ "no input", "the water's mapper has no input. There is no water." });
    return;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this, scene);
  if (scene.empty() && !this->UseSheetBounds)
  {
    return; // not in a scene yet
  }
  const vtkMTimeType frame =
    scene.empty() ? 0 : vtkWaterShaderHook::GetOfThread()->Keys.GetFrame(scene.front());
  if (frame != 0 && this->FittedFrame == frame)
  {
    return; // asking all props for their bounds costs time
  }
  this->FittedFrame = frame;
  double origin[3];
  vtkWaterGather::ReadPlaneOrigin(this, origin);
  this->IsUpdatingSheet = true;
  const water_status status = this->Sheet->Fit(vtkWaterGather::ReadPlane(this), origin,
    this->UseSheetBounds ? this->SheetBounds : nullptr, scene);
  this->IsUpdatingSheet = false;
  if (status != WATER_OK)
  {
    this->OwnPass->SetDecision(WATER_NO_REFLECT_FAILED);
  }
  this->ReportError(nullptr, status == WATER_OK ? vtkWaterError() : vtkWaterDescribe(status, this));
}

//------------------------------------------------------------------------------
double* vtkWaterActor::GetBounds()
{
  this->UpdateSheet();
  double* bounds = this->Superclass::GetBounds();
  water_plane unit;
  const water_plane plane = vtkWaterGather::ReadPlane(this);
  if (!this->IsDisplaced() || !bounds || !vtkMath::AreBoundsInitialized(bounds) ||
    water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return bounds;
  }
  water_plane_displaced_bounds(&unit, bounds, this->WaterProperty->GetWaveHeightMax(),
    this->WaterProperty->GetWaveReach(), this->DisplacedBounds);
  return this->DisplacedBounds;
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetMapper(vtkMapper* mapper)
{
  this->Superclass::SetMapper(mapper ? mapper : this->Sheet->GetMapper());
  this->ReportError(nullptr, vtkWaterError());
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
  this->Surface->ReleaseGraphicsResources(window);
  this->Secondary->ReleaseGraphicsResources(window);
  if (vtkTexture* environment = this->WaterProperty->GetEnvironmentTexture())
  {
    environment->ReleaseGraphicsResources(window);
  }
  this->Sea->ReleaseGraphicsResources(window);
  this->Grid->GetMapper()->ReleaseGraphicsResources(window);
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
    else
    {
      this->ResetSheetBounds();
    }
    this->OwnPass->SetTextureScale(other->OwnPass->GetTextureScale());
    this->OwnPass->SetMultiSamples(other->OwnPass->GetMultiSamples());
    this->OwnPass->SetColorPrecision(other->OwnPass->GetColorPrecision());
    this->OwnPass->SetClipMargin(other->OwnPass->GetClipMargin());
    this->OwnPass->SetGuardBand(other->OwnPass->GetGuardBand());
    this->OwnPass->SetSkips(other->OwnPass->GetSkips());
    this->OwnPass->SetMinimumPropSize(other->OwnPass->GetMinimumPropSize());
    this->OwnPass->SetReflectanceError(other->OwnPass->GetReflectanceError());
    this->OwnPass->SetQuality(other->OwnPass->GetQuality());
    this->OwnPass->SetTargetError(other->OwnPass->GetTargetError());
    this->OwnPass->SetTimeBudget(other->OwnPass->GetTimeBudget());
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
    os << "those of the scene\n";
  }
  os << indent << "Surface: " << (this->UsesOwnSheet() ? "own sheet" : "mapper of the user")
     << "\n";
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "WaterProperty:\n";
  this->WaterProperty->PrintSelf(os, next);
  os << indent << "ReflectionPass (" << (this->ComposedPass ? "composed by hand" : "own") << "):\n";
  this->GetReflectionPass()->PrintSelf(os, next);
  os << indent << "LastError: " << (*this->GetLastError() ? this->GetLastError() : "(none)")
     << "\n";
}
VTK_ABI_NAMESPACE_END
