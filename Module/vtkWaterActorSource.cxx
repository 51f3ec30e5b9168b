// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorSource.cxx: the part of vtkWaterActor that the rooms below ask: its snapshot, its
// plane, its passes, and where they say what is wrong.
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterFrame.h"
#include "vtkWaterGather.h"
#include "vtkWaterMeshTraits.h"
#include "vtkWaterProperty.h"
#include "vtkWaterReflection.h"
#include "vtkWaterReflectionPass.h"
#include "vtkWindow.h"
#include "water_beyond.h"
#include "water_plane.h"
#include "water_slopes.h"

#include <algorithm>
#include <atomic>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkWaterSource* vtkWaterSource::Of(vtkProp* prop)
{
  // Asked of every prop, most of which are of one class: its name's address tells that class.
  static std::atomic<const char*> other(nullptr);
  const char* name = prop ? prop->GetClassName() : nullptr;
  if (!prop || name == other.load(std::memory_order_relaxed))
  {
    return nullptr;
  }
  vtkWaterActor* water = vtkWaterActor::SafeDownCast(prop);
  if (!water)
  {
    other.store(name, std::memory_order_relaxed);
  }
  return water ? water->GetSource() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::Report(vtkRenderer* renderer, const vtkWaterError& error)
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
    vtkErrorWithObjectMacro(this->Self, << error.Text);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::HasSheetError() const
{
  return !this->Errors.empty() && this->Errors.front().IsOfSheet;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadPlane(water_plane* plane, double origin[3])
{
  // by value and gradient, as planes may have an offset or a transform besides
  double worldOrigin[3] = { 0.0, 0.0, 0.0 };
  vtkPlane* given = this->Self->Plane;
  given->FunctionGradient(worldOrigin, plane->normal);
  plane->offset = given->FunctionValue(worldOrigin);
  water_plane unit;
  given->GetOrigin(origin);
  if (given->FunctionValue(origin) != 0.0 && water_plane_normalise(plane, &unit) == WATER_OK)
  {
    water_plane_project(&unit, origin, origin);
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadPlaces(vtkWaterSnapshot& water)
{
  this->ReadPlane(&water.Plane, water.Origin);
  std::copy_n(this->Self->Plane->GetOrigin(), 3, water.GivenOrigin);
  std::copy_n(this->Self->Plane->GetNormal(), 3, water.GivenNormal);
}

//------------------------------------------------------------------------------
void vtkWaterActor::GetSkyDirection(double azimuth, double elevation, double direction[3])
{
  water_plane plane;
  water_plane unit;
  double origin[3];
  this->Internal->ReadPlane(&plane, origin);
  std::fill_n(direction, 3, vtkMath::Nan());
  if (vtkMath::IsFinite(azimuth) && vtkMath::IsFinite(elevation) &&
    water_plane_normalise(&plane, &unit) == WATER_OK)
  {
    water_plane_sky_direction(unit.normal, vtkMath::RadiansFromDegrees(azimuth),
      vtkMath::RadiansFromDegrees(elevation), direction);
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::GetMeshPlacement(double placement[4])
{
  water_plane plane;
  water_plane unit;
  double origin[3];
  this->Internal->ReadPlane(&plane, origin);
  std::fill_n(placement, 4, vtkMath::Nan());
  vtkMapper* mapper = this->GetMapper();
  vtkPolyData* mesh = this->UsesOwnSheet() ? nullptr : vtkWaterMeshPlacement::FindMesh(mapper);
  if (!mesh || water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return false;
  }
  this->ComputeMatrix();
  const water_placement_verdict verdict =
    vtkWaterMeshPlacement::Judge(mesh, this->GetMatrix(), unit);
  placement[0] = verdict.height;
  placement[1] = verdict.height_max;
  placement[2] = vtkMath::DegreesFromRadians(verdict.angle_rad);
  placement[3] = vtkMath::DegreesFromRadians(verdict.angle_max_rad);
  return true;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsClear()
{
  return this->Self->WaterProperty->GetRefraction() && this->Self->HasOpaqueGeometry();
}

//------------------------------------------------------------------------------
vtkWaterReflection& vtkWaterActor::Internals::GetOwnReflection()
{
  return this->Self->OwnPass->GetReflection();
}

//------------------------------------------------------------------------------
vtkWaterReflection* vtkWaterActor::Internals::GetComposedReflection()
{
  return this->Self->ComposedPass ? &this->Self->ComposedPass->GetReflection() : nullptr;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadMesh(const water_plane& plane, vtkWaterMesh* mesh)
{
  vtkMapper* mapper = this->Self->GetMapper();
  water_plane unit;
  mesh->HeightMax = std::numeric_limits<double>::infinity();
  if (water_plane_normalise(&plane, &unit) != WATER_OK)
  {
    return; // what is wrong with the plane is said as an error
  }
  if (vtkWaterMeshTraits::IsDrawnAsItIs(mapper, this->Self))
  {
    *mesh = this->Heights.Read(mapper, this->Self->GetMatrix(), unit);
  }
  if (this->Self->UsesOwnSheet() || !this->MayMirror) // then the plane's view is not shown
  {
    return;
  }
  const std::string text = this->Placement.Check(mapper, this->Self->GetMatrix(), unit);
  if (!text.empty())
  {
    vtkWarningWithObjectMacro(this->Self, << text);
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ColorLook(vtkWaterLook* look)
{
  // VTK's own property does not tell a white that was set from the white that it begins with
  double color[3];
  this->Self->GetProperty()->GetDiffuseColor(color);
  const bool isWhite = std::all_of(color, color + 3, [](double channel) { return channel == 1.0; });
  if (!look->HasDeepColor && !isWhite)
  {
    std::copy_n(color, 3, look->DeepColor);
    look->HasDeepColor = true;
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::Describe(vtkWaterLook& look)
{
  vtkWaterProperty* property = this->Self->WaterProperty;
  property->Describe(property->GetMetresPerUnit() == 0.0 ? this->GetSceneDiagonal() : 0.0, look);
  const bool isKnown = this->Self->SheetIsAutomatic;
  look.HasGround = isKnown && !this->Self->SheetToHorizon;
  look.Bed = isKnown && !look.HasGround ? WATER_UNITS_BED_NONE : WATER_UNITS_BED_UNEVEN;
  look.Bed = look.HasGround && this->Ground.GetIsFlat() ? WATER_UNITS_BED_FLAT : look.Bed;
  this->ColorLook(&look);
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::SetMayMirror(bool mayMirror)
{
  if (this->MayMirror != mayMirror)
  {
    this->MayMirror = mayMirror;
    this->Self->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::SetDrawnMapper(vtkMapper* mapper)
{
  this->SetIsDrawing(false);
  this->OtherMapper = mapper;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::SetIsDrawing(bool isDrawing)
{
  if (this->IsDrawing != isDrawing && this->OtherMapper)
  {
    // not by SetMapper, which makes the actor another one for all who keep what they know of it
    vtkMapper* other = this->OtherMapper;
    other->Register(this->Self);
    this->OtherMapper = this->Self->Mapper;
    this->Self->Mapper->UnRegister(this->Self);
    this->Self->Mapper = other;
    this->IsDrawing = isDrawing;
  }
}

namespace
{
bool IsOpen(const vtkWaterSnapshot& water)
{
  return water_beyond_is_open(water.Look.Bed, water.IsEndless, water.Look.RefractionSource);
}

water_feature_set FeaturesOf(const vtkWaterSnapshot& water)
{
  const vtkWaterLook& look = water.Look;
  water_feature_set features = water_features_of(&look.Has);
  features = look.HasGround ? water_features_with_ground(features) : features;
  features = IsOpen(water) ? water_features_with_open(features) : features;
  return look.DomePortRadius > 0.0 ? water_features_with_port(features) : features;
}
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::ReadExtent(vtkWaterSnapshot& water)
{
  const double* bounds = this->Self->FindBounds(); // lays the sheet where it is now
  if (bounds && !this->Self->IsEndless())
  {
    std::copy_n(bounds, 6, water.Bounds);
  }
  this->ReadPlaces(water);
  water.IsEndless = this->Self->IsEndless();
  water.IsSheet = water.IsEndless || (this->Self->UsesOwnSheet() && this->Self->GetIsIdentity());
  std::copy_n(this->Sheet.GetRectangle(), 4, water.Sheet);
  water.HasBorder = water.IsSheet && !water.IsEndless;
  if (!water.IsSheet)
  {
    water.HasBorder =
      water_sheet_around(&water.Plane, water.Origin, water.Bounds, water.Sheet) == WATER_OK;
    this->ReadMesh(water.Plane, &water.Mesh);
  }
}

namespace
{
bool HasOwnView(const vtkWaterSnapshot& water, vtkRenderer* renderer)
{
  const int whole[2] = { 1, 1 };
  vtkWindow* window = renderer ? renderer->GetVTKWindow() : nullptr;
  vtkCamera* camera = window ? renderer->GetActiveCamera() : nullptr;
  const bool isLow = camera &&
    water_beyond_is_low(&water.Plane, camera->GetPosition(), camera->GetDirectionOfProjection());
  return water_beyond_is_wanted(
    water.Look.RefractionSource, IsOpen(water), isLow, window ? window->GetTileScale() : whole);
}
}

//------------------------------------------------------------------------------
vtkWaterSnapshotPointer vtkWaterActor::Internals::Take(vtkRenderer* renderer)
{
  const vtkMTimeType frame = renderer ? vtkWaterFrame::NumberOf(renderer) : 0;
  const vtkMTimeType time = this->Self->GetMTime();
  if (frame != 0 && frame == this->SnapshotFrame && time == this->SnapshotTime)
  {
    if (vtkWaterSnapshotPointer taken = this->Snapshot.lock())
    {
      return taken;
    }
  }
  auto made = std::make_shared<vtkWaterSnapshot>();
  made->Actor = this->Self;
  this->ReadExtent(*made);
  made->Time = this->Self->Time;
  this->ReadFoam(*made);
  this->Describe(made->Look);
  made->Look.HasOwnView = HasOwnView(*made, renderer);
  made->Look.Has.is_opaque = this->Self->HasOpaqueGeometry() != 0;
  made->Look.Has.has_environment =
    made->Look.Has.has_environment || !this->Self->SceneReflection || !this->MayMirror;
  // code that adds black costs a GPU a twentieth of its time for the surface
  made->Look.Has.has_glitter =
    made->Look.Has.has_glitter && (!renderer || vtkWaterGather::HasSun(renderer));
  made->Features = FeaturesOf(*made);
  if (made->Mesh.HasVertexHeights)
  {
    made->Features = made->Mesh.IsSloped && this->Self->MeshSlopes
      ? water_features_with_slopes(made->Features, made->Look.Has.lookup)
      : water_features_with_mesh(made->Features);
  }
  this->ReadData(*made);
  if (made->IsSloped())
  {
    made->Look.SlopeRMS = water_slopes_together(made->Look.SlopeRMS, made->Mesh.SlopeRMS);
    made->Look.SlopeLookedUp = std::numeric_limits<double>::infinity();
  }
  this->CutHulls(*made);
  made->Waves = this->GetWaveTerms(made->Look);
  made->Sea = &this->Sea;
  made->Settings = this->GetOwnReflection().Settings;
  if (frame != 0)
  {
    this->Snapshot = made;
    this->SnapshotFrame = frame;
    this->SnapshotTime = time;
    vtkWaterFrame::Of(renderer).Keep(made);
  }
  return made;
}
VTK_ABI_NAMESPACE_END
