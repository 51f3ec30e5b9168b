// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionOtherViews.cxx: the part of vtkWaterReflection that renders the own view of
// clear water (water_beyond.h), the sun view (water_sun_view.h) and the sky view
// (water_sky_view.h), in the same five steps as the mirrored view and after it. What is gathered is
// the same.
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterProps.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"
#include "water_beyond.h"

#include <algorithm>
#include <cstddef>

//------------------------------------------------------------------------------
bool vtkWaterReflection::WantOwnView(const Attempt& attempt)
{
  return std::any_of(attempt.Waters.begin(), attempt.Waters.end(),
    [](const vtkWaterSnapshotPointer& water) { return water->WantsOwnView(); });
}

//------------------------------------------------------------------------------
void vtkWaterReflection::MarkOwnProps(const Frame& frame)
{
  for (size_t i = 0; i < this->Gathered.Props.size(); ++i)
  {
    vtkProp* prop = frame.Records->GetProp(i);
    uint32_t& flags = this->Gathered.Props[i].flags;
    const bool isReflected = (flags & WATER_PROP_NOT_REFLECTED) == 0;
    if (!isReflected || prop != frame.Records->GetDrawn(i))
    {
      // its bounds were not read: they are not worth it for the few there are
      flags |= WATER_PROP_OWN_OTHER | (prop->GetVisibility() ? WATER_PROP_OWN_VISIBLE : 0);
    }
  }
}

//------------------------------------------------------------------------------
water_scene vtkWaterReflection::GetSceneOfAll() const
{
  water_scene scene = this->Gathered.Scene;
  if (this->Ranks.AreSeveral())
  {
    scene.props = this->RankProps.data();
    scene.prop_count = this->RankProps.size();
  }
  return scene;
}

