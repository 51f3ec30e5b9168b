// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterFrameGroups.cxx: the part of vtkWaterFrame that finds the sheets that share a mirrored
// view, and when, and with what budget, that is drawn.
#include "vtkCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPropCollection.h"
#include "vtkWaterDebug.h"
#include "vtkWaterFrame.h"
#include "vtkWaterGL.h"
#include "vtkWaterPasses.h"
#include "vtkWaterProps.h"
#include "vtkWaterReflection.h"
#include "vtkWaterSource.h"
#include "water_quality.h"
#include "water_seen.h"
#include "water_share.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
const char* const kOfNoView[] = { "vtkActor", "vtkOpenGLActor", "vtkFollower", "vtkProp3DFollower",
  "vtkVolume", "vtkSkybox", "vtkOpenGLSkybox" };

water_share ShareOf(const vtkWaterSnapshot& water)
{
  water_share share = water_share();
  share.plane = water.Plane;
  std::copy_n(water.Origin, 3, share.origin);
  share.look = water.Look.Property;
  share.is_clear = water.IsClear();
  share.is_displaced = water.IsDisplaced();
  share.is_opaque = water.Look.Has.is_opaque;
  share.needs_rays = water.NeedsRays();
  share.has_environment = water.Look.Has.has_environment;
  share.settings = water.Settings;
  return share;
}

bool IsWater(vtkProp* prop)
{
  return vtkWaterSource::Of(prop) != nullptr;
}

// May a prop show something else in the main view when it has been drawn in a mirrored one in the
// middle of it? Legends, slices and others make what they show for the view they were drawn in
// last.
bool IsOfItsView(vtkProp* prop)
{
  const char* name = prop->GetClassName();
  const bool isLabel = prop->IsA("vtkBillboardTextActor3D") || prop->IsA("vtkFlagpoleLabel");
  return !vtkWaterProps::IsOverlay(prop) && !isLabel && !IsWater(prop) &&
    std::none_of(std::begin(kOfNoView), std::end(kOfNoView),
      [name](const char* known) { return std::strcmp(name, known) == 0; });
}

bool IsClearWater(vtkProp* prop)
{
  vtkWaterSource* water = vtkWaterSource::Of(prop);
  return water && water->IsClear();
}

// How far the water's plane is from the eye.
double DistanceOf(vtkProp* prop, vtkCamera* camera)
{
  water_plane plane;
  double origin[3];
  double eye[3];
  vtkWaterSource::Of(prop)->ReadPlane(&plane, origin);
  camera->GetPosition(eye);
  return water_seen_distance(&plane, eye);
}
}

