// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterActorSheet.cxx: the part of vtkWaterActor that lays its own sheet: as wide as its user
// says, as its scene, or as the eye sees.
#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkWaterActorInternals.h"
#include "vtkWaterCompat.h"
#include "vtkWaterErrors.h"
#include "vtkWaterFrame.h"
#include "vtkWaterGather.h"
#include "vtkWaterReflection.h"
#include "water_horizon.h"
#include "water_plane.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

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
    this->SheetIsAutomatic = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::ResetSheetBounds()
{
  if (this->UseSheetBounds || this->SheetToHorizon || this->SheetIsAutomatic)
  {
    std::fill(this->SheetBounds, this->SheetBounds + 4, 0.0);
    this->UseSheetBounds = false;
    this->SheetToHorizon = false;
    this->SheetIsAutomatic = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetSheetToHorizon()
{
  if (!this->SheetToHorizon || this->SheetIsAutomatic)
  {
    this->ResetSheetBounds();
    this->SheetToHorizon = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkWaterActor::SetSheetToAutomatic()
{
  if (!this->SheetIsAutomatic)
  {
    this->ResetSheetBounds();
    this->SheetIsAutomatic = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkWaterActor::UsesOwnSheet()
{
  return this->Mapper == this->Internal->Sheet.GetMapper();
}

//------------------------------------------------------------------------------
void vtkWaterActor::ChooseSheet(const std::vector<vtkRenderer*>& scene)
{
  if (!this->SheetIsAutomatic)
  {
    return;
  }
  double bounds[6];
  double origin[3];
  water_plane plane;
  this->Internal->FindSceneBounds(scene, bounds);
  this->Internal->ReadPlane(&plane, origin);
  // water alone is open water, in a frame; before there is nothing yet to choose by
  vtkWaterGround& ground = this->Internal->Ground;
  this->SheetToHorizon = vtkMath::AreBoundsInitialized(bounds)
    ? !(this->Internal->HasRankBounds ? ground.IsUnderOfRanks(plane)
                                      : ground.IsUnder(plane, bounds, scene))
    : std::any_of(scene.begin(), scene.end(), IsRendering);
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
  this->ChooseSheet(scene);
  static const std::vector<double> all;
  double bounds[6] = {};
  if (!this->UseSheetBounds && !this->SheetToHorizon)
  {
    internal.FindSceneBounds(scene, bounds); // asks all props
  }
  const water_status status = this->SheetToHorizon
    ? internal.Sheet.Clear(fitted.Plane)
    : internal.Sheet.Fit(fitted.Plane, fitted.Origin,
        this->UseSheetBounds ? this->SheetBounds : nullptr, bounds,
        this->SheetIsAutomatic ? internal.Ground.GetWet() : all);
  internal.IsUpdatingSheet = false;
  const bool isEarly = std::none_of(scene.begin(), scene.end(), IsRendering) ||
    (internal.IsDrawnOnAllRanks() && !internal.HasRankBounds);
  if (status == WATER_BAD_SURFACE && isEarly)
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
void vtkWaterActor::Internals::FindSceneBounds(
  const std::vector<vtkRenderer*>& scene, double bounds[6])
{
  if (this->HasRankBounds)
  {
    std::copy_n(this->RankBounds, 6, bounds);
    return;
  }
  vtkWaterSheet::FindSceneBounds(scene, bounds);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::HasAutomaticExtent()
{
  return this->Self->SheetIsAutomatic && this->Self->UsesOwnSheet();
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsGroundJoined()
{
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  water_plane plane;
  double origin[3];
  this->ReadPlane(&plane, origin);
  return this->HasRankBounds &&
    this->Ground.IsJoined(plane, this->RankBounds, scene, this->GetRanks().GetStamp());
}

//------------------------------------------------------------------------------
std::vector<double> vtkWaterActor::Internals::ReadGroundPart()
{
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  water_plane plane;
  double origin[3];
  this->ReadPlane(&plane, origin);
  return this->Ground.ReadPart(plane, this->RankBounds, scene, this->GetRanks().GetStamp());
}

//------------------------------------------------------------------------------
std::vector<double> vtkWaterActor::Internals::JoinGround(const std::vector<double>& parts)
{
  water_plane plane;
  double origin[3];
  this->ReadPlane(&plane, origin);
  return this->Ground.Join(plane, this->RankBounds, parts);
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::JoinGroundBelow(const std::vector<double>& parts)
{
  this->Ground.JoinBelow(parts);
  this->FittedFrame = this->MeasuredFrame = this->SnapshotFrame = 0;
}

//------------------------------------------------------------------------------
void vtkWaterActor::Internals::SetSceneBounds(const double* bounds)
{
  const bool isSame = this->HasRankBounds == (bounds != nullptr) &&
    (!bounds || std::equal(bounds, bounds + 6, this->RankBounds));
  if (isSame)
  {
    return;
  }
  this->HasRankBounds = bounds != nullptr;
  if (bounds)
  {
    std::copy_n(bounds, 6, this->RankBounds);
  }
  // what was laid and measured in this frame was so for a part of the scene
  this->FittedFrame = this->MeasuredFrame = this->SnapshotFrame = 0;
}

//------------------------------------------------------------------------------
const vtkWaterRanks& vtkWaterActor::Internals::GetRanks()
{
  vtkWaterReflection* composed = this->GetComposedReflection();
  return (composed ? *composed : this->GetOwnReflection()).Ranks;
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsDrawnOnAllRanks()
{
  if (!this->GetRanks().AreSeveral())
  {
    return false;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  return std::any_of(scene.begin(), scene.end(), IsRendering);
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::IsKeptFromCullers()
{
  if (!this->IsDrawnOnAllRanks())
  {
    return false;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  // waters begin the frame, once the cullers are through
  return std::any_of(scene.begin(), scene.end(),
    [](vtkRenderer* renderer) { return vtkWaterFrame::NumberOf(renderer) == 0; });
}

//------------------------------------------------------------------------------
bool vtkWaterActor::Internals::FindSeenBounds(double bounds[6])
{
  if (!this->IsDrawnOnAllRanks() || this->IsKeptFromCullers())
  {
    return false;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  water_plane plane;
  double origin[3];
  this->ReadPlane(&plane, origin);
  vtkWaterLook look;
  this->Describe(look);
  const bool isDisplaced = this->IsDisplaced();
  vtkBoundingBox box;
  for (vtkRenderer* renderer : scene)
  {
    const water_camera eye = vtkWaterGather::ReadCamera(renderer);
    double seen[6];
    if (vtkWaterFrame::NumberOf(renderer) != 0 &&
      water_horizon_bounds(&eye, &plane, isDisplaced ? look.WaveHeightMax : 0.0,
        isDisplaced ? look.WaveReach : 0.0, seen))
    {
      box.AddBounds(seen);
    }
  }
  if (box.IsValid())
  {
    box.GetBounds(bounds);
  }
  return box.IsValid() != 0;
}

//------------------------------------------------------------------------------
double vtkWaterActor::Internals::GetSceneDiagonal()
{
  std::vector<vtkRenderer*> scene;
  FindRenderers(this->Self, scene);
  const vtkMTimeType frame = scene.empty() ? 0 : vtkWaterFrame::NumberOf(scene.front());
  // between frames it is as it was in the last one: buoys ask often
  const bool isKnown = this->MeasuredFrame != 0 && (frame == 0 || frame == this->MeasuredFrame);
  if (!this->IsUpdatingSheet && !isKnown)
  {
    this->MeasuredFrame = frame;
    double bounds[6];
    this->IsUpdatingSheet = true; // a scene that is asked for its bounds asks this water, too
    this->FindSceneBounds(scene, bounds);
    this->IsUpdatingSheet = false;
    this->SceneDiagonal =
      vtkMath::AreBoundsInitialized(bounds) ? vtkBoundingBox(bounds).GetDiagonalLength() : 0.0;
  }
  return this->SceneDiagonal;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkWaterActor::GetPickable()
{
  const vtkTypeBool isPickable = this->Superclass::GetPickable();
  if (!isPickable || !this->IsEndless())
  {
    return isPickable;
  }
  std::vector<vtkRenderer*> scene;
  FindRenderers(this, scene);
  return std::any_of(scene.begin(), scene.end(),
    [](vtkRenderer* renderer) { return renderer->GetSelector() != nullptr; });
}
VTK_ABI_NAMESPACE_END
