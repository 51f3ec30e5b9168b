// SPDX-License-Identifier: BSD-3-Clause
// vtkWaterReflectionOtherViews.cxx: the part of vtkWaterReflection that renders the own view of
// clear water (water_beyond.h), the sun view (water_sun_view.h) and the sky view
// (water_sky_view.h), in the same five steps as the mirrored view and after it. What is gathered is
// the same.
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkProp.h"
#include "vtkWaterPropRecords.h"
#include "vtkWaterReflection.h"
#include "vtkWaterShaderHook.h"
#include "vtkWaterShadows.h"

#include <algorithm>

//------------------------------------------------------------------------------
water_scene vtkWaterReflection::ReadOwnScene(
  const Frame& frame, std::vector<water_prop>& props) const
{
  water_scene scene = this->Gathered.Scene;
  scene.is_beyond = true;
  for (size_t i = 0; i < scene.prop_count; ++i)
  {
    vtkProp* prop = frame.Records->GetProp(i);
    const bool isReflected = (this->Gathered.Props[i].flags & WATER_PROP_NOT_REFLECTED) == 0;
    if (isReflected && prop == frame.Records->GetDrawn(i))
    {
      continue;
    }
    if (props.empty())
    {
      props = this->Gathered.Props;
    }
    // its bounds were not read: they are not worth it for the few there are
    const uint32_t visible = prop->GetVisibility() ? WATER_PROP_VISIBLE : 0;
    props[i].flags &= ~static_cast<uint32_t>(WATER_PROP_VISIBLE);
    props[i].flags |= visible | WATER_PROP_NO_BOUNDS;
  }
  scene.props = props.empty() ? scene.props : props.data();
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
    "The water shows what the picture has of the scene below (RefractionSource).", true, false };
  const bool isWanted = !this->Ranks.AreSeveral() && !frame.Primary &&
    std::any_of(attempt.Waters.begin(), attempt.Waters.end(),
      [](const vtkWaterSnapshotPointer& water) { return water->WantsOwnView(); });
  if (!isWanted)
  {
    ReleaseOther(view.Own, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  std::vector<water_prop> props;
  water_scene scene = this->ReadOwnScene(frame, props);
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
    "Nothing casts shadows on the water (Shadows).", false, true };
  const bool isWanted = !this->Ranks.AreSeveral() && !frame.Primary &&
    std::any_of(attempt.Waters.begin(), attempt.Waters.end(),
      [](const vtkWaterSnapshotPointer& water) { return water->WantsSunView(); });
  if (!isWanted)
  {
    ReleaseOther(view.Sun, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  water_scene scene = this->Gathered.Scene;
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
    "Rays that leave the reflection texture meet no dome.", true, false };
  const bool isWanted = !this->Ranks.AreSeveral() && !frame.Primary && this->Plan.is_enclosed &&
    this->Gathered.Scene.has_waves && water_plan_has_reflection(&this->Plan);
  if (!isWanted)
  {
    ReleaseOther(view.Sky, frame.Renderer->GetRenderWindow());
    return vtkWaterError();
  }
  water_scene scene = this->Gathered.Scene;
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
  if (this->GetPlannedView() != attempt.Drawn.get() || attempt.IsAborted ||
    this->Report.Decision == WATER_NO_REFLECT_FAILED)
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
  return plan.decision == WATER_REFLECT
    ? this->DrawOther(
        frame, attempt, { plan, reasons, other.IsDirect }, scene, plan, reasons, other)
    : vtkWaterError();
}

//------------------------------------------------------------------------------
vtkWaterError vtkWaterReflection::DrawOther(const Frame& frame, Attempt& attempt,
  const Choice& choice, const water_scene& scene, water_plan& plan,
  std::vector<water_cull_reason>& reasons, const Other& other)
{
  vtkWaterError error;
  View& view = *attempt.Drawn;
  auto* window = static_cast<vtkOpenGLRenderWindow*>(frame.Renderer->GetRenderWindow());
  if (!other.View)
  {
    other.View = std::make_unique<OtherView>();
  }
  OtherView& own = *other.View;
  vtkWaterMirroredView::Draft draft;
  draft.Hook = frame.Hook;
  draft.IsDepth = other.IsDepth;
  // which triangles a pixel shows is known of cameras' own projections
  draft.CanCut = !other.IsDepth && (this->Settings.skips & WATER_MAY_SKIP_CLUSTERS) != 0;
  draft.Shadows = vtkWaterShadows::Find(frame.Renderer);
  if (!other.IsDepth)
  {
    draft.Sky = this->Gathered.Sky;
  }
  FindDrawn(frame, attempt, choice, draft.Props);
  vtkWaterSignature signature;
  this->Sign(frame, choice, draft, signature);
  water_plan_revise(
    &scene, &own.DrawnPlan, signature.IsSameAs(own.DrawnSignature), nullptr, &plan, reasons.data());
  if (plan.decision != WATER_REFLECT)
  {
    return Describe(own.Drawn.GetShortage());
  }
  this->SortDrawn(frame, choice, draft);
  own.DrawnPlan = water_plan();
  if (draft.Shadows)
  {
    vtkWaterShadows::Bake(frame.Renderer, draft.Shadows);
  }
  (void)own.Drawn.FindVisible(frame.Renderer, plan, false); // all of it is looked at
  const char* failure = own.Drawn.Draw(frame.Renderer, plan, draft);
  if (this->GetPlannedView() != &view)
  {
    own.Drawn.ReleaseGraphicsResources(window); // was wanted in the middle of it
    plan.decision = WATER_NOT_PLANNED;
  }
  else if (failure)
  {
    plan.decision = WATER_NO_REFLECT_FAILED;
    error.Kind = std::string(other.Name) + ": " + failure;
    error.Text = error.Kind + ". " + other.Without;
  }
  else if (window->GetAbortRender() || frame.Hook->Failures.TakeMirrored())
  {
    plan.decision = WATER_NOT_PLANNED; // what was refused is left out of the next one
  }
  else
  {
    ++other.RenderCount;
    own.DrawnPlan = plan;
    own.DrawnSignature = signature;
    error = Describe(own.Drawn.GetShortage());
  }
  return error;
}