//------------------------------------------------------------------------------
void vtkWaterReflection::ReleaseOther(std::unique_ptr<OtherView>& view, vtkWindow* window)
{
  if (view && !view->Drawn.GetIsDrawing()) // else who draws it does it
  {
    view->Drawn.ReleaseGraphicsResources(window);
    view = nullptr;
  }
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderOtherViews(const Frame& frame, Attempt& attempt)
{
  const vtkWaterError ofOwnView = this->RenderOwnView(frame, attempt);
  const vtkWaterError ofSunView = this->RenderSunView(frame, attempt);
  const vtkWaterError ofSkyView = this->RenderSkyView(frame, attempt);
  const vtkWaterError& first = ofOwnView.Text.empty() ? ofSunView : ofOwnView;
  return first.Text.empty() ? ofSkyView : first;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderOwnView(const Frame& frame, Attempt& attempt)
{
  this->Report.OwnViewDecision = WATER_NOT_PLANNED;
  View& view = *attempt.Drawn;
  const Other other = { view.Own, this->Report.OwnViewRenderCount, "own view of refraction",
    "The water shows what the picture has of the scene below (RefractionSource).", true, false,
    true };
  if (frame.Primary || !WantOwnView(attempt))
  {
    ReleaseOther(view.Own, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  water_scene scene = this->GetSceneOfAll();
  std::vector<water_prop> props(scene.prop_count);
  std::transform(scene.props, scene.props + scene.prop_count, props.begin(),
    [](const water_prop& prop) { return water_beyond_prop(&prop); });
  scene.props = props.data();
  scene.is_beyond = true;
  water_plan plan = water_plan();
  vtkWaterError error = this->RenderOther(frame, attempt, scene, plan, other);
  this->Report.OwnViewDecision = plan.decision;
  this->HasOwnView = water_plan_has_reflection(&plan);
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderSunView(const Frame& frame, Attempt& attempt)
{
  View& view = *attempt.Drawn;
  const Other other = { view.Sun, this->Report.SunViewRenderCount, "sun view",
    "Nothing casts shadows on the water (Shadows).", false, true, false };
  const bool isWanted = !frame.Primary &&
    std::any_of(attempt.Waters.begin(), attempt.Waters.end(),
      [](const vtkWaterSnapshotPointer& water) { return water->WantsSunView(); });
  if (!isWanted)
  {
    ReleaseOther(view.Sun, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  water_scene scene = this->GetSceneOfAll();
  scene.is_from_sun = true;
  water_plan plan = water_plan();
  vtkWaterError error = this->RenderOther(frame, attempt, scene, plan, other);
  this->HasSunView = water_plan_has_reflection(&plan);
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderSkyView(const Frame& frame, Attempt& attempt)
{
  View& view = *attempt.Drawn;
  const Other other = { view.Sky, this->Report.SkyViewRenderCount, "sky view",
    "Rays that leave the reflection texture meet no dome.", true, false, false };
  const bool isWanted = !frame.Primary && this->Plan.is_enclosed &&
    this->Gathered.Scene.has_waves && water_plan_has_reflection(&this->Plan);
  if (!isWanted)
  {
    ReleaseOther(view.Sky, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  water_scene scene = this->GetSceneOfAll();
  scene.is_of_sky = true;
  water_plan plan = water_plan();
  vtkWaterError error = this->RenderOther(frame, attempt, scene, plan, other);
  this->HasSkyView = water_plan_has_reflection(&plan);
  if (plan.decision == WATER_REFLECT && this->Gathered.IsRough)
  {
    view.Sky->Drawn.MakeLevels();
  }
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::RenderOther(
  const Frame& frame, Attempt& attempt, water_scene& scene, water_plan& plan, const Other& other)
{
  const bool areSeveral = this->Ranks.AreSeveral();
  const bool isInVain = this->GetPlannedView() != attempt.Drawn.get() || attempt.IsAborted ||
    this->Report.Decision == WATER_NO_REFLECT_FAILED;
  if (isInVain && !areSeveral) // ranks tell each other
  {
    return vtkWaterError(); // the plain colour is shown
  }
  std::vector<water_cull_reason> reasons(scene.prop_count, WATER_CULL_NONE);
  // what is wrong with the scene is told by the mirrored view's plan
  (void)water_plan_make(&scene, &plan, reasons.data());
  const bool isAsked = water_plan_has_reflection(&this->Plan);
  if (plan.decision == WATER_REFLECT && !isAsked && frame.AreHidden && frame.AreHidden())
  {
    scene.is_hidden = true;
    (void)water_plan_make(&scene, &plan, reasons.data());
  }
  if (plan.decision != WATER_REFLECT)
  {
    return vtkWaterError();
  }
  // of the props of all ranks, its own
  const size_t own = this->Gathered.Props.size();
  reasons.erase(reasons.begin(), reasons.begin() + static_cast<std::ptrdiff_t>(attempt.FirstProp));
  reasons.resize(own);
  scene.props += attempt.FirstProp;
  scene.prop_count = own;
  if (!other.View)
  {
    other.View = std::make_unique<OtherView>();
  }
  Attempt part;
  part.Waters = attempt.Waters;
  part.Drawn = attempt.Drawn;
  part.IsAborted = attempt.IsAborted;
  const Choice choice = { plan, reasons, other.IsDirect };
  return areSeveral ? this->DrawOtherOfAll(frame, part, choice, scene, plan, reasons, other)
                    : this->DrawOther(frame, part, choice, scene, plan, reasons, other);
}

//------------------------------------------------------------------------------
bool vtkWaterReflection::ReviseOther(const Frame& frame, Attempt& part, const Choice& choice,
  const water_scene& scene, std::vector<water_cull_reason>& reasons, const Other& other)
{
  const OtherView& own = *other.View;
  vtkWaterMirroredView::Draft& draft = part.Draft;
  draft.Hook = frame.Hook;
  draft.IsDepth = other.IsDepth;
  draft.HasMarchedRays = other.HasLayer;
  // which triangles a pixel shows is known of cameras' own projections
  draft.CanCut = !other.IsDepth && (this->Settings.skips & WATER_MAY_SKIP_CLUSTERS) != 0;
  draft.Shadows = vtkWaterShadows::Find(frame.Renderer);
  if (!other.IsDepth)
  {
    draft.Sky = this->Gathered.Sky;
  }
  FindDrawn(frame, part, choice, draft.Props);
  this->Sign(frame, choice, draft, part.Signature);
  water_plan revised = choice.Plan;
  water_plan_revise(&scene, &own.DrawnPlan, part.Signature.IsSameAs(own.DrawnSignature), nullptr,
    &revised, reasons.data());
  return revised.decision == WATER_REUSE;
}

//------------------------------------------------------------------------------
const char* vtkWaterReflection::CarryOutOther(
  const Frame& frame, Attempt& part, const Choice& choice, OtherView& own)
{
  this->SortDrawn(frame, choice, part.Draft);
  const bool hasVolumes =
    std::any_of(part.Draft.Others.begin(), part.Draft.Others.end(), vtkWaterProps::HoldsVolume);
  part.Draft.HasMarchedRays = part.Draft.HasMarchedRays &&
    water_beyond_keeps_layer(
      this->Gathered.Scene.is_software, hasVolumes, this->Ranks.AreSeveral());
  own.DrawnPlan = water_plan();
  if (part.Draft.Shadows)
  {
    vtkWaterShadows::Bake(frame.Renderer, part.Draft.Shadows);
  }
  (void)own.Drawn.FindVisible(frame.Renderer, choice.Plan, false); // all of it is looked at
  return own.Drawn.Draw(frame.Renderer, choice.Plan, part.Draft);
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::CommitOther(
  const Frame& frame, const Attempt& part, water_plan& plan, const Other& other)
{
  vtkWaterError error;
  OtherView& own = *other.View;
  vtkRenderWindow* window = frame.Renderer->GetRenderWindow();
  if (this->GetPlannedView() != part.Drawn.get())
  {
    own.Drawn.ReleaseGraphicsResources(window); // was wanted in the middle of it
    plan.decision = WATER_NOT_PLANNED;
  }
  else if (part.Failure)
  {
    plan.decision = WATER_NO_REFLECT_FAILED;
    error.Kind = std::string(other.Name) + ": " + part.Failure;
    error.Text = error.Kind + ". " + other.Without;
  }
  else if (part.IsAborted || window->GetAbortRender() || frame.Hook->Failures.TakeMirrored())
  {
    plan.decision = WATER_NOT_PLANNED; // what was refused is left out of the next one
  }
  else
  {
    ++other.RenderCount;
    own.DrawnPlan = plan;
    own.DrawnSignature = part.Signature;
    error = Describe(own.Drawn.GetShortage());
  }
  return error;
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::DrawOther(const Frame& frame, Attempt& part, const Choice& choice,
  const water_scene& scene, water_plan& plan, std::vector<water_cull_reason>& reasons,
  const Other& other)
{
  if (this->ReviseOther(frame, part, choice, scene, reasons, other))
  {
    plan.decision = WATER_REUSE;
    return Describe(other.View->Drawn.GetShortage());
  }
  part.Failure = this->CarryOutOther(frame, part, choice, *other.View);
  return this->CommitOther(frame, part, plan, other);
}