//------------------------------------------------------------------------------
void vtkWaterFrame::DrawLast(vtkWaterSource& water)
{
  vtkProp3D* prop = water.GetProp();
  const vtkWaterDrawnProps props(this->Renderer);
  vtkProp** self = props.Find(prop);
  const bool isClear = water.IsClear();
  // opaque waters before clear ones, through which they are seen
  vtkProp** last = props.End;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double distance = isClear ? DistanceOf(prop, camera) : 0.0;
  while (last > self && last[-1] != prop && IsClearWater(last[-1]) &&
    (!isClear || DistanceOf(last[-1], camera) <= distance))
  {
    --last;
  }
  if (self == props.End || last <= self + 1 || (!isClear && std::all_of(self, last, IsWater)))
  {
    return;
  }
  std::rotate(self, self + 1, last);
  // The renderer is in the middle of allotting times, by place; it has done this one.
  vtkProp* next = *self;
  const double mine = prop->GetRenderTimeMultiplier();
  next->SetAllocatedRenderTime(
    mine > 0.0 ? prop->GetAllocatedRenderTime() * next->GetRenderTimeMultiplier() / mine : 0.0,
    this->Renderer);
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::CanBeLate(vtkWaterSource& water)
{
  vtkOpenGLRenderer* renderer = this->Renderer;
  const unsigned wanted = WATER_MAY_SKIP_HIDDEN | WATER_MAY_SKIP_PIXELS;
  vtkWaterReflection& reflection = water.GetOwnReflection();
  // what hides the water is one rank's alone
  return !reflection.Ranks.AreSeveral() && (reflection.Settings.skips & wanted) &&
    !water.GetComposedReflection() && !renderer->GetPass() && !renderer->GetUseSSAO() &&
    !renderer->GetUseShadows() && !renderer->GetUseHiddenLineRemoval() &&
    water.GetProp()->HasOpaqueGeometry() && vtkWaterDrawnProps(renderer).Has(water.GetProp()) &&
    !this->HasPropsOfTheirView();
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::HasPropsOfTheirView() const
{
  const std::vector<vtkProp*>& others = this->Records.GetOthers();
  return std::any_of(others.begin(), others.end(),
    [](vtkProp* prop) { return vtkWaterProps::HasAny(prop, IsOfItsView); });
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::CanShare(vtkWaterSource& water, vtkWaterSource& other)
{
  if (other.GetComposedReflection() || other.HasSheetError())
  {
    return false;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const water_share mine = ShareOf(*water.Take(this->Renderer));
  const water_share its = ShareOf(*other.Take(this->Renderer));
  return water_share_can(&mine, &its, camera->GetPosition(), camera->GetParallelProjection() != 0);
}

//------------------------------------------------------------------------------
std::vector<vtkWaterSource*> vtkWaterFrame::FindSheets(vtkWaterSource& water)
{
  const vtkWaterDrawnProps props(this->Renderer);
  if (!(water.GetOwnReflection().Settings.skips & WATER_MAY_SKIP_SHARED) ||
    water.GetComposedReflection() || !props.Has(water.GetProp()))
  {
    return { &water };
  }
  // in the order of the scene, which drawing does not change
  std::vector<vtkWaterSource*> sheets;
  vtkPropCollection* all = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  while (vtkProp* prop = all->GetNextProp(it))
  {
    vtkWaterSource* other = vtkWaterSource::Of(prop);
    if (other && (other == &water || (props.Has(prop) && this->CanShare(water, *other))))
    {
      sheets.push_back(other);
    }
  }
  return sheets.size() > 1 ? sheets : std::vector<vtkWaterSource*>{ &water };
}

//------------------------------------------------------------------------------
const vtkWaterFrame::Group* vtkWaterFrame::FindGroup(vtkWaterSource& water) const
{
  const vtkMTimeType number = this->GetNumber();
  if (number == 0 || this->GroupsNumber != number)
  {
    return nullptr;
  }
  vtkProp* prop = water.GetProp();
  // the last one: who was found later may have taken a sheet along
  const auto found =
    std::find_if(this->Groups.rbegin(), this->Groups.rend(), [prop](const Group& group) {
      return std::find(group.Sheets.begin(), group.Sheets.end(), prop) != group.Sheets.end();
    });
  return found != this->Groups.rend() ? &*found : nullptr;
}

//------------------------------------------------------------------------------
const vtkWaterFrame::Group& vtkWaterFrame::EnsureGroup(vtkWaterSource& water)
{
  if (const Group* known = this->FindGroup(water))
  {
    return *known; // another sheet of this frame was first
  }
  if (this->GroupsNumber != this->GetNumber())
  {
    this->Groups.clear();
    this->GroupsNumber = this->GetNumber();
  }
  const std::vector<vtkWaterSource*> sheets = this->FindSheets(water);
  Group group;
  group.IsLate = this->CanBeLate(water) && this->IsWorthWaiting(sheets);
  for (vtkWaterSource* sheet : sheets)
  {
    group.Sheets.emplace_back(sheet->GetProp());
  }
  this->Groups.push_back(group);
  return this->Groups.back();
}

//------------------------------------------------------------------------------
std::vector<vtkWaterSource*> vtkWaterFrame::GetSources(const Group& group)
{
  std::vector<vtkWaterSource*> sources;
  for (const auto& sheet : group.Sheets)
  {
    if (sheet)
    {
      sources.push_back(vtkWaterSource::Of(sheet));
    }
  }
  return sources;
}

//------------------------------------------------------------------------------
vtkWaterReflection& vtkWaterFrame::GetReflection(vtkWaterSource& water)
{
  if (vtkWaterReflection* composed = water.GetComposedReflection())
  {
    return *composed;
  }
  const Group* group = this->FindGroup(water);
  vtkProp* leader = group ? group->Sheets.front().Get() : nullptr;
  return leader ? vtkWaterSource::Of(leader)->GetOwnReflection() : water.GetOwnReflection();
}

//------------------------------------------------------------------------------
void vtkWaterFrame::RenderShared(vtkWaterSource& water, const int viewport_px[2], bool isLate)
{
  vtkRenderer* renderer = this->Renderer;
  const std::vector<vtkWaterSource*> sheets = GetSources(this->EnsureGroup(water));
  const vtkWaterDrawnProps props(renderer);
  vtkWaterReflection::Frame frame;
  frame.Renderer = renderer;
  frame.Number = this->GetNumber();
  frame.Hook = GetHook();
  frame.Records = &this->Records;
  std::copy_n(viewport_px, 2, frame.Viewport_px);
  frame.Hints.IsSoftware = this->IsSoftware();
  frame.Hints.MayToneMap = vtkWaterPasses::MayKeepFloats(renderer->GetPass());
  if (isLate)
  {
    frame.AreHidden = [this, &sheets]() { return this->AreHidden(sheets); };
  }
  // other waters hide, too, and need not say when they move
  frame.Hints.HasSceneDepth = isLate &&
    std::count_if(props.Begin, props.End, IsWater) == static_cast<std::ptrdiff_t>(sheets.size());
  frame.Hints.BudgetMs = this->FindBudget(sheets);
  vtkWaterReflection& reflection = sheets.front()->GetOwnReflection();
  frame.RanksError = this->Agree(reflection) ? nullptr : &this->RanksError;
  this->AreAgreed = reflection.Render(frame, sheets) && this->AreAgreed;
  for (size_t i = 1; i < sheets.size(); ++i)
  {
    sheets[i]->GetOwnReflection().Decline(WATER_NO_REFLECT_SHARED);
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkWaterFrame::GetSamples(vtkWaterSource& water)
{
  return water.GetOwnReflection()
    .GetOcclusion(this->Renderer)
    ->GetSamples(this->Renderer->GetRenderWindow());
}

//------------------------------------------------------------------------------
double vtkWaterFrame::FindBudget(const std::vector<vtkWaterSource*>& sheets)
{
  const water_settings& settings = sheets.front()->GetOwnReflection().Settings;
  if (settings.quality != WATER_QUALITY_TIME_BUDGET &&
    settings.quality != WATER_QUALITY_UPDATE_RATE)
  {
    return 0.0;
  }
  const double budget = settings.quality == WATER_QUALITY_UPDATE_RATE
    ? water_quality_budget(this->Renderer->GetRenderWindow()->GetDesiredUpdateRate())
    : settings.time_budget_ms;
  // what was seen in the last frame of all that go by a budget, and which of them are ours
  std::vector<double> areas;
  std::vector<unsigned char> areOurs; // bool for C
  const vtkWaterDrawnProps props(this->Renderer);
  std::for_each(props.Begin, props.End, [&](vtkProp* prop) {
    vtkWaterSource* water = vtkWaterSource::Of(prop);
    if (water && water->GetOwnReflection().Settings.quality == settings.quality)
    {
      areas.push_back(static_cast<double>(this->GetSamples(*water)));
      areOurs.push_back(std::find(sheets.begin(), sheets.end(), water) != sheets.end());
    }
  });
  std::vector<double> shares(areas.size(), 0.0);
  return water_quality_share_of(areas.data(), areOurs.data(), areas.size(), budget, shares.data());
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::IsWorthWaiting(const std::vector<vtkWaterSource*>& sheets)
{
  // What was seen in the last frame is the best guess at what is seen in this one. A wrong guess
  // costs time and shows nothing.
  double visible = 0.0;
  for (vtkWaterSource* water : sheets)
  {
    const vtkIdType samples = this->GetSamples(*water);
    visible = samples < 0 || visible < 0.0 ? -1.0 : visible + static_cast<double>(samples);
  }
  return sheets.front()->GetOwnReflection().ShouldWait(this->Renderer, visible, this->IsSoftware());
}

//------------------------------------------------------------------------------
bool vtkWaterFrame::AreHidden(const std::vector<vtkWaterSource*>& sheets)
{
  // Asking GL what is seen waits for all that was drawn. It is worth that only if the answer is
  // likely to be no, and it likely is what it was in the last frame.
  auto wasHidden = [this](vtkWaterSource* water) { return this->GetSamples(*water) == 0; };
  if (!(sheets.front()->GetOwnReflection().Settings.skips & WATER_MAY_SKIP_HIDDEN) ||
    !std::all_of(sheets.begin(), sheets.end(), wasHidden))
  {
    return false;
  }
  vtkOpenGLState* state = this->Renderer->GetState();
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  auto isHidden = [this](vtkWaterSource* water) {
    water->Probe(this->Renderer);
    const vtkIdType samples =
      water->GetOwnReflection().GetOcclusion(this->Renderer)->WaitForSamples();
    if (samples < 0 && !this->IsSilenceSaid)
    {
      this->IsSilenceSaid = vtkWaterDebug::Say(water->GetProp(),
        "this driver does not report whether the water is hidden; its reflection is rendered.");
    }
    return samples == 0;
  };
  return std::all_of(sheets.begin(), sheets.end(), isHidden);
}
